// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/context.hpp"
#include "render/context/framebuffer.hpp"
#include "render/context/gl.hpp"
#include "render/context/shader.hpp"

#include <frostfill/image.hpp>
#include <frostfill/snapshot.hpp>

#include <array>
#include <memory>
#include <vector>

namespace frostfill
{

/// Spheres as icospheres of 20 * 4^subdivisions triangles with one light: what our exact spheres
/// are compared with.
class TessellatedSpheres
{
public:
    /// `scale`: of the scene before it is drawn.
    TessellatedSpheres(PictureSize size, int samples, int supersample, int subdivisions,
                       float scale);
    ~TessellatedSpheres();

    TessellatedSpheres(const TessellatedSpheres&) = delete;
    TessellatedSpheres& operator=(const TessellatedSpheres&) = delete;

    /// Draws spheres that, scaled, lie within 0.75 of the origin.
    void draw(const Snapshot& snapshot, Image& image);

private:
    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    Framebuffer framebuffer_;
    int supersample_;
    float scale_;
    ShaderProgram program_;
    glm::mat4 toClip_;
    GLsizei vertices_ = 0;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{};
    std::vector<float> instances_;
    Image drawn_; ///< scratch, before it is shrunk
};

} // namespace frostfill
