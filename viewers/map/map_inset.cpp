#include "viewers/map/map_inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "viewers/map/map_colors.h"
#include "viewers/map/map_gesture.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
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
  static constexpr std::array<std::string_view, 1> k_slope{"slope"};
  static constexpr std::array<std::string_view, 1> k_curvature{"curvature"};
  const bool is_slope = colors == MapColors::slope;
  return legend_.draw(
      ui, list, at, width,
      is_slope ? LegendText{k_slope, "0", "1", false, true} : LegendText{k_curvature, "10⁻⁴", "1 /texel", true, true});
}

}  // namespace glint::view
