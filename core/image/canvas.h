#pragma once
// A small 8-bit RGB canvas for pictures that are written to files: rectangles, pixels, text. Not for the window.

#include <filesystem>
#include <string>
#include <vector>

#include "core/image/color_map.h"
#include "core/math/result.h"

namespace glint {

class Canvas {
 public:
  Canvas(int width, int height, DisplayColor ground);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Pixels outside the canvas are ignored.
  void set(int x, int y, DisplayColor color);
  void fill(int x, int y, int width, int height, DisplayColor color);
  /// One pixel wide, just outside the rectangle.
  void outline(int x, int y, int width, int height, DisplayColor color);

  enum class Align { left, center, right };
  enum class Face { text, numbers };
  /// One line of text whose baseline is at y. Without any known font on the machine nothing is drawn and
  /// text_missing() says so.
  void text(int x, int y, const std::string& line, int size, DisplayColor color, Align align = Align::left,
            Face face = Face::text);
  [[nodiscard]] bool text_missing() const { return text_missing_; }

  /// Writes a PNG; all or nothing. Equal canvases give equal bytes.
  [[nodiscard]] Status write_png(const std::filesystem::path& path) const;

 private:
  int width_;
  int height_;
  bool text_missing_ = false;
  std::vector<DisplayColor> pixels_;
};

}  // namespace glint
