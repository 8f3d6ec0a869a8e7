// SPDX-License-Identifier: MIT
#include "framebuffer.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace frostfill
{
namespace
{

/// Largest edge of a picture. OSMesa takes more than it can draw, without an error, so we ask.
int sizeLimit(const GlFunctions& gl)
{
    GLint renderbuffer = 0;
    std::array<GLint, 2> viewport{};
    gl.getIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    gl.getIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min({renderbuffer, viewport[0], viewport[1]});
}

/// Turns rows about and divides colours by alpha.
void copyWithStraightAlpha(const std::vector<std::uint8_t>& bottomUp, std::size_t width,
                           std::size_t height, std::vector<std::uint8_t>& pixels)
{
    for (std::size_t y = 0; y < height; ++y)
    {
        const std::uint8_t* from = bottomUp.data() + (height - 1 - y) * width * 4;
        std::uint8_t* to = pixels.data() + y * width * 4;
        for (std::size_t x = 0; x < width; ++x, from += 4, to += 4)
        {
            const int alpha = from[3];
            for (std::size_t c = 0; c < 3; ++c)
            {
                const int straight = alpha == 0 ? 0 : (from[c] * 255 + alpha / 2) / alpha;
                to[c] = static_cast<std::uint8_t>(std::min(straight, 255));
            }
            to[3] = from[3];
        }
    }
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
    attach(framebuffers_[0], GL_DEPTH_ATTACHMENT, renderbuffers_[1], GL_DEPTH_COMPONENT32F, asked);
    attach(framebuffers_[1], GL_COLOR_ATTACHMENT0, renderbuffers_[2], GL_RGBA8, 0);
    for (const GLuint framebuffer : framebuffers_)
    {
        gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        if (gl.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        {
            throw Error(ErrorCode::noOpenGl,
                        fmt::format("no framebuffer of {}x{} pixels and {} samples is to be had",
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

void Framebuffer::resolve() const
{
    if (samples_ == 1)
    {
        return;
    }
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
    gl_.bindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
    gl_.blitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
}

void Framebuffer::readColour(Image& image, bool withAlpha)
{
    const auto width = static_cast<std::size_t>(width_);
    const auto height = static_cast<std::size_t>(height_);
    rgba_.resize(width * height * 4);
    image.width = width_;
    image.height = height_;
    image.channels = withAlpha ? 4 : 3;
    image.pixels.resize(width * height * static_cast<std::size_t>(image.channels));

    // Reading RGBA, which is how the pixels lie, and dropping alpha ourselves is faster than
    // having OpenGL read RGB.
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[samples_ > 1 ? 1 : 0]);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.readPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    if (withAlpha)
    {
        copyWithStraightAlpha(rgba_, width, height, image.pixels);
        return;
    }
    for (std::size_t y = 0; y < height; ++y)
    {
        const std::uint8_t* from = rgba_.data() + (height - 1 - y) * width * 4;
        std::uint8_t* to = image.pixels.data() + y * width * 3;
        for (std::size_t x = 0; x < width; ++x)
        {
            to[3 * x] = from[4 * x];
            to[3 * x + 1] = from[4 * x + 1];
            to[3 * x + 2] = from[4 * x + 2];
        }
    }
}

std::vector<float> Framebuffer::readDepth() const
{
    assert(samples_ == 1);
    const auto width = static_cast<std::size_t>(width_);
    const auto height = static_cast<std::size_t>(height_);
    std::vector<float> bottomUp(width * height);
    gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.readPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, bottomUp.data());

    std::vector<float> depth;
    depth.reserve(bottomUp.size());
    for (std::size_t y = height; y-- > 0;)
    {
        const auto row = bottomUp.begin() + static_cast<std::ptrdiff_t>(y * width);
        depth.insert(depth.end(), row, row + width_);
    }
    return depth;
}

} // namespace frostfill
