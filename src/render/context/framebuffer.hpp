// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl.hpp"
#include "render/framing/pixel_rectangle.hpp"

#include <frostfill/image.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The picture while it is drawn: RGBA8, 24-bit depth and 8-bit stencil, several samples a pixel.
class Framebuffer
{
public:
    /// Throws Error usage when the size is beyond the context's limits.
    Framebuffer(const GlFunctions& gl, int width, int height, int samples);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    /// Everything drawn from now on goes here.
    void bind() const;
    /// Samples a pixel that the context really gave; 1 when there is no multisampling.
    [[nodiscard]] int samples() const { return samples_; }

    /// Copies colour, depth and stencil from a framebuffer of the same shape.
    void restore(const Framebuffer& from, const PixelRectangle& part) const;
    /// Averages the samples, after which this part of the picture can be read.
    void resolve(const PixelRectangle& part) const;
    /// RGB, or of premultiplied colours RGBA with straight alpha, top row first. Leaves the rest of
    /// the picture as it is if it has the right shape.
    void readColour(Image& image, std::span<const PixelRectangle> rectangles, bool withAlpha);
    /// Window depths of a part as 24 bits above the stencil's 8, bottom row first. Only without
    /// multisampling.
    void readDepth(const PixelRectangle& part, std::vector<std::uint32_t>& depths) const;

    [[nodiscard]] PixelRectangle whole() const { return {0, 0, width_, height_}; }

private:
    /// From the framebuffer that is bound for reading to the one for drawing.
    void copy(const PixelRectangle& part, GLbitfield what) const;
    void attach(GLuint framebuffer, GLenum attachment, GLuint renderbuffer, GLenum format,
                int samples) const;

    const GlFunctions& gl_;
    int width_;
    int height_;
    int samples_ = 1;
    std::array<GLuint, 2> framebuffers_{};  ///< drawn to; read from
    std::array<GLuint, 3> renderbuffers_{}; ///< colour and depth drawn to; resolved colour
    std::vector<std::uint8_t> rgba_;
};

} // namespace frostfill
