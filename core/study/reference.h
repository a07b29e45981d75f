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

/// Linear and constant surfaces are evaluated as they are. The smooth surface is evaluated with shifted vertices on
/// 4 x 4, 8 x 8, … sub-cells a texel until the relative L1 changes by less than 2e-4. Nothing if cancelled.
std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, JobControl& control);

}  // namespace glint
