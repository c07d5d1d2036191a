#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A ribbon between two points, as wide as asked in pixels.
uniform mat4 clipFromTooth;
uniform vec3 fromMm;
uniform vec3 toMm;
uniform vec2 halfWidth;  // clip units across

out float along;

void main()
{
    along = float(gl_VertexID / 2);
    vec4 clip = clipFromTooth * vec4(mix(fromMm, toMm, along), 1.0);
    clip.xy += (gl_VertexID % 2 == 0 ? -1.0 : 1.0) * halfWidth * clip.w;
    gl_Position = clip;
}
