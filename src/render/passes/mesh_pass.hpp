// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "render/passes/sphere_pass.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/picture/studio.hpp"

#include <frostfill/snapshot.hpp>

#include <array>
#include <span>
#include <vector>

namespace frostfill
{

/// The shell in the memory of OpenGL. Owns what it creates.
class MeshBuffer
{
public:
    /// Its edges have to be set before it is drawn.
    MeshBuffer(const GlFunctions& gl, const ShadedMesh& mesh);
    ~MeshBuffer();
    MeshBuffer(const MeshBuffer&) = delete;
    MeshBuffer& operator=(const MeshBuffer&) = delete;

    /// How strongly edges are drawn, which depends on where they are looked at from.
    void setEdges(const std::vector<std::array<std::uint8_t, 3>>& edgeStrengths);
    /// Takes the states of these triangles; all are active before.
    void update(std::span<const std::uint32_t> changed, std::span<const PolygonState> states);
    /// The triangles that draw() draws.
    void choose(std::span<const std::uint32_t> triangles);
    void draw() const;

private:
    const GlFunctions& gl_;
    std::size_t triangles_;
    GLuint array_ = 0;
    std::array<GLuint, 4> buffers_{}; ///< shape; states; edges; indices of the chosen
    std::vector<std::array<std::uint8_t, 4>> edges_; ///< [#T x 3] the three; distance from a crease
    std::vector<std::uint8_t> states_;               ///< [#T x 3]
    std::vector<std::uint32_t> indices_;
};

/// The program that draws the shell.
class MeshPass
{
public:
    MeshPass(const GlFunctions& gl, const ShaderVariant& variant, const Palette& palette,
             const MeshStrokes& strokes);

    /// Blends back faces, then front faces, over what is there; depth is tested and not written, so
    /// the spheres stay in charge.
    void draw(const MeshBuffer& mesh, const SphereUniforms& uniforms) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
};

/// The program that draws the ground, and the ground in the memory of OpenGL. Owns what it creates.
class GroundPass
{
public:
    GroundPass(const GlFunctions& gl, const GroundShadow& ground);
    ~GroundPass();
    GroundPass(const GroundPass&) = delete;
    GroundPass& operator=(const GroundPass&) = delete;

    /// Blends over what is there, whatever its depth.
    void draw(const SphereUniforms& uniforms) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{}; ///< places, corners
    GLsizei corners_;
};

} // namespace frostfill
