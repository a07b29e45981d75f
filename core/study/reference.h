#pragma once
// The reference of a surface: the exact method in double precision, with its own error.

#include <optional>

#include "core/math/parallel.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/pndf_model.h"
#include "core/surface/surface.h"

namespace glint {

struct ReferenceImage {
  Interpolation surface;
  PndfImage image;
  /// Smooth: the relative L1 between the last two refinements. Linear and constant: the bound of what the image's cut
  /// leaves out, for there the triangles are the surface.
  double own_error = 0;
};

/// What the cells of an image hold: the value at their centre, or the mean over them (binning).
enum class CellContent { point, mean };

/// Linear and constant surfaces are evaluated as they are. The smooth surface is evaluated with shifted vertices on
/// 4 x 4, 8 x 8, … sub-cells a texel until the relative L1 changes by less than 2e-4. The joint cut is 8. Means are
/// taken over 2 x 2 Gauss points of each cell; where the grid is so coarse that the exact image widens the roughness,
/// its cells are means already. Nothing if cancelled.
std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, CellContent content,
                                              JobControl& control);

}  // namespace glint
