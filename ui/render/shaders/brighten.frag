#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
in float halfBrighter;
out vec4 colour;

void main()
{
    // The blend function is twice source times destination, so the factor can exceed one. Noise of half a step of the
    // display prevents visible bands in soft shadows.
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(vec3(halfBrighter * (1.0 + 0.006 * grain)), 1.0);
}
