// SPDX-License-Identifier: MIT
// The text of the shaders as the page reads it, which no test without a browser would compile.
#include "render/context/context.hpp"
#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "support/drawn_with.hpp"
#include "support/paths.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace frostfill
{
namespace
{

std::string shaderText(const std::string& name)
{
    std::ifstream file(testing_support::sourceFolder() / "shaders" / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// What the compiler says; empty if it takes the text.
std::string refusal(const GlFunctions& gl, GLenum stage, const std::string& text)
{
    const GLuint shader = gl.createShader(stage);
    const GLchar* string = text.data();
    const auto length = static_cast<GLint>(text.size());
    gl.shaderSource(shader, 1, &string, &length);
    gl.compileShader(shader);
    GLint compiled = GL_FALSE;
    gl.getShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::array<GLchar, 2048> log{};
    gl.getShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.deleteShader(shader);
    return compiled == GL_FALSE ? log.data() : "";
}

TEST(ShaderText, IsGlslEsAsThePageCompilesIt)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    const std::unique_ptr<Context> context = openContext(*test::openGl());
    const GlFunctions gl = loadGlFunctions(*context);
    // As page/programs.js has it.
    const std::string head = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    int texts = 0;
    for (const char* name : {"sphere", "mesh"})
    {
        for (int variant = 0; variant < 8; ++variant)
        {
            std::string defined;
            defined += (variant & 1) != 0 ? "#define CUTAWAY\n" : "";
            defined += (variant & 2) != 0 ? "#define OUTLINES\n" : "";
            defined += (variant & 4) != 0 ? "#define FADING_LINES\n" : "";
            const std::string front = head + defined + commonShaderText();
            EXPECT_EQ(
                refusal(gl, GL_VERTEX_SHADER, front + shaderText(name + std::string(".vert"))), "")
                << name << ", " << defined;
            EXPECT_EQ(
                refusal(gl, GL_FRAGMENT_SHADER, front + shaderText(name + std::string(".frag"))),
                "")
                << name << ", " << defined;
            ++texts;
        }
    }
    EXPECT_EQ(texts, 16);
    EXPECT_NE(refusal(gl, GL_VERTEX_SHADER, head + "const float wrong = 1;\nvoid main() {}\n"), "")
        << "it takes what GLSL ES does not";
}

} // namespace
} // namespace frostfill
