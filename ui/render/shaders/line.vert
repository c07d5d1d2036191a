#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A ribbon between two points, of a width given in clip units.
uniform mat4 clipFromTooth;
uniform vec3 fromMm;
uniform vec3 toMm;
uniform vec2 halfWidth;  // clip units across
uniform vec4 clipPlane;  // clip plane of the mirror, tooth frame; zero: no clipping

out float along;

void main()
{
    along = float(gl_VertexID / 2);
    vec4 placed = vec4(mix(fromMm, toMm, along), 1.0);
    gl_ClipDistance[0] = dot(clipPlane, placed);
    vec4 clip = clipFromTooth * placed;
    clip.xy += (gl_VertexID % 2 == 0 ? -1.0 : 1.0) * halfWidth * clip.w;
    gl_Position = clip;
}
