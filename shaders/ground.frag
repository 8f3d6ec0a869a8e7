// SPDX-License-Identifier: MIT
// Shadow on the ground.

in float dark;

out vec4 colour;

void main()
{
    colour = vec4(dark * kShadow, dark); // premultiplied
}
