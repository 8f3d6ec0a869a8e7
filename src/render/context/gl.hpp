// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl_registry.hpp"

#include <cstddef>
#include <type_traits>

namespace frostfill
{

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
    X(drawArrays, void(GLenum, GLint, GLsizei))                                                    \
    X(drawArraysInstanced, void(GLenum, GLint, GLsizei, GLsizei))                                  \
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
    X(uniform1i, void(GLint, GLint))                                                               \
    X(uniform2fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniform3fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniform4fv, void(GLint, GLsizei, const GLfloat*))                                            \
    X(uniformMatrix4fv, void(GLint, GLsizei, GLboolean, const GLfloat*))                           \
    X(useProgram, void(GLuint))                                                                    \
    X(vertexAttribDivisor, void(GLuint, GLuint))                                                   \
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
