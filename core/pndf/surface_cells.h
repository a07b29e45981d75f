#pragma once
// A surface as exact evaluation sees it: cells of the plane, each cut into triangles on which the normal is affine, and
// boxes of normals by which whole tiles of cells are passed over.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint_window.h"
#include "core/surface/surface.h"

namespace glint {

/// A box of projected normals.
struct NormalBox {
  glm::dvec2 lo;
  glm::dvec2 hi;

  void include(glm::dvec2 n);
  void include(const NormalBox& other);
  /// Squared distance from s to the box, in units of the roughness on each axis.
  [[nodiscard]] double squared_distance(glm::dvec2 s, glm::dvec2 roughness) const;
};

/// One triangle with a right angle at `corner` and legs along the axes.
struct SurfaceTriangle {
  glm::dvec2 corner;                  ///< offset of the right angle from the footprint's centre, texels
  double du;                          ///< signed leg along u, texels
  double dv;                          ///< signed leg along v, texels
  std::array<glm::dvec2, 3> normals;  ///< at the corner, at the end of du, at the end of dv

  [[nodiscard]] OffsetBox offsets() const;
  [[nodiscard]] NormalBox normal_box() const;
};

/// Where a cell lies: its columns and rows may run over any number of periods of the map.
struct CellIndex {
  std::int64_t i;
  std::int64_t j;
};

/// The vertices of one cell: (columns + 1) x (rows + 1) normals on a regular grid.
struct CellVertices {
  OffsetBox box{};  ///< offsets of the cell from the footprint's centre
  int columns = 1;
  int rows = 1;
  std::vector<glm::dvec2> normals;

  [[nodiscard]] NormalBox normal_box() const;
  /// The two triangles of sub-cell (a, b), cut from (u1, v0) to (u0, v1).
  [[nodiscard]] std::array<SurfaceTriangle, 2> triangles(int a, int b) const;

  template <class Body>
  void for_each_triangle(Body body) const {
    for (int b = 0; b < rows; ++b) {
      for (int a = 0; a < columns; ++a) {
        for (const SurfaceTriangle& triangle : triangles(a, b)) body(triangle);
      }
    }
  }
};

/// Immutable; shared between threads.
class SurfaceCells {
 public:
  static constexpr int k_tile = 16;  ///< cells a side of a tile

  /// `subdivision` sub-cells per axis and cell, for the smooth surface only (1 otherwise): 4 is the 32-triangle map.
  /// `vertex_shift` moves the vertices of the smooth surface by -(h^2 / 12)(n_uu + n_vv - n_uv), h = 1 / subdivision,
  /// which takes the O(h^2) bias of the triangles away; derivatives are those of the cell's own side.
  SurfaceCells(Surface surface, int subdivision, bool vertex_shift);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] int subdivision() const { return subdivision_; }
  [[nodiscard]] bool vertex_shift() const { return vertex_shift_; }
  [[nodiscard]] std::size_t bytes() const { return tiles_.size() * sizeof(NormalBox); }

  /// The indices of cells along one axis: [first, first + count), repeated with that period where the map repeats. A
  /// map that clamps has one cell more on each side than its triangles need, stretched to where the footprint ends.
  struct Axis {
    std::int64_t first;
    std::int64_t count;
    bool periodic;
  };
  [[nodiscard]] Axis axis_u() const { return axis_u_; }
  [[nodiscard]] Axis axis_v() const { return axis_v_; }

  /// The position of the left or upper border of cell 0, texels: 0.5, or 0 on the constant surface.
  [[nodiscard]] double border() const { return surface_.interpolation() == Interpolation::constant ? 0.0 : 0.5; }

  /// Offsets of a column of cells from a centre; `reach` is how far stretched cells must go from the centre.
  [[nodiscard]] Interval column_span(std::int64_t i, double center, double reach) const;
  [[nodiscard]] Interval row_span(std::int64_t j, double center, double reach) const;

  /// What bounds the normals of cells i0 … i1: texels i0 - before … i1 + after, and their range widened by `overshoot`
  /// of itself on either side; likewise along v.
  struct Support {
    int before;
    int after;
    double overshoot;
  };
  [[nodiscard]] Support support() const;

  /// A box that holds all normals of the tile's cells; a and b count tiles from the axes' first cells.
  [[nodiscard]] const NormalBox& tile_box(std::int64_t a, std::int64_t b) const;
  /// A box that holds all normals of one cell, overshoot included.
  [[nodiscard]] NormalBox cell_box(CellIndex cell) const;
  /// The vertices of a cell whose box of offsets is given.
  void vertices(CellIndex cell, const OffsetBox& box, CellVertices& out) const;

 private:
  [[nodiscard]] NormalBox texel_box(std::int64_t i0, std::int64_t i1, std::int64_t j0, std::int64_t j1) const;
  [[nodiscard]] bool stretched(const Axis& axis, std::int64_t k) const {
    return !axis.periodic && (k == axis.first || k == axis.first + axis.count - 1);
  }
  void smooth_vertices(CellIndex cell, CellVertices& out) const;

  Surface surface_;
  int subdivision_;
  bool vertex_shift_;
  Axis axis_u_;
  Axis axis_v_;
  std::int64_t tile_columns_;
  std::vector<NormalBox> tiles_;
};

}  // namespace glint
