// SPDX-License-Identifier: MIT
// Room: programs that draw one kind of thing: spheres, the shell, depth, normals, identities. A
// pass draws what it is given and keeps no history.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "render/framing/framing.hpp"

#include <frostfill/view.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// A sphere as the vertex shader gets it, in unit space.
struct SphereInstance
{
    float x, y, z, radius;
    std::uint32_t state;
    Colour colour{};
    friend bool operator==(const SphereInstance&, const SphereInstance&) = default;
};

/// Spheres in the memory of OpenGL, each as the four corners of its square: software renderers take
/// twice as long for instances. Owns what it creates.
class SphereBuffer
{
public:
    explicit SphereBuffer(const GlFunctions& gl);
    ~SphereBuffer();
    SphereBuffer(const SphereBuffer&) = delete;
    SphereBuffer& operator=(const SphereBuffer&) = delete;

    /// Makes the buffer hold these spheres.
    void update(std::span<const SphereInstance> spheres);
    void draw() const;

private:
    const GlFunctions& gl_;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{}; ///< corners and indices
    std::vector<SphereInstance> corners_;
    std::size_t count_ = 0; ///< of spheres
};

/// What the sphere shaders need beside the spheres.
struct SphereUniforms
{
    glm::mat4 view{1};
    glm::mat4 projection{1};
    float depthAtInfinity = 0;
    float depthSlope = 0;
    float pixelScale = 1; ///< pixels in a length of 1 at distance 1
    glm::vec4 heightPlane{0, 0, 0, 1};
    glm::vec4 distancePlane{0};
    float haze = 0;
    std::array<glm::vec4, 2> cutPlanes{}; ///< in eye space; see CutPlanes
};

/// What decides how the programs of spheres and mesh are compiled.
struct ShaderVariant
{
    bool orthographic = false;
    bool cutaway = false;
    bool outlines = false; ///< around every sphere
    /// Lines for the front of both stages.
    [[nodiscard]] std::string definitions() const;
};

/// The program that draws spheres exactly, as one square each; sphere.frag has the mathematics.
class SpherePass
{
public:
    SpherePass(const GlFunctions& gl, const ShaderVariant& variant,
               std::span<const glm::vec2> samplePositions, const Style& style, float lineWidth);

    /// Draws with depth test and writing.
    void draw(const SphereBuffer& spheres, const SphereUniforms& uniforms) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
};

[[nodiscard]] glm::vec4 toVector(const Colour& colour);

} // namespace frostfill
