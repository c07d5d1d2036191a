#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex a lattice node: its place comes from a buffer, all else from the maps. What depends on the node alone is
// read here and not for every pixel: a node covers a dozen of them.
layout(location = 0) in vec2 placeMm;

uniform mat4 clipFromTooth;
uniform sampler2D heights;      // as drawn, and as the height map has it; mm
uniform sampler2D normals;      // x, y of the unit normal
uniform sampler2D light;        // openness to the sky, operating light, cut, crevice
uniform sampler2D upperLayers;  // roof and floor of the decay, dentin, roof of the pulp; heights in mm
uniform sampler2D lowerLayers;  // floor of the pulp, mm; share of decayed columns around

out vec3 positionMm;
out vec2 across;        // x, y of the normal
out vec4 shadeHere;
out vec4 aboveLayers;   // below the roof of the decay, above its floor, above the dentin, below the roof of the pulp; mm
out vec2 aboveLower;    // above the floor of the pulp, mm; share of decayed columns around

void main()
{
    int side = textureSize(heights, 0).x;
    ivec2 node = ivec2(gl_VertexID % side, gl_VertexID / side);
    // Materials by the map's own height, as the layers are: a drawn surface may lie a little beside it.
    vec2 height = texelFetch(heights, node, 0).rg;
    vec4 layer = texelFetch(upperLayers, node, 0);
    vec2 lower = texelFetch(lowerLayers, node, 0).rg;
    positionMm = vec3(placeMm, height.r);
    across = texelFetch(normals, node, 0).rg;
    shadeHere = texelFetch(light, node, 0);
    aboveLayers = vec4(layer.x - height.g, height.g - layer.y, height.g - layer.z, layer.w - height.g);
    aboveLower = vec2(height.g - lower.x, lower.y);
    gl_Position = clipFromTooth * vec4(positionMm, 1.0);
}
