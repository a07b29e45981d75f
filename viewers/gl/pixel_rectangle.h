#pragma once

#include <algorithm>

namespace glint::view {

/// Pixels x0 … x1 - 1 of rows y0 … y1 - 1, counted from the upper left corner.
struct PixelRectangle {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  [[nodiscard]] bool empty() const { return x1 <= x0 || y1 <= y0; }
  [[nodiscard]] int area() const { return empty() ? 0 : (x1 - x0) * (y1 - y0); }
  bool operator==(const PixelRectangle&) const = default;
};

inline PixelRectangle common_part(const PixelRectangle& a, const PixelRectangle& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// The smallest that holds both.
inline PixelRectangle around(const PixelRectangle& a, const PixelRectangle& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace glint::view
