#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex per lattice node, read from the maps. Values that depend only on the node are read here and not for each
// pixel, because a node covers about a dozen pixels.
uniform mat4 clipFromTooth;
uniform sampler2D places;   // x, y as drawn, mm
uniform sampler2D heights;  // as drawn, mm
uniform sampler2D normals;  // x, y of the unit normal
uniform sampler2D upperLayers;  // only z is used: the dentin, mm
uniform sampler2D lowerLayers;  // only z is used: the uncut surface, mm
uniform sampler2D ideal;    // only x is used: depth of the ideal surface below the uncut one, mm
uniform sampler2D light;    // openness to the sky, operating light, cut, crevice
uniform sampler2D blood;    // of an opened pulp, 1 where it covers the surface
uniform vec4 clipPlane;     // clip plane of the mirror, tooth frame; zero: no clipping
uniform float facing;       // 1 upper surface, -1 lower
uniform vec3 lattice;       // x, y of the first node, mm; nodes per mm

invariant gl_Position;  // must equal the position in brighten.vert
out vec3 positionMm;
out vec3 normalHere;  // interpolated linearly, so that the rim, where z passes 0, is invisible
out vec4 shadeHere;
out float cutMm;     // depth below the uncut surface
out float tooDeepMm;  // depth below the ideal surface
out float enamelHere;  // enamel above the dentin of this column, mm
out float bloodHere;  // on the upper surface
out vec2 onLattice;  // texture coordinates of this column's layers

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
    // The light map is that of the upper surface.
    if (facing < 0.0)
        shadeHere = mix(vec4(1.0, 1.0, 0.0, 0.5), vec4(0.8, 0.6, 0.0, 0.5), smoothstep(0.0, 0.8, -normalHere.z));
    bloodHere = facing > 0.0 ? texelFetch(blood, node, 0).r : 0.0;
    onLattice = ((placeMm - lattice.xy) * lattice.z + 0.5) / float(side);
    gl_ClipDistance[0] = dot(clipPlane, vec4(positionMm, 1.0));
    gl_Position = clipFromTooth * vec4(positionMm, 1.0);
}
