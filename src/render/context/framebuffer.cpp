// SPDX-License-Identifier: MIT
#include "render/context/framebuffer.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace frostfill
{
namespace
{

/// Between eye and far plane the depths of a perspective lie mostly above 1/2, where 24 bits are as
/// fine as a 32-bit float.
constexpr GLenum kDepthFormat = GL_DEPTH24_STENCIL8;

/// Largest edge of a picture. OSMesa takes more than it can draw, without an error, so we ask.
int sizeLimit(const GlFunctions& gl)
{
    GLint renderbuffer = 0;
    std::array<GLint, 2> viewport{};
    gl.getIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    gl.getIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min({renderbuffer, viewport[0], viewport[1]});
}

} // namespace

Framebuffer::Framebuffer(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl), width_(width), height_(height)
{
    const int limit = sizeLimit(gl);
    if (width < 1 || height < 1 || width > limit || height > limit)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("a picture of {}x{} pixels cannot be drawn: each edge must be "
                                "between 1 and {} pixels",
                                width, height, limit));
    }
    GLint maxSamples = 1;
    gl.getIntegerv(GL_MAX_SAMPLES, &maxSamples);
    const int asked = samples > 1 ? std::min(samples, static_cast<int>(maxSamples)) : 0;

    gl.genFramebuffers(2, framebuffers_.data());
    gl.genRenderbuffers(3, renderbuffers_.data());
    attach(framebuffers_[0], GL_COLOR_ATTACHMENT0, renderbuffers_[0], GL_RGBA8, asked);
    attach(framebuffers_[0], GL_DEPTH_STENCIL_ATTACHMENT, renderbuffers_[1], kDepthFormat, asked);
    attach(framebuffers_[1], GL_COLOR_ATTACHMENT0, renderbuffers_[2], GL_RGBA8, 0);
    for (const GLuint framebuffer : framebuffers_)
    {
        gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        if (gl.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        {
            throw Error(ErrorCode::noOpenGl,
                        fmt::format("no framebuffer of {}x{} pixels and {} samples is available",
                                    width, height, samples));
        }
    }
    bind();
    GLint given = 0;
    gl.getIntegerv(GL_SAMPLES, &given);
    samples_ = std::max(1, static_cast<int>(given));
}

Framebuffer::~Framebuffer()
{
    gl_.deleteFramebuffers(2, framebuffers_.data());
    gl_.deleteRenderbuffers(3, renderbuffers_.data());
}

void Framebuffer::attach(GLuint framebuffer, GLenum attachment, GLuint renderbuffer, GLenum format,
                         int samples) const
{
    gl_.bindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl_.renderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
    gl_.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.framebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

void Framebuffer::bind() const
{
    gl_.bindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
    gl_.viewport(0, 0, width_, height_);
}

void Framebuffer::restore(const Framebuffer& from, const PixelRectangle& part) const
{
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffers_[0]);
    gl_.bindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[0]);
    copy(part, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Framebuffer::resolve(const PixelRectangle& part) const
{
    if (samples_ > 1)
    {
        gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
        gl_.bindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
        copy(part, GL_COLOR_BUFFER_BIT);
    }
}

void Framebuffer::copy(const PixelRectangle& part, GLbitfield what) const
{
    const auto& [left, bottom, right, top] = part;
    gl_.blitFramebuffer(left, bottom, right, top, left, bottom, right, top, what, GL_NEAREST);
}

void Framebuffer::readColour(Image& image, std::span<const PixelRectangle> rectangles,
                             bool withAlpha)
{
    const auto width = static_cast<std::size_t>(width_);
    const auto height = static_cast<std::size_t>(height_);
    image.width = width_;
    image.height = height_;
    image.channels = withAlpha ? 4 : 3;
    const auto channels = static_cast<std::size_t>(image.channels);
    image.pixels.resize(width * height * channels);

    // Reading RGBA, which is how the pixels lie, and dropping alpha ourselves is faster than
    // having OpenGL read RGB.
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[samples_ > 1 ? 1 : 0]);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    for (const PixelRectangle& part : rectangles)
    {
        rgba_.resize(static_cast<std::size_t>(part.area()) * 4);
        gl_.readPixels(part.left, part.bottom, part.width(), part.height(), GL_RGBA,
                       GL_UNSIGNED_BYTE, rgba_.data());
        const std::uint8_t* from = rgba_.data();
        for (int y = part.bottom; y < part.top; ++y)
        {
            const auto row = height - 1 - static_cast<std::size_t>(y);
            std::uint8_t* to = image.pixels.data() +
                               (row * width + static_cast<std::size_t>(part.left)) * channels;
            writePixels(from, part.width(), image.channels, to);
            from += 4 * static_cast<std::ptrdiff_t>(part.width());
        }
    }
}

void Framebuffer::readDepth(const PixelRectangle& part, std::vector<std::uint32_t>& depths) const
{
    assert(samples_ == 1);
    depths.resize(static_cast<std::size_t>(part.area()));
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    // As they lie: to make floats of them takes longer than to copy them.
    gl_.readPixels(part.left, part.bottom, part.width(), part.height(), GL_DEPTH_STENCIL,
                   GL_UNSIGNED_INT_24_8, depths.data());
}

} // namespace frostfill
