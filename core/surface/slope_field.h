#pragma once
// Private to the generators: the slopes (h_u, h_v) per texel of a square periodic height field, dimensionless, along
// right and down. Heights are additive, and so are slopes. Every function gives the same bytes for any number of
// threads and returns false, with the field in no particular state, if the job was cancelled.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"

namespace glint {

struct SlopeField {
  int size = 0;
  std::vector<glm::vec2> slopes;  ///< size x size, rows from the top

  /// Level ground.
  explicit SlopeField(int texels_per_side)
      : size(texels_per_side), slopes(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}
};

/// Runs body(row) for every row of a map, a few rows to a block.
bool for_each_row(int size, JobControl& control, const std::function<void(int)>& body);

/// Scales the field so that the root mean square over both slope components is `rms_slope`. Level ground stays level.
bool set_rms_slope(SlopeField& field, double rms_slope, JobControl& control);

/// Fills the field with the slopes of white noise filtered to the height autocorrelation exp(-x^2 / l^2), at the given
/// RMS slope. The size is a power of two; l = correlation_length is in texels, at least 1.5 and at most a quarter of
/// it.
bool fill_gaussian_slopes(SlopeField& field, std::uint64_t seed, double correlation_length, double rms_slope,
                          JobControl& control);

/// Turns slopes into projected normals (s, t) in place: field.slopes then holds what a NormalMap takes.
bool slopes_to_normals(SlopeField& field, JobControl& control);

}  // namespace glint
