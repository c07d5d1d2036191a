#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Shades the teeth and gums of the mouth, lit as in tooth.frag.
in vec3 positionMm;
in vec3 normalInScene;
in float openHere;
in float tissueHere;  // 0 enamel, 1 root, 2 gum, 3 mucosa
in float neckwards;
in float shownHere;  // 1: opaque, 0: faded into the background

uniform vec3 eyeMm;
uniform vec3 towardsLight;
uniform vec3 towardsSky;
uniform vec2 highlight;  // x: selected, y: hovered
uniform float dimmed;    // darkens the pieces around the tooth being worked on

out vec4 colour;

// Linear colours; enamel and dentin as in tooth.frag.
const vec3 kEnamel = vec3(0.89, 0.83, 0.71);
const vec3 kNeckEnamel = vec3(0.85, 0.74, 0.54);
const vec3 kDentin = vec3(0.84, 0.65, 0.36);
const vec3 kGum = vec3(0.66, 0.285, 0.265);
const vec3 kMucosa = vec3(0.58, 0.20, 0.19);
const vec3 kChosen = vec3(0.10, 0.62, 0.62);

const vec3 kLamp = vec3(1.0, 0.97, 0.91);
const vec3 kSky = vec3(0.86, 0.93, 1.0);
const vec3 kGround = vec3(0.50, 0.36, 0.31);

void main()
{
    vec3 normal = normalize(normalInScene);
    vec3 towardsEye = normalize(eyeMm - positionMm);
    if (!gl_FrontFacing)
        normal = -normal;
    float soft = smoothstep(1.4, 1.6, tissueHere);
    float root = smoothstep(0.3, 0.9, tissueHere) * (1.0 - soft);
    vec3 enamel = mix(kEnamel, kNeckEnamel, smoothstep(0.45, 1.0, neckwards));
    vec3 base = mix(enamel, kDentin, root);
    base = mix(base, mix(kGum, kMucosa, smoothstep(2.1, 2.9, tissueHere)), soft);

    float open = openHere;
    // Slightly stains the enamel in pits and fissures, which see little of the sky.
    base *= mix(vec3(0.62, 0.52, 0.40), vec3(1.0), mix(smoothstep(0.25, 0.62, open), 1.0, soft));
    float facingEye = max(dot(normal, towardsEye), 0.0);
    float wrap = mix(0.35, 0.5, soft);
    float lamp = max((dot(normal, towardsLight) + wrap) / (1.0 + wrap), 0.0);
    lamp *= lamp * 0.35 + 0.65;
    lamp *= mix(0.35, 1.0, open);
    vec3 warm = mix(vec3(1.0, 0.90, 0.78), vec3(1.0), smoothstep(0.0, 0.6, lamp));
    float head = facingEye * mix(open, 1.0, 0.3);
    vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * dot(normal, towardsSky)) * open;
    vec3 lit = base * (0.72 * lamp * kLamp * warm + 0.22 * head + 0.27 * sky);
    // Light reflected between pink surfaces.
    lit += base * base * (1.0 - open) * 0.10;

    // Gloss: polished enamel, moist gum.
    float polish = 1.0 - root;
    float glance = max(dot(normal, normalize(towardsLight + towardsEye)), 0.0);
    glance *= glance;
    glance *= glance;
    float glance8 = glance * glance;
    float glance16 = glance8 * glance8;
    float glance32 = glance16 * glance16;
    float glance128 = glance32 * glance32 * glance32 * glance32;
    float shine = mix(0.42 * glance128 + 0.09 * glance16, 0.16 * glance32 + 0.05 * glance8, soft) * polish;
    float grazing = 1.0 - facingEye;
    grazing *= grazing * grazing;
    lit += kLamp * shine * open;
    lit += mix(vec3(0.085, 0.10, 0.12), vec3(0.10, 0.035, 0.03), soft) * grazing * polish * open;

    lit = mix(lit, lit * kChosen * 1.25 + kChosen * 0.12 * grazing, 0.8 * highlight.x);
    lit += highlight.y * (0.10 + 0.25 * grazing) * vec3(0.75, 1.0, 1.0);
    // Dimming: darker and greyer.
    lit = mix(lit, vec3(dot(lit, vec3(0.3, 0.5, 0.2))) * 0.55, dimmed);
    if (!gl_FrontFacing)
        lit *= 0.7;
    colour = vec4(sqrt(lit / (1.0 + 0.16 * lit * lit)), shownHere);
}
