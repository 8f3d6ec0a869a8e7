// SPDX-License-Identifier: MIT
#include "render/passes/sphere_pass.hpp"

#include "render/context/embedded.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace frostfill
{
namespace
{

std::string sampleDefinitions(std::size_t samples)
{
    return samples > 1 ? fmt::format("#extension GL_ARB_sample_shading : require\n"
                                     "#define SAMPLES {}\n",
                                     samples)
                       : "";
}

/// Drawn at once: as many as indices of 16 bits can tell apart.
constexpr std::size_t kSquares = 65536 / 4;

/// Two triangles a square.
std::vector<std::uint16_t> indicesOfSquares()
{
    std::vector<std::uint16_t> indices;
    indices.reserve(6 * kSquares);
    for (std::size_t square = 0; square < kSquares; ++square)
    {
        for (const std::size_t corner : {0, 1, 2, 2, 1, 3})
        {
            indices.push_back(static_cast<std::uint16_t>(4 * square + corner));
        }
    }
    return indices;
}

/// Of surfaces: their normals, their identities.
constexpr std::array<GLenum, 2> kColourTargets = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

// Shared by the pass of colours and that of surfaces.
void setCamera(const ShaderProgram& program, const SphereUniforms& uniforms)
{
    program.set("view", uniforms.view);
    program.set("projection", uniforms.projection);
    program.set("depthAtInfinity", uniforms.depthAtInfinity);
    program.set("depthSlope", uniforms.depthSlope);
}

} // namespace

std::string definitionsOf(const ShaderVariant& variant)
{
    std::string lines;
    lines += variant.orthographic ? "#define ORTHOGRAPHIC\n" : "";
    lines += variant.cutaway ? "#define CUTAWAY\n" : "";
    lines += variant.outlines ? "#define OUTLINES\n" : "";
    lines += variant.occlusion ? "#define OCCLUSION\n" : "";
    lines += variant.studio ? "#define STUDIO\n" : "";
    lines += variant.fadingLines ? "#define FADING_LINES\n" : "";
    return lines;
}

SphereBuffer::SphereBuffer(const GlFunctions& gl, bool lit) : gl_(gl)
{
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(3, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.vertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(SphereInstance), nullptr);
    gl.vertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(SphereInstance),
                            inBuffer(offsetof(SphereInstance, state)));
    gl.vertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SphereInstance),
                           inBuffer(offsetof(SphereInstance, colour)));
    for (GLuint attribute = 0; attribute < 3; ++attribute)
    {
        gl.enableVertexAttribArray(attribute);
    }
    if (lit)
    {
        gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
        constexpr std::size_t kListed = SphereLight{}.occluders.size();
        for (std::size_t i = 0; i <= kListed; ++i)
        {
            const auto attribute = static_cast<GLuint>(3 + i);
            gl.vertexAttribPointer(attribute, 4, i < kListed ? GL_BYTE : GL_UNSIGNED_BYTE, GL_TRUE,
                                   sizeof(SphereLight), inBuffer(4 * i));
            gl.enableVertexAttribArray(attribute);
        }
    }
    const std::vector<std::uint16_t> indices = indicesOfSquares();
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    gl.bufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * 2),
                  indices.data(), GL_STATIC_DRAW);
}

SphereBuffer::~SphereBuffer()
{
    gl_.deleteBuffers(3, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void SphereBuffer::update(std::span<const SphereInstance> spheres)
{
    corners_.resize(spheres.size() * 4);
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        std::fill_n(corners_.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, spheres[i]);
    }
    // A new store each time: OpenGL may still be drawing from the old one.
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl_.bufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(corners_.size() * sizeof(SphereInstance)),
                   corners_.data(), GL_STREAM_DRAW);
    count_ = spheres.size();
}

void SphereBuffer::light(std::span<const SphereLight> lights)
{
    lights_.resize(lights.size() * 4);
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
        std::fill_n(lights_.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, lights[i]);
    }
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lights_.size() * sizeof(SphereLight)),
                   lights_.data(), GL_STREAM_DRAW);
}

