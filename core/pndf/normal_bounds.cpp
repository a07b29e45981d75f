#include "core/pndf/normal_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {
namespace {

constexpr NormalNode empty_node() {
  NormalNode node{};
  for (std::size_t axis = 0; axis < NormalNode::k_axes; ++axis) {
    node.lo[axis].fill(std::numeric_limits<std::int16_t>::max());
    node.hi[axis].fill(std::numeric_limits<std::int16_t>::min());
  }
  return node;
}

// Bounds along the four axes.
struct Bounds {
  std::array<float, NormalNode::k_axes> lo;
  std::array<float, NormalNode::k_axes> hi;

  Bounds() {
    lo.fill(std::numeric_limits<float>::max());
    hi.fill(std::numeric_limits<float>::lowest());
  }
  void include(const Bounds& other) {
    for (std::size_t axis = 0; axis < lo.size(); ++axis) {
      lo[axis] = std::min(lo[axis], other.lo[axis]);
      hi[axis] = std::max(hi[axis], other.hi[axis]);
    }
  }
  void include(glm::vec2 n) {
    const std::array<float, NormalNode::k_axes> values{n.x, n.y, n.x + n.y, n.x - n.y};
    for (std::size_t axis = 0; axis < lo.size(); ++axis) {
      lo[axis] = std::min(lo[axis], values[axis]);
      hi[axis] = std::max(hi[axis], values[axis]);
    }
  }
};

void store(const Bounds& bounds, float margin, NormalNode& node, std::size_t child) {
  const auto step = [](float value) { return static_cast<std::int16_t>(std::clamp(value, -32767.0F, 32767.0F)); };
  for (std::size_t axis = 0; axis < NormalNode::k_axes; ++axis) {
    const float more = margin * (bounds.hi[axis] - bounds.lo[axis]);
    node.lo[axis][child] = step(std::floor((bounds.lo[axis] - more) / NormalBounds::k_step) - 1);
    node.hi[axis][child] = step(std::ceil((bounds.hi[axis] + more) / NormalBounds::k_step) + 1);
  }
}

}  // namespace

NormalBounds::NormalBounds(const SurfaceCells& cells)
    : tile_columns_(static_cast<int>((cells.axis_u().count + k_tile - 1) / k_tile)),
      tile_rows_(static_cast<int>((cells.axis_v().count + k_tile - 1) / k_tile)),
      tiles_(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_), empty_node()),
      groups_(static_cast<std::size_t>(group_columns()) * static_cast<std::size_t>(group_rows()), empty_node()) {
  for (int b = 0; b < tile_rows_; ++b) build_tile_row(cells, b);
  for (int b = 0; b < group_rows(); ++b) build_group_row(b);
}

std::size_t NormalBounds::bytes_for(const SurfaceCells& cells) {
  const auto nodes = [&](int size) {
    return static_cast<std::size_t>((cells.axis_u().count + size - 1) / size) *
           static_cast<std::size_t>((cells.axis_v().count + size - 1) / size);
  };
  return (nodes(k_tile) + nodes(k_group)) * sizeof(NormalNode);
}

// Bounds of columns of texels first, four cells wide; then of the rows of them that a block needs.
void NormalBounds::build_tile_row(const SurfaceCells& cells, int b) {
  const NormalMap& map = cells.surface().map();
  const auto [before, after, overshoot] = cells.support();
  const SurfaceCells::Axis u = cells.axis_u();
  const SurfaceCells::Axis v = cells.axis_v();
  const std::int64_t block_columns = (u.count + k_block - 1) / k_block;
  const std::int64_t last_row = std::min<std::int64_t>((b + 1) * std::int64_t{k_tile}, v.count);
  std::vector<Bounds> blocks(static_cast<std::size_t>(block_columns) * 4);
  std::vector<glm::vec2> texels(static_cast<std::size_t>(u.count + before + after));
  for (std::int64_t j = b * std::int64_t{k_tile} - before; j < last_row + after; ++j) {
    for (std::size_t k = 0; k < texels.size(); ++k) {
      texels[k] = map.texel(u.first + static_cast<std::int64_t>(k) - before, v.first + j);
    }
    for (std::int64_t column = 0; column < block_columns; ++column) {
      Bounds row;
      const std::int64_t end = std::min<std::int64_t>((column + 1) * k_block, u.count) + before + after;
      for (std::int64_t k = column * k_block; k < end; ++k) row.include(texels[static_cast<std::size_t>(k)]);
      for (int block = 0; block < 4; ++block) {
        const std::int64_t first = b * std::int64_t{k_tile} + block * std::int64_t{k_block};
        const std::int64_t last = std::min<std::int64_t>(first + k_block, v.count);
        if (first >= v.count || j < first - before || j >= last + after) continue;
        blocks[static_cast<std::size_t>(block * block_columns + column)].include(row);
      }
    }
  }
  for (int block = 0; block < 4; ++block) {
    if (b * std::int64_t{k_tile} + block * std::int64_t{k_block} >= v.count) break;
    for (std::int64_t column = 0; column < block_columns; ++column) {
      store(blocks[static_cast<std::size_t>(block * block_columns + column)], static_cast<float>(overshoot),
            tiles_[index(static_cast<int>(column / 4), b, tile_columns_)],
            static_cast<std::size_t>(std::int64_t{4} * block + column % 4));
    }
  }
}

void NormalBounds::build_group_row(int b) {
  for (int a = 0; a < group_columns(); ++a) {
    NormalNode& node = groups_[index(a, b, group_columns())];
    for (int child = 0; child < 16; ++child) {
      const int column = 4 * a + child % 4;
      const int row = 4 * b + child / 4;
      if (column >= tile_columns_ || row >= tile_rows_) continue;
      const NormalNode& below = tile(column, row);
      for (std::size_t axis = 0; axis < NormalNode::k_axes; ++axis) {
        node.lo[axis][static_cast<std::size_t>(child)] =
            *std::min_element(below.lo[axis].begin(), below.lo[axis].end());
        node.hi[axis][static_cast<std::size_t>(child)] =
            *std::max_element(below.hi[axis].begin(), below.hi[axis].end());
      }
    }
  }
}

}  // namespace glint
