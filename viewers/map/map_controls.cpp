#include "viewers/map/map_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/document/names.h"
#include "core/document/parameter.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

std::string zoom_text(double zoom) {
  const int digits = zoom >= 9.95 ? 0 : zoom >= 0.995 ? 1 : zoom >= 0.0995 ? 2 : 3;
  return fmt::format("{:.{}f}×", zoom, digits);
}

Rectangle around(ImVec2 center, float half) {
  return {{center.x - half, center.y - half}, {center.x + half, center.y + half}};
}

}  // namespace

std::optional<Edit> draw_map_toolbar(Ui& ui, const Rectangle& area, const Document& document, double zoom) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  static constexpr std::array<std::string_view, 3> k_labels{"Normal", "Slope", "Curvature"};
  const Parameter& parameter = *find_parameter("view.map_colors");
  const Explained explained{"Map colours", std::string(parameter.help), {}};
  const std::string value = zoom_text(zoom);
  const float value_width = text_size(ui.fonts.numbers, "0.25×").x;
  const float caption_width = text_size(ui.fonts.small, "zoom").x + ui.px(5);
  const float switch_room = area.width() - value_width - ui.px(8);
  const int chosen = static_cast<int>(document.view.map_colors);
  std::optional<int> picked;
  float used = switch_width(ui, k_labels);
  if (used <= switch_room) {
    picked = switch_of(ui, parameter.path, area.min, k_choice_names<MapColors>, k_labels, chosen, explained);
  } else {
    used = std::min(ui.px(110), switch_room);
    picked = combo(ui, parameter.path, {area.min, {area.min.x + used, area.max.y}}, k_labels, chosen, explained);
  }
  const float top = area.center().y - 0.5F * ui.fonts.numbers->FontSize;
  draw_text_right(list, ui.fonts.numbers, {area.max.x, top}, color::k_text, value);
  const Rectangle zoom_area{{area.max.x - value_width, area.min.y}, area.max};
  ui.widgets.record("map.zoom", {zoom_area, {}, false, false});
  explain(ui, "map.zoom", zoom_area, {"Zoom", "Screen pixels a texel.", {}});
  if (used + caption_width <= switch_room) {
    draw_text(list, ui.fonts.small,
              {area.max.x - text_size(ui.fonts.numbers, value).x - caption_width,
               area.center().y - 0.5F * ui.fonts.small->FontSize + ui.px(1)},
              color::k_hint, "zoom");
  }
  if (!picked) return std::nullopt;
  Edit edit{document, {}, true};
  edit.document.view.map_colors = static_cast<MapColors>(*picked);
  edit.label = "Map colours to " + std::string(choice_name(edit.document.view.map_colors));
  return edit;
}

MapMouse mouse_over(Ui& ui, const Rectangle& picture) {
  ImGui::SetCursorScreenPos(picture.min);
  ImGui::InvisibleButton("map.picture", {std::max(1.0F, picture.width()), std::max(1.0F, picture.height())},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  const ImGuiIO& io = ImGui::GetIO();
  MapMouse mouse;
  mouse.at = ImGui::IsMousePosValid() ? io.MousePos : ImVec2(-1e6F, -1e6F);
  mouse.over = !ui.blocked && ImGui::IsItemHovered();
  mouse.held = !ui.blocked && ImGui::IsItemActive();
  mouse.pressed = mouse.held && ImGui::IsItemActivated();
  const bool space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space));
  mouse.pans = io.KeyAlt || space || !ImGui::IsMouseDown(ImGuiMouseButton_Left);
  mouse.wheel = mouse.over ? io.MouseWheel : 0;
  mouse.shift = io.KeyShift;
  mouse.ctrl = io.KeyCtrl;
  return mouse;
}

void record_map_places(Ui& ui, const MapScene& scene) {
  ui.widgets.record("map.picture", {scene.camera.picture, {}, false, false});
  ui.widgets.record("map.center",
                    {around(screen_of_texel(scene.camera, scene.footprint.center), ui.px(5)), {}, false, false});
  for (std::size_t k = 0; k < scene.handles.size(); ++k) {
    ui.widgets.record(fmt::format("map.handle.{}", k + 1), {around(scene.handles[k], ui.px(4)), {}, false, false});
  }
  if (scene.minimap) ui.widgets.record("map.minimap", {*scene.minimap, {}, false, false});
}

void explain_map_target(Ui& ui, const MapScene& scene, const MapTarget& target) {
  switch (target.kind) {
    case MapTarget::Kind::handle: {
      const auto index = static_cast<std::size_t>(target.handle);
      explain(ui, fmt::format("map.handle.{}", index + 1), around(scene.handles[index], ui.px(7)),
              {k_axis_ends[index].axis == 0 ? "Width σ1 and angle" : "Width σ2 and angle",
               "Drag to shape the footprint. Shift keeps the angle, Ctrl the ratio of the widths.",
               {}});
      break;
    }
    case MapTarget::Kind::center:
      explain(ui, "map.center", around(screen_of_texel(scene.camera, scene.footprint.center), ui.px(6)),
              {"Centre of the footprint", "Drag to move it. Shift snaps to the centres of texels.", {}});
      break;
    case MapTarget::Kind::minimap:
      explain(ui, "map.minimap", *scene.minimap, {"Overview", "Click or drag to look elsewhere on the map.", {}});
      break;
    case MapTarget::Kind::nothing:
      explain(ui, "map.picture", scene.camera.picture,
              {{}, "The map ends here, for its wrap is clamp: a footprint's centre must lie on it.", {}});
      break;
    case MapTarget::Kind::ground:
      break;
  }
}

bool draw_empty_map(Ui& ui, const Rectangle& area, const std::string& error, bool loading) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_picture);
  list.AddRect(area.min, area.max, color::k_border);
  const std::string sentence = loading         ? "The map is on its way."
                               : error.empty() ? "No map yet. Drop a picture here, or open one."
                                               : error;
  const std::vector<std::string> lines = wrapped_text(ui.fonts.text, sentence, area.width() - ui.px(24));
  const float pitch = ui.fonts.text->FontSize + ui.px(2);
  float y = area.center().y - 0.5F * (static_cast<float>(lines.size()) * pitch + ui.px(34));
  for (const std::string& line : lines) {
    draw_text_centered(list, ui.fonts.text, {area.center().x, y + 0.5F * pitch}, color::k_hint, line);
    y += pitch;
  }
  const float width = button_width(ui, "Open…");
  const float left = std::floor(area.center().x - 0.5F * width);
  const float top = std::floor(y + ui.px(10));
  return button(ui, "map.open", {{left, top}, {left + width, top + ui.px(size::k_row)}}, "Open…",
                {"Open a normal map", "PNG, JPEG, TGA, EXR, HDR, TIFF …", {}});
}

}  // namespace glint::view
