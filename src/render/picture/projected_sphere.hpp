// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/picture/sphere_instance.hpp"

#include <cstdint>

namespace frostfill
{

/// Where a sphere can be seen at most, and no nearer than where.
struct ProjectedSphere
{
    PixelRectangle pixels;   ///< clipped to the picture; empty when the sphere is out of view
    float furthestDepth = 2; ///< window depth; no visible point of the sphere has a larger one
    float nearestDepth = 0;  ///< window depth; no visible point of the sphere has a smaller one
    float ahead = 0;         ///< of the centre from the plane of the eye [unit]; perspective
};

/// Projects spheres with the numbers that are the same for all of them worked out beforehand.
/// Bounds are safe by a pixel and some rounding, never exact.
class SphereProjector
{
public:
    SphereProjector(const Framing& framing, const PictureSize& size);

    [[nodiscard]] ProjectedSphere project(const SphereInstance& sphere) const;

private:
    [[nodiscard]] PixelRectangle wholePicture() const { return {0, 0, width_, height_}; }
    [[nodiscard]] ProjectedSphere perspective(const glm::vec3& centre, float radius) const;
    [[nodiscard]] ProjectedSphere orthographic(const glm::vec3& centre, float radius) const;
    [[nodiscard]] PixelRectangle pixels(float left, float right, float bottom, float top) const;

    glm::mat4 view_;
    glm::mat4 projection_;
    bool orthographic_;
    int width_;
    int height_;
    float depthSlack_;
};

/// What a cutaway leaves of a sphere. Most are whole or gone: those are drawn, or not, as without
/// one, at a quarter of the cost.
enum class CutShare : std::uint8_t
{
    whole,
    part,
    nothing,
};

/// By the planes of the uniforms.
[[nodiscard]] CutShare cutShareOf(const SphereInstance& sphere, const SphereUniforms& uniforms);

} // namespace frostfill
