// SPDX-License-Identifier: MIT
#include "sphere_pass.hpp"

#include "embedded.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace frostfill
{
namespace
{

/// Differing spheres that are closer than this in the order of ids are uploaded in one go, with
/// what lies between them: a call costs as much as this many spheres.
constexpr std::size_t kMergeGap = 64;

std::string sampleDefinitions(std::size_t samples)
{
    return samples > 1 ? fmt::format("#extension GL_ARB_sample_shading : require\n"
                                     "#define SAMPLES {}\n",
                                     samples)
                       : "";
}

} // namespace

std::string ShaderVariant::definitions() const
{
    std::string lines;
    lines += orthographic ? "#define ORTHOGRAPHIC\n" : "";
    lines += cutaway ? "#define CUTAWAY\n" : "";
    lines += outlines ? "#define OUTLINES\n" : "";
    return lines;
}

glm::vec4 toVector(const Colour& colour)
{
    return glm::vec4(colour[0], colour[1], colour[2], colour[3]) / 255.0F;
}

SphereBuffer::SphereBuffer(const GlFunctions& gl) : gl_(gl)
{
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(1, &buffer_);
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(SphereInstance), nullptr);
    gl.vertexAttribDivisor(0, 1);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(SphereInstance),
                            reinterpret_cast<const void*>(offsetof(SphereInstance, state)));
    gl.vertexAttribDivisor(1, 1);
    gl.enableVertexAttribArray(2);
    gl.vertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SphereInstance),
                           reinterpret_cast<const void*>(offsetof(SphereInstance, colour)));
    gl.vertexAttribDivisor(2, 1);
}

SphereBuffer::~SphereBuffer()
{
    gl_.deleteBuffers(1, &buffer_);
    gl_.deleteVertexArrays(1, &array_);
}

void SphereBuffer::grow(std::span<const SphereInstance> spheres)
{
    capacity_ = std::max(spheres.size(), 2 * capacity_);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_ * sizeof(SphereInstance)),
                   nullptr, GL_DYNAMIC_DRAW);
    held_.clear();
}

void SphereBuffer::update(std::span<const SphereInstance> spheres)
{
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
    if (spheres.size() > capacity_)
    {
        grow(spheres);
    }
    const std::size_t common = std::min(held_.size(), spheres.size());
    const auto differs = [&](std::size_t i) { return i >= common || held_[i] != spheres[i]; };
    for (std::size_t first = 0; first < spheres.size(); ++first)
    {
        if (!differs(first))
        {
            continue;
        }
        std::size_t end = first + 1;
        for (std::size_t i = end; i < std::min(end + kMergeGap, spheres.size()); ++i)
        {
            end = differs(i) ? i + 1 : end;
        }
        gl_.bufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(first * sizeof(SphereInstance)),
                          static_cast<GLsizeiptr>((end - first) * sizeof(SphereInstance)),
                          spheres.data() + first);
        first = end;
    }
    held_.assign(spheres.begin(), spheres.end());
}

void SphereBuffer::draw() const
{
    gl_.bindVertexArray(array_);
    gl_.drawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(held_.size()));
}

void placeSpheres(const Snapshot& snapshot, const Framing& framing, const SphereColours& colours,
                  std::vector<SphereInstance>& instances)
{
    const Eigen::Vector3f offset =
        ((snapshot.origin - framing.centre) * framing.scale).cast<float>();
    const auto scale = static_cast<float>(framing.scale);
    instances.resize(snapshot.centres.size());
    for (std::size_t i = 0; i < instances.size(); ++i)
    {
        const Eigen::Vector3f centre = snapshot.centres[i] * scale + offset;
        instances[i] = {centre.x(), centre.y(), centre.z(), snapshot.radii[i] * scale,
                        static_cast<std::uint32_t>(snapshot.states[i]), colours.of(snapshot, i)};
    }
}

SpherePass::SpherePass(const GlFunctions& gl, const ShaderVariant& variant,
                       std::span<const glm::vec2> samplePositions, const Style& style,
                       float lineWidth)
    : gl_(gl), program_(gl, sampleDefinitions(samplePositions.size()) + variant.definitions(),
                        embedded::shader_sphere_vert(), embedded::shader_sphere_frag())
{
    program_.use();
    const std::array background = {toVector(style.palette.background)};
    program_.set("background", background);
    program_.set("outlineWidth", lineWidth);
    program_.set("gloss", style.look == Look::paper ? 0.0F : 1.0F);
    if (samplePositions.size() > 1)
    {
        program_.set("samplePositions", samplePositions);
    }
}

void SpherePass::draw(const SphereBuffer& spheres, const SphereUniforms& uniforms) const
{
    program_.use();
    program_.set("view", uniforms.view);
    program_.set("projection", uniforms.projection);
    program_.set("depthAtInfinity", uniforms.depthAtInfinity);
    program_.set("depthSlope", uniforms.depthSlope);
    program_.set("pixelScale", uniforms.pixelScale);
    program_.set("heightPlane", std::span(&uniforms.heightPlane, 1));
    program_.set("distancePlane", std::span(&uniforms.distancePlane, 1));
    program_.set("haze", uniforms.haze);
    program_.set("cutPlanes", uniforms.cutPlanes);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthMask(GL_TRUE);
    gl_.disable(GL_BLEND);
    spheres.draw();
}

} // namespace frostfill
