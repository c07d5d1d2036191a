#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The upper surface once more, to multiply upon its picture what bur and handpiece change of the light.
uniform mat4 clipFromTooth;
uniform sampler2D places;    // x, y as drawn, mm
uniform sampler2D heights;   // as drawn, mm
uniform sampler2D burLight;  // from burlight.frag
uniform vec4 clipPlane;      // of the mirror, tooth frame; zero: nothing is cut off

invariant gl_Position;  // as in tooth.vert
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
