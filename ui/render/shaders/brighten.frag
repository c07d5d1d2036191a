#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
in float halfBrighter;
out vec4 colour;

void main()
{
    // Blended as twice source times destination, so that it can also be more than one.
    colour = vec4(vec3(halfBrighter), 1.0);
}
