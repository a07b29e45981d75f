#pragma once
// Private to footprint_moments: footprints narrower than a texel, by quadrature.

#include "core/pndf/footprint.h"
#include "core/pndf/lean_moments.h"
#include "core/surface/surface.h"

namespace glint {

/// Of the surface at the points of a sheared lattice, at most half a deviation and 3/8 of a texel apart, within
/// k_lean_cut deviations, unless that takes more than k_most_lean_points: then wider apart along the footprint's longer
/// side.
SlopeMoments point_moments(const Surface& surface, const Footprint& footprint);

/// Of the constant surface: its texels, by the mass of the footprint over their squares.
SlopeMoments flake_moments(const Surface& surface, const Footprint& footprint);

}  // namespace glint
