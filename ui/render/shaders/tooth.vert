#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex a lattice node, which comes from the maps. What depends on the node alone is
// read here and not for every pixel: a node covers a dozen of them.
uniform mat4 clipFromTooth;
uniform sampler2D places;   // x, y as drawn, mm
uniform sampler2D heights;  // as drawn, mm
uniform sampler2D normals;  // x, y of the unit normal
uniform sampler2D upperLayers;  // of it only the dentin, mm
uniform sampler2D lowerLayers;  // of it only the uncut surface, mm
uniform sampler2D ideal;    // of it only how far the ideal surface lies below the uncut one, mm
uniform sampler2D light;    // openness to the sky, operating light, cut, crevice
uniform vec4 clipPlane;     // of the mirror, tooth frame; zero: nothing is cut off
uniform float facing;       // 1 upper surface, -1 lower
uniform vec3 lattice;       // x, y of the first node, mm; nodes a mm

invariant gl_Position;  // as in brighten.vert
out vec3 positionMm;
out vec3 normalHere;  // turned linearly from node to node, or the rim, where z goes through 0, would show
out vec4 shadeHere;
out float cutMm;     // below the uncut surface
out float tooDeepMm;  // below the ideal one
out float enamelHere;  // over the dentin of this column, mm
out vec2 onLattice;  // where the layers of this column are, as a texture is read

void main()
{
    int side = textureSize(heights, 0).x;
    ivec2 node = ivec2(gl_VertexID % side, gl_VertexID / side);
    vec2 placeMm = texelFetch(places, node, 0).rg;
    positionMm = vec3(placeMm, texelFetch(heights, node, 0).r);
    cutMm = texelFetch(lowerLayers, node, 0).b - positionMm.z;
    tooDeepMm = cutMm - texelFetch(ideal, node, 0).r;
    enamelHere = positionMm.z - texelFetch(upperLayers, node, 0).b;
    vec2 across = texelFetch(normals, node, 0).rg;
    normalHere = vec3(across, facing * sqrt(max(1.0 - dot(across, across), 0.0)));
    shadeHere = texelFetch(light, node, 0);
    // The map of light is the upper surface's.
    if (facing < 0.0)
        shadeHere = mix(vec4(1.0, 1.0, 0.0, 0.5), vec4(0.8, 0.6, 0.0, 0.5), smoothstep(0.0, 0.8, -normalHere.z));
    onLattice = ((placeMm - lattice.xy) * lattice.z + 0.5) / float(side);
    gl_ClipDistance[0] = dot(clipPlane, vec4(positionMm, 1.0));
    gl_Position = clipFromTooth * vec4(positionMm, 1.0);
}
