// SPDX-License-Identifier: MIT
// Shadow on the ground, which has the colour of the background.

in float dark;

out vec4 colour;

void main()
{
    colour = vec4(0.07, 0.08, 0.11, dark);
}
