#include "core/pndf/pndf_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glint {

std::optional<glm::ivec2> PndfGrid::cell_at(glm::dvec2 s) const {
  const bool inside = s.x >= s_min && s.x <= s_max && s.y >= t_min && s.y <= t_max;
  if (!inside) return std::nullopt;
  const int column = static_cast<int>((s.x - s_min) / pitch().x);
  const int row = static_cast<int>((t_max - s.y) / pitch().y);
  return glm::ivec2{std::min(column, columns - 1), std::min(row, rows - 1)};
}

std::optional<std::string> grid_fault(const PndfGrid& grid) {
  for (const double value : {grid.s_min, grid.s_max, grid.t_min, grid.t_max}) {
    if (!std::isfinite(value) || std::abs(value) > 100) return "the window must be four numbers within [-100, 100]";
  }
  if (!(grid.s_min < grid.s_max && grid.t_min < grid.t_max)) {
    return "the window SMIN,SMAX,TMIN,TMAX must have SMIN < SMAX and TMIN < TMAX";
  }
  if (grid.columns < 1 || grid.rows < 1 || grid.columns > k_largest_grid_side || grid.rows > k_largest_grid_side) {
    return "the grid must have 1 to 16384 cells a side";
  }
  if (!(grid.pitch().x > 1e-12 && grid.pitch().y > 1e-12)) return "the window is too narrow for so many cells";
  return std::nullopt;
}

glm::dvec2 mean_widening(const PndfGrid& grid) {
  return grid.pitch() * grid.pitch() / 12.0;
}

glm::dvec2 widening_for(const PndfGrid& grid, double intrinsic_roughness) {
  const glm::dvec2 mean = mean_widening(grid);
  return {intrinsic_roughness < 0.6 * grid.pitch().x ? mean.x : 0.0,
          intrinsic_roughness < 0.6 * grid.pitch().y ? mean.y : 0.0};
}

double integral(const PndfImage& image) {
  return std::accumulate(image.density.begin(), image.density.end(), 0.0) * image.grid.cell_area();
}

glm::dvec2 mean_normal(const PndfImage& image) {
  glm::dvec2 moment{0, 0};
  double mass = 0;
  for (int row = 0; row < image.grid.rows; ++row) {
    for (int column = 0; column < image.grid.columns; ++column) {
      const double density = image.density[image.grid.index(column, row)];
      moment += density * image.grid.center(column, row);
      mass += density;
    }
  }
  return mass > 0 ? moment / mass : glm::dvec2(0);
}

}  // namespace glint
