#include "gui/window/layout.h"

#include <algorithm>
#include <cmath>

#include "viewers/widgets/theme.h"

namespace glint::gui {
namespace {

constexpr float k_least_map = 240;  // widths at scale 1, as in the theme
constexpr float k_least_pndf = 420;
constexpr float k_least_inspector = 250;
constexpr double k_map_share = 0.44;  // of what the Inspector leaves

float whole(double x) {
  return static_cast<float>(std::floor(x + 0.5));
}

double ratio_of(const std::map<std::string, double>& ratios, const char* name, double otherwise) {
  const auto found = ratios.find(name);
  return found == ratios.end() ? otherwise : found->second;
}

float inspector_width(float width, float scale) {
  return width >= 1500 * scale ? 308 * scale : 262 * scale;
}

}  // namespace

std::string_view panel_name(Panel panel) {
  switch (panel) {
    case Panel::map:
      return "map";
    case Panel::pndf:
      return "pndf";
    case Panel::inspector:
      break;
  }
  return "inspector";
}

Layout compute_layout(ImVec2 window, float scale, float message_height, const std::map<std::string, double>& ratios,
                      std::string_view maximised) {
  Layout layout;
  const ImVec2 size{std::max(window.x, k_least_width * scale), std::max(window.y, k_least_height * scale)};
  const float bar = whole(view::size::k_bar * scale);
  const float gap = whole(view::size::k_gap * scale);
  layout.menu_bar = {{0, 0}, {size.x, bar}};
  layout.status_bar = {{0, size.y - bar}, {size.x, size.y}};
  layout.messages = {{0, bar}, {size.x, bar + message_height}};
  const float top = bar + message_height + gap;
  const view::Rectangle room{{gap, top}, {size.x - gap, size.y - bar - gap}};

  for (int k = 0; k < k_panel_count; ++k) {
    if (maximised == panel_name(static_cast<Panel>(k))) {
      layout.panels[static_cast<std::size_t>(k)] = room;
      return layout;
    }
  }

  const double width = room.width();
  const double least_left = (k_least_map + k_least_pndf) * scale + gap;
  Splitter& right = layout.splitters[1];
  right.name = "splitter.inspector";
  right.lowest = least_left / width;
  right.highest = (width - gap - k_least_inspector * scale) / width;
  right.ratio =
      std::clamp(ratio_of(ratios, "splitter.inspector", (width - gap - inspector_width(size.x, scale)) / width),
                 right.lowest, std::max(right.lowest, right.highest));
  const float left_end = whole(room.min.x + right.ratio * width);

  Splitter& left = layout.splitters[0];
  const double left_width = left_end - room.min.x;
  left.name = "splitter.map";
  left.lowest = k_least_map * scale / left_width;
  left.highest = (left_width - gap - k_least_pndf * scale) / left_width;
  left.ratio =
      std::clamp(ratio_of(ratios, "splitter.map", k_map_share), left.lowest, std::max(left.lowest, left.highest));
  const float map_end = whole(room.min.x + left.ratio * left_width);

  layout.panels[0] = {room.min, {map_end, room.max.y}};
  layout.panels[1] = {{map_end + gap, room.min.y}, {left_end, room.max.y}};
  layout.panels[2] = {{left_end + gap, room.min.y}, room.max};
  left.area = {{map_end, room.min.y}, {map_end + gap, room.max.y}};
  right.area = {{left_end, room.min.y}, {left_end + gap, room.max.y}};
  layout.splitter_count = 2;
  return layout;
}

}  // namespace glint::gui
