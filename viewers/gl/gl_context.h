#pragma once
// Where OpenGL comes from. gui/ has one on GLFW (a window) and one on OSMesa (memory), chosen at run time.

#include <glm/vec2.hpp>

#include "viewers/gl/gl_functions.h"

namespace glint::view {

/// Belongs to the thread that made it.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  virtual void make_current() = 0;
  /// The functions of this context, loaded when it was made.
  [[nodiscard]] virtual const GlFunctions& gl() const = 0;
  /// Pixels of what is drawn to.
  [[nodiscard]] virtual glm::ivec2 size() const = 0;
};

}  // namespace glint::view
