// SPDX-License-Identifier: MIT
#pragma once

#include "render/passes/sphere_pass.hpp"

#include <frostfill/snapshot.hpp>

#include <limits>
#include <vector>

namespace frostfill
{

/// What is seen of the spheres in each pixel, top row first.
struct Surfaces
{
    static constexpr float kNothing = std::numeric_limits<float>::infinity();

    int width = 0;
    int height = 0;
    std::vector<float> distance; ///< [height x width] along the view, unit space; or kNothing
    std::vector<std::array<std::uint8_t, 3>> normal; ///< 0..255 for -1..1, in eye space
    std::vector<std::uint32_t> identity;             ///< index of the sphere + 1; or 0
};

/// The spheres of a snapshot in unit space, by id, without colours.
[[nodiscard]] std::vector<SphereInstance> placeSpheres(const Snapshot& snapshot,
                                                       const Framing& framing);

/// Draws the spheres once more, one sample a pixel, for what they are and not how they look. Needs
/// nothing of the picture, so it does not matter how that was drawn.
class SurfacePass
{
public:
    SurfacePass(const GlFunctions& gl, const ShaderVariant& variant, const PictureSize& size);
    ~SurfacePass();
    SurfacePass(const SurfacePass&) = delete;
    SurfacePass& operator=(const SurfacePass&) = delete;

    [[nodiscard]] const PictureSize& size() const { return size_; }
    /// Leaves another framebuffer bound than before.
    void draw(std::span<const SphereInstance> spheres, const SphereUniforms& uniforms,
              Surfaces& surfaces);

private:
    void read(const SphereUniforms& uniforms, Surfaces& surfaces);

    const GlFunctions& gl_;
    PictureSize size_;
    bool orthographic_;
    ShaderProgram program_;
    SphereBuffer buffer_;
    GLuint framebuffer_ = 0;
    std::array<GLuint, 3> renderbuffers_{}; ///< normal, identity, depth
    std::vector<std::uint8_t> bytes_;
    std::vector<float> depth_;
};

/// Nearest and furthest distance that a projection shows, in unit space.
struct DepthLimits
{
    double nearest, furthest;
};
[[nodiscard]] DepthLimits depthLimits(const Framing& framing);

} // namespace frostfill
