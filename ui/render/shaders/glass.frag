#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// What the mirror shows has been drawn as the eye sees it: each pixel of the glass finds its own there.
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
