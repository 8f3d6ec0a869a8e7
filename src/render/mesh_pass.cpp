// SPDX-License-Identifier: MIT
#include "mesh_pass.hpp"

#include "embedded.hpp"
#include "sphere_pass.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace frostfill
{
namespace
{

struct Vertex
{
    glm::vec3 position;
    glm::vec3 normal;
    std::array<std::uint8_t, 4> edges;
};

std::vector<Vertex> verticesOf(const ShadedMesh& mesh,
                               const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths)
{
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.corners.size() * 3);
    for (std::size_t t = 0; t < mesh.corners.size(); ++t)
    {
        const auto& [a, b, c] = edgeStrengths[t];
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            vertices.push_back({mesh.corners[t][corner], mesh.normals[t][corner], {a, b, c, 0}});
        }
    }
    return vertices;
}

const void* offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

} // namespace

MeshBuffer::MeshBuffer(const GlFunctions& gl, const ShadedMesh& mesh,
                       const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths)
    : gl_(gl), triangles_(mesh.corners.size())
{
    const std::vector<Vertex> vertices = verticesOf(mesh, edgeStrengths);
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(2, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                  vertices.data(), GL_STATIC_DRAW);
    gl.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    gl.vertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                           offset(offsetof(Vertex, normal)));
    gl.vertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex),
                           offset(offsetof(Vertex, edges)));
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

MeshPass::MeshPass(const GlFunctions& gl, bool orthographic, const Palette& palette,
                   const MeshStrokes& strokes)
    : gl_(gl), program_(gl, orthographic ? "#define ORTHOGRAPHIC\n" : "",
                        embedded::shader_mesh_vert(), embedded::shader_mesh_frag())
{
    program_.use();
    const std::array active = {toVector(palette.activePolygon)};
    const std::array discarded = {toVector(palette.discardedPolygon)};
    program_.set("activeColour", active);
    program_.set("discardedColour", discarded);
    program_.set("lineWidth", strokes.lineWidth);
    program_.set("hatchPeriod", strokes.hatchPeriod);
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
