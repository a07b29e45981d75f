#pragma once
// The moments of the slopes under a pixel footprint: the merge rule of lean_moments.h with the footprint's Gaussian for
// weights ("elliptical filtering").

#include <functional>

#include "core/pndf/footprint.h"
#include "core/pndf/lean_moments.h"
#include "core/surface/surface.h"

namespace glint {

/// A footprint is at least so many texels, or blocks, wide where those are merged: see footprint_moments.
inline constexpr double k_least_texel_deviation = 0.75;  ///< on the smooth surface
inline constexpr double k_least_flake_deviation = 2;     ///< on the constant one
inline constexpr double k_least_block_deviation = 2;
/// Merged within so many deviations; 4e-6 of the mass lies beyond.
inline constexpr double k_lean_cut = 5;
/// Where points of the surface are merged instead, at most so many. Only footprints narrower than a texel and above
/// some 100 long would need more: theirs lie further apart, and so sample the slopes along it.
inline constexpr double k_most_lean_points = 1 << 16;

/// Deviations are those of the footprint's narrowest direction. Below 0.75 texels it merges points of the surface,
/// below two blocks of 4 x 4 the texels, and above the largest blocks of which it is two wide; a footprint so wide that
/// a map that repeats is uniform under it takes the whole map. On the constant surface texels have the mass of their
/// squares. `chain` is called where blocks are needed and returns those of the surface's map. `footprint` is free of
/// faults.
SlopeMoments footprint_moments(const Surface& surface, const Footprint& footprint,
                               const std::function<const LeanMoments&()>& chain);

}  // namespace glint
