#pragma once

#include "core/pndf/footprint.h"
#include "core/pndf/pndf_grid.h"
#include "core/surface/surface.h"

namespace glint {

/// A square window round the lobe of D_P, cut into cells x cells: it holds the normals of 16384 positions spread evenly
/// over the footprint (all but the one outermost on each side) and 4.5 sigma_r around them, at most [-1, 1]^2.
PndfGrid fitted_window(const Surface& surface, const Footprint& footprint, double intrinsic_roughness, int cells);

}  // namespace glint
