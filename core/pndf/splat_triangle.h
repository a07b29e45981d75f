#pragma once
// One triangle on its way into a P-NDF image in single precision: what the per-target parts of triangle_splat.cpp
// share.

#include <array>
#include <cstdint>
#include <vector>

#include "core/pndf/triangle_rules.h"
#include "core/pndf/triangle_splat.h"

namespace glint {

// For whole panels across the longest edge that splat() takes.
inline constexpr int k_most_nodes = 336;

struct alignas(64) SplatScratch::Arrays {
  // Of the rays, affine in the cell's column x and row y: the distance of the line, p0 + px x + py y, and of its start,
  // b0 + bx x + by y; both in units in which exp(-x^2 / 2) is 2^(-x^2).
  std::array<float, k_most_nodes> p0, px, py, b0, bx, by, length, weight;
  std::vector<std::int32_t> first;  // columns of each row that are in reach
  std::vector<std::int32_t> last;
  std::vector<float> row_factors;  // of points, by point
  std::vector<float> column_factors;
};

// A triangle after the QR, whitened; x and y count cells from an origin near it.
struct SplatTriangle {
  float r11, r12, r22;
  float wx0, wxx, wxy;  // the right-angled vertex: (wx0 + wxx x + wxy y, wy0 + wyx x + wyy y)
  float wy0, wyx, wyy;
  // log2 of the residual's factor is -(u0 + ux x + uy y)^2 - (v0 + vx x + vy y)^2: as squares of two lengths, for the
  // terms of their sum would cancel.
  float u0, ux, uy;
  float v0, vx, vy;
  float factor;
};

struct SplatEdges {
  float to_du;  // squared length of the edge from the right angle to the end of du
  float to_dv;
  float between;
};

inline SplatEdges edges_of(const SplatTriangle& t) {
  const float across = t.r12 - t.r11;
  return {t.r11 * t.r11, t.r12 * t.r12 + t.r22 * t.r22, across * across + t.r22 * t.r22};
}

}  // namespace glint
