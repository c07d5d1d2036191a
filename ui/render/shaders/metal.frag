#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Shades steel, which reflects a soft sky, a bright lamp and a dark floor.
in vec3 positionMm;
in vec3 normalInTooth;
in vec2 onPart;  // angle about the axis of a turned part, and height
in float finishHere;

uniform vec3 eyeMm;
uniform mat3 eyeRotation;  // eye from tooth
uniform vec3 towardsLight;
uniform float turnRad;     // rotation of the bur
uniform float blur;        // 0: at rest, 1: spinning, blades blurred
uniform float fade;        // 1: opaque, less: transparent
uniform vec4 tint;         // colour of the head, and its opacity
uniform vec2 grains;       // of a diamond bur: grains around its head, and grains per millimetre
uniform vec3 ring;         // colour of the ring on a diamond's shank
uniform vec2 workFrom;     // pixels: the part of the bur that must not be hidden, from its tip
uniform vec2 workTo;
uniform float workRadius;  // radius around that part, pixels; 0: opaque everywhere
uniform float tipAwayMm;   // distance of the tip from the eye

out vec4 colour;

// Powers by squaring, and a bell curve of squares, because pow() and exp() take a software driver ten times as long.
float bell(float t)
{
    float quarter = 1.0 / (1.0 + 0.25 * t);
    quarter *= quarter;
    return quarter * quarter;
}

// Returns two pseudo-random numbers from 0 to 1 for each grain.
vec2 random(ivec2 grain)
{
    uint h = uint(grain.x) * 0x9E3779B1u + uint(grain.y) * 0x85EBCA6Bu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h ^= h >> 13;
    return vec2(float(h & 0xFFFFu), float(h >> 16)) / 65535.0;
}

void main()
{
    vec3 normal = normalize(normalInTooth);
    vec3 towardsEye = normalize(eyeMm - positionMm);
    vec3 base = vec3(0.80, 0.82, 0.85);
    float gloss = 1.0;
    float matt = 0.0;
    if (finishHere > 4.5) {
        base = ring;
        gloss = 0.3;
    } else if (finishHere > 3.5) {
        // Grains in matt nickel, in rows; every other row is shifted by half a grain. Grains smaller than a pixel, and
        // those of a spinning bur, are blurred.
        vec2 place = vec2((onPart.x + turnRad) / 6.2831853 * grains.x, onPart.y * grains.y);
        float sizePx = 1.0 / max(max(fwidth(onPart.x) / 6.2831853 * grains.x, fwidth(place.y)), 1.0e-4);
        place.x += 0.5 * mod(floor(place.y), 2.0);
        ivec2 grain = ivec2(mod(floor(place.x), grains.x), floor(place.y));
        vec2 dice = random(grain);
        float edge = length(fract(place) - 0.5 - 0.4 * (dice - 0.5)) + 0.2 * dice.y;
        float seen = smoothstep(1.0, 3.0, sizePx) * (1.0 - smoothstep(0.0, 0.8, blur));
        float facet = (1.0 - smoothstep(0.30, 0.60, edge)) * (0.35 + 0.65 * dice.x);
        base = vec3(0.78, 0.76, 0.72) * mix(0.70, 0.42 + 0.75 * facet, seen);
        vec3 tangent = normalize(vec3(-normal.y, normal.x, 0.0) + 1.0e-5);
        normal = normalize(normal + seen * 0.9 * ((dice.x - 0.5) * tangent + vec3(0.0, 0.0, dice.y - 0.5)));
        gloss = 0.15 + 0.9 * seen * step(0.85, dice.y) * facet;
        matt = 1.0;
    } else if (finishHere > 1.5) {
        // Six blades along a slight helix. Each is a slope that ends in a step.
        float around = onPart.x + turnRad + 0.55 * onPart.y;
        float blade = fract(around * 6.0 / 6.2831853);
        float groove = smoothstep(0.0, 0.28, blade) * (1.0 - smoothstep(0.86, 1.0, blade));
        vec3 tangent = normalize(vec3(-normal.y, normal.x, 0.0) + 1.0e-5);
        normal = normalize(normal + tangent * (blade - 0.45) * 1.1 * (1.0 - blur));
        if (finishHere > 2.5) {
            // Notches across the blades, staggered from blade to blade.
            float along = onPart.y * 2.2 + 0.5 * mod(floor(around * 6.0 / 6.2831853), 2.0);
            groove *= smoothstep(0.0, 0.10, abs(fract(along) - 0.5) - 0.06);
        }
        base = vec3(0.74, 0.73, 0.71) * mix(mix(0.30, 1.1, groove), 0.9, blur);
    } else if (finishHere > 0.5) {
        base = vec3(0.10, 0.105, 0.115);
        gloss = 0.45;
    }
    base = mix(base, tint.rgb, tint.a);
    gloss *= 1.0 - 0.85 * tint.a;
    // The reflected room as the eye sees it: a soft sky, a long lamp on the left and a thin one on the right. The dark
    // between them makes steel look like steel.
    vec3 seen = eyeRotation * normal;
    float sky = 0.10 + 0.42 * smoothstep(-0.7, 0.95, seen.y);
    float left = seen.x + 0.45;
    float right = seen.x - 0.74;
    float core = seen.x - 0.16;
    float strips = 0.85 * bell(left * left / 0.035) + 0.40 * bell(right * right / 0.010);
    float room = sky * (1.0 - 0.55 * bell(core * core / 0.09)) + strips * (0.55 + 0.45 * seen.y);
    float glance = max(dot(normal, normalize(towardsLight + towardsEye)), 0.0);
    glance *= glance;
    glance *= glance;
    glance *= glance;
    glance *= glance;
    glance *= glance;
    glance *= glance;
    float rim = 1.0 - max(dot(normal, towardsEye), 0.0);
    rim *= rim;
    rim *= rim;
    float lambert = max(dot(normal, towardsLight), 0.0);
    vec3 lit = base * (0.10 + 0.45 * tint.a + 0.14 * lambert + matt * (0.12 + 0.30 * lambert) + gloss * room) +
               gloss * (0.9 * glance + 0.10 * rim);

    float opacity = 1.0;
    if (workRadius > 0.0) {
        vec2 work = workTo - workFrom;
        vec2 here = gl_FragCoord.xy - workFrom;
        float along = clamp(dot(here, work) / max(dot(work, work), 1.0), 0.0, 1.0);
        float away = length(here - work * along) / workRadius;
        // Close to the eye the metal would hide everything, so it fades out.
        float near = smoothstep(0.2, 0.4, length(eyeMm - positionMm) / tipAwayMm);
        opacity = mix(0.14 + 0.5 * rim, 1.0, smoothstep(0.75, 1.25, away)) * near;
    }
    colour = vec4(sqrt(lit / (1.0 + 0.16 * lit * lit)), opacity * fade);
}
