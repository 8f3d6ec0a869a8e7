// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/view.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace frostfill
{

/// A sphere as it is drawn, in unit space.
struct SphereInstance
{
    float x, y, z, radius;
    std::uint32_t state; ///< with an axis, see stateOf and axisOf in shaders/looks.glsl
    Colour colour{};
    friend bool operator==(const SphereInstance&, const SphereInstance&) = default;
};

/// The ambient occlusion of one sphere.
struct SphereLight
{
    /// The neighbours that hide most from it: the way to their centres and their radii, over
    /// shading::kOccluderRange times its own radius, -127..127 for -1..1. All 0: there is none.
    std::array<std::array<std::int8_t, 4>, 12> occluders{};
    /// What all others let through to it, 0..255 for 0..1: of the sky, of the lamp.
    std::array<std::uint8_t, 4> open{255, 255, 0, 0};

    friend bool operator==(const SphereLight&, const SphereLight&) = default;
};

/// What spheres are drawn with beside themselves.
struct SphereUniforms
{
    glm::mat4 view{1};
    glm::mat4 projection{1};
    float depthAtInfinity = 0;
    float depthSlope = 0;
    float pixelScale = 1;  ///< pixels in a length of 1 at distance 1
    float supersample = 1; ///< drawn for one pixel of the picture, each way
    glm::vec4 heightPlane{0, 0, 0, 1};
    glm::vec4 distancePlane{0};
    float haze = 0;
    glm::vec3 lamp{0, 0, 1};              ///< towards it, in eye space; studio
    glm::vec3 above{0, 1, 0};             ///< away from the ground, in eye space; studio
    std::array<glm::vec4, 2> cutPlanes{}; ///< in eye space; see CutPlanes
};

/// What decides which programs draw spheres and mesh.
struct ShaderVariant
{
    bool orthographic = false;
    bool cutaway = false;
    bool outlines = false;    ///< around every sphere: for print
    bool fadingLines = false; ///< the shell's lines suit triangles of any size
    bool occlusion = false;   ///< with ambient occlusion
    bool studio = false;      ///< with that and a lamp
};

/// For passes that show no colours.
[[nodiscard]] inline ShaderVariant shapesOnly(ShaderVariant variant)
{
    variant.occlusion = variant.studio = false;
    return variant;
}

[[nodiscard]] inline glm::vec4 toVector(const Colour& colour)
{
    return glm::vec4(colour[0], colour[1], colour[2], colour[3]) / 255.0F;
}

} // namespace frostfill
