#include "viewers/map/map_inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/image/color_map.h"
#include "viewers/map/map_colors.h"
#include "viewers/map/map_gesture.h"
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

std::optional<Rectangle> MapInset::area(const Ui& ui, const MapCamera& camera, const NormalMap& map, float side) {
  const TexelRange range = visible_texels(camera);
  const bool all_in_view =
      range.min.x <= 0 && range.min.y <= 0 && range.max.x >= map.width() && range.max.y >= map.height();
  if (all_in_view) return std::nullopt;
  const double longer = std::max(map.width(), map.height());
  const auto length = [&](int texels) {
    return std::max(ui.px(6), std::floor(static_cast<float>(texels / longer) * side + 0.5F));
  };
  const ImVec2 corner{camera.picture.max.x - ui.px(6), camera.picture.min.y + ui.px(6)};
  return Rectangle{{corner.x - length(map.width()), corner.y}, {corner.x, corner.y + length(map.height())}};
}

void MapInset::draw(Ui& ui, ImDrawList& list, const Rectangle& area, const MapCamera& camera,
                    const std::shared_ptr<const NormalPyramid>& pyramid, MapColors colors,
                    glm::dvec2 footprint_center) {
  const int side = static_cast<int>(std::max(area.width(), area.height()));
  if (of_ != pyramid || colors_ != colors || side_ != side) {
    const Overview overview = overview_of(*pyramid, colors, side);
    overview_ = Texture(ui.gl, Texture::Format::rgba8, overview.size, overview.texels.data());
    of_ = pyramid;
    colors_ = colors;
    side_ = side;
  }
  const float line = ui.px(1);
  list.AddRectFilled({area.min.x - 2 * line, area.min.y - 2 * line}, {area.max.x + 2 * line, area.max.y + 2 * line},
                     color::k_under_stroke);
  list.AddRectFilled({area.min.x - line, area.min.y - line}, {area.max.x + line, area.max.y + line},
                     rgb(0xFFFFFF, 230));
  list.AddImage(ui.pictures.add(overview_, {}), area.min, area.max);

  const glm::ivec2 size(pyramid->width(0), pyramid->height(0));
  const TexelRange range = visible_texels(camera);
  const ImVec2 low = minimap_of_texel(area, size, range.min);
  const ImVec2 high = minimap_of_texel(area, size, range.max);
  // At least three pixels, so that it can be seen where one is at any zoom.
  const float grow_x = std::max(0.0F, 0.5F * (ui.px(5) - (high.x - low.x)));
  const float grow_y = std::max(0.0F, 0.5F * (ui.px(5) - (high.y - low.y)));
  list.PushClipRect(area.min, area.max, true);
  const ImVec2 a{std::floor(std::max(low.x - grow_x, area.min.x)), std::floor(std::max(low.y - grow_y, area.min.y))};
  const ImVec2 b{std::ceil(std::min(high.x + grow_x, area.max.x)), std::ceil(std::min(high.y + grow_y, area.max.y))};
  list.AddRect({a.x - line, a.y - line}, {b.x + line, b.y + line}, color::k_under_stroke, 0, 0, line);
  list.AddRect(a, b, color::k_accent, 0, 0, line);
  const ImVec2 dot = minimap_of_texel(area, size, footprint_center);
  list.AddCircleFilled(dot, 3 * ui.scale, color::k_under_stroke, 12);
  list.AddCircleFilled(dot, 2 * ui.scale, color::k_accent, 12);
  list.PopClipRect();
}

std::optional<Rectangle> MapInset::draw_legend(Ui& ui, ImDrawList& list, ImVec2 at, float width, MapColors colors) {
  if (colors == MapColors::normal) return std::nullopt;
  if (bar_.empty()) bar_ = viridis_bar(ui.gl);
  const bool is_slope = colors == MapColors::slope;
  const std::string_view low = is_slope ? "0" : "10⁻⁴";
  const std::string_view high = is_slope ? "1" : "1 /texel";
  const std::string_view name = is_slope ? "slope" : "curvature";
  const ImFont* font = ui.fonts.small;
  const float gap = ui.px(5);
  const float triangle = ui.px(6);
  const float words = text_size(font, low).x + text_size(font, high).x + 4 * gap + 2 * triangle;
  const float named = text_size(font, name).x + gap;
  const float wanted = ui.px(64);
  const bool has_name = words + named + ui.px(30) <= width;
  const float bar = std::floor(std::clamp(width - words - (has_name ? named : 0), ui.px(20), wanted));
  const Rectangle area{at, {at.x + std::ceil(words + bar + (has_name ? named : 0)), at.y + ui.px(18)}};
  list.AddRectFilled(area.min, area.max, color::k_chip, ui.px(3));
  const float top = at.y + 0.5F * (ui.px(18) - font->FontSize);
  float x = at.x + gap;
  const auto word = [&](std::string_view text, ImU32 ink) {
    draw_text(list, font, {x, top}, ink, text);
    x += text_size(font, text).x + gap;
  };
  if (has_name) word(name, color::k_text_2);
  word(low, color::k_text);
  x = std::floor(x);
  const float y0 = at.y + ui.px(5);
  const float y1 = at.y + ui.px(13);
  const float middle = 0.5F * (y0 + y1);
  const ImU32 under = packed(k_underflow_color);
  if (!is_slope) {
    list.AddTriangleFilled({x, middle}, {x + triangle, y0}, {x + triangle, y1}, under);
    list.AddTriangle({x, middle}, {x + triangle, y0}, {x + triangle, y1}, color::k_border_strong);
  }
  x += triangle;
  list.AddImage(ui.pictures.add(bar_, {}), {x, y0}, {x + bar, y1});
  x += bar;
  list.AddTriangleFilled({x, y0}, {x + triangle, middle}, {x, y1}, packed(k_overflow_color));
  x += triangle + gap;
  word(high, color::k_text);
  return area;
}

}  // namespace glint::view
