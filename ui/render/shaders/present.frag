#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Combines the pictures of one or two eyes into the picture on the screen.
in vec2 place;  // -1 .. 1
uniform sampler2D leftEye;
uniform sampler2D rightEye;
uniform int stereo;  // as render::Stereo
uniform vec2 flip;   // 1: flips that axis

out vec4 colour;

// Least-squares approximation of what each eye sees through red and cyan glasses on a common display: Dubois, ICASSP
// 2001. Columns are red, green and blue of the eye's picture.
const mat3 kLeft = mat3(0.4561, -0.0401, -0.0152, 0.5005, -0.0378, -0.0206, 0.1764, -0.0158, -0.0055);
const mat3 kRight = mat3(-0.0435, 0.3785, -0.0722, -0.0879, 0.7336, -0.1130, -0.0016, -0.0185, 1.2264);
const vec3 kGrey = vec3(0.299, 0.587, 0.114);

void main()
{
    vec2 at = mix(0.5 + 0.5 * place, 0.5 - 0.5 * place, flip);
    // Both eyes are read once in every mode, because a software driver executes both sides of every branch.
    bool beside = stereo == 3;
    bool above = stereo == 4;
    vec2 size = vec2(beside ? 2.0 : 1.0, above ? 2.0 : 1.0);
    vec3 left = texture(leftEye, at * size - vec2(0.0, above ? 1.0 : 0.0)).rgb;
    vec3 right = texture(rightEye, at * size - vec2(beside ? 1.0 : 0.0, 0.0)).rgb;
    vec3 seen = (beside && at.x >= 0.5) || (above && at.y < 0.5) ? right : left;
    if (stereo == 1)
        seen = clamp(kLeft * left + kRight * right, 0.0, 1.0);
    if (stereo == 2)
        seen = vec3(dot(kGrey, left), vec2(dot(kGrey, right)));
    colour = vec4(seen, 1.0);
}
