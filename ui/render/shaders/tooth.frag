#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A tooth under an operating light: what material lies at this height of this column, and how it takes the light.
in vec3 positionMm;
in vec2 across;       // x, y of the normal
in vec4 shadeHere;    // openness to the sky, operating light, cut, crevice
in vec2 onLattice;
uniform sampler2D upperLayers;  // roof and floor of the decay, dentin, roof of the pulp; heights in mm
uniform sampler2D lowerLayers;  // floor of the pulp, mm; share of decayed columns around

uniform float facing;          // 1 upper surface, -1 lower
uniform vec3 eyeMm;
uniform vec3 towardsLight;
uniform vec3 tipMm;            // of the bur
uniform float burShadowMm;     // radius of its soft shadow, 0: none

out vec4 colour;

// Linear light.
const vec3 kEnamel = vec3(0.89, 0.83, 0.71);
const vec3 kCutEnamel = vec3(0.96, 0.945, 0.90);
const vec3 kDentin = vec3(0.84, 0.65, 0.36);
const vec3 kDecay = vec3(0.060, 0.026, 0.011);
const vec3 kDecayEdge = vec3(0.36, 0.19, 0.07);
const vec3 kPulp = vec3(0.68, 0.13, 0.14);

const vec3 kLamp = vec3(1.0, 0.97, 0.91);
const vec3 kSky = vec3(0.86, 0.93, 1.0);
const vec3 kGround = vec3(0.50, 0.36, 0.31);  // what the mouth throws back

void main()
{
    vec3 normal = normalize(vec3(across, facing * sqrt(max(1.0 - dot(across, across), 0.0))));
    vec4 shade = shadeHere;
    // The map of light is the upper surface's; from the rim downwards the lower one leaves it.
    if (facing < 0.0)
        shade = mix(shade, vec4(0.8, 0.6, 0.0, 0.5), smoothstep(0.0, 0.8, -normal.z));

    // Materials, first match wins: decay, pulp, enamel, dentin. Edges a few hundredths of a millimetre soft.
    vec4 upper = texture(upperLayers, onLattice);
    vec2 lower = texture(lowerLayers, onLattice).rg;
    float z = positionMm.z;
    float enamelMm = z - upper.z;
    float inDecay = smoothstep(-0.05, 0.0, upper.x - z) * smoothstep(0.0, 0.12, z - upper.y) *
                    smoothstep(0.3, 0.7, lower.y);
    float inPulp = smoothstep(0.0, 0.06, min(upper.w - z, z - lower.x));
    float isEnamel = smoothstep(-0.03, 0.03, enamelMm);
    float cut = shade.b;
    vec3 enamel = mix(kEnamel, kCutEnamel, 0.75 * cut);
    // Dentin shines through thin enamel.
    enamel = mix(mix(kDentin, enamel, 0.6), enamel, smoothstep(0.0, 1.5, enamelMm));
    vec3 base = mix(kDentin, enamel, isEnamel);
    base = mix(base, kPulp, inPulp);
    base = mix(base, mix(kDecayEdge, kDecay, smoothstep(0.15, 0.8, inDecay)), smoothstep(0.0, 0.5, inDecay));
    float hard = (1.0 - inDecay) * (1.0 - inPulp) * isEnamel;

    // Fissures are stained a little, and hold less light than the map of the sky can tell.
    float crevice = clamp(2.0 * shade.a - 1.0, -1.0, 1.0);
    float stain = smoothstep(0.12, 0.5, crevice) * (1.0 - cut);
    base *= mix(vec3(1.0), vec3(0.50, 0.38, 0.26), stain);
    float open = shade.r * sqrt(shade.r) * (1.0 - 0.35 * smoothstep(0.05, 0.6, crevice));

    vec3 towardsEye = normalize(eyeMm - positionMm);
    float facingEye = max(dot(normal, towardsEye), 0.0);

    // The operating light wraps around: enamel and dentin scatter it within, and where it fades it is warmer.
    float lamp = max((dot(normal, towardsLight) + 0.35) / 1.35, 0.0);
    lamp *= lamp * 0.35 + 0.65;
    lamp *= mix(0.24, 1.0, shade.g);
    if (burShadowMm > 0.0 && facing > 0.0) {
        float below = max(tipMm.z - positionMm.z, 0.0);
        vec2 away = positionMm.xy - (tipMm.xy - towardsLight.xy / towardsLight.z * below * 0.5);
        float radius = burShadowMm + 0.35 * below;
        float near = max(1.0 - dot(away, away) / (3.0 * radius * radius), 0.0);
        lamp *= 1.0 - 0.6 * near * near * burShadowMm / (burShadowMm + 0.3 * below);
    }
    vec3 warm = mix(vec3(1.0, 0.90, 0.78), vec3(1.0), smoothstep(0.0, 0.6, lamp));
    float head = facingEye * mix(open, 1.0, 0.35);
    vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * normal.z) * open;
    vec3 lit = base * (0.72 * lamp * mix(open, 1.0, 0.5) * kLamp * warm + 0.22 * head + 0.27 * sky);
    // Light bounced about in a cavity takes the colour of its walls, and so does what wanders within them into a shadow.
    lit += base * base * ((1.0 - open) * 0.10 + (1.0 - shade.g) * 0.10) * vec3(1.0, 0.90, 0.74);

    // Gloss: polished enamel, frosted where cut, dull dentin.
    float polish = hard * (1.0 - 0.85 * cut) * (1.0 - stain);
    vec3 halfLamp = normalize(towardsLight + towardsEye);
    // Powers of two by squaring: a software driver takes ten times as long for pow().
    float glance = max(dot(normal, halfLamp), 0.0);
    glance *= glance;
    glance *= glance;
    float glance8 = glance * glance;
    float glance16 = glance8 * glance8;
    float glance32 = glance16 * glance16;
    float glance128 = glance32 * glance32 * glance32 * glance32;
    float shine = mix(0.05 * glance8 * glance, 0.42 * glance128 + 0.09 * glance16, polish);
    float straight = facingEye * facingEye;
    straight *= straight;
    straight *= straight;
    straight *= straight;
    straight *= straight;
    float headShine = 0.10 * polish * straight * straight;
    float grazing = 1.0 - facingEye;
    grazing *= grazing * grazing;
    lit += kLamp * (shine * shade.g + headShine) * open;
    // Translucent edges: cool and faintly bright where the enamel is seen edge on.
    lit += vec3(0.085, 0.10, 0.12) * grazing * polish * open;

    colour = vec4(sqrt(lit / (1.0 + 0.16 * lit * lit)), 1.0);
}
