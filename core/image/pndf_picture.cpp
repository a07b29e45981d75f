#include "core/image/pndf_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr DisplayColor k_window{0x14, 0x14, 0x14};
constexpr DisplayColor k_border{0x4a, 0x4a, 0x4a};
constexpr DisplayColor k_rim{0x9a, 0x9a, 0x9a};
constexpr DisplayColor k_text{0xea, 0xea, 0xea};
constexpr DisplayColor k_text_2{0xb4, 0xb4, 0xb4};
constexpr DisplayColor k_hint{0x96, 0x96, 0x96};

constexpr int k_side = 512;  // wanted size of a picture
constexpr int k_margin = 24;
constexpr int k_gap = 56;
constexpr int k_header = 52;
constexpr int k_below = 66;  // ticks and caption under a picture
constexpr int k_footer = 34;
constexpr int k_bar = 14;
constexpr int k_bar_labels = 64;

struct Frame {
  int x;
  int y;
  int width;
  int height;
  int magnification;  // pixels a cell, or …
  int reduction;      // … cells a pixel: the mean of the cells is shown
};

Frame frame_for(const PndfGrid& grid) {
  const int longest = std::max(grid.columns, grid.rows);
  const int reduction = (longest + 2 * k_side - 1) / (2 * k_side);
  const int magnification = std::max(1, k_side / longest);
  return {0,        0, grid.columns * magnification / reduction, grid.rows * magnification / reduction, magnification,
          reduction};
}

double shown_density(const PndfImage& image, const Frame& frame, int x, int y) {
  const int column = x / frame.magnification * frame.reduction;
  const int row = y / frame.magnification * frame.reduction;
  double sum = 0;
  for (int b = 0; b < frame.reduction; ++b) {
    for (int a = 0; a < frame.reduction; ++a) sum += image.density[image.grid.index(column + a, row + b)];
  }
  return sum / (frame.reduction * frame.reduction);
}

void draw_density(Canvas& canvas, const Frame& frame, const PndfImage& image, const LogScale& scale) {
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      canvas.set(frame.x + x, frame.y + y, scale.color(shown_density(image, frame, x, y)));
    }
  }
  canvas.outline(frame.x, frame.y, frame.width, frame.height, k_border);
}

void draw_rim(Canvas& canvas, const Frame& frame, const PndfGrid& grid) {
  // Two steps a pixel, however narrow the window is.
  const double scale = std::max(frame.width / (grid.s_max - grid.s_min), frame.height / (grid.t_max - grid.t_min));
  const int steps = static_cast<int>(std::min(4 * std::numbers::pi * scale, 1e7));
  for (int k = 0; k < steps; ++k) {
    const double angle = 2 * std::numbers::pi * k / steps;
    const double x = (std::cos(angle) - grid.s_min) / (grid.s_max - grid.s_min);
    const double y = (grid.t_max - std::sin(angle)) / (grid.t_max - grid.t_min);
    if (x < 0 || x >= 1 || y < 0 || y >= 1) continue;
    canvas.set(frame.x + static_cast<int>(x * frame.width), frame.y + static_cast<int>(y * frame.height), k_rim);
  }
}

void draw_axes(Canvas& canvas, const Frame& frame, const PndfGrid& grid) {
  using Align = Canvas::Align;
  const int below = frame.y + frame.height + 18;
  const auto number = [](double value) { return fmt::format("{:.4g}", value); };
  canvas.text(frame.x, below, number(grid.s_min), 12, k_text_2, Align::left, Canvas::Face::numbers);
  canvas.text(frame.x + frame.width / 2, below, "s", 13, k_text_2, Align::center);
  canvas.text(frame.x + frame.width, below, number(grid.s_max), 12, k_text_2, Align::right, Canvas::Face::numbers);
  const int left = frame.x - 6;
  canvas.text(left, frame.y + 10, number(grid.t_max), 12, k_text_2, Align::right, Canvas::Face::numbers);
  canvas.text(left, frame.y + frame.height / 2 + 5, "t", 13, k_text_2, Align::right);
  canvas.text(left, frame.y + frame.height, number(grid.t_min), 12, k_text_2, Align::right, Canvas::Face::numbers);
}

void draw_bar(Canvas& canvas, int x, int y, int height, const LogScale& scale) {
  for (int row = 0; row < height; ++row) {
    canvas.fill(x, y + row, k_bar, 1, viridis(1 - (row + 0.5) / height));
  }
  canvas.outline(x, y, k_bar, height, k_border);
  canvas.text(x, y - 8, "D", 13, k_text);
  canvas.text(x + 14, y - 8, "per area", 12, k_hint);
  const auto decades = static_cast<int>(std::lround(std::log10(scale.hi / scale.lo)));
  for (int decade = 0; decade <= decades; ++decade) {
    const int at = y + height * decade / decades;
    canvas.fill(x + k_bar + 1, at, 4, 1, k_text_2);
    canvas.text(x + k_bar + 9, at + 5, fmt::format("{:.3g}", scale.hi * std::pow(10, -decade)), 12, k_text_2,
                Canvas::Align::left, Canvas::Face::numbers);
  }
}

}  // namespace

Canvas draw_pndf_picture(std::span<const PictureEntry> entries, const std::string& footer) {
  const PndfGrid& grid = entries.front().image->grid;
  Frame frame = frame_for(grid);
  const int count = static_cast<int>(entries.size());
  const int step = frame.width + k_gap;
  Canvas canvas(k_margin + count * step + k_gap + k_bar + k_bar_labels, k_header + frame.height + k_below + k_footer,
                k_window);
  const auto& densities = entries.front().image->density;
  const LogScale scale = fitted_scale(*std::max_element(densities.begin(), densities.end()));

  frame.y = k_header;
  for (int k = 0; k < count; ++k) {
    const PictureEntry& entry = entries[static_cast<std::size_t>(k)];
    frame.x = k_margin + k_gap + k * step;
    canvas.text(frame.x, 32, entry.title, 16, k_text);
    canvas.text(frame.x + frame.width, 32, entry.detail, 12, k_hint, Canvas::Align::right);
    draw_density(canvas, frame, *entry.image, scale);
    draw_rim(canvas, frame, grid);
    draw_axes(canvas, frame, grid);
    canvas.text(frame.x, frame.y + frame.height + 44, entry.caption, 12, k_text_2, Canvas::Align::left,
                Canvas::Face::numbers);
  }
  draw_bar(canvas, frame.x + frame.width + 28, frame.y, frame.height, scale);
  canvas.text(k_margin + k_gap, canvas.height() - 18, footer, 12, k_hint);
  return canvas;
}

}  // namespace glint
