#pragma once
// Numbers that tell whether a normal map was read as it was meant: is its slope field that of a surface, does it
// repeat.

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "core/surface/normal_map.h"

namespace glint {

/// The slopes of a surface have no curl: dh_u/dv = dh_v/du. Of a map read with the wrong direction of green they have,
/// and have none once t is negated. Returns the mean squared curl with t negated over that with t as it is: above 1
/// speaks for the map as it stands, below 1 for the other direction. Slopes above 5 are left
/// out, so that a few steep texels do not decide. Nothing if too little of the map is left, or it is too flat, to tell;
/// large maps are sampled.
std::optional<double> curl_ratio(const NormalMap& map);

/// A curl ratio above this, or below its inverse, is clear. Real maps are rarely integrable exactly.
inline constexpr double k_clear_curl_ratio = 1.6;

/// The mean jump between opposite edges over the mean jump between neighbours inside: about 1 where a map repeats.
struct SeamRatios {
  double left_right = 0;  ///< 0 where there is no jump, or too little map to tell
  double top_bottom = 0;
};

SeamRatios seam_ratios(const NormalMap& map);
/// Of a height field, rows from the top; jumps that are not finite are left out.
SeamRatios seam_ratios(std::span<const float> heights, int width, int height);

/// A seam ratio above this is a seam that shows.
inline constexpr double k_clear_seam_ratio = 3;

inline constexpr double k_step_of_8_bits = 2.0 / 255;
inline constexpr double k_step_of_16_bits = 2.0 / 65535;

/// The step of the integers that the map was stored as, found in the values themselves: s and t, or three components of
/// some length before it was normalised, are all of (2 k - 255) / 255, or of its like in 16 bits. 0 where they are not,
/// or do not vary; looks at 256 texels.
double value_step(const NormalMap& map);

/// Whether the map about these positions (texels) is made of flat pieces with jumps between: at least half of all
/// neighbours are equal, and at least half of the others jump, by more than three steps of 8 bits, from one pair of
/// equal ones to another.
bool is_flat_in_pieces(const NormalMap& map, std::span<const glm::dvec2> positions);

}  // namespace glint
