// SPDX-License-Identifier: MIT
#include "render/context/shader.hpp"

#include "render/context/embedded.hpp"

#include <frostfill/error.hpp>

#include <array>

namespace frostfill
{
namespace
{

constexpr std::string_view kVersion = "#version 330 core\n";

/// Throws what the driver says of a shader or program that has failed.
void requireSuccess(GLuint object, GLenum status, decltype(GlFunctions::getShaderiv) statusOf,
                    decltype(GlFunctions::getShaderInfoLog) logOf,
                    decltype(GlFunctions::deleteShader) destroy, const char* what)
{
    GLint succeeded = GL_FALSE;
    statusOf(object, status, &succeeded);
    if (succeeded == GL_FALSE)
    {
        std::array<GLchar, 2048> log{};
        logOf(object, static_cast<GLsizei>(log.size()), nullptr, log.data());
        destroy(object);
        throw Error(ErrorCode::noOpenGl, std::string(what) + log.data());
    }
}

GLuint compile(const GlFunctions& gl, GLenum stage, std::string_view definitions,
               std::string_view source)
{
    const std::string common = commonShaderText();
    const std::array<std::string_view, 4> parts = {kVersion, definitions, common, source};
    std::array<const GLchar*, parts.size()> strings{};
    std::array<GLint, parts.size()> lengths{};
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        strings[i] = parts[i].data();
        lengths[i] = static_cast<GLint>(parts[i].size());
    }
    const GLuint shader = gl.createShader(stage);
    gl.shaderSource(shader, static_cast<GLsizei>(parts.size()), strings.data(), lengths.data());
    gl.compileShader(shader);

    requireSuccess(shader, GL_COMPILE_STATUS, gl.getShaderiv, gl.getShaderInfoLog, gl.deleteShader,
                   "a shader does not compile: ");
    return shader;
}

} // namespace

std::string commonShaderText()
{
    std::string text;
    for (const std::string_view part :
         {embedded::shader_real_glsl(), embedded::shader_numbers_glsl(),
          embedded::shader_lights_glsl(), embedded::shader_looks_glsl(),
          embedded::shader_studio_glsl(), embedded::shader_film_glsl(),
          embedded::shader_common_glsl()})
    {
        text += part;
    }
    return text;
}

ShaderProgram::ShaderProgram(const GlFunctions& gl, std::string_view definitions,
                             std::string_view vertex, std::string_view fragment)
    : gl_(gl)
{
    const GLuint vertexShader = compile(gl, GL_VERTEX_SHADER, definitions, vertex);
    const GLuint fragmentShader = compile(gl, GL_FRAGMENT_SHADER, definitions, fragment);
    program_ = gl.createProgram();
    gl.attachShader(program_, vertexShader);
    gl.attachShader(program_, fragmentShader);
    gl.linkProgram(program_);
    gl.deleteShader(vertexShader);
    gl.deleteShader(fragmentShader);

    requireSuccess(program_, GL_LINK_STATUS, gl.getProgramiv, gl.getProgramInfoLog,
                   gl.deleteProgram, "the shaders do not link: ");
}

ShaderProgram::~ShaderProgram()
{
    gl_.deleteProgram(program_);
}

GLint ShaderProgram::location(const char* name) const
{
    return gl_.getUniformLocation(program_, name);
}

void ShaderProgram::set(const char* name, float value) const
{
    gl_.uniform1f(location(name), value);
}

void ShaderProgram::set(const char* name, const glm::vec3& value) const
{
    gl_.uniform3fv(location(name), 1, &value[0]);
}

void ShaderProgram::set(const char* name, std::span<const glm::vec2> values) const
{
    gl_.uniform2fv(location(name), static_cast<GLsizei>(values.size()), &values[0][0]);
}

void ShaderProgram::set(const char* name, std::span<const glm::vec4> values) const
{
    gl_.uniform4fv(location(name), static_cast<GLsizei>(values.size()), &values[0][0]);
}

void ShaderProgram::set(const char* name, const glm::mat4& value) const
{
    gl_.uniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}

} // namespace frostfill
