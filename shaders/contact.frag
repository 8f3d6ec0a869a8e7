// SPDX-License-Identifier: MIT
// Shadow of a sphere on the wall that it touches.

in vec2 beside;
flat in vec4 shadow;

out vec4 colour;

void main()
{
    float dark = contactShadow(beside.x, beside.y, shadow.x, shadow.y, shadow.z, shadow.w);
    colour = vec4(dark * kShadow, dark); // premultiplied
}
