#include "core/pndf/surface_cells.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/surface/catmull_rom.h"

namespace glint {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr NormalBox k_empty_box{{k_infinity, k_infinity}, {-k_infinity, -k_infinity}};

SurfaceCells::Axis axis_for(int size, Wrap wrap) {
  if (wrap == Wrap::repeat) return {0, size, true};
  // Cells -1 … size - 1 hold all that is not constant along the axis, whatever the interpolation.
  return {-2, std::int64_t{size} + 3, false};
}

Interval span_of(const SurfaceCells::Axis& axis, std::int64_t k, double border, double center, double reach) {
  Interval span{static_cast<double>(k) + border - center, static_cast<double>(k + 1) + border - center};
  if (!axis.periodic && k == axis.first) span.lo = std::min(span.lo, -reach);
  if (!axis.periodic && k == axis.first + axis.count - 1) span.hi = std::max(span.hi, reach);
  return span;
}

double axis_distance(double value, double lo, double hi, double roughness) {
  return std::max({lo - value, value - hi, 0.0}) / roughness;
}

}  // namespace

void NormalBox::include(glm::dvec2 n) {
  lo = {std::min(lo.x, n.x), std::min(lo.y, n.y)};
  hi = {std::max(hi.x, n.x), std::max(hi.y, n.y)};
}

void NormalBox::include(const NormalBox& other) {
  include(other.lo);
  include(other.hi);
}

double NormalBox::squared_distance(glm::dvec2 s, glm::dvec2 roughness) const {
  const double x = axis_distance(s.x, lo.x, hi.x, roughness.x);
  const double y = axis_distance(s.y, lo.y, hi.y, roughness.y);
  return x * x + y * y;
}

OffsetBox SurfaceTriangle::offsets() const {
  return {{std::min(corner.x, corner.x + du), std::max(corner.x, corner.x + du)},
          {std::min(corner.y, corner.y + dv), std::max(corner.y, corner.y + dv)}};
}

NormalBox SurfaceTriangle::normal_box() const {
  NormalBox box{normals[0], normals[0]};
  box.include(normals[1]);
  box.include(normals[2]);
  return box;
}

NormalBox CellVertices::normal_box() const {
  NormalBox bounds = k_empty_box;
  for (const glm::dvec2& n : normals) bounds.include(n);
  return bounds;
}

std::array<SurfaceTriangle, 2> CellVertices::triangles(int a, int b) const {
  const double width = (box.x.hi - box.x.lo) / columns;
  const double height = (box.y.hi - box.y.lo) / rows;
  const double x0 = box.x.lo + a * width;
  const double y0 = box.y.lo + b * height;
  const auto stride = static_cast<std::size_t>(columns) + 1;
  const std::size_t first = static_cast<std::size_t>(b) * stride + static_cast<std::size_t>(a);
  const glm::dvec2 right = normals[first + 1];
  const glm::dvec2 below = normals[first + stride];
  return {SurfaceTriangle{{x0, y0}, width, height, {normals[first], right, below}},
          SurfaceTriangle{{x0 + width, y0 + height}, -width, -height, {normals[first + stride + 1], below, right}}};
}

SurfaceCells::SurfaceCells(Surface surface, int subdivision, bool vertex_shift)
    : surface_(std::move(surface)),
      subdivision_(surface_.interpolation() == Interpolation::smooth ? subdivision : 1),
      vertex_shift_(vertex_shift && surface_.interpolation() == Interpolation::smooth),
      axis_u_(axis_for(surface_.map().width(), surface_.map().wrap())),
      axis_v_(axis_for(surface_.map().height(), surface_.map().wrap())),
      tile_columns_((axis_u_.count + k_tile - 1) / k_tile) {
  const std::int64_t tile_rows = (axis_v_.count + k_tile - 1) / k_tile;
  tiles_.reserve(static_cast<std::size_t>(tile_columns_ * tile_rows));
  for (std::int64_t b = 0; b < tile_rows; ++b) {
    for (std::int64_t a = 0; a < tile_columns_; ++a) {
      const std::int64_t i = axis_u_.first + a * k_tile;
      const std::int64_t j = axis_v_.first + b * k_tile;
      tiles_.push_back(texel_box(i, std::min(i + k_tile, axis_u_.first + axis_u_.count) - 1, j,
                                 std::min(j + k_tile, axis_v_.first + axis_v_.count) - 1));
    }
  }
}

Interval SurfaceCells::column_span(std::int64_t i, double center, double reach) const {
  return span_of(axis_u_, i, border(), center, reach);
}

Interval SurfaceCells::row_span(std::int64_t j, double center, double reach) const {
  return span_of(axis_v_, j, border(), center, reach);
}

