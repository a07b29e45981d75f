#pragma once
// The OpenGL functions this program calls, found at run time through the context's own look-up. Nothing links libGL:
// the same code draws in a window (GLFW) and without a display (OSMesa).

#include <GL/glcorearb.h>
#include <functional>

#include "core/math/result.h"

namespace glint::view {

// clang-format off
#define GLINT_GL_FUNCTIONS(X)                                                                                         \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDBUFFER, BindBuffer)                             \
  X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDRENDERBUFFER, BindRenderbuffer) X(BINDSAMPLER, BindSampler)               \
  X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray) X(BLENDEQUATION, BlendEquation)                     \
  X(BLENDFUNCSEPARATE, BlendFuncSeparate) X(BLITFRAMEBUFFER, BlitFramebuffer) X(BUFFERDATA, BufferData)               \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear) X(CLEARCOLOR, ClearColor)                         \
  X(COMPILESHADER, CompileShader) X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader)                       \
  X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) X(DELETEPROGRAM, DeleteProgram)           \
  X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESAMPLERS, DeleteSamplers) X(DELETESHADER, DeleteShader)         \
  X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays) X(DISABLE, Disable)                     \
  X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex) X(ENABLE, Enable)                                                 \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FINISH, Finish)                                               \
  X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) X(GENBUFFERS, GenBuffers)                                       \
  X(GENERATEMIPMAP, GenerateMipmap) X(GENFRAMEBUFFERS, GenFramebuffers) X(GENRENDERBUFFERS, GenRenderbuffers)         \
  X(GENSAMPLERS, GenSamplers) X(GENTEXTURES, GenTextures) X(GENVERTEXARRAYS, GenVertexArrays) X(GETERROR, GetError)   \
  X(GETINTEGERV, GetIntegerv) X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv)                   \
  X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv) X(GETSTRING, GetString)                           \
  X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) X(PIXELSTOREI, PixelStorei)                   \
  X(READPIXELS, ReadPixels) X(RENDERBUFFERSTORAGE, RenderbufferStorage) X(SAMPLERPARAMETERI, SamplerParameteri)       \
  X(SCISSOR, Scissor) X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D) X(UNIFORM1I, Uniform1i)                 \
  X(UNIFORM4F, Uniform4f) X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(USEPROGRAM, UseProgram)                             \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)
// clang-format on

/// `gl.BindTexture(…)` is glBindTexture of the context the table was loaded from, which must be current.
struct GlFunctions {
#define GLINT_GL_MEMBER(type, name) PFNGL##type##PROC name = nullptr;
  GLINT_GL_FUNCTIONS(GLINT_GL_MEMBER)
#undef GLINT_GL_MEMBER
};

using GlLookUp = std::function<void (*(const char* name))()>;

/// Fills the table; an error names the first function that is missing, or a version below 3.3.
Result<GlFunctions> load_gl_functions(const GlLookUp& look_up);

}  // namespace glint::view
