// SPDX-License-Identifier: MIT
#pragma once

#include "render/passes/sphere_pass.hpp"
#include "render/picture/surfaces.hpp"

#include <vector>

namespace frostfill
{

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

} // namespace frostfill
