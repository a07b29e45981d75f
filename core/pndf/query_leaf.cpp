#include "core/pndf/query_leaf.h"

#include <algorithm>

#include "core/surface/catmull_rom.h"

namespace glint {
namespace {

// Calls body(row, first texel of the row), which `count` texels follow in memory; `spare` holds rows across a border.
template <int count, class Body>
void for_rows(const NormalMap& map, std::int64_t i, std::int64_t j, Body body) {
  const bool inside = i >= 0 && j >= 0 && i + count <= map.width() && j + count <= map.height();
  if (inside) {
    const glm::vec2* row = map.normals().data() + j * map.width() + i;
    for (std::size_t r = 0; r < count; ++r, row += map.width()) body(r, row);
    return;
  }
  std::array<glm::vec2, count> spare;
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t c = 0; c < count; ++c) {
      spare[c] = map.texel(i + static_cast<std::int64_t>(c), j + static_cast<std::int64_t>(r));
    }
    body(r, spare.data());
  }
}

// Weights of the vertices 0, 1/4, … 1 of a cell.
constexpr std::array<std::array<float, 4>, 5> vertex_weights() {
  std::array<std::array<float, 4>, 5> all{};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CubicWeights weights = catmull_rom(0.25 * static_cast<double>(k));
    for (std::size_t c = 0; c < 4; ++c) all[k][c] = static_cast<float>(weights[c]);
  }
  return all;
}
constexpr auto k_vertex_weights = vertex_weights();

}  // namespace

void fill_linear_leaf(const NormalMap& map, CellIndex first, QueryLeaf& leaf) {
  for_rows<5>(map, first.i, first.j, [&](std::size_t r, const glm::vec2* row) {
    // In separate loops, which compilers turn into shuffles of whole vectors.
    for (std::size_t c = 0; c < 4; ++c) leaf.x0[4 * r + c] = row[c].x;
    for (std::size_t c = 0; c < 4; ++c) leaf.y0[4 * r + c] = row[c].y;
    for (std::size_t c = 0; c < 4; ++c) leaf.x1[4 * r + c] = row[c + 1].x;
    for (std::size_t c = 0; c < 4; ++c) leaf.y1[4 * r + c] = row[c + 1].y;
  });
}

void load_smooth_block(const NormalMap& map, CellIndex first, SmoothTexels& texels) {
  for_rows<7>(map, first.i - 1, first.j - 1,
              [&](std::size_t r, const glm::vec2* row) { std::copy_n(row, 7, texels[r].begin()); });
}

void bound_smooth_cells(const SmoothTexels& texels, CellBoxes& boxes) {
  // Of four texels along each row, then of four such.
  struct Range {
    glm::vec2 lo;
    glm::vec2 hi;
  };
  const auto joined = [](const Range& a, const Range& b) {
    return Range{{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y)},
                 {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y)}};
  };
  std::array<std::array<Range, 4>, 7> rows;
  for (std::size_t r = 0; r < 7; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      Range range{texels[r][c], texels[r][c]};
      for (std::size_t k = 1; k < 4; ++k) range = joined(range, {texels[r][c + k], texels[r][c + k]});
      rows[r][c] = range;
    }
  }
  constexpr auto k_overshoot = static_cast<float>(k_catmull_rom_overshoot * 1.0001);
  for (std::size_t cell = 0; cell < 16; ++cell) {
    Range range = rows[cell / 4][cell % 4];
    for (std::size_t k = 1; k < 4; ++k) range = joined(range, rows[cell / 4 + k][cell % 4]);
    const glm::vec2 more = k_overshoot * (range.hi - range.lo);
    boxes.x_lo[cell] = range.lo.x - more.x;
    boxes.x_hi[cell] = range.hi.x + more.x;
    boxes.y_lo[cell] = range.lo.y - more.y;
    boxes.y_hi[cell] = range.hi.y + more.y;
  }
}

void fill_smooth_leaf(const SmoothTexels& texels, int column, int row, QueryLeaf& leaf) {
  const auto c0 = static_cast<std::size_t>(column);
  const auto r0 = static_cast<std::size_t>(row);
  std::array<std::array<glm::vec2, 5>, 4> along{};  // rows of texels at the five columns of vertices
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t v = 0; v < 5; ++v) {
      const std::array<float, 4>& w = k_vertex_weights[v];
      const glm::vec2* t = texels[r0 + r].data() + c0;
      along[r][v] = w[0] * t[0] + w[1] * t[1] + w[2] * t[2] + w[3] * t[3];
    }
  }
  for (std::size_t b = 0; b < 5; ++b) {
    const std::array<float, 4>& w = k_vertex_weights[b];
    std::array<glm::vec2, 5> line{};
    for (std::size_t v = 0; v < 5; ++v) {
      line[v] = w[0] * along[0][v] + w[1] * along[1][v] + w[2] * along[2][v] + w[3] * along[3][v];
    }
    for (std::size_t c = 0; c < 4; ++c) {
      leaf.x0[4 * b + c] = line[c].x;
      leaf.y0[4 * b + c] = line[c].y;
      leaf.x1[4 * b + c] = line[c + 1].x;
      leaf.y1[4 * b + c] = line[c + 1].y;
    }
  }
}

}  // namespace glint
