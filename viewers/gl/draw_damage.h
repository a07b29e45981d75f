#pragma once
// Which pixels of a frame differ from those of the frame before, found from what was recorded and not from pixels: a
// fingerprint of every tile's triangles, in drawing order. Software OpenGL pays for each pixel it fills, and under a
// moving mouse most of the window stays as it was.

#include <cstdint>
#include <imgui.h>
#include <vector>

#include "viewers/gl/pixel_rectangle.h"

namespace glint::view {

/// For one sequence of frames whose pixels are kept.
class DrawDamage {
 public:
  /// Rectangles without common pixels that hold every pixel which `data` draws differently from the data of the call
  /// before; the whole frame at first and after a change of its size.
  std::vector<PixelRectangle> update(const ImDrawData& data);
  /// What was drawn before is lost.
  void forget() { size_ = {}; }

 private:
  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::vector<std::uint64_t> fingerprints(const ImDrawData& data) const;
  [[nodiscard]] std::vector<PixelRectangle> changed_tiles(const std::vector<std::uint64_t>& tiles) const;

  ImVec2 size_{0, 0};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint64_t> tiles_;
};

}  // namespace glint::view
