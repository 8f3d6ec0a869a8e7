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

/// Longest way and largest radius that SphereLight tells [radius of the sphere that is lit].
inline constexpr float kOccluderRange = 7;

/// What keeps light from one sphere.
struct SphereLight
{
    /// The neighbours that hide most from it: the way to their centres and their radii, over
    /// kOccluderRange times its own radius, -127..127 for -1..1. All 0: there is none.
    std::array<std::array<std::int8_t, 4>, 12> occluders{};
    /// What all others let through to it, 0..255 for 0..1: of the sky, of the lamp.
    std::array<std::uint8_t, 4> open{255, 255, 0, 0};

    friend bool operator==(const SphereLight&, const SphereLight&) = default;
};

/// Spheres in the memory of OpenGL, each as the four corners of its square: software renderers take
/// twice as long for instances. Owns what it creates.
class SphereBuffer
{
public:
    /// `lit`: with what keeps light from each.
    explicit SphereBuffer(const GlFunctions& gl, bool lit = false);
    ~SphereBuffer();
    SphereBuffer(const SphereBuffer&) = delete;
    SphereBuffer& operator=(const SphereBuffer&) = delete;

    /// Makes the buffer hold these spheres.
    void update(std::span<const SphereInstance> spheres);
    /// [spheres] for a lit buffer, after update().
    void light(std::span<const SphereLight> lights);
    void draw() const;

private:
    const GlFunctions& gl_;
    GLuint array_ = 0;
    std::array<GLuint, 3> buffers_{}; ///< corners, indices, lights
    std::vector<SphereInstance> corners_;
    std::vector<SphereLight> lights_; ///< of the corners
    std::size_t count_ = 0;           ///< of spheres
};

/// What the sphere shaders need beside the spheres.
struct SphereUniforms
{
    glm::mat4 view{1};
    glm::mat4 projection{1};
    float depthAtInfinity = 0;
    float depthSlope = 0;
    float pixelScale = 1;  ///< pixels in a length of 1 at distance 1
    float supersample = 1; ///< drawn for one pixel of the picture, each way
    glm::vec4 heightPlane{0, 0, 0, 1};
    glm::vec4 distancePlane{0};
    float haze = 0;
    glm::vec3 lamp{0, 0, 1};              ///< towards it, in eye space; studio
    glm::vec3 above{0, 1, 0};             ///< away from the ground, in eye space; studio
    std::array<glm::vec4, 2> cutPlanes{}; ///< in eye space; see CutPlanes
};

/// What decides how the programs of spheres and mesh are compiled.
struct ShaderVariant
{
    bool orthographic = false;
    bool cutaway = false;
    bool outlines = false;    ///< around every sphere, and hatched polygons: for print
    bool fadingLines = false; ///< the shell's lines suit triangles of any size
    bool studio = false;      ///< spheres keep light from each other
    /// Lines for the front of both stages.
    [[nodiscard]] std::string definitions() const;
};

/// For passes that show no colours.
[[nodiscard]] inline ShaderVariant shapesOnly(ShaderVariant variant)
{
    variant.studio = false;
    return variant;
}

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
