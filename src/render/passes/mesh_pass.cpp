// SPDX-License-Identifier: MIT
#include "render/passes/mesh_pass.hpp"

#include "render/context/embedded.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace frostfill
{
namespace
{

/// Of two triangles for each cell of the ground.
std::vector<std::uint32_t> cornersOf(const GroundShadow& ground)
{
    std::vector<std::uint32_t> corners;
    const auto row = static_cast<std::uint32_t>(ground.cells) + 1;
    for (std::uint32_t first = 0; first + row + 1 < ground.places.size(); ++first)
    {
        if ((first + 1) % row != 0)
        {
            corners.insert(corners.end(), {first, first + 1, first + row + 1, first,
                                           first + row + 1, first + row});
        }
    }
    return corners;
}

struct Vertex
{
    glm::vec3 position;
    glm::vec3 normal;
};

std::vector<Vertex> verticesOf(const ShadedMesh& mesh)
{
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.triangles.size() * 3);
    for (const auto& corners : mesh.triangles)
    {
        for (const std::uint32_t corner : corners)
        {
            vertices.push_back({mesh.positions[corner], mesh.normals[corner]});
        }
    }
    return vertices;
}

} // namespace

MeshBuffer::MeshBuffer(const GlFunctions& gl, const ShadedMesh& mesh)
    : gl_(gl), triangles_(mesh.triangles.size())
{
    const std::vector<Vertex> vertices = verticesOf(mesh);
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(4, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                  vertices.data(), GL_STATIC_DRAW);
    gl.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    gl.vertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                           inBuffer(offsetof(Vertex, normal)));
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
    gl.vertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    states_.assign(triangles_ * 3, static_cast<std::uint8_t>(PolygonState::active));
    gl.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(states_.size()), states_.data(),
                  GL_DYNAMIC_DRAW);
    gl.vertexAttribIPointer(3, 1, GL_UNSIGNED_BYTE, 1, nullptr);
    for (GLuint attribute = 0; attribute < 4; ++attribute)
    {
        gl.enableVertexAttribArray(attribute);
    }
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[3]);
    edges_.assign(triangles_ * 3, {0, 0, 0, 255});
    for (std::size_t i = 0; i < edges_.size() && !mesh.creaseDistances.empty(); ++i)
    {
        edges_[i][3] = static_cast<std::uint8_t>(
            std::lround(255 * mesh.creaseDistances[mesh.triangles[i / 3][i % 3]]));
    }
}

MeshBuffer::~MeshBuffer()
{
    gl_.deleteBuffers(4, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void MeshBuffer::setEdges(const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths)
{
    for (std::size_t i = 0; i < edges_.size(); ++i)
    {
        std::copy_n(edgeStrengths[i / 3].begin(), 3, edges_[i].begin());
    }
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(edges_.size() * 4), edges_.data(),
                   GL_DYNAMIC_DRAW);
}

void MeshBuffer::update(std::span<const std::uint32_t> changed,
                        std::span<const PolygonState> states)
{
    if (changed.empty())
    {
        return;
    }
    for (const std::uint32_t t : changed)
    {
        std::fill_n(states_.begin() + 3 * std::ptrdiff_t{t}, 3,
                    static_cast<std::uint8_t>(states[t]));
    }
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl_.bufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(states_.size()), states_.data());
}

void MeshBuffer::choose(std::span<const std::uint32_t> triangles)
{
    indices_.clear();
    for (const std::uint32_t t : triangles)
    {
        indices_.insert(indices_.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    }
    gl_.bindVertexArray(array_);
    gl_.bufferData(GL_ELEMENT_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)),
                   indices_.data(), GL_STREAM_DRAW);
}

void MeshBuffer::draw() const
{
    if (!indices_.empty())
    {
        gl_.bindVertexArray(array_);
        gl_.drawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_INT,
                         nullptr);
    }
}

MeshPass::MeshPass(const GlFunctions& gl, const ShaderVariant& variant, const Palette& palette,
                   const MeshStrokes& strokes)
    : gl_(gl), program_(gl, definitionsOf(variant), embedded::shader_mesh_vert(),
                        embedded::shader_mesh_frag())
{
    program_.use();
    const std::array active = {toVector(palette.activePolygon)};
    const std::array discarded = {toVector(palette.discardedPolygon)};
    program_.set("activeInk", inkFor(palette.activePolygon, palette.background));
    program_.set("discardedInk", inkFor(palette.discardedPolygon, palette.background));
    program_.set("activeColour", active);
    program_.set("discardedColour", discarded);
    program_.set("lineWidth", strokes.lineWidth);
    program_.set("edgeFade", std::array{glm::vec2(strokes.edgeFade[0], strokes.edgeFade[1])});
}

void MeshPass::draw(const MeshBuffer& mesh, const SphereUniforms& uniforms) const
{
    program_.use();
    program_.set("view", uniforms.view);
    program_.set("projection", uniforms.projection);
    program_.set("pixelLength", 1 / uniforms.pixelScale);
    program_.set("cutPlanes", uniforms.cutPlanes);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.enable(GL_CULL_FACE);
    for (const bool fronts : {false, true})
    {
        gl_.cullFace(fronts ? GL_BACK : GL_FRONT);
        mesh.draw();
    }
    gl_.disable(GL_CULL_FACE);
    gl_.depthMask(GL_TRUE);
}

GroundPass::GroundPass(const GlFunctions& gl, const GroundShadow& ground)
    : gl_(gl), program_(gl, "", embedded::shader_ground_vert(), embedded::shader_ground_frag())
{
    const std::vector<std::uint32_t> corners = cornersOf(ground);
    corners_ = static_cast<GLsizei>(corners.size());
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(2, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.bufferData(GL_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(ground.places.size() * sizeof(glm::vec4)),
                  ground.places.data(), GL_STATIC_DRAW);
    gl.vertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
    gl.enableVertexAttribArray(0);
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    gl.bufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(corners.size() * sizeof(std::uint32_t)), corners.data(),
                  GL_STATIC_DRAW);
}

GroundPass::~GroundPass()
{
    gl_.deleteBuffers(2, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void GroundPass::draw(const SphereUniforms& uniforms) const
{
    program_.use();
    program_.set("view", uniforms.view);
    program_.set("projection", uniforms.projection);
    gl_.disable(GL_DEPTH_TEST);
    gl_.enable(GL_DEPTH_CLAMP); // it reaches further than the object, for which the far plane is
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.bindVertexArray(array_);
    gl_.drawElements(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr);
    gl_.disable(GL_DEPTH_CLAMP);
    gl_.depthMask(GL_TRUE);
}

} // namespace frostfill
