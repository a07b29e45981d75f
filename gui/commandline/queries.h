#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/result.h"

namespace glint::gui {

/// The normals of `--queries FILE`, one `s t` a line ("-" is standard input); empty lines are passed over. A malformed
/// line is a request error that names its number.
Result<std::vector<glm::dvec2>> read_queries(const std::string& file);

}  // namespace glint::gui
