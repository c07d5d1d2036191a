#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The empty room.
in vec2 place;

out vec4 colour;

vec3 roomColour(vec2 place);

void main()
{
    colour = vec4(roomColour(place), 1.0);
}
