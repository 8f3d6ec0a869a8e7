// SPDX-License-Identifier: MIT
#pragma once

#include <GL/glcorearb.h>

#include <cstddef>

namespace frostfill
{

class Context;

/// Every function of OpenGL that we call, as X(member, type, name). Loaded by hand, because the
/// usual loaders fail on OSMesa contexts. Tried on OSMesa and on EGL's surfaceless and device
/// platforms: libepoxy 1.5.10 aborts on the first ("Couldn't find current GLX or EGL context"), and
/// glbinding 2.1.1 (4.6 MB, linked with libGL) resolves nulls and draws nothing there. Both draw on
/// EGL.
#define FROSTFILL_GL_FUNCTIONS(X)                                                                  \
    X(attachShader, PFNGLATTACHSHADERPROC, "glAttachShader")                                       \
    X(bindBuffer, PFNGLBINDBUFFERPROC, "glBindBuffer")                                             \
    X(bindFramebuffer, PFNGLBINDFRAMEBUFFERPROC, "glBindFramebuffer")                              \
    X(bindRenderbuffer, PFNGLBINDRENDERBUFFERPROC, "glBindRenderbuffer")                           \
    X(bindVertexArray, PFNGLBINDVERTEXARRAYPROC, "glBindVertexArray")                              \
    X(blendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC, "glBlendFuncSeparate")                        \
    X(blitFramebuffer, PFNGLBLITFRAMEBUFFERPROC, "glBlitFramebuffer")                              \
    X(bufferData, PFNGLBUFFERDATAPROC, "glBufferData")                                             \
    X(bufferSubData, PFNGLBUFFERSUBDATAPROC, "glBufferSubData")                                    \
    X(checkFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC, "glCheckFramebufferStatus")         \
    X(clear, PFNGLCLEARPROC, "glClear")                                                            \
    X(clearColor, PFNGLCLEARCOLORPROC, "glClearColor")                                             \
    X(clearStencil, PFNGLCLEARSTENCILPROC, "glClearStencil")                                       \
    X(compileShader, PFNGLCOMPILESHADERPROC, "glCompileShader")                                    \
    X(createProgram, PFNGLCREATEPROGRAMPROC, "glCreateProgram")                                    \
    X(createShader, PFNGLCREATESHADERPROC, "glCreateShader")                                       \
    X(cullFace, PFNGLCULLFACEPROC, "glCullFace")                                                   \
    X(deleteBuffers, PFNGLDELETEBUFFERSPROC, "glDeleteBuffers")                                    \
    X(deleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC, "glDeleteFramebuffers")                     \
    X(deleteProgram, PFNGLDELETEPROGRAMPROC, "glDeleteProgram")                                    \
    X(deleteRenderbuffers, PFNGLDELETERENDERBUFFERSPROC, "glDeleteRenderbuffers")                  \
    X(deleteShader, PFNGLDELETESHADERPROC, "glDeleteShader")                                       \
    X(deleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC, "glDeleteVertexArrays")                     \
    X(depthMask, PFNGLDEPTHMASKPROC, "glDepthMask")                                                \
    X(disable, PFNGLDISABLEPROC, "glDisable")                                                      \
    X(drawArrays, PFNGLDRAWARRAYSPROC, "glDrawArrays")                                             \
    X(drawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC, "glDrawArraysInstanced")                  \
    X(drawBuffers, PFNGLDRAWBUFFERSPROC, "glDrawBuffers")                                          \
    X(drawElements, PFNGLDRAWELEMENTSPROC, "glDrawElements")                                       \
    X(drawElementsBaseVertex, PFNGLDRAWELEMENTSBASEVERTEXPROC, "glDrawElementsBaseVertex")         \
    X(enable, PFNGLENABLEPROC, "glEnable")                                                         \
    X(enableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC, "glEnableVertexAttribArray")      \
    X(finish, PFNGLFINISHPROC, "glFinish")                                                         \
    X(framebufferRenderbuffer, PFNGLFRAMEBUFFERRENDERBUFFERPROC, "glFramebufferRenderbuffer")      \
    X(genBuffers, PFNGLGENBUFFERSPROC, "glGenBuffers")                                             \
    X(genFramebuffers, PFNGLGENFRAMEBUFFERSPROC, "glGenFramebuffers")                              \
    X(genRenderbuffers, PFNGLGENRENDERBUFFERSPROC, "glGenRenderbuffers")                           \
    X(genVertexArrays, PFNGLGENVERTEXARRAYSPROC, "glGenVertexArrays")                              \
    X(getIntegerv, PFNGLGETINTEGERVPROC, "glGetIntegerv")                                          \
    X(getMultisamplefv, PFNGLGETMULTISAMPLEFVPROC, "glGetMultisamplefv")                           \
    X(getProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC, "glGetProgramInfoLog")                        \
    X(getProgramiv, PFNGLGETPROGRAMIVPROC, "glGetProgramiv")                                       \
    X(getShaderInfoLog, PFNGLGETSHADERINFOLOGPROC, "glGetShaderInfoLog")                           \
    X(getShaderiv, PFNGLGETSHADERIVPROC, "glGetShaderiv")                                          \
    X(getString, PFNGLGETSTRINGPROC, "glGetString")                                                \
    X(getUniformLocation, PFNGLGETUNIFORMLOCATIONPROC, "glGetUniformLocation")                     \
    X(linkProgram, PFNGLLINKPROGRAMPROC, "glLinkProgram")                                          \
    X(pixelStorei, PFNGLPIXELSTOREIPROC, "glPixelStorei")                                          \
    X(readBuffer, PFNGLREADBUFFERPROC, "glReadBuffer")                                             \
    X(readPixels, PFNGLREADPIXELSPROC, "glReadPixels")                                             \
    X(renderbufferStorageMultisample, PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC,                     \
      "glRenderbufferStorageMultisample")                                                          \
    X(scissor, PFNGLSCISSORPROC, "glScissor")                                                      \
    X(shaderSource, PFNGLSHADERSOURCEPROC, "glShaderSource")                                       \
    X(stencilFunc, PFNGLSTENCILFUNCPROC, "glStencilFunc")                                          \
    X(stencilOp, PFNGLSTENCILOPPROC, "glStencilOp")                                                \
    X(uniform1f, PFNGLUNIFORM1FPROC, "glUniform1f")                                                \
    X(uniform1i, PFNGLUNIFORM1IPROC, "glUniform1i")                                                \
    X(uniform2fv, PFNGLUNIFORM2FVPROC, "glUniform2fv")                                             \
    X(uniform3fv, PFNGLUNIFORM3FVPROC, "glUniform3fv")                                             \
    X(uniform4fv, PFNGLUNIFORM4FVPROC, "glUniform4fv")                                             \
    X(uniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC, "glUniformMatrix4fv")                           \
    X(useProgram, PFNGLUSEPROGRAMPROC, "glUseProgram")                                             \
    X(vertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC, "glVertexAttribDivisor")                  \
    X(vertexAttribIPointer, PFNGLVERTEXATTRIBIPOINTERPROC, "glVertexAttribIPointer")               \
    X(vertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC, "glVertexAttribPointer")                  \
    X(viewport, PFNGLVIEWPORTPROC, "glViewport")

/// The functions of one context, to be called while it is current.
struct GlFunctions
{
#define FROSTFILL_GL_MEMBER(member, type, name) type member = nullptr;
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
