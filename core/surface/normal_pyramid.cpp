#include "core/surface/normal_pyramid.h"

#include <algorithm>
#include <utility>

namespace glint {
namespace {

constexpr int k_block_rows = 64;

glm::vec2 mean_below(const NormalMap& map, int i, int j) {
  const int columns = std::min(2, map.width() - 2 * i);
  const int rows = std::min(2, map.height() - 2 * j);
  glm::dvec2 sum{0, 0};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) sum += glm::dvec2(map.texel(2 * i + column, 2 * j + row));
  }
  return {sum / static_cast<double>(columns * rows)};
}

std::optional<NormalMap> halved(const NormalMap& map, JobControl& control) {
  const int width = (map.width() + 1) / 2;
  const int height = (map.height() + 1) / 2;
  std::vector<glm::vec2> normals(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto blocks = static_cast<std::size_t>((height + k_block_rows - 1) / k_block_rows);
  const bool done = parallel_blocks(blocks, control, [&](std::size_t block) {
    const int first = static_cast<int>(block) * k_block_rows;
    auto normal = normals.begin() + static_cast<std::ptrdiff_t>(first) * width;
    for (int j = first; j < std::min(first + k_block_rows, height); ++j) {
      for (int i = 0; i < width; ++i) *normal++ = mean_below(map, i, j);
    }
  });
  if (!done) return std::nullopt;
  return NormalMap(width, height, std::move(normals), map.wrap(), map.piecewise_constant());
}

}  // namespace

std::optional<NormalPyramid> NormalPyramid::build(std::shared_ptr<const NormalMap> map, JobControl& control) {
  NormalPyramid pyramid(std::move(map));
  while (!control.cancelled()) {
    const int last = pyramid.levels() - 1;
    if (pyramid.width(last) == 1 && pyramid.height(last) == 1) return pyramid;
    std::optional<NormalMap> next = halved(pyramid.at(last), control);
    if (next) pyramid.smaller_.push_back(*std::move(next));
  }
  return std::nullopt;
}

std::size_t NormalPyramid::bytes() const {
  std::size_t sum = 0;
  for (const NormalMap& level : smaller_) sum += level.bytes();
  return sum;
}

}  // namespace glint
