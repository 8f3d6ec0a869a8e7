// SPDX-License-Identifier: MIT
// The text of the shaders that says how things look, as C++ for several pixels at once.
#pragma once

#include "render/framing/numbers.hpp"
#include "render/raster/lanes/lanes.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace frostfill::lanes
{

/// Directions, or colours.
struct Vectors
{
    Floats x, y, z;
};

FROSTFILL_INLINE Vectors operator*(Floats a, const Vectors& b)
{
    return {a * b.x, a * b.y, a * b.z};
}

FROSTFILL_INLINE Vectors operator*(const Vectors& a, Floats b)
{
    return b * a;
}

FROSTFILL_INLINE Vectors operator*(const Vectors& a, const Vectors& b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

FROSTFILL_INLINE Vectors operator*(Floats a, const glm::vec3& b)
{
    return {a * b.x, a * b.y, a * b.z};
}

FROSTFILL_INLINE Vectors operator*(const glm::vec3& a, Floats b)
{
    return b * a;
}

FROSTFILL_INLINE Vectors operator+(const Vectors& a, const Vectors& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

FROSTFILL_INLINE Vectors operator+(const Vectors& a, const glm::vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

FROSTFILL_INLINE Vectors operator+(const Vectors& a, Floats b)
{
    return {a.x + b, a.y + b, a.z + b};
}

FROSTFILL_INLINE Vectors operator+(float a, const Vectors& b)
{
    return {a + b.x, a + b.y, a + b.z};
}

FROSTFILL_INLINE Floats dot(const Vectors& a, const Vectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FROSTFILL_INLINE Floats dot(const Vectors& a, const glm::vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FROSTFILL_INLINE Floats abs(Floats value)
{
    return max(value, -value);
}

FROSTFILL_INLINE Floats clamp(Floats value, float least, float most)
{
    return min(max(value, least), most);
}

FROSTFILL_INLINE Floats sqrt(Floats value)
{
    return root(value);
}

FROSTFILL_INLINE Floats mix(Floats a, float b, float share)
{
    return a + (b - a) * share;
}

/// Truncating serves for floor: phases are above -4.
FROSTFILL_INLINE Floats fract(Floats value)
{
    return value - (__builtin_convertvector(__builtin_convertvector(value + 4, Mask), Floats) - 4);
}

FROSTFILL_INLINE Floats select(Mask mask, Floats a, float b)
{
    return select(mask, a, all(b));
}

using glm::clamp;
using glm::cross;
using glm::length;
using glm::max;
using glm::mix;
using glm::normalize;
using glm::smoothstep;

using namespace shading;
using real = Floats;
using real3 = Vectors;
using truth = Mask;
using glm::vec3;

const float kWhite = 255; ///< a full channel

// The texts' own word.
#define INLINE FROSTFILL_INLINE // NOLINT
#include "../../../../shaders/lights.glsl"
// stripes are in film and on spheres
#include "../../../../shaders/film.glsl"
#include "../../../../shaders/looks.glsl"
#include "../../../../shaders/studio.glsl"
#undef INLINE

} // namespace frostfill::lanes
