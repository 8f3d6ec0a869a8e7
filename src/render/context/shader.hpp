// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <string>
#include <string_view>

namespace frostfill
{

/// What stands in front of all stages: the text that C++ has too, and what GLSL needs for it.
[[nodiscard]] std::string commonShaderText();

/// A linked program.
class ShaderProgram
{
public:
    /// Both stages get `definitions` (lines of #define) and the common chunk in front. A shader
    /// that does not compile is our own mistake or the driver's: throws Error noOpenGl with its
    /// log.
    ShaderProgram(const GlFunctions& gl, std::string_view definitions, std::string_view vertex,
                  std::string_view fragment);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const { gl_.useProgram(program_); }

    /// Set while the program is in use; a name that the compiler has optimised away is ignored.
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, std::span<const glm::vec2> values) const;
    void set(const char* name, std::span<const glm::vec4> values) const;
    void set(const char* name, const glm::mat4& value) const;

private:
    [[nodiscard]] GLint location(const char* name) const;

    const GlFunctions& gl_;
    GLuint program_ = 0;
};

} // namespace frostfill
