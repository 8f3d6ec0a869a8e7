// SPDX-License-Identifier: MIT
// Room: programs of OpenGL that draw one kind of thing: spheres, the shell, the ground, depth,
// normals, identities. A pass draws what it is given and keeps no history.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "render/picture/sphere_instance.hpp"
#include "render/picture/surfaces.hpp"

#include <frostfill/view.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// Spheres in the memory of OpenGL, each as the four corners of its square: software renderers take
/// twice as long for instances. Owns what it creates.
class SphereBuffer
{
public:
    /// `lit`: with what keeps light from each.
    explicit SphereBuffer(const GlFunctions& gl, bool lit = false);
    ~SphereBuffer();
    SphereBuffer(const SphereBuffer&) = delete;
    SphereBuffer& operator=(const SphereBuffer&) = delete;

    /// Makes the buffer hold these spheres.
    void update(std::span<const SphereInstance> spheres);
    /// [spheres] for a lit buffer, after update().
    void light(std::span<const SphereLight> lights);
    void draw() const;

private:
    const GlFunctions& gl_;
    GLuint array_ = 0;
    std::array<GLuint, 3> buffers_{}; ///< corners, indices, lights
    std::vector<SphereInstance> corners_;
    std::vector<SphereLight> lights_; ///< of the corners
    std::size_t count_ = 0;           ///< of spheres
};

/// Lines for the front of both stages.
[[nodiscard]] std::string definitionsOf(const ShaderVariant& variant);

/// The program that draws spheres exactly, as one square each; sphere.frag has the mathematics.
class SpherePass
{
public:
    SpherePass(const GlFunctions& gl, const ShaderVariant& variant,
               std::span<const glm::vec2> samplePositions, const Style& style, float lineWidth);

    /// Draws with depth test and writing.
    void draw(const SphereBuffer& spheres, const SphereUniforms& uniforms) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
};

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
    std::array<GLuint, 3> renderbuffers_{};             ///< normal, identity, depth
    std::array<std::vector<std::uint32_t>, 2> colours_; ///< normals, identities
    std::vector<float> depth_;
};

} // namespace frostfill
