// SPDX-License-Identifier: MIT
#pragma once

#include "framing.hpp"
#include "gl.hpp"
#include "mesh_shading.hpp"
#include "shader.hpp"
#include "sphere_pass.hpp"

#include <frostfill/snapshot.hpp>

#include <span>
#include <vector>

namespace frostfill
{

/// A corner of a triangle as the vertex shader gets it.
struct MeshVertex
{
    glm::vec3 position;
    glm::vec3 normal;
    std::array<std::uint8_t, 4> edges;
};

/// The shell in the memory of OpenGL. Owns what it creates.
class MeshBuffer
{
public:
    MeshBuffer(const GlFunctions& gl, const ShadedMesh& mesh,
               const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths);
    ~MeshBuffer();
    MeshBuffer(const MeshBuffer&) = delete;
    MeshBuffer& operator=(const MeshBuffer&) = delete;

    /// Takes other strengths of the edges, for another view.
    void setEdges(const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths);
    /// Takes the states of the triangles; those beyond the span's end are active.
    void update(std::span<const PolygonState> states);
    void draw() const;

private:
    const GlFunctions& gl_;
    std::vector<MeshVertex> vertices_; ///< [#T x 3]
    std::size_t triangles_;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{};  ///< shape; states
    std::vector<PolygonState> held_;   ///< [#T] what OpenGL has
    std::vector<std::uint8_t> staged_; ///< [#T x 3]
};

/// Lengths in the picture [pixel].
struct MeshStrokes
{
    float lineWidth = 1;
    float hatchPeriod = 8;
};

/// The program that draws the shell.
class MeshPass
{
public:
    MeshPass(const GlFunctions& gl, const ShaderVariant& variant, const Palette& palette,
             const MeshStrokes& strokes);

    /// Planes in eye space; see CutPlanes.
    void setCutPlanes(const std::array<glm::vec4, 2>& planes) const;

    /// Blends back faces, then front faces, over what is there; depth is tested and not written, so
    /// the spheres stay in charge.
    void draw(const MeshBuffer& mesh, const glm::mat4& view, const glm::mat4& projection) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
};

} // namespace frostfill
