#pragma once
// Private to the scratch generator: lines engraved into a square periodic height field, and its blur. Both give the
// same bytes for any number of threads and return false if the job was cancelled.

#include <span>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"

namespace glint {

/// A straight groove with the profile h = -g w sqrt(e) exp(-x^2 / (2 w^2)) across: its largest slope is g, at x = +-w.
/// Its ends rise smoothly (smoothstep, over 4 w or half the length) within the length.
struct Scratch {
  glm::dvec2 center;   ///< texels
  double angle;        ///< radians from the u axis towards the top of the picture
  double length;       ///< texels, from end to end
  double half_width;   ///< w, texels
  double flank_slope;  ///< g, dimensionless
};

/// Texels visited for one scratch, about; what bounds the work.
double engraved_area(double length, double half_width);

/// Lowers `heights` (size x size, rows from the top, in texels) to the bottom of every scratch and of its periodic
/// images. Crossing scratches do not add up: the lower one wins.
bool engrave(std::span<float> heights, int size, std::span<const Scratch> scratches, JobControl& control);

/// Periodic Gaussian blur of the given standard deviation in texels; 0 changes nothing.
bool blur_heights(std::span<float> heights, int size, double deviation, JobControl& control);

}  // namespace glint
