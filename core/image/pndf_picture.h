#pragma once
// P-NDF images side by side in false colour, with their one scale: what `pndf -o X.png` writes.

#include <filesystem>
#include <span>
#include <string>

#include "core/image/canvas.h"
#include "core/pndf/pndf_grid.h"

namespace glint {

struct PictureEntry {
  std::string title;    ///< "exact"
  std::string detail;   ///< "smooth surface, 32 triangles a texel", beside the title
  std::string caption;  ///< a line of figures under the picture
  const PndfImage* image;
};

/// All entries on one grid and one logarithmic scale, fitted to the first; `footer` is one line under them all. Where a
/// window reaches beyond the unit disk, the rim is drawn.
Canvas draw_pndf_picture(std::span<const PictureEntry> entries, const std::string& footer);

}  // namespace glint
