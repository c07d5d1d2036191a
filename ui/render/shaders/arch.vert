#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
layout(location = 3) in float tissue;
layout(location = 4) in float shown;

uniform mat4 clipFromPiece;
uniform vec4 clipPlane;       // scene frame; zero: no clipping
uniform mat4 sceneFromPiece;  // rotates and mirrors, does not scale

out vec3 positionMm;
out vec3 normalInScene;
out float openHere;
out float tissueHere;
out float shownHere;
out float neckwards;  // 0 at the tip of the tooth, 1 from 9 mm below it

void main()
{
    positionMm = (sceneFromPiece * vec4(position, 1.0)).xyz;
    normalInScene = mat3(sceneFromPiece) * normal;
    openHere = open;
    tissueHere = tissue;
    shownHere = shown;
    neckwards = clamp(-position.z / 9.0, 0.0, 1.0);
    gl_ClipDistance[0] = dot(clipPlane, vec4(positionMm, 1.0));
    gl_Position = clipFromPiece * vec4(position, 1.0);
}
