// SPDX-License-Identifier: MIT
#pragma once

#include "render/context.hpp"
#include "render/framebuffer.hpp"
#include "render/gl.hpp"
#include "render/shader.hpp"

#include <frostfill/image.hpp>
#include <frostfill/snapshot.hpp>

#include <filesystem>
#include <memory>

namespace frostfill::benchmark
{

/// What one would write first: every sphere an icosphere of 320 triangles with one light, all of
/// them drawn for every picture, and stb_image_write as it comes, in one thread.
class NaivePipeline
{
public:
    NaivePipeline(PictureSize size, int samples);
    ~NaivePipeline();

    /// Draws spheres around the origin that fill a unit cube.
    void draw(const Snapshot& snapshot, Image& image);
    static void save(const Image& image, const std::filesystem::path& file);

private:
    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    Framebuffer framebuffer_;
    ShaderProgram program_;
    glm::mat4 toClip_;
    GLsizei vertices_ = 0;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{};
    std::vector<float> instances_;
};

} // namespace frostfill::benchmark
