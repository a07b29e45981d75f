#include "viewers/gl/gl_functions.h"

namespace glint::view {

Result<GlFunctions> load_gl_functions(const GlLookUp& look_up) {
  GlFunctions gl;
#define GLINT_GL_LOAD(type, name)                                     \
  gl.name = reinterpret_cast<PFNGL##type##PROC>(look_up("gl" #name)); \
  if (gl.name == nullptr) return content_error("OpenGL", "lacks gl" #name);
  GLINT_GL_FUNCTIONS(GLINT_GL_LOAD)
#undef GLINT_GL_LOAD
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 33) {
    return content_error("OpenGL", "is version " + std::to_string(major) + "." + std::to_string(minor) +
                                       "; the window needs 3.3 or later");
  }
  return gl;
}

}  // namespace glint::view
