// The OpenGL functions that the viewer's own drawing calls, looked up once a context exists.
//
// One program draws with libGL (a window) or with libOSMesa (headless), so neither is linked. Dear ImGui's
// back end loads its functions by itself (gl_lookup.cpp helps it headless). Nothing beyond core 3.3.
#pragma once

#include <functional>

#include <GL/glcorearb.h>

#include "engine/base/result.h"

namespace glint {

#define GLINT_GL_FUNCTIONS(X)                                  \
    X(PFNGLGETSTRINGPROC, GetString)                           \
    X(PFNGLGETERRORPROC, GetError)                             \
    X(PFNGLVIEWPORTPROC, Viewport)                             \
    X(PFNGLCLEARCOLORPROC, ClearColor)                         \
    X(PFNGLCLEARPROC, Clear)                                   \
    X(PFNGLFINISHPROC, Finish)                                 \
    X(PFNGLDISABLEPROC, Disable)                               \
    X(PFNGLREADPIXELSPROC, ReadPixels)                         \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                       \
    X(PFNGLGENTEXTURESPROC, GenTextures)                       \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                 \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                       \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                   \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                         \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                   \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                   \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)               \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)               \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)     \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus) \
    X(PFNGLCREATESHADERPROC, CreateShader)                     \
    X(PFNGLDELETESHADERPROC, DeleteShader)                     \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                     \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                   \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                       \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)             \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                   \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                   \
    X(PFNGLATTACHSHADERPROC, AttachShader)                     \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                       \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                     \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)           \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                         \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)         \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                           \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                           \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)             \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)               \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)         \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)               \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)

/// Function pointers named as OpenGL's functions without their prefix: gl.Viewport(...).
struct GlApi {
#define GLINT_GL_MEMBER(type, name) type name = nullptr;
    GLINT_GL_FUNCTIONS(GLINT_GL_MEMBER)
#undef GLINT_GL_MEMBER
};

using GlProc = void (*)();
using GlLookup = std::function<GlProc(const char* name)>;

/// Needs a current context. Error: the first function that is missing, with the driver's name where it
/// is known.
Result<GlApi> loadGlApi(const GlLookup& lookup);

}  // namespace glint
