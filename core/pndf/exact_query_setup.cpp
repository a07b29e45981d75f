// Of exact queries: what one footprint prepares, in plain C++.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/pndf/exact_query.h"
#include "core/pndf/query_scratch.h"
#include "core/pndf/triangle_kernel.h"

namespace glint {
namespace {

constexpr double k_most_groups = 1e6;

// Of cells that the footprint reaches.
double group_estimate(const NormalMap& map, const FootprintWindow& window, double cut) {
  const double width = std::min(NormalBounds::k_group, map.width());
  const double height = std::min(NormalBounds::k_group, map.height());
  return (2 * window.reach_x(cut) / width + 2) * (2 * window.reach_y(cut) / height + 2);
}

// Calls body(group, offset of its first cell) for each group of the axis that meets [lo, hi], in offsets from the
// centre; a map that repeats has groups in every period.
template <class Body>
void for_groups(const SurfaceCells::Axis& axis, double first_offset, double reach, int groups, Body body) {
  const double period = static_cast<double>(axis.count);
  const double first_period = axis.periodic ? std::floor((-reach - first_offset) / period) : 0;
  const double last_period = axis.periodic ? std::floor((reach - first_offset) / period) : 0;
  for (double p = first_period; p <= last_period; ++p) {
    for (int group = 0; group < groups; ++group) {
      const double lo = first_offset + p * period + group * NormalBounds::k_group;
      const double size = std::min<double>(NormalBounds::k_group, period - group * NormalBounds::k_group);
      if (lo <= reach && lo + size >= -reach) body(group, lo, size);
    }
  }
}

}  // namespace

bool can_query(const SurfaceCells& cells, const FootprintWindow& window, glm::dvec2 center, double roughness,
               double cut) {
  assert(cut * cut < 31 && "children without cells are told by bounds 32 squared roughnesses away");
  if (roughness < k_least_single_roughness || !suits_single_precision(window, cut)) return false;
  if (group_estimate(cells.surface().map(), window, cut) > k_most_groups) return false;
  const Interpolation interpolation = cells.surface().interpolation();
  if (interpolation == Interpolation::constant) return false;
  if (interpolation == Interpolation::smooth && cells.subdivision() != 4) return false;
  if (cells.surface().map().wrap() == Wrap::repeat) return true;
  const NormalMap& map = cells.surface().map();
  const double u = window.reach_x(cut) + 1;
  const double v = window.reach_y(cut) + 1;
  return center.x - u > 0 && center.x + u < map.width() && center.y - v > 0 && center.y + v < map.height();
}

QueryFrame make_query_frame(const SurfaceCells& cells, const NormalBounds& bounds, const FootprintWindow& window,
                            glm::dvec2 center, double roughness, double cut) {
  const Whitening& w = window.whitening();
  QueryFrame frame{
      &cells,
      &bounds,
      static_cast<float>(w.w11),
      static_cast<float>(w.w12),
      static_cast<float>(w.w22),
      static_cast<float>(1 / roughness),
      static_cast<float>(cut),
      static_cast<float>(w.determinant() / (4 * std::numbers::pi * std::numbers::pi * roughness * roughness)),
      {}};
  const double first_u = static_cast<double>(cells.axis_u().first) + cells.border() - center.x;
  const double first_v = static_cast<double>(cells.axis_v().first) + cells.border() - center.y;
  for_groups(cells.axis_v(), first_v, window.reach_y(cut), bounds.group_rows(), [&](int b, double top, double height) {
    for_groups(cells.axis_u(), first_u, window.reach_x(cut), bounds.group_columns(),
               [&](int a, double left, double width) {
                 if (window.squared_distance({{left, left + width}, {top, top + height}}) >= cut * cut) return;
                 frame.groups.push_back(
                     {&bounds.group(a, b), 4 * a, 4 * b, static_cast<float>(left), static_cast<float>(top)});
               });
  });
  return frame;
}

double sum_in_double(const QueryFrame& frame, const TriangleList& triangles, float leg,
                     const std::array<float, 2>& low) {
  const Whitening whitening{frame.w11, frame.w12, frame.w22};
  const double roughness = 1 / static_cast<double>(frame.inverse_roughness);
  double sum = 0;
  for (std::size_t k = 0; k < triangles.count; ++k) {
    const auto pair = [&](std::size_t field) {
      return glm::dvec2(triangles.fields[field][k], triangles.fields[field + 1][k]);
    };
    const SurfaceTriangle triangle{pair(0), leg, leg, {pair(2), pair(4), pair(6)}};
    sum += TriangleKernel(triangle, whitening, glm::dvec2(roughness)).density({low[0], low[1]}, frame.cut);
  }
  return sum;
}

}  // namespace glint
