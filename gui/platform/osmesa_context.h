#pragma once
// OpenGL in memory, without a display: for screenshots, scripts and tests.

#include <memory>

#include "core/math/result.h"
#include "viewers/gl/gl_context.h"

namespace glint::gui {

/// Fails with one sentence where libOSMesa is not installed.
Result<std::unique_ptr<view::GlContext>> make_osmesa_context(glm::ivec2 size);

}  // namespace glint::gui
