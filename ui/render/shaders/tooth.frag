#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Shades a tooth under an operating light: finds the material at this height of the column, and how it reflects light.
in vec3 positionMm;
in vec3 normalHere;
in vec4 shadeHere;    // openness to the sky, operating light, cut, crevice
in float cutMm;       // depth below the uncut surface
in float tooDeepMm;   // depth below the ideal surface
in float enamelHere;  // enamel above the dentin, mm; on flanks more accurate than the map
in float bloodHere;   // of an opened pulp, 1 where it covers the surface
in vec2 onLattice;
uniform sampler2D upperLayers;  // roof and floor of the decay, dentin, roof of the pulp; heights in mm
uniform sampler2D lowerLayers;  // floor of the pulp, mm; share of decayed columns around; uncut, mm; share of open ones

uniform sampler2D ideal;        // depth of the ideal surface below the uncut one; distance outside its outline, mm

uniform float facing;          // 1 upper surface, -1 lower
uniform vec3 eyeMm;
uniform vec3 towardsLight;
uniform bool decayZones;       // decay in dentin is soft, leathery and firm
uniform bool distinct;         // colours and patterns that are easy to distinguish
uniform float wet;             // 1 under a film of water
uniform int depthColours;      // 0 none, 1 below the uncut surface, 2 against the ideal one
uniform bool idealOutline;     // line around the area that the ideal removes
uniform float scaleMm;         // end of the depth scale
uniform vec2 fadeMm;           // heights between which the root fades into the background, like the gum around it

out vec4 colour;

// Linear colours.
const vec3 kEnamel = vec3(0.89, 0.83, 0.71);
const vec3 kCutEnamel = vec3(0.96, 0.945, 0.90);
const vec3 kDentin = vec3(0.84, 0.65, 0.36);
const vec3 kDecay = vec3(0.060, 0.026, 0.011);
const vec3 kLeatheryDecay = vec3(0.17, 0.075, 0.028);
const vec3 kFirmDecay = vec3(0.48, 0.29, 0.12);
const vec3 kDecayEdge = vec3(0.36, 0.19, 0.07);
const vec3 kPulp = vec3(0.68, 0.13, 0.14);
const vec3 kBlood = vec3(0.42, 0.012, 0.016);

// Screen colours, as the ideal is drawn in the section.
const vec3 kOutline = vec3(1.0, 0.82, 0.25);
const vec3 kUnderOutline = vec3(0.06, 0.07, 0.08);

const vec3 kLamp = vec3(1.0, 0.97, 0.91);
const vec3 kSky = vec3(0.86, 0.93, 1.0);
const vec3 kGround = vec3(0.50, 0.36, 0.31);  // light reflected by the mouth

/// Stripes and dots of 0.3 mm that are fixed to the tooth. Returns 1 on them, 0 between them.
float stripes(float along)
{
    return smoothstep(0.25, 0.35, abs(fract(along / 0.45) - 0.5));
}

float dots(vec3 at)
{
    vec2 cell = fract((at.xy + vec2(0.6, -0.4) * at.z) / 0.5) - 0.5;
    return 1.0 - smoothstep(0.16, 0.22, length(cell));
}

