// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

namespace frostfill
{

// The part of OpenGL 3.3 that Frostfill uses is declared here, so that building needs no headers of
// OpenGL: Debian's pull in Mesa and LLVM, a third of all that the program needs to be built. Names
// and values are the registry's.

// NOLINTBEGIN(readability-identifier-naming)
using GLbitfield = unsigned int;
using GLboolean = unsigned char;
using GLchar = char;
using GLenum = unsigned int;
using GLfloat = float;
using GLint = int;
using GLintptr = std::ptrdiff_t;
using GLsizei = int;
using GLsizeiptr = std::ptrdiff_t;
using GLubyte = unsigned char;
using GLuint = unsigned int;

constexpr GLboolean GL_FALSE = 0;
constexpr GLboolean GL_TRUE = 1;
constexpr GLbitfield GL_COLOR_BUFFER_BIT = 0x00004000;
constexpr GLbitfield GL_DEPTH_BUFFER_BIT = 0x00000100;
constexpr GLbitfield GL_STENCIL_BUFFER_BIT = 0x00000400;
constexpr GLenum GL_ALWAYS = 0x0207;
constexpr GLenum GL_ARRAY_BUFFER = 0x8892;
constexpr GLenum GL_BACK = 0x0405;
constexpr GLenum GL_BLEND = 0x0BE2;
constexpr GLenum GL_BYTE = 0x1400;
constexpr GLenum GL_COLOR_ATTACHMENT0 = 0x8CE0;
constexpr GLenum GL_COLOR_ATTACHMENT1 = 0x8CE1;
constexpr GLenum GL_COMPILE_STATUS = 0x8B81;
constexpr GLenum GL_CULL_FACE = 0x0B44;
constexpr GLenum GL_DEPTH24_STENCIL8 = 0x88F0;
constexpr GLenum GL_DEPTH_ATTACHMENT = 0x8D00;
constexpr GLenum GL_DEPTH_CLAMP = 0x864F;
constexpr GLenum GL_DEPTH_COMPONENT = 0x1902;
constexpr GLenum GL_DEPTH_COMPONENT32F = 0x8CAC;
constexpr GLenum GL_DEPTH_STENCIL = 0x84F9;
constexpr GLenum GL_DEPTH_STENCIL_ATTACHMENT = 0x821A;
constexpr GLenum GL_DEPTH_TEST = 0x0B71;
constexpr GLenum GL_DRAW_FRAMEBUFFER = 0x8CA9;
constexpr GLenum GL_DYNAMIC_DRAW = 0x88E8;
constexpr GLenum GL_ELEMENT_ARRAY_BUFFER = 0x8893;
constexpr GLenum GL_EQUAL = 0x0202;
constexpr GLenum GL_FLOAT = 0x1406;
constexpr GLenum GL_FRAGMENT_SHADER = 0x8B30;
constexpr GLenum GL_FRAMEBUFFER = 0x8D40;
constexpr GLenum GL_FRAMEBUFFER_COMPLETE = 0x8CD5;
constexpr GLenum GL_FRONT = 0x0404;
constexpr GLenum GL_KEEP = 0x1E00;
constexpr GLenum GL_LINK_STATUS = 0x8B82;
constexpr GLenum GL_MAX_RENDERBUFFER_SIZE = 0x84E8;
constexpr GLenum GL_MAX_SAMPLES = 0x8D57;
constexpr GLenum GL_MAX_VIEWPORT_DIMS = 0x0D3A;
constexpr GLenum GL_NEAREST = 0x2600;
constexpr GLenum GL_ONE = 1;
constexpr GLenum GL_ONE_MINUS_SRC_ALPHA = 0x0303;
constexpr GLenum GL_PACK_ALIGNMENT = 0x0D05;
constexpr GLenum GL_READ_FRAMEBUFFER = 0x8CA8;
constexpr GLenum GL_RENDERBUFFER = 0x8D41;
constexpr GLenum GL_RENDERER = 0x1F01;
constexpr GLenum GL_REPLACE = 0x1E01;
constexpr GLenum GL_RGBA = 0x1908;
constexpr GLenum GL_RGBA8 = 0x8058;
constexpr GLenum GL_SAMPLES = 0x80A9;
constexpr GLenum GL_SAMPLE_POSITION = 0x8E50;
constexpr GLenum GL_SCISSOR_TEST = 0x0C11;
constexpr GLenum GL_STATIC_DRAW = 0x88E4;
constexpr GLenum GL_STENCIL_TEST = 0x0B90;
constexpr GLenum GL_STREAM_DRAW = 0x88E0;
constexpr GLenum GL_TRIANGLES = 0x0004;
constexpr GLenum GL_UNSIGNED_BYTE = 0x1401;
constexpr GLenum GL_UNSIGNED_INT = 0x1405;
constexpr GLenum GL_UNSIGNED_INT_8_8_8_8_REV = 0x8367;
constexpr GLenum GL_UNSIGNED_INT_24_8 = 0x84FA;
constexpr GLenum GL_UNSIGNED_SHORT = 0x1403;
constexpr GLenum GL_VENDOR = 0x1F00;
constexpr GLenum GL_VERSION = 0x1F02;
constexpr GLenum GL_VERTEX_SHADER = 0x8B31;
// NOLINTEND(readability-identifier-naming)

class Context;

/// Every function of OpenGL that we call, as X(member, type): the member `clear` is glClear. Loaded
/// by hand, because the usual loaders fail on OSMesa contexts. Tried on OSMesa and on EGL's
/// surfaceless and device platforms: libepoxy 1.5.10 aborts on the first ("Couldn't find current
/// GLX or EGL context"), and glbinding 2.1.1 (4.6 MB, linked with libGL) resolves nulls and draws
/// nothing there. Both draw on EGL.
#define FROSTFILL_GL_FUNCTIONS(X)                                                                  \
    X(attachShader, void(GLuint, GLuint))                                                          \
    X(bindBuffer, void(GLenum, GLuint))                                                            \
    X(bindFramebuffer, void(GLenum, GLuint))                                                       \
    X(bindRenderbuffer, void(GLenum, GLuint))                                                      \
    X(bindVertexArray, void(GLuint))                                                               \
    X(blendFuncSeparate, void(GLenum, GLenum, GLenum, GLenum))                                     \
    X(blitFramebuffer,                                                                             \
      void(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum))            \
    X(bufferData, void(GLenum, GLsizeiptr, const void*, GLenum))                                   \
    X(bufferSubData, void(GLenum, GLintptr, GLsizeiptr, const void*))                              \
    X(checkFramebufferStatus, GLenum(GLenum))                                                      \
    X(clear, void(GLbitfield))                                                                     \
    X(clearColor, void(GLfloat, GLfloat, GLfloat, GLfloat))                                        \
    X(clearStencil, void(GLint))                                                                   \
    X(compileShader, void(GLuint))                                                                 \
    X(createProgram, GLuint())                                                                     \
    X(createShader, GLuint(GLenum))                                                                \
    X(cullFace, void(GLenum))                                                                      \
    X(deleteBuffers, void(GLsizei, const GLuint*))                                                 \
    X(deleteFramebuffers, void(GLsizei, const GLuint*))                                            \
    X(deleteProgram, void(GLuint))                                                                 \
    X(deleteRenderbuffers, void(GLsizei, const GLuint*))                                           \
    X(deleteShader, void(GLuint))                                                                  \
    X(deleteVertexArrays, void(GLsizei, const GLuint*))                                            \
    X(depthMask, void(GLboolean))                                                                  \
    X(disable, void(GLenum))                                                                       \
    X(drawBuffers, void(GLsizei, const GLenum*))                                                   \
    X(drawElements, void(GLenum, GLsizei, GLenum, const void*))                                    \
    X(drawElementsBaseVertex, void(GLenum, GLsizei, GLenum, const void*, GLint))                   \
    X(enable, void(GLenum))                                                                        \
    X(enableVertexAttribArray, void(GLuint))                                                       \
    X(finish, void())                                                                              \
    X(framebufferRenderbuffer, void(GLenum, GLenum, GLenum, GLuint))                               \
    X(genBuffers, void(GLsizei, GLuint*))                                                          \
    X(genFramebuffers, void(GLsizei, GLuint*))                                                     \
    X(genRenderbuffers, void(GLsizei, GLuint*))                                                    \
    X(genVertexArrays, void(GLsizei, GLuint*))                                                     \
    X(getIntegerv, void(GLenum, GLint*))                                                           \
    X(getMultisamplefv, void(GLenum, GLuint, GLfloat*))                                            \
    X(getProgramInfoLog, void(GLuint, GLsizei, GLsizei*, GLchar*))                                 \
    X(getProgramiv, void(GLuint, GLenum, GLint*))                                                  \
    X(getShaderInfoLog, void(GLuint, GLsizei, GLsizei*, GLchar*))                                  \
    X(getShaderiv, void(GLuint, GLenum, GLint*))                                                   \
    X(getString, const GLubyte*(GLenum))                                                           \
    X(getUniformLocation, GLint(GLuint, const GLchar*))                                            \
    X(linkProgram, void(GLuint))                                                                   \
    X(pixelStorei, void(GLenum, GLint))                                                            \
    X(readBuffer, void(GLenum))                                                                    \
    X(readPixels, void(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*))                     \
    X(renderbufferStorageMultisample, void(GLenum, GLsizei, GLenum, GLsizei, GLsizei))             \
    X(scissor, void(GLint, GLint, GLsizei, GLsizei))                                               \
    X(shaderSource, void(GLuint, GLsizei, const GLchar* const*, const GLint*))                     \
    X(stencilFunc, void(GLenum, GLint, GLuint))                                                    \
    X(stencilOp, void(GLenum, GLenum, GLenum))                                                     \
    X(uniform1f, void(GLint, GLfloat))                                                             \
    X(uniform2fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniform3fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniform4fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniformMatrix4fv, void(GLint, GLsizei, GLboolean, const GLfloat*))                           \
    X(useProgram, void(GLuint))                                                                    \
    X(vertexAttribIPointer, void(GLuint, GLint, GLenum, GLsizei, const void*))                     \
    X(vertexAttribPointer, void(GLuint, GLint, GLenum, GLboolean, GLsizei, const void*))           \
    X(viewport, void(GLint, GLint, GLsizei, GLsizei))

/// The functions of one context, to be called while it is current.
struct GlFunctions
{
#define FROSTFILL_GL_MEMBER(member, type) std::add_pointer_t<type> member = nullptr;
    FROSTFILL_GL_FUNCTIONS(FROSTFILL_GL_MEMBER)
#undef FROSTFILL_GL_MEMBER
};

/// Throws Error noOpenGl, naming the first function that the context lacks.
[[nodiscard]] GlFunctions loadGlFunctions(const Context& context);

/// A place in the buffer that is bound, as OpenGL wants it told [byte].
[[nodiscard]] inline const void* inBuffer(std::size_t offset)
{
    return reinterpret_cast<const void*>(offset); // NOLINT(performance-no-int-to-ptr)
}

} // namespace frostfill
