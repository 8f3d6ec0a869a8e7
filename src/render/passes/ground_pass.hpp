// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "render/picture/studio.hpp"

#include <glm/mat4x4.hpp>

#include <array>

namespace frostfill
{

/// The program that draws the ground, and the ground in the memory of OpenGL. Owns what it creates.
class GroundPass
{
public:
    GroundPass(const GlFunctions& gl, const GroundShadow& ground);
    ~GroundPass();
    GroundPass(const GroundPass&) = delete;
    GroundPass& operator=(const GroundPass&) = delete;

    /// Blends over what is there, whatever its depth.
    void draw(const glm::mat4& view, const glm::mat4& projection) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{}; ///< places, corners
    GLsizei corners_;
};

} // namespace frostfill
