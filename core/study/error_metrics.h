#pragma once
// Errors of one P-NDF image against another on the same grid, as the conventions name them.

#include "core/pndf/pndf_grid.h"

namespace glint {

struct PndfErrors {
  double relative_l1 = 0;   ///< integral of |D - D_ref| over integral of D_ref: the headline figure
  double peak_error = 0;    ///< max |D - D_ref| / max D_ref
  double energy_error = 0;  ///< |integral of D - integral of D_ref|
};

/// Both images have the same grid; `reference` has mass.
PndfErrors compare(const PndfImage& image, const PndfImage& reference);

}  // namespace glint