const NormalBox& SurfaceCells::tile_box(std::int64_t a, std::int64_t b) const {
  return tiles_[static_cast<std::size_t>(b * tile_columns_ + a)];
}

SurfaceCells::Support SurfaceCells::support() const {
  switch (surface_.interpolation()) {
    case Interpolation::constant:
      return {0, 0, 0};
    case Interpolation::linear:
      return {0, 1, 0};
    case Interpolation::smooth:
      break;
  }
  // The sum of the weights of n_uu + n_vv - n_uv in absolute value is 25 at most: 12.5 ranges to either side.
  const double h = 1.0 / subdivision_;
  return {1, 2, k_catmull_rom_overshoot + (vertex_shift_ ? h * h / 12 * 12.5 : 0.0)};
}

// The range of normals over cells [i0, i1] x [j0, j1], from the texels they are made of.
NormalBox SurfaceCells::texel_box(std::int64_t i0, std::int64_t i1, std::int64_t j0, std::int64_t j1) const {
  const Support needed = support();
  NormalBox box = k_empty_box;
  for (std::int64_t j = j0 - needed.before; j <= j1 + needed.after; ++j) {
    for (std::int64_t i = i0 - needed.before; i <= i1 + needed.after; ++i) {
      box.include(glm::dvec2(surface_.map().texel(i, j)));
    }
  }
  const glm::dvec2 margin = needed.overshoot * (box.hi - box.lo);
  return {box.lo - margin, box.hi + margin};
}

NormalBox SurfaceCells::cell_box(CellIndex cell) const {
  return texel_box(cell.i, cell.i, cell.j, cell.j);
}

void SurfaceCells::vertices(CellIndex cell, const OffsetBox& box, CellVertices& out) const {
  out.box = box;
  out.columns = stretched(axis_u_, cell.i) ? 1 : subdivision_;
  out.rows = stretched(axis_v_, cell.j) ? 1 : subdivision_;
  out.normals.resize(static_cast<std::size_t>(out.columns + 1) * static_cast<std::size_t>(out.rows + 1));
  const NormalMap& map = surface_.map();
  switch (surface_.interpolation()) {
    case Interpolation::constant:
      std::fill(out.normals.begin(), out.normals.end(), glm::dvec2(map.texel(cell.i, cell.j)));
      return;
    case Interpolation::linear:
      out.normals = {glm::dvec2(map.texel(cell.i, cell.j)), glm::dvec2(map.texel(cell.i + 1, cell.j)),
                     glm::dvec2(map.texel(cell.i, cell.j + 1)), glm::dvec2(map.texel(cell.i + 1, cell.j + 1))};
      return;
    case Interpolation::smooth:
      smooth_vertices(cell, out);
  }
}

void SurfaceCells::smooth_vertices(CellIndex cell, CellVertices& out) const {
  std::array<std::array<glm::dvec2, 4>, 4> texels{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      texels[row][column] = glm::dvec2(surface_.map().texel(cell.i - 1 + static_cast<std::int64_t>(column),
                                                            cell.j - 1 + static_cast<std::int64_t>(row)));
    }
  }
  using Lines = std::array<glm::dvec2, 4>;  // one value a row of texels
  const auto along_u = [&](const CubicWeights& w) {
    Lines lines{};
    for (std::size_t row = 0; row < 4; ++row) {
      const Lines& t = texels[row];
      lines[row] = w[0] * t[0] + w[1] * t[1] + w[2] * t[2] + w[3] * t[3];
    }
    return lines;
  };
  const auto along_v = [](const CubicWeights& w, const Lines& l) {
    return w[0] * l[0] + w[1] * l[1] + w[2] * l[2] + w[3] * l[3];
  };
  const double h = 1.0 / subdivision_;
  const auto stride = static_cast<std::size_t>(out.columns) + 1;
  for (int a = 0; a <= out.columns; ++a) {
    const double x = static_cast<double>(a) / out.columns;
    const Lines value = along_u(catmull_rom(x));
    const Lines slope = vertex_shift_ ? along_u(catmull_rom_derivative(x)) : Lines{};
    const Lines bend = vertex_shift_ ? along_u(catmull_rom_second_derivative(x)) : Lines{};
    for (int b = 0; b <= out.rows; ++b) {
      const double y = static_cast<double>(b) / out.rows;
      const CubicWeights wy = catmull_rom(y);
      glm::dvec2 normal = along_v(wy, value);
      if (vertex_shift_) {
        const glm::dvec2 curvature = along_v(wy, bend) + along_v(catmull_rom_second_derivative(y), value) -
                                     along_v(catmull_rom_derivative(y), slope);
        normal -= h * h / 12 * curvature;
      }
      out.normals[static_cast<std::size_t>(b) * stride + static_cast<std::size_t>(a)] = normal;
    }
  }
}

}  // namespace glint
