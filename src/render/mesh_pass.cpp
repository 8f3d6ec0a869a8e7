// SPDX-License-Identifier: MIT
#include "mesh_pass.hpp"

#include "embedded.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace frostfill
{
namespace
{

std::vector<MeshVertex> verticesOf(const ShadedMesh& mesh)
{
    std::vector<MeshVertex> vertices;
    vertices.reserve(mesh.corners.size() * 3);
    for (std::size_t t = 0; t < mesh.corners.size(); ++t)
    {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            vertices.push_back({mesh.corners[t][corner], mesh.normals[t][corner], {}});
        }
    }
    return vertices;
}

/// Darker than the surface on a light ground, lighter on a dark one.
glm::vec3 inkFor(const Colour& surface, const Colour& background)
{
    const glm::vec3 own(toVector(surface));
    const bool dark = background[3] > 127 && background[0] + background[1] + background[2] < 3 * 96;
    return dark ? glm::mix(own, glm::vec3(1), 0.12F) : 0.38F * own;
}

const void* offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

} // namespace

MeshBuffer::MeshBuffer(const GlFunctions& gl, const ShadedMesh& mesh,
                       const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths)
    : gl_(gl), vertices_(verticesOf(mesh)), triangles_(mesh.corners.size())
{
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(2, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    setEdges(edgeStrengths);
    gl.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
    gl.vertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                           offset(offsetof(MeshVertex, normal)));
    gl.vertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(MeshVertex),
                           offset(offsetof(MeshVertex, edges)));
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles_ * 3), nullptr,
                  GL_DYNAMIC_DRAW);
    gl.vertexAttribIPointer(3, 1, GL_UNSIGNED_BYTE, 1, nullptr);
    for (GLuint attribute = 0; attribute < 4; ++attribute)
    {
        gl.enableVertexAttribArray(attribute);
    }
}

MeshBuffer::~MeshBuffer()
{
    gl_.deleteBuffers(2, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void MeshBuffer::setEdges(const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths)
{
    for (std::size_t t = 0; t < triangles_; ++t)
    {
        const auto& [a, b, c] = edgeStrengths[t];
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            vertices_[3 * t + corner].edges = {a, b, c, 0};
        }
    }
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(MeshVertex)),
                   vertices_.data(), GL_STATIC_DRAW);
}

void MeshBuffer::update(std::span<const PolygonState> states)
{
    std::vector<PolygonState> wanted(triangles_, PolygonState::active);
    std::copy_n(states.begin(), std::min(states.size(), triangles_), wanted.begin());
    if (wanted == held_)
    {
        return;
    }
    held_ = std::move(wanted);
    staged_.clear();
    for (const PolygonState state : held_)
    {
        staged_.insert(staged_.end(), 3, static_cast<std::uint8_t>(state));
    }
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl_.bufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(staged_.size()), staged_.data());
}

void MeshBuffer::draw() const
{
    gl_.bindVertexArray(array_);
    gl_.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_ * 3));
}

MeshPass::MeshPass(const GlFunctions& gl, const ShaderVariant& variant, const Palette& palette,
                   const MeshStrokes& strokes)
    : gl_(gl), program_(gl, variant.definitions(), embedded::shader_mesh_vert(), embedded::shader_mesh_frag())
{
    program_.use();
    const std::array active = {toVector(palette.activePolygon)};
    const std::array discarded = {toVector(palette.discardedPolygon)};
    program_.set("activeInk", inkFor(palette.activePolygon, palette.background));
    program_.set("discardedInk", inkFor(palette.discardedPolygon, palette.background));
    program_.set("activeColour", active);
    program_.set("discardedColour", discarded);
    program_.set("lineWidth", strokes.lineWidth);
    program_.set("hatchPeriod", strokes.hatchPeriod);
}

void MeshPass::setCutPlanes(const std::array<glm::vec4, 2>& planes) const
{
    program_.use();
    program_.set("cutPlanes", planes);
}

void MeshPass::draw(const MeshBuffer& mesh, const glm::mat4& view,
                    const glm::mat4& projection) const
{
    program_.use();
    program_.set("view", view);
    program_.set("projection", projection);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.enable(GL_CULL_FACE);
    for (const GLenum hidden : {GL_FRONT, GL_BACK})
    {
        gl_.cullFace(hidden);
        mesh.draw();
    }
    gl_.disable(GL_CULL_FACE);
    gl_.depthMask(GL_TRUE);
}

} // namespace frostfill
