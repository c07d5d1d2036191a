#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the upper surface again, to multiply its picture by the light changes from bur and handpiece.
uniform mat4 clipFromTooth;
uniform sampler2D places;    // x, y as drawn, mm
uniform sampler2D heights;   // as drawn, mm
uniform sampler2D burLight;  // from burlight.frag
uniform vec4 clipPlane;      // clip plane of the mirror, tooth frame; zero: no clipping

invariant gl_Position;  // must equal the position in tooth.vert
out float halfBrighter;

void main()
{
    int side = textureSize(heights, 0).x;
    ivec2 node = ivec2(gl_VertexID % side, gl_VertexID / side);
    vec3 positionMm = vec3(texelFetch(places, node, 0).rg, texelFetch(heights, node, 0).r);
    halfBrighter = texelFetch(burLight, node, 0).r;
    gl_ClipDistance[0] = dot(clipPlane, vec4(positionMm, 1.0));
    gl_Position = clipFromTooth * vec4(positionMm, 1.0);
}
