#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 finish;  // what it is made of; angle about the axis

uniform mat4 clipFromTooth;
uniform mat4 toothFromPart;
uniform float topMm;     // of the part; what is higher is pushed down to here
uniform vec4 clipPlane;  // of the mirror, tooth frame; zero: nothing is cut off

out vec3 positionMm;
out vec3 normalInTooth;
out vec2 onPart;
out float finishHere;

void main()
{
    vec4 placed = toothFromPart * vec4(position.xy, min(position.z, topMm), 1.0);
    positionMm = placed.xyz;
    normalInTooth = mat3(toothFromPart) * normal;
    onPart = vec2(finish.y, position.z);
    finishHere = finish.x;
    gl_ClipDistance[0] = dot(clipPlane, placed);
    gl_Position = clipFromTooth * placed;
}
