#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Computes how bur and handpiece change the light on the upper surface: their shadows under the operating light, and
// the light of the handpiece's lamp. One pixel per lattice node: half the factor of its brightness.
uniform sampler2D places;   // x, y as drawn, mm
uniform sampler2D heights;  // as drawn, mm
uniform sampler2D normals;  // x, y of the unit normal
uniform sampler2D light;    // openness to the sky, operating light, cut, crevice
uniform vec3 lattice;       // x, y of the first node, mm; nodes per mm
uniform vec3 towardsLight;
uniform vec3 tipMm;         // tip of the bur
uniform vec4 castFrom[5];   // rods that cast the shadow: start, mm, and radius
uniform vec4 castTo[5];     // end, mm, and the largest share of light that the rod blocks
uniform float penumbra;     // half-width of the penumbra per millimetre of height
uniform float softestMm;    // least half-width of a shadow's edge
uniform float lampReachMm;  // reach of the lamp's light around the bur
uniform vec3 burLampMm;     // position of the handpiece's lamp
uniform float burLamp;      // 1 on, 0 off

out vec4 colour;

/// Returns the share of the operating light that a rod blocks at a point.
float shadowOf(vec3 from, vec3 begin, vec3 end, float radius)
{
    vec3 rod = end - begin;
    vec3 away = from - begin;
    float e = dot(rod, rod);
    float b = dot(towardsLight, rod);
    float c = dot(towardsLight, away);
    float f = dot(rod, away);
    float along = max((b * f - c * e) / max(e - b * b, 1.0e-4), 0.0);
    float on = clamp((b * along + f) / e, 0.0, 1.0);
    along = max(b * on - c, 0.0);
    float near = length(away + towardsLight * along - rod * on);
    float soft = penumbra * along + softestMm;
    return min(1.0, radius / soft) * (1.0 - smoothstep(radius - soft, radius + soft, near));
}

/// Returns the share of the lamp's light that arrives at a surface whose normal has this z. Ground in between blocks it
/// gradually.
float burLightAt(vec3 from, float slope)
{
    float side = float(textureSize(heights, 0).x);
    vec3 way = burLampMm - from;
    float open = 1.0;
    for (int k = 1; k <= 10; ++k) {
        vec3 at = from + way * (0.012 * float(k * k) + 0.01);
        float ground = textureLod(heights, ((at.xy - lattice.xy) * lattice.z + 0.5) / side, 0.0).r;
        // On a flank, ground above the ray counts less.
        float over = (ground - at.z) * slope;
        open = min(open, 1.0 - smoothstep(0.0, 0.25 + 0.02 * float(k * k), over));
    }
    return open;
}

void main()
{
    ivec2 node = ivec2(gl_FragCoord.xy);
    vec3 positionMm = vec3(texelFetch(places, node, 0).rg, texelFetch(heights, node, 0).r);
    vec2 across = texelFetch(normals, node, 0).rg;
    vec3 normal = vec3(across, sqrt(max(1.0 - dot(across, across), 0.0)));
    vec4 shade = texelFetch(light, node, 0);

    // The light without bur and handpiece, as in tooth.frag.
    float open = shade.r * sqrt(shade.r);
    float lamp = max((dot(normal, towardsLight) + 0.35) / 1.35, 0.0);
    lamp *= lamp * 0.35 + 0.65;
    lamp *= 0.72 * mix(0.24, 1.0, shade.g) * mix(open, 1.0, 0.5);
    float head = 0.18 * normal.z * mix(open, 1.0, 0.35);  // for an eye above the tooth, the usual viewpoint
    float all = lamp + head + 0.22 * open + 0.04;

    float arrives = 1.0;
    for (int k = 0; k < 5; ++k)
        arrives *= 1.0 - castTo[k].w * shadowOf(positionMm, castFrom[k].xyz, castTo[k].xyz, castFrom[k].w);
    float now = all - lamp * (1.0 - arrives);
    if (burLamp > 0.0) {
        vec3 way = burLampMm - positionMm;
        float away2 = dot(way, way);
        float own = max(dot(normal, way) * inversesqrt(away2), 0.0) * 90.0 / (away2 + 20.0);
        own *= (1.0 - smoothstep(2.0, lampReachMm, length(positionMm.xy - tipMm.xy))) * burLightAt(positionMm + normal * 0.05, normal.z);
        now += 0.3 * own;
    }
    // The lower surface has no such map, so the changes on the upper one fade towards the height of contour.
    colour = vec4(0.5 * mix(1.0, sqrt(now / all), smoothstep(0.0, 0.35, normal.z)));
}
