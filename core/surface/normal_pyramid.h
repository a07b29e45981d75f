#pragma once
// A normal map at every smaller size, for drawing it zoomed out. Not a model of the P-NDF: averaged normals lose what
// makes a surface glint.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/surface/normal_map.h"

namespace glint {

/// Level 0 is the map itself; each level halves the sizes of the one before, rounded up, until 1 x 1. A texel is the
/// mean of the 2 x 2 texels (s, t) below it, of fewer at an odd border. Immutable; safe to read from any thread.
class NormalPyramid {
 public:
  /// On all threads; nothing if cancelled.
  static std::optional<NormalPyramid> build(std::shared_ptr<const NormalMap> map, JobControl& control);

  [[nodiscard]] const std::shared_ptr<const NormalMap>& map() const { return map_; }
  /// How many there are, the map among them; at least 1.
  [[nodiscard]] int levels() const { return 1 + static_cast<int>(smaller_.size()); }
  [[nodiscard]] int width(int level) const { return at(level).width(); }
  [[nodiscard]] int height(int level) const { return at(level).height(); }
  /// The texel in column i and row j of a level; any i and j, brought inside by the map's wrap.
  [[nodiscard]] glm::vec2 texel(int level, std::int64_t i, std::int64_t j) const { return at(level).texel(i, j); }
  /// Rows of a level from the top.
  [[nodiscard]] const std::vector<glm::vec2>& texels(int level) const { return at(level).normals(); }
  /// Held beyond the map.
  [[nodiscard]] std::size_t bytes() const;

 private:
  explicit NormalPyramid(std::shared_ptr<const NormalMap> map) : map_(std::move(map)) {}
  [[nodiscard]] const NormalMap& at(int level) const {
    return level == 0 ? *map_ : smaller_[static_cast<std::size_t>(level) - 1];
  }

  std::shared_ptr<const NormalMap> map_;
  std::vector<NormalMap> smaller_;
};

}  // namespace glint
