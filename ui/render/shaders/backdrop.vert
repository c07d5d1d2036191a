#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle that covers the whole picture.
out vec2 place;

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    place = corner;
    gl_ClipDistance[0] = 1.0;  // not clipped, also in the mirror
    gl_Position = vec4(corner, 1.0, 1.0);
}
