#include "viewers/widgets/panel.h"

#include <string>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

void draw_header(Ui& ui, const PanelHeader& header, const Rectangle& area, PanelEvents& events) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = ui.px(size::k_panel_header);
  const Rectangle bar{area.min, {area.max.x, area.min.y + height}};
  const float rounding = ui.px(4);
  list.AddRectFilled(bar.min, bar.max, color::k_header, rounding, ImDrawFlags_RoundCornersTop);
  list.AddLine({bar.min.x, bar.max.y}, bar.max, color::k_border);
  if (header.focused) {
    list.AddRectFilled(bar.min, {bar.max.x, bar.min.y + ui.px(2)}, color::k_accent, rounding,
                       ImDrawFlags_RoundCornersTop);
  }
  const std::string name(header.name);
  const float middle = bar.center().y;
  float right = bar.max.x - ui.px(15);
  icon_button(ui, name + ".help", {right, middle}, Icon::help,
              {std::string(header.title), std::string(header.hint) + ". " + std::string(header.help), {}});
  right -= ui.px(22);
  events.maximise_pressed =
      icon_button(ui, name + ".maximise", {right, middle}, header.maximised ? Icon::restore : Icon::maximise,
                  {header.maximised ? "Back to all panels" : "Fill the window with this panel", {}, {}});
  if (header.can_export) {
    right -= ui.px(22);
    events.export_pressed = icon_button(ui, name + ".export", {right, middle}, Icon::export_picture,
                                        {"Export this panel", "As a PNG of what is on screen, or as data.", {}});
  }
  const float x = bar.min.x + ui.px(size::k_padding);
  draw_text(list, ui.fonts.title, {x, middle - 0.5F * ui.fonts.title->FontSize}, color::k_text, header.title);
  const float hint_x = x + text_size(ui.fonts.title, header.title).x + ui.px(10);
  if (hint_x + text_size(ui.fonts.small, header.hint).x < right - ui.px(16)) {
    draw_text(list, ui.fonts.small, {hint_x, middle - 0.5F * ui.fonts.small->FontSize + ui.px(1)}, color::k_hint,
              header.hint);
  }
  if (header.busy) {
    const Rectangle progress{{bar.min.x, bar.max.y - ui.px(3)}, bar.max};
    list.AddRectFilled(progress.min, progress.max, color::k_frame_active);
    list.AddRectFilled(progress.min,
                       {progress.min.x + static_cast<float>(header.progress) * progress.width(), progress.max.y},
                       color::k_accent);
  }
}

}  // namespace

PanelEvents begin_panel(Ui& ui, const PanelHeader& header, const Rectangle& area, Rectangle& content, bool scrolls) {
  PanelEvents events;
  const std::string name(header.name);
  ui.widgets.record(name, {area, {}, false, false});
  ImGui::SetCursorScreenPos(area.min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 0);
  constexpr ImGuiWindowFlags k_still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                                       ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground;
  ImGui::BeginChild(("##panel " + name).c_str(), area.size(), false, k_still);
  ImGui::PopStyleVar(2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(4);
  list.AddRectFilled(area.min, area.max, color::k_panel, rounding);
  draw_header(ui, header, area, events);
  list.AddRect(area.min, area.max, header.focused ? color::k_border_strong : color::k_border, rounding);
  events.clicked = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::IsMouseClicked(0);

  content = {{area.min.x + ui.px(1), area.min.y + ui.px(size::k_panel_header) + 1},
             {area.max.x - ui.px(1), area.max.y - ui.px(1)}};
  ImGui::SetCursorScreenPos(content.min);
  const ImGuiWindowFlags flags = scrolls ? ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground : k_still;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 0);
  ImGui::BeginChild(("##content " + name).c_str(), content.size(), false, flags);
  ImGui::PopStyleVar(2);
  return events;
}

void end_panel() {
  ImGui::EndChild();
  ImGui::EndChild();
}

}  // namespace glint::view
