// SPDX-License-Identifier: MIT
#pragma once

#include "gl.hpp"

#include <frostfill/image.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The picture while it is drawn: RGBA8 and 32-bit float depth, several samples a pixel.
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

    /// Averages the samples, after which the picture can be read.
    void resolve() const;
    /// RGB, or RGBA with straight alpha, top row first. Premultiplied colours are drawn.
    void readColour(Image& image, bool withAlpha = false);
    /// Window depth in 0..1, top row first. Only without multisampling.
    [[nodiscard]] std::vector<float> readDepth() const;

private:
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
