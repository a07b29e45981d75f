#pragma once
// The P-NDF pictures of a document as one picture with its scale, for `pndf -o X.png` and the window's export.

#include <cstdint>
#include <span>
#include <string>

#include "core/document/document.h"
#include "core/image/canvas.h"
#include "core/pndf/pndf_grid.h"

namespace glint::gui {

struct MethodImage {
  PndfMethod method = PndfMethod::exact;
  Interpolation surface = Interpolation::smooth;
  const PndfImage* image = nullptr;
};

/// Times stay out of it: equal inputs give equal bytes.
Canvas false_color_picture(const Document& document, std::span<const MethodImage> images);

/// Own noise as people read it: "1.2 %", "none", or "unknown" without a sample in the window.
std::string noise_text(const PndfImage& image);

}  // namespace glint::gui
