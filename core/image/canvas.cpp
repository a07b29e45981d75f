#include "core/image/canvas.h"

#include <array>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "core/image/png_file.h"

namespace glint {
namespace {

// The tool's faces first, then what most machines have. OpenImageIO takes a font by its file.
std::string font_file(Canvas::Face face) {
  static constexpr std::array k_text = {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
                                        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
  static constexpr std::array k_numbers = {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
                                           "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"};
  for (const char* file : face == Canvas::Face::text ? k_text : k_numbers) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return file;
  }
  return {};
}

}  // namespace

Canvas::Canvas(int width, int height, DisplayColor ground)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), ground) {}

void Canvas::set(int x, int y, DisplayColor color) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] = color;
}

void Canvas::fill(int x, int y, int width, int height, DisplayColor color) {
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) set(column, row, color);
  }
}

void Canvas::outline(int x, int y, int width, int height, DisplayColor color) {
  fill(x - 1, y - 1, width + 2, 1, color);
  fill(x - 1, y + height, width + 2, 1, color);
  fill(x - 1, y, 1, height, color);
  fill(x + width, y, 1, height, color);
}

void Canvas::text(int x, int y, const std::string& line, int size, DisplayColor color, Align align, Face face) {
  if (line.empty()) return;  // it has no extent
  const std::string font = font_file(face);
  const OIIO::ROI extent = font.empty() ? OIIO::ROI() : OIIO::ImageBufAlgo::text_size(line, size, font);
  if (!extent.defined()) {
    text_missing_ = true;
    return;
  }
  const int left = align == Align::left ? x : align == Align::right ? x - extent.width() : x - extent.width() / 2;
  const OIIO::ImageSpec spec(width_, height_, 3, OIIO::TypeDesc::UINT8);
  OIIO::ImageBuf buffer(spec, pixels_.data());
  const std::array<float, 3> ink = {static_cast<float>(color.r) / 255.0F, static_cast<float>(color.g) / 255.0F,
                                    static_cast<float>(color.b) / 255.0F};
  if (!OIIO::ImageBufAlgo::render_text(buffer, left, y, line, size, font, ink)) text_missing_ = true;
}

Status Canvas::write_png(const std::filesystem::path& path) const {
  static_assert(sizeof(DisplayColor) == 3);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels_.data());
  return write_png_8(path, width_, height_, {bytes, 3 * pixels_.size()});
}

}  // namespace glint
