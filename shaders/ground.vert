// SPDX-License-Identifier: MIT
// The studio's ground: only its shadow is seen.

layout(location = 0) in vec4 place; // position, and how dark it is there

uniform mat4 view;
uniform mat4 projection;

out float dark;

void main()
{
    dark = place.w;
    gl_Position = projection * (view * vec4(place.xyz, 1.0));
}
