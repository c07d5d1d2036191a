#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Shades the mirror's glass. The reflection has been drawn from the eye, so each pixel uses the one at its own
// position.
in vec2 onGlass;
uniform sampler2D reflection;
uniform vec2 sizePx;

out vec4 colour;

void main()
{
    vec3 seen = texture(reflection, gl_FragCoord.xy / sizePx).rgb;
    float edge = smoothstep(0.90, 1.0, length(onGlass));
    colour = vec4(mix(seen * 0.94 + 0.012, vec3(0.16), edge), 1.0);
}