void main()
{
    vec3 normal = normalize(normalHere);
    vec4 shade = shadeHere;

    // Materials; the first match wins: decay, pulp, enamel, dentin. Edges are soft over a few hundredths of a
    // millimetre.
    vec4 upper = texture(upperLayers, onLattice);
    vec4 lower = texture(lowerLayers, onLattice);
    float z = positionMm.z;
    float enamelMm = facing > 0.0 ? z - upper.z : enamelHere;
    float inDecay = smoothstep(-0.12, 0.0, upper.x - z) * smoothstep(0.0, 0.12, z - upper.y) *
                    smoothstep(0.3, 0.7, lower.y);
    float inPulp = smoothstep(0.0, 0.06, min(upper.w - z, z - lower.x));
    // At the neck the enamel becomes thin. Its edge is soft there, so that the steps of the lattice are invisible.
    float edgeMm = facing > 0.0 ? 0.03 : 0.3;
    float isEnamel = smoothstep(-edgeMm, edgeMm, enamelMm);
    float cut = shade.b;
    vec3 enamel = mix(kEnamel, kCutEnamel, 0.75 * cut);
    // Dentin shines through thin enamel. On a flank the enamel below a point is thicker than the enamel behind it.
    float thick = mix(5.0, 1.5, normal.z * normal.z);
    enamel = mix(mix(kDentin, enamel, 0.6), enamel, smoothstep(0.0, thick, enamelMm));
    vec3 base = mix(kDentin, enamel, isEnamel);
    base = mix(base, kPulp, inPulp);
    // The tissue around an open lesion is stained.
    base = mix(base, kDecayEdge, 0.8 * smoothstep(0.0, 0.35, lower.w) * smoothstep(0.0, 0.12, z - upper.y));
    vec3 decay = kDecay;
    // The firm zone is the lowest 0.5 mm in dentin, the leathery one the next 0.5 mm (core/terrain/DecayZones.h).
    float inDentin = decayZones ? 1.0 - smoothstep(0.0, 0.1, z - upper.z) : 0.0;
    float leathery = inDentin * (1.0 - smoothstep(0.95, 1.05, z - upper.y));
    float firm = inDentin * (1.0 - smoothstep(0.45, 0.55, z - upper.y));
    decay = mix(mix(decay, kLeatheryDecay, leathery), kFirmDecay, firm);
    base = mix(base, mix(kDecayEdge, decay, smoothstep(0.15, 0.8, inDecay)), smoothstep(0.0, 0.5, inDecay));
    if (distinct) {
        vec3 at = positionMm;
        base = mix(mix(vec3(0.78, 0.36, 0.0), vec3(0.60, 0.25, 0.0), stripes(at.x + at.y)), vec3(0.86, 0.80, 0.30), isEnamel);
        base = mix(base, mix(vec3(0.58, 0.19, 0.38), vec3(0.93, 0.60, 0.78), dots(at)), inPulp);
        vec3 striped = mix(vec3(0.0, 0.16, 0.44), vec3(0.10, 0.42, 0.80), stripes(at.x - at.y + 0.5 * at.z));
        base = mix(base, mix(striped, vec3(1.0), 0.25 * (leathery + firm)), smoothstep(0.2, 0.5, inDecay));
    }
    bool isScale = depthColours > 0;
    if (isScale) {
        // Grey where nothing is cut or left to cut; otherwise from blue through white to vermilion. Both ends are
        // equally dark.
        float deep = depthColours == 1 ? cutMm / scaleMm : 0.5 + 0.5 * tooDeepMm / scaleMm;
        float told = smoothstep(0.015, 0.05, cutMm);
        if (depthColours == 2)
            told = max(told, smoothstep(0.02, 0.06, abs(tooDeepMm)));
        vec3 scale = mix(vec3(0.13, 0.35, 0.68), vec3(0.90, 0.90, 0.86), smoothstep(0.0, 0.5, deep));
        scale = mix(scale, vec3(0.72, 0.14, 0.03), smoothstep(0.5, 1.0, deep));
        base = mix(vec3(0.34), scale, facing > 0.0 ? told : 0.0);
    }
    // Blood lies on any material and on any colours.
    float blood = smoothstep(0.1, 0.6, bloodHere);
    base = mix(base, distinct ? mix(vec3(0.58, 0.19, 0.38), vec3(0.93, 0.60, 0.78), dots(positionMm)) : kBlood, blood);
    float hard = (1.0 - inDecay) * (1.0 - inPulp) * isEnamel;

    // Fissures are slightly stained, and receive less light than the sky map shows.
    float crevice = clamp(2.0 * shade.a - 1.0, -1.0, 1.0);
    float stain = isScale ? 0.0 : smoothstep(0.06, 0.34, crevice) * (1.0 - cut);
    base *= mix(vec3(1.0), vec3(0.50, 0.38, 0.26), stain);
    float open = shade.r * sqrt(shade.r) * (1.0 - 0.35 * smoothstep(0.03, 0.42, crevice));

    base *= 1.0 - 0.12 * wet;

    vec3 towardsEye = normalize(eyeMm - positionMm);
    float facingEye = max(dot(normal, towardsEye), 0.0);

    // The operating light wraps around edges, because enamel and dentin scatter it. Where it fades it is warmer.
    float lamp = max((dot(normal, towardsLight) + 0.35) / 1.35, 0.0);
    lamp *= lamp * 0.35 + 0.65;
    lamp *= mix(0.24, 1.0, shade.g);
    vec3 warm = mix(vec3(1.0, 0.90, 0.78), vec3(1.0), smoothstep(0.0, 0.6, lamp));
    float head = facingEye * mix(open, 1.0, 0.35);
    vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * normal.z) * open;
    vec3 lit = base * (0.72 * lamp * mix(open, 1.0, 0.5) * kLamp * warm + 0.22 * head + 0.27 * sky);
    // Depth colours are shaded less, so that they can be compared with the scale.
    if (isScale)
        lit = mix(lit, base * 0.9, 0.65);
    // Light reflected in a cavity takes on the colour of its walls, and so does light scattered into a shadow.
    lit += base * base * ((1.0 - open) * 0.10 + (1.0 - shade.g) * 0.10) * vec3(1.0, 0.90, 0.74);

    // Gloss: polished enamel, frosted where cut; matt dentin.
    float polish = max(hard * (1.0 - 0.85 * cut) * (1.0 - stain), 0.9 * max(wet, blood));
    vec3 halfLamp = normalize(towardsLight + towardsEye);
    // Powers of two by squaring, because pow() takes a software driver ten times as long.
    float glance = max(dot(normal, halfLamp), 0.0);
    glance *= glance;
    glance *= glance;
    float glance8 = glance * glance;
    float glance16 = glance8 * glance8;
    float glance32 = glance16 * glance16;
    float glance128 = glance32 * glance32 * glance32 * glance32;
    float shine = mix(0.05 * glance8 * glance, (0.42 + 0.5 * wet) * glance128 + 0.09 * glance16, polish);
    float straight = facingEye * facingEye;
    straight *= straight;
    straight *= straight;
    straight *= straight;
    straight *= straight;
    float headShine = 0.10 * polish * straight * straight;
    float grazing = 1.0 - facingEye;
    grazing *= grazing * grazing;
    lit += kLamp * (shine * shade.g + headShine) * open;
    // Translucent edges: cool and slightly bright where the enamel is seen at a grazing angle.
    lit += vec3(0.085, 0.10, 0.12) * grazing * polish * open;

    colour = vec4(sqrt(lit / (1.0 + 0.16 * lit * lit)), smoothstep(fadeMm.y, fadeMm.x, z));
    if (idealOutline && facing > 0.0) {
        float outsideMm = texture(ideal, onLattice).g;
        float awayMm = abs(outsideMm);
        float pixelMm = max(length(vec2(dFdx(outsideMm), dFdy(outsideMm))), 1e-4);
        float halfMm = max(0.03, 0.8 * pixelMm);
        float uncut = 1.0 - smoothstep(0.02, 0.06, cutMm);
        float under = 1.0 - smoothstep(2.0 * halfMm - 0.5 * pixelMm, 2.0 * halfMm + 0.5 * pixelMm, awayMm);
        float line = 1.0 - smoothstep(halfMm - 0.5 * pixelMm, halfMm + 0.5 * pixelMm, awayMm);
        colour.rgb = mix(mix(colour.rgb, kUnderOutline, 0.7 * under * uncut), kOutline, line * uncut);
    }
}
