#pragma once
// Adds triangles of a surface to a P-NDF image in single precision, with the widest vector instructions there are: the
// kernel of FastExactPndf::image. Units: normals are in cells of the image, deviations are those of the roughness.

#include <memory>
#include <span>
#include <vector>

#include "core/pndf/footprint_window.h"
#include "core/pndf/pndf_grid.h"

namespace glint {

/// What all triangles of one image have in common.
struct SplatFrame {
  float w11, w12, w22;  ///< whitening of offsets from the footprint's centre, texels
  float kx, ky;         ///< pitch of the grid in deviations
  float cut;            ///< joint cut R, deviations
  float scale;          ///< det W / (4 pi^2 sigma_x sigma_y)
  int columns;
};

/// The vertices of one cell of the surface: (columns + 1) x (rows + 1) of them, by rows.
struct SplatCell {
  float left, top;      ///< offset of the first vertex from the footprint's centre, texels
  float width, height;  ///< of a sub-cell, texels
  int columns, rows;    ///< sub-cells
  int origin_column;    ///< of the image: x and y count from there
  int origin_row;
  const float* x;
  const float* y;
};

/// Rows of a P-NDF image in single precision, with room for vectors that reach beyond the last column.
class SplatBand {
 public:
  static constexpr int k_padding = 16;

  SplatBand(float* first, int columns, int first_row, int rows)
      : first_(first), stride_(stride_for(columns)), first_row_(first_row), rows_(rows) {}

  static int stride_for(int columns) { return columns + k_padding; }
  [[nodiscard]] int first_row() const { return first_row_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] float* row(int index) const { return first_ + static_cast<std::ptrdiff_t>(index) * stride_; }

 private:
  float* first_;
  int stride_;
  int first_row_;
  int rows_;
};

/// Memory of one thread for splat().
class SplatScratch {
 public:
  SplatScratch();
  SplatScratch(const SplatScratch&) = delete;
  SplatScratch& operator=(const SplatScratch&) = delete;
  ~SplatScratch();

  struct Arrays;
  [[nodiscard]] Arrays& arrays() { return *arrays_; }

 private:
  std::unique_ptr<Arrays> arrays_;
};

/// The shortest whitened edge, in deviations, up to which splat() takes a triangle.
inline constexpr float k_longest_splat_edge = 240;

/// A triangle too long for single precision, by its sub-cell and which of the sub-cell's two it is.
struct RefusedTriangle {
  int column;
  int row;
  int half;
};

/// Within the cut an error is at most some 1e-5 of the triangle's scale, the factor of its integral times min(1/2, 2 pi
/// / twice the whitened area). Adds both triangles of
/// every sub-cell, cut from (u1, v0) to (u0, v1), where they are within the cut. What is too long is appended to
/// `refused` instead.
void splat(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, SplatScratch& scratch,
           std::vector<RefusedTriangle>& refused);

}  // namespace glint
