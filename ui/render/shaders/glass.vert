#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The glass of the dental mirror: a disc of 64 corners in the mirror's frame, just in front of the metal.
uniform mat4 clipFromMirror;
uniform float radiusMm;

out vec2 onGlass;  // -1 .. 1

void main()
{
    float angle = 6.2831853 * float(gl_VertexID) / 64.0;
    onGlass = vec2(cos(angle), sin(angle));
    gl_Position = clipFromMirror * vec4(onGlass * radiusMm, 0.02, 1.0);
}
