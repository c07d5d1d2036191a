#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
in float halfBrighter;
out vec4 colour;

void main()
{
    // Blended as twice source times destination, so that it can also be more than one. The grain is half a step of the
    // display: without it a soft shadow shows bands.
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(vec3(halfBrighter * (1.0 + 0.006 * grain)), 1.0);
}
