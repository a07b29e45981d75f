#include "core/surface/surface.h"

#include <cmath>
#include <utility>

#include "core/surface/catmull_rom.h"

namespace glint {
namespace {

// The cell between texel centres that holds u, and where in it u lies.
struct CellPosition {
  std::int64_t i;
  std::int64_t j;
  double x;  // in [0, 1)
  double y;
};

CellPosition cell_position(glm::dvec2 u) {
  const double i = std::floor(u.x - 0.5);
  const double j = std::floor(u.y - 0.5);
  return {static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), u.x - 0.5 - i, u.y - 0.5 - j};
}

glm::dvec2 texel(const NormalMap& map, std::int64_t i, std::int64_t j) {
  return glm::dvec2(map.texel(i, j));
}

glm::dvec2 bicubic(const NormalMap& map, const CellPosition& cell, const CubicWeights& wx, const CubicWeights& wy) {
  glm::dvec2 sum{0, 0};
  for (std::size_t row = 0; row < 4; ++row) {
    glm::dvec2 line{0, 0};
    for (std::size_t column = 0; column < 4; ++column) {
      line += wx[column] *
              texel(map, cell.i - 1 + static_cast<std::int64_t>(column), cell.j - 1 + static_cast<std::int64_t>(row));
    }
    sum += wy[row] * line;
  }
  return sum;
}

// The triangle of the linear surface at a position: its value at the right-angled vertex and its two slopes.
struct LinearTriangle {
  glm::dvec2 corner;
  glm::dmat2 jacobian;
  double x;  // offset of the position from the right-angled vertex
  double y;
};

LinearTriangle linear_triangle(const NormalMap& map, const CellPosition& cell) {
  const glm::dvec2 right = texel(map, cell.i + 1, cell.j);
  const glm::dvec2 below = texel(map, cell.i, cell.j + 1);
  if (cell.x + cell.y < 1) {
    const glm::dvec2 corner = texel(map, cell.i, cell.j);
    return {corner, {right - corner, below - corner}, cell.x, cell.y};
  }
  const glm::dvec2 corner = texel(map, cell.i + 1, cell.j + 1);
  return {corner, {corner - below, corner - right}, cell.x - 1, cell.y - 1};
}

glm::dvec2 constant_normal(const NormalMap& map, glm::dvec2 u) {
  return texel(map, static_cast<std::int64_t>(std::floor(u.x)), static_cast<std::int64_t>(std::floor(u.y)));
}

}  // namespace

Surface::Surface(std::shared_ptr<const NormalMap> map, Interpolation interpolation)
    : map_(std::move(map)), interpolation_(interpolation) {}

glm::dvec2 Surface::normal(glm::dvec2 u) const {
  switch (interpolation_) {
    case Interpolation::constant:
      return constant_normal(*map_, u);
    case Interpolation::linear: {
      const LinearTriangle triangle = linear_triangle(*map_, cell_position(u));
      return triangle.corner + triangle.jacobian[0] * triangle.x + triangle.jacobian[1] * triangle.y;
    }
    case Interpolation::smooth:
      break;
  }
  const CellPosition cell = cell_position(u);
  return bicubic(*map_, cell, catmull_rom(cell.x), catmull_rom(cell.y));
}

glm::dmat2 Surface::jacobian(glm::dvec2 u) const {
  switch (interpolation_) {
    case Interpolation::constant:
      return glm::dmat2(0);
    case Interpolation::linear:
      return linear_triangle(*map_, cell_position(u)).jacobian;
    case Interpolation::smooth:
      break;
  }
  const CellPosition cell = cell_position(u);
  return {bicubic(*map_, cell, catmull_rom_derivative(cell.x), catmull_rom(cell.y)),
          bicubic(*map_, cell, catmull_rom(cell.x), catmull_rom_derivative(cell.y))};
}

}  // namespace glint
