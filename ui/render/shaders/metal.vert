#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 finish;  // material; angle about the axis

uniform mat4 clipFromTooth;
uniform mat4 toothFromPart;
uniform float topMm;     // upper end of the part; higher vertices are moved down to it
uniform vec4 clipPlane;  // clip plane of the mirror, tooth frame; zero: no clipping

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
