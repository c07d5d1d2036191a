#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of one or two eyes become what the screen shows.
in vec2 place;  // -1 .. 1
uniform sampler2D leftEye;
uniform sampler2D rightEye;
uniform int stereo;  // as render::Stereo
uniform vec2 flip;   // 1: that axis is turned over

out vec4 colour;

// Least squares of what an eye sees through each filter of red and cyan glasses on a common display: Dubois, ICASSP
// 2001. Columns are red, green and blue of the eye's picture.
const mat3 kLeft = mat3(0.4561, -0.0401, -0.0152, 0.5005, -0.0378, -0.0206, 0.1764, -0.0158, -0.0055);
const mat3 kRight = mat3(-0.0435, 0.3785, -0.0722, -0.0879, 0.7336, -0.1130, -0.0016, -0.0185, 1.2264);
const vec3 kGrey = vec3(0.299, 0.587, 0.114);

void main()
{
    vec2 at = mix(0.5 + 0.5 * place, 0.5 - 0.5 * place, flip);
    vec3 seen;
    if (stereo == 3) {
        seen = at.x < 0.5 ? texture(leftEye, vec2(2.0 * at.x, at.y)).rgb
                          : texture(rightEye, vec2(2.0 * at.x - 1.0, at.y)).rgb;
    } else if (stereo == 4) {
        seen = at.y >= 0.5 ? texture(leftEye, vec2(at.x, 2.0 * at.y - 1.0)).rgb
                           : texture(rightEye, vec2(at.x, 2.0 * at.y)).rgb;
    } else {
        seen = texture(leftEye, at).rgb;
        if (stereo != 0) {
            vec3 right = texture(rightEye, at).rgb;
            seen = stereo == 1 ? clamp(kLeft * seen + kRight * right, 0.0, 1.0)
                               : vec3(dot(kGrey, seen), vec2(dot(kGrey, right)));
        }
    }
    colour = vec4(seen, 1.0);
}
