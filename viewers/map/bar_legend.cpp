#include "viewers/map/bar_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/image/color_map.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

ImU32 packed(DisplayColor color) {
  return IM_COL32(color.x, color.y, color.z, 255);
}

Texture viridis_bar(const GlFunctions& gl) {
  std::array<std::uint8_t, 1024> texels{};
  const std::array<DisplayColor, 256> table = viridis_table();
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (int c = 0; c < 3; ++c) texels[4 * k + static_cast<std::size_t>(c)] = table[k][c];
    texels[4 * k + 3] = 255;
  }
  return {gl, Texture::Format::rgba8, {256, 1}, texels.data()};
}

}  // namespace

Rectangle BarLegend::draw(Ui& ui, ImDrawList& list, ImVec2 at, float width, const LegendText& text) {
  if (bar_.empty()) bar_ = viridis_bar(ui.gl);
  const ImFont* font = ui.fonts.small;
  const float gap = ui.px(5);
  const float triangle = ui.px(6);
  const float words = text_size(font, text.low).x + text_size(font, text.high).x + 4 * gap + 2 * triangle;
  const auto named = [&](std::string_view name) { return text_size(font, name).x + gap; };
  const auto fits = [&](std::string_view name) { return words + named(name) + ui.px(30) <= width; };
  const auto name = std::find_if(text.names.begin(), text.names.end(), fits);
  const float name_width = name == text.names.end() ? 0 : named(*name);
  const float bar = std::floor(std::clamp(width - words - name_width, ui.px(20), ui.px(64)));
  const Rectangle area{at, {at.x + std::ceil(words + bar + name_width), at.y + ui.px(18)}};
  list.AddRectFilled(area.min, area.max, color::k_chip, ui.px(3));
  const float top = at.y + 0.5F * (ui.px(18) - font->FontSize);
  float x = at.x + gap;
  const auto word = [&](std::string_view letters, ImU32 ink) {
    draw_text(list, font, {x, top}, ink, letters);
    x += text_size(font, letters).x + gap;
  };
  if (name != text.names.end()) word(*name, color::k_text_2);
  word(text.low, color::k_text);
  x = std::floor(x);
  const float y0 = at.y + ui.px(5);
  const float y1 = at.y + ui.px(13);
  const float middle = 0.5F * (y0 + y1);
  if (text.has_under) {
    list.AddTriangleFilled({x, middle}, {x + triangle, y0}, {x + triangle, y1}, packed(k_underflow_color));
    list.AddTriangle({x, middle}, {x + triangle, y0}, {x + triangle, y1}, color::k_border_strong);
  }
  x += triangle;
  list.AddImage(ui.pictures.add(bar_, {}), {x, y0}, {x + bar, y1});
  x += bar;
  if (text.has_over) {
    list.AddTriangleFilled({x, y0}, {x + triangle, middle}, {x, y1}, packed(k_overflow_color));
  }
  x += triangle + gap;
  word(text.high, color::k_text);
  return area;
}

}  // namespace glint::view
