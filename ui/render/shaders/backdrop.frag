#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Shades the practice room: neutral dark grey, slightly lighter where the lamp points, darker towards the corners.
in vec2 place;
uniform vec2 crown;  // position of the tooth, clip coordinates
uniform float aspect;

out vec4 colour;

void main()
{
    vec2 away = (place - crown) * vec2(aspect, 1.0);
    float lamp = 1.0 / (1.0 + 0.4 * dot(away, away));
    lamp *= lamp;
    float grey = mix(0.115, 0.165, 0.5 + 0.5 * place.y) + 0.075 * lamp;
    grey *= 1.0 - 0.10 * dot(place, place) * 0.5;
    // Noise below one step of the display prevents visible bands in the gradient.
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(vec3(grey) * vec3(0.97, 0.99, 1.03) + grain / 255.0, 1.0);
}
