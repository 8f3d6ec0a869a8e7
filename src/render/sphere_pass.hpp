// SPDX-License-Identifier: MIT
#pragma once

#include "colour_scale.hpp"
#include "framing.hpp"
#include "gl.hpp"
#include "shader.hpp"

#include <frostfill/snapshot.hpp>
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

/// Spheres in the memory of OpenGL. Owns what it creates.
class SphereBuffer
{
public:
    explicit SphereBuffer(const GlFunctions& gl);
    ~SphereBuffer();
    SphereBuffer(const SphereBuffer&) = delete;
    SphereBuffer& operator=(const SphereBuffer&) = delete;

    /// Makes the buffer hold these spheres; uploads only what differs from what it holds.
    void update(std::span<const SphereInstance> spheres);
    void draw() const;

private:
    void grow(std::span<const SphereInstance> spheres);

    const GlFunctions& gl_;
    GLuint array_ = 0;
    GLuint buffer_ = 0;
    std::size_t capacity_ = 0;
    std::vector<SphereInstance> held_; ///< what OpenGL has
};

/// The spheres of a snapshot in unit space. `instances` is reused.
void placeSpheres(const Snapshot& snapshot, const Framing& framing, const SphereColours& colours,
                  std::vector<SphereInstance>& instances);

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
