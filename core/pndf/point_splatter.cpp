#include "core/pndf/point_splatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

// exp(-x^2 / 2) at x0, x0 + step, …: each value from the one before by one product, the ratio by another. After n steps
// the relative error is about n^2 rounding errors: below 1e-8 for the longest line a grid can have.
struct GaussianRecurrence {
  GaussianRecurrence(double x0, double step)
      : value(std::exp(-0.5 * x0 * x0)),
        ratio(std::exp(-step * (x0 + 0.5 * step))),
        ratio_of_ratios(std::exp(-step * step)) {}

  double next() {
    const double current = value;
    value *= ratio;
    ratio *= ratio_of_ratios;
    return current;
  }

  double value;
  double ratio;
  double ratio_of_ratios;
};

int clamped_ceil(double x, int lo, int hi) {
  return static_cast<int>(std::clamp(std::ceil(x), static_cast<double>(lo), static_cast<double>(hi)));
}

}  // namespace

PointSplatter::PointSplatter(const PndfGrid& grid, int first_row, int rows, glm::dvec2 roughness)
    : grid_(grid),
      first_row_(first_row),
      rows_(rows),
      roughness_(roughness),
      peak_(1 / (2 * std::numbers::pi * roughness.x * roughness.y)),
      sums_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(grid.columns)),
      profile_(static_cast<std::size_t>(grid.columns)) {}

// Columns whose centres s_min + (c + 0.5) pitch lie in [lo, hi].
PointSplatter::Range PointSplatter::column_range(double lo, double hi) const {
  const double pitch = grid_.pitch().x;
  const int begin = clamped_ceil((lo - grid_.s_min) / pitch - 0.5, 0, grid_.columns);
  return {begin, clamped_ceil(std::nextafter((hi - grid_.s_min) / pitch + 0.5, 1e300), begin, grid_.columns)};
}

// Rows of this band whose centres t_max - (r + 0.5) pitch lie in [lo, hi].
PointSplatter::Range PointSplatter::row_range(double lo, double hi) const {
  const double pitch = grid_.pitch().y;
  const int begin = clamped_ceil((grid_.t_max - hi) / pitch - 0.5, first_row_, first_row_ + rows_);
  return {begin, clamped_ceil(std::nextafter((grid_.t_max - lo) / pitch + 0.5, 1e300), begin, first_row_ + rows_)};
}

double PointSplatter::count_cells(glm::dvec2 lo, glm::dvec2 hi) const {
  const Range columns = column_range(lo.x, hi.x);
  const Range rows = row_range(lo.y, hi.y);
  return static_cast<double>(columns.end - columns.begin) * static_cast<double>(rows.end - rows.begin);
}

void PointSplatter::add(double weight, glm::dvec2 normal, double reach) {
  const glm::dvec2 extent = reach * roughness_;
  const Range columns = column_range(normal.x - extent.x, normal.x + extent.x);
  const Range rows = row_range(normal.y - extent.y, normal.y + extent.y);
  const int count = columns.end - columns.begin;
  if (count <= 0 || rows.begin >= rows.end) return;

  const glm::dvec2 first = (grid_.center(columns.begin, rows.begin) - normal) / roughness_;
  GaussianRecurrence along_s(first.x, grid_.pitch().x / roughness_.x);
  for (int k = 0; k < count; ++k) profile_[static_cast<std::size_t>(k)] = along_s.next();

  GaussianRecurrence along_t(first.y, -grid_.pitch().y / roughness_.y);
  const double* profile = profile_.data();
  for (int row = rows.begin; row < rows.end; ++row) {
    const double factor = weight * peak_ * along_t.next();
    double* line = line_of(row) + columns.begin;
    for (int k = 0; k < count; ++k) line[k] += factor * profile[k];
  }
}

}  // namespace glint
