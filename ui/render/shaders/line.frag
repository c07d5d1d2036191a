#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
in float along;
uniform vec4 tint;

out vec4 colour;

void main()
{
    colour = vec4(tint.rgb, tint.a * (0.35 + 0.65 * along));
}