void SphereBuffer::draw() const
{
    gl_.bindVertexArray(array_);
    for (std::size_t first = 0; first < count_; first += kSquares)
    {
        gl_.drawElementsBaseVertex(GL_TRIANGLES,
                                   static_cast<GLsizei>(6 * std::min(kSquares, count_ - first)),
                                   GL_UNSIGNED_SHORT, nullptr, static_cast<GLint>(4 * first));
    }
}

SpherePass::SpherePass(const GlFunctions& gl, const ShaderVariant& variant,
                       std::span<const glm::vec2> samplePositions, const Style& style,
                       float lineWidth)
    : gl_(gl), program_(gl, sampleDefinitions(samplePositions.size()) + definitionsOf(variant),
                        embedded::shader_sphere_vert(), embedded::shader_sphere_frag())
{
    program_.use();
    program_.set("background", glm::vec3(toVector(style.palette.background)));
    program_.set("outlineWidth", lineWidth);
    if (samplePositions.size() > 1)
    {
        program_.set("samplePositions", samplePositions);
    }
}

void SpherePass::draw(const SphereBuffer& spheres, const SphereUniforms& uniforms) const
{
    program_.use();
    setCamera(program_, uniforms);
    program_.set("pixelScale", uniforms.pixelScale);
    program_.set("supersample", uniforms.supersample);
    program_.set("heightPlane", std::span(&uniforms.heightPlane, 1));
    program_.set("distancePlane", std::span(&uniforms.distancePlane, 1));
    program_.set("haze", uniforms.haze);
    program_.set("cutPlanes", uniforms.cutPlanes);
    program_.set("lamp", uniforms.lamp);
    program_.set("above", uniforms.above);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthMask(GL_TRUE);
    gl_.disable(GL_BLEND);
    spheres.draw();
}

SurfacePass::SurfacePass(const GlFunctions& gl, const ShaderVariant& variant,
                         const PictureSize& size)
    : gl_(gl), size_(size), orthographic_(variant.orthographic),
      program_(gl, "#define SURFACES\n" + definitionsOf(variant), embedded::shader_sphere_vert(),
               embedded::shader_sphere_frag()),
      buffer_(gl)
{
    gl.genFramebuffers(1, &framebuffer_);
    gl.genRenderbuffers(3, renderbuffers_.data());
    gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const std::array formats = {GL_RGBA8, GL_RGBA8, GL_DEPTH_COMPONENT32F};
    const std::array attachments = {kColourTargets[0], kColourTargets[1], GL_DEPTH_ATTACHMENT};
    for (std::size_t i = 0; i < renderbuffers_.size(); ++i)
    {
        gl.bindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
        gl.renderbufferStorageMultisample(GL_RENDERBUFFER, 0, formats[i], size.width, size.height);
        gl.framebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER,
                                   renderbuffers_[i]);
    }
    gl.drawBuffers(2, kColourTargets.data());
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
    setCamera(program_, uniforms);
    program_.set("cutPlanes", uniforms.cutPlanes);
    buffer_.draw();
    gl_.finish();
    read(uniforms, surfaces);
}

void SurfacePass::read(const SphereUniforms& uniforms, Surfaces& surfaces)
{
    const auto pixels =
        static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    for (std::size_t i = 0; i < colours_.size(); ++i)
    {
        colours_[i].resize(pixels);
        gl_.readBuffer(kColourTargets[i]);
        gl_.readPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV,
                       colours_[i].data());
    }
    depth_.resize(pixels);
    gl_.readPixels(0, 0, size_.width, size_.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth_.data());
    // Window depth is A0 + B / distance in perspective, linear without.
    const double a = orthographic_ ? 0 : double{uniforms.depthAtInfinity};
    const double b = 0.5 * double{uniforms.projection[3][2]};
    const double slope = -0.5 * double{uniforms.projection[2][2]};
    surfaces.resize(size_);
    for (std::size_t i = 0; i < pixels; ++i)
    {
        const double depth = double{depth_[i]};
        const double distance = orthographic_ ? (depth - 0.5 - b) / slope : b / (depth - a);
        const auto pixel = static_cast<int>(i);
        surfaces.set(pixel % size_.width, pixel / size_.width,
                     depth < 1 ? static_cast<float>(distance) : Surfaces::kNothing, colours_[0][i],
                     colours_[1][i]);
    }
}

} // namespace frostfill
