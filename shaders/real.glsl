// SPDX-License-Identifier: MIT
// What numbers.glsl, lights.glsl, looks.glsl and film.glsl are written with. They are read as GLSL
// here and in the page, and as C++ where the processor draws (render/raster/lanes/shading.hpp), so that a
// picture looks the same with every backend. `real` differs from pixel to pixel, where C++ has several
// of them at once; `float` is the same all over a sphere or triangle. No branch depends on a `real`,
// no swizzle is written to, and every number has its F: GLSL ES turns no int into a float.

#define INLINE
#define real float
#define real3 vec3
#define truth bool

const float kWhite = 1.0F; // a full channel

float select(bool which, float a, float b)
{
    return which ? a : b;
}
