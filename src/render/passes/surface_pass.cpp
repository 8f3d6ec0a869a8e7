// SPDX-License-Identifier: MIT
#include "render/passes/surface_pass.hpp"

#include "render/context/embedded.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

namespace frostfill
{

SurfacePass::SurfacePass(const GlFunctions& gl, const ShaderVariant& variant,
                         const PictureSize& size)
    : gl_(gl), size_(size), orthographic_(variant.orthographic),
      program_(gl, definitionsOf(variant), embedded::shader_sphere_vert(),
               embedded::shader_surface_frag()),
      buffer_(gl)
{
    gl.genFramebuffers(1, &framebuffer_);
    gl.genRenderbuffers(3, renderbuffers_.data());
    gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const std::array formats = {GL_RGBA8, GL_RGBA8, GL_DEPTH_COMPONENT32F};
    const std::array attachments = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                    GL_DEPTH_ATTACHMENT};
    for (std::size_t i = 0; i < renderbuffers_.size(); ++i)
    {
        gl.bindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
        gl.renderbufferStorageMultisample(GL_RENDERBUFFER, 0, static_cast<GLenum>(formats[i]),
                                          size.width, size.height);
        gl.framebufferRenderbuffer(GL_FRAMEBUFFER, static_cast<GLenum>(attachments[i]),
                                   GL_RENDERBUFFER, renderbuffers_[i]);
    }
    constexpr std::array<GLenum, 2> kTargets = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.drawBuffers(2, kTargets.data());
    if (gl.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
        throw Error(
            ErrorCode::noOpenGl,
            fmt::format("no framebuffer of {}x{} pixels is available for depth, normals and "
                        "identities",
                        size.width, size.height));
    }
}

SurfacePass::~SurfacePass()
{
    gl_.deleteFramebuffers(1, &framebuffer_);
    gl_.deleteRenderbuffers(3, renderbuffers_.data());
}

void SurfacePass::draw(std::span<const SphereInstance> spheres, const SphereUniforms& uniforms,
                       Surfaces& surfaces)
{
    buffer_.update(spheres);
    gl_.bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.viewport(0, 0, size_.width, size_.height);
    gl_.clearColor(0, 0, 0, 0);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthMask(GL_TRUE);
    gl_.disable(GL_BLEND);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("view", uniforms.view);
    program_.set("projection", uniforms.projection);
    program_.set("depthAtInfinity", uniforms.depthAtInfinity);
    program_.set("depthSlope", uniforms.depthSlope);
    program_.set("cutPlanes", uniforms.cutPlanes);
    buffer_.draw();
    gl_.finish();
    read(uniforms, surfaces);
}

void SurfacePass::read(const SphereUniforms& uniforms, Surfaces& surfaces)
{
    const auto width = static_cast<std::size_t>(size_.width);
    const auto height = static_cast<std::size_t>(size_.height);
    surfaces.width = size_.width;
    surfaces.height = size_.height;
    surfaces.distance.resize(width * height);
    surfaces.normal.resize(width * height);
    surfaces.identity.resize(width * height);
    bytes_.resize(width * height * 4);
    depth_.resize(width * height);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    const auto eachPixel = [&](auto take)
    {
        for (std::size_t y = 0; y < height; ++y)
        {
            for (std::size_t x = 0; x < width; ++x)
            {
                take((height - 1 - y) * width + x, y * width + x);
            }
        }
    };

    gl_.readBuffer(GL_COLOR_ATTACHMENT0);
    gl_.readPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
    eachPixel(
        [&](std::size_t from, std::size_t to)
        {
            const std::uint8_t* pixel = bytes_.data() + 4 * from;
            surfaces.normal[to] = {pixel[0], pixel[1], pixel[2]};
        });
    gl_.readBuffer(GL_COLOR_ATTACHMENT1);
    gl_.readPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
    eachPixel(
        [&](std::size_t from, std::size_t to)
        {
            const std::uint8_t* pixel = bytes_.data() + 4 * from;
            surfaces.identity[to] = pixel[0] | static_cast<std::uint32_t>(pixel[1]) << 8 |
                                    static_cast<std::uint32_t>(pixel[2]) << 16 |
                                    static_cast<std::uint32_t>(pixel[3]) << 24;
        });
    gl_.readPixels(0, 0, size_.width, size_.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth_.data());
    // Window depth is A0 + B / distance in perspective, linear without.
    const double a = orthographic_ ? 0 : double{uniforms.depthAtInfinity};
    const double b = 0.5 * double{uniforms.projection[3][2]};
    const double slope = -0.5 * double{uniforms.projection[2][2]};
    eachPixel(
        [&](std::size_t from, std::size_t to)
        {
            const double depth = double{depth_[from]};
            const double distance = orthographic_ ? (depth - 0.5 - b) / slope : b / (depth - a);
            surfaces.distance[to] = depth < 1 ? static_cast<float>(distance) : Surfaces::kNothing;
        });
}

} // namespace frostfill
