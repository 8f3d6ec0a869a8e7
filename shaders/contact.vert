// SPDX-License-Identifier: MIT
// Shadow of a sphere on the wall that it touches: a square in the wall, around a disc as large as the
// sphere.

layout(location = 0) in vec3 place;
layout(location = 1) in vec2 corner; // from where it touches [the sphere's radius]
layout(location = 2) in vec4 numbers; // height, lamp along and away from the wall, strength

uniform mat4 view;
uniform mat4 projection;

out vec2 beside;
flat out vec4 shadow;

void main()
{
    beside = corner;
    shadow = numbers;
    gl_Position = projection * (view * vec4(place, 1.0));
}
