#pragma once
// The walk over all cells that a truncated footprint touches, tile by tile, in one fixed order.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/pndf/footprint_window.h"
#include "core/pndf/surface_cells.h"

namespace glint {

/// What of the walk one task does: tile rows first, first + stride, … Different tasks touch different cells.
struct VisitShare {
  std::int64_t first = 0;
  std::int64_t stride = 1;
};

namespace cell_visit_detail {

inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

inline std::int64_t floor_index(double x) {
  return static_cast<std::int64_t>(std::floor(x));
}

// Calls body(first cell, last cell, tile, ordinal) for each tile of the axis that meets cells [lo, hi].
template <class Body>
void for_tiles(const SurfaceCells::Axis& axis, std::int64_t lo, std::int64_t hi, Body body) {
  if (!axis.periodic) {
    lo = std::clamp(lo, axis.first, axis.first + axis.count - 1);
    hi = std::clamp(hi, axis.first, axis.first + axis.count - 1);
  }
  const std::int64_t tiles = (axis.count + SurfaceCells::k_tile - 1) / SurfaceCells::k_tile;
  const std::int64_t last_period = floor_divide(hi - axis.first, axis.count);
  for (std::int64_t period = floor_divide(lo - axis.first, axis.count); period <= last_period; ++period) {
    const std::int64_t begin = axis.first + period * axis.count;
    const std::int64_t first_tile = std::max<std::int64_t>(0, floor_divide(lo - begin, SurfaceCells::k_tile));
    for (std::int64_t tile = first_tile; tile < tiles; ++tile) {
      const std::int64_t tile_begin = begin + tile * SurfaceCells::k_tile;
      if (tile_begin > hi) break;
      const std::int64_t tile_end = std::min(tile_begin + SurfaceCells::k_tile, begin + axis.count);
      body(std::max(lo, tile_begin), std::min(hi, tile_end - 1), tile, period * tiles + tile);
    }
  }
}

}  // namespace cell_visit_detail

/// Calls visit(CellIndex, OffsetBox, NormalBox) for each cell that can hold a point with
/// d_u^2 + d_s^2 < cut^2, where d_u is the distance from the footprint's centre in its deviations and d_s^2 at least
/// squared_s(NormalBox). `center` is the footprint's centre in texels.
template <class SquaredDistance, class Visit>
void visit_cells(const SurfaceCells& cells, const FootprintWindow& window, glm::dvec2 center, double cut,
                 VisitShare share, SquaredDistance squared_s, Visit visit) {
  using namespace cell_visit_detail;  // NOLINT(google-build-using-namespace)
  const double limit = cut * cut;
  const double reach_u = window.reach_x(cut);
  const double reach_v = window.reach_y(cut);
  const auto column_of = [&](double offset) { return floor_index(offset + center.x - cells.border()); };
  const auto row_of = [&](double offset) { return floor_index(offset + center.y - cells.border()); };

  for_tiles(
      cells.axis_v(), row_of(-reach_v), row_of(reach_v),
      [&](std::int64_t j0, std::int64_t j1, std::int64_t tile_row, std::int64_t ordinal) {
        if (((ordinal % share.stride) + share.stride) % share.stride != share.first) return;
        const Interval band{cells.row_span(j0, center.y, reach_v).lo, cells.row_span(j1, center.y, reach_v).hi};
        const std::optional<Interval> columns = window.columns(band, cut);
        if (!columns) return;
        for_tiles(
            cells.axis_u(), column_of(columns->lo), column_of(columns->hi),
            [&](std::int64_t i0, std::int64_t i1, std::int64_t tile_column, std::int64_t) {
              const OffsetBox tile{
                  {cells.column_span(i0, center.x, reach_u).lo, cells.column_span(i1, center.x, reach_u).hi}, band};
              if (window.squared_distance(tile) + squared_s(cells.tile_box(tile_column, tile_row)) >= limit) return;
              for (std::int64_t j = j0; j <= j1; ++j) {
                for (std::int64_t i = i0; i <= i1; ++i) {
                  const OffsetBox box{cells.column_span(i, center.x, reach_u), cells.row_span(j, center.y, reach_v)};
                  const double squared_u = window.squared_distance(box);
                  if (squared_u >= limit) continue;
                  const NormalBox normals = cells.cell_box({i, j});
                  if (squared_u + squared_s(normals) < limit) visit(CellIndex{i, j}, box, normals);
                }
              }
            });
      });
}

/// Calls visit(CellIndex) for each cell of one period (of a map that repeats) whose box of normals passes `keep`.
template <class Keep, class Visit>
void visit_period(const SurfaceCells& cells, VisitShare share, Keep keep, Visit visit) {
  using namespace cell_visit_detail;  // NOLINT(google-build-using-namespace)
  const SurfaceCells::Axis u = cells.axis_u();
  const SurfaceCells::Axis v = cells.axis_v();
  for_tiles(v, 0, v.count - 1, [&](std::int64_t j0, std::int64_t j1, std::int64_t tile_row, std::int64_t ordinal) {
    if (ordinal % share.stride != share.first) return;
    for_tiles(u, 0, u.count - 1, [&](std::int64_t i0, std::int64_t i1, std::int64_t tile_column, std::int64_t) {
      if (!keep(cells.tile_box(tile_column, tile_row))) return;
      for (std::int64_t j = j0; j <= j1; ++j) {
        for (std::int64_t i = i0; i <= i1; ++i) {
          if (keep(cells.cell_box({i, j}))) visit(CellIndex{i, j});
        }
      }
    });
  });
}

/// The centre brought into the map where it repeats, so that offsets keep their last digits.
inline glm::dvec2 reduced_center(const NormalMap& map, glm::dvec2 center) {
  if (map.wrap() == Wrap::clamp) return center;
  const auto reduce = [](double x, double period) { return x - period * std::floor(x / period); };
  return {reduce(center.x, map.width()), reduce(center.y, map.height())};
}

}  // namespace glint
