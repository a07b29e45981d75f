#pragma once
// What stands beside the name of a method in the P-NDF panel.

#include <string>

#include "core/document/document.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::view {

/// That of the method among the results; null where there is none.
const MethodPicture* picture_of(const PndfResults* results, PndfMethod method);

/// "32 triangles, shifted", "h 0.5, atlas", "1 M samples"; of auto, who answered. Less of it where there is little
/// room.
std::string setting_text(const Document& document, const PndfResults* results, PndfMethod method, bool compact);

}  // namespace glint::view
