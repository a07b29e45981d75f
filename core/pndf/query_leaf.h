#pragma once
// Sixteen cells of a query at once: the vertices of 4 x 4 (sub-)cells in the layout that vectors load, made from
// texels.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/exact_query.h"
#include "core/surface/normal_map.h"

namespace glint {

// 4 x 4 cells between 5 x 5 vertices. Vertex (column, row) of the first four columns stands in x0[4 row + column], that
// to its right in x1 at the same place.
struct alignas(64) QueryLeaf {
  std::array<float, 20> x0;
  std::array<float, 20> x1;
  std::array<float, 20> y0;
  std::array<float, 20> y1;
  float left, top;  // offset of the first vertex from the footprint's centre, texels
  float size;       // of a cell, texels
};

// A normal as the sum of two floats: normals near it are subtracted without loss.
struct QueryNormal {
  std::array<float, 2> high;
  std::array<float, 2> low;
};

struct QueryScratch::Arrays {
  std::vector<QueryLeaf> leaves;  // the first leaf_count are in use
  std::size_t leaf_count = 0;
  std::vector<std::int32_t> triangles;  // 32 leaf + 16 half + cell; the first triangle_count are in use
  std::size_t triangle_count = 0;
  std::array<std::vector<float>, 8> rays;
  std::vector<std::int32_t> ray_counts;
  std::vector<std::int32_t> order;

  QueryLeaf& add_leaf() {
    if (leaf_count == leaves.size()) leaves.resize(2 * leaves.size() + 64);
    return leaves[leaf_count++];
  }
};

// Bounds of the normals of 16 cells.
struct CellBoxes {
  alignas(64) std::array<float, 16> x_lo;
  alignas(64) std::array<float, 16> x_hi;
  alignas(64) std::array<float, 16> y_lo;
  alignas(64) std::array<float, 16> y_hi;
};

using SmoothTexels = std::array<std::array<glm::vec2, 7>, 7>;

void fill_linear_leaf(const NormalMap& map, CellIndex first, QueryLeaf& leaf);
void load_smooth_block(const NormalMap& map, CellIndex first, SmoothTexels& texels);
void bound_smooth_cells(const SmoothTexels& texels, CellBoxes& boxes);
void fill_smooth_leaf(const SmoothTexels& texels, int column, int row, QueryLeaf& leaf);

}  // namespace glint
