#include "viewers/widgets/widgets.h"

#include <array>
#include <cmath>
#include <vector>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr double k_rest_before_tooltip = 0.45;  // seconds

float middle(const Rectangle& area, const ImFont* font) {
  return area.min.y + 0.5F * (area.height() - font->FontSize);
}

void outline(ImDrawList& list, const Rectangle& area, ImU32 ink, float rounding) {
  list.AddRect(area.min, area.max, ink, rounding);
}

}  // namespace

void explain(Ui& ui, std::string_view name, const Rectangle& area, const Explained& explained) {
  if (explained.title.empty() && explained.text.empty() && explained.reason.empty()) return;
  const bool hovered = !ui.blocked && ImGui::IsMouseHoveringRect(area.min, area.max) && ImGui::IsWindowHovered();
  UiState& state = ui.state;
  if (!hovered) {
    if (state.hovered == name) state.hovered.clear();
    return;
  }
  if (state.hovered != name) {
    state.hovered = name;
    state.hovered_since = ui.seconds;
  }
  const bool waits = ui.seconds - state.hovered_since < k_rest_before_tooltip && !ui.headless;
  if (waits || ImGui::IsAnyMouseDown()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(340));
  if (!explained.title.empty()) {
    ImGui::PushFont(ui.fonts.title);
    ImGui::TextUnformatted(explained.title.c_str());
    ImGui::PopFont();
  }
  ImGui::PushFont(ui.fonts.small);
  if (!explained.reason.empty()) ImGui::TextUnformatted(explained.reason.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, color::k_text_2);
  if (!explained.text.empty()) ImGui::TextUnformatted(explained.text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

Press pressable(Ui& ui, std::string_view name, const Rectangle& area, const Explained& explained) {
  Press press;
  press.enabled = explained.reason.empty();
  ui.widgets.record(name, {area, explained.reason, press.enabled, false});
  ImGui::SetCursorScreenPos(area.min);
  ImGui::PushID(name.data(), name.data() + name.size());
  const bool clicked = ImGui::InvisibleButton("press", {std::max(1.0F, area.width()), std::max(1.0F, area.height())});
  press.hovered = ImGui::IsItemHovered();
  press.held = ImGui::IsItemActive() && press.enabled;
  ImGui::PopID();
  KeyboardFocus& focus = ui.state.focus;
  press.focused = focus.name == name;
  bool entered = false;
  if (press.focused) {
    if (focus.moved && ImGui::GetScrollMaxY() > 0) ImGui::SetScrollFromPosY(area.center().y - ImGui::GetWindowPos().y);
    if (focus.activate && ui.state.open_popup.empty()) {  // a list takes the key first
      entered = true;
      focus.activate = false;
    }
  }
  press.pressed = press.enabled && (clicked || entered);
  if (clicked) focus.name.clear();
  explain(ui, name, area, explained);
  return press;
}

float button_width(const Ui& ui, std::string_view text) {
  return std::ceil(text_size(ui.fonts.text, text).x) + 2 * ui.px(10);
}

bool button(Ui& ui, std::string_view name, const Rectangle& area, std::string_view text, const Explained& explained,
            ButtonKind kind) {
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(3);
  const bool primary = kind == ButtonKind::primary && press.enabled;
  if (press.enabled) {
    const ImU32 ground = primary         ? (press.hovered ? color::k_accent_hover : color::k_accent)
                         : press.held    ? color::k_frame_active
                         : press.hovered ? color::k_frame_hover
                                         : color::k_frame;
    list.AddRectFilled(area.min, area.max, ground, rounding);
  }
  const ImU32 edge = press.focused ? color::k_accent : press.enabled ? color::k_border_strong : color::k_border;
  if (!primary || press.focused) outline(list, area, primary ? color::k_text : edge, rounding);
  const ImU32 ink = primary ? color::k_on_accent : press.enabled ? color::k_text : color::k_disabled;
  draw_text_centered(list, ui.fonts.text, area.center(), ink, fitted_text(ui.fonts.text, text, area.width()));
  return press.pressed;
}

bool icon_button(Ui& ui, std::string_view name, ImVec2 center, Icon icon, const Explained& explained) {
  const float half = ui.px(10);
  const Rectangle area{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (press.hovered && press.enabled) list.AddRectFilled(area.min, area.max, color::k_frame_hover, ui.px(3));
  if (press.focused) outline(list, area, color::k_accent, ui.px(3));
  const ImU32 ink = !press.enabled ? color::k_disabled : press.hovered ? color::k_text : color::k_text_2;
  draw_icon(ui, list, icon, center, ink);
  return press.pressed;
}

float switch_width(const Ui& ui, std::span<const std::string_view> labels) {
  float width = 0;
  for (const std::string_view label : labels) width += std::ceil(text_size(ui.fonts.text, label).x) + 2 * ui.px(9);
  return width;
}

std::optional<int> switch_of(Ui& ui, std::string_view name, ImVec2 at, std::span<const std::string_view> keys,
                             std::span<const std::string_view> labels, int chosen, const Explained& explained) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(3);
  const float height = ui.px(size::k_row);
  const Rectangle whole{at, {at.x + switch_width(ui, labels), at.y + height}};
  const bool enabled = explained.reason.empty();
  if (enabled) list.AddRectFilled(whole.min, whole.max, color::k_frame, rounding);
  if (!enabled) outline(list, whole, color::k_border, rounding);
  ui.widgets.record(name, {whole, explained.reason, false, false});
  std::optional<int> picked;
  float x = at.x;
  for (int k = 0; k < static_cast<int>(labels.size()); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const float width = std::ceil(text_size(ui.fonts.text, labels[index]).x) + 2 * ui.px(9);
    const Rectangle area{{x, at.y}, {x + width, at.y + height}};
    const Press press = pressable(ui, std::string(name) + "." + std::string(keys[index]), area, explained);
    const bool is_chosen = k == chosen;
    if (is_chosen && enabled) {
      list.AddRectFilled(area.min, area.max, color::k_accent_ground, rounding);
      outline(list, area, color::k_accent, rounding);
    } else if (press.hovered && enabled) {
      list.AddRectFilled(area.min, area.max, color::k_frame_hover, rounding);
    }
    if (press.focused) outline(list, area, color::k_accent_hover, rounding);
    if (k > 0 && !is_chosen && k - 1 != chosen) {
      list.AddLine({x, at.y + ui.px(6)}, {x, at.y + ui.px(18)}, color::k_border_strong);
    }
    const ImU32 ink = !enabled ? color::k_disabled : is_chosen ? color::k_text : color::k_text_2;
    draw_text_centered(list, ui.fonts.text, area.center(), ink, labels[index]);
    if (press.pressed && !is_chosen) picked = k;
    x += width;
  }
  return picked;
}

bool checkbox(Ui& ui, std::string_view name, const Rectangle& area, std::string_view label, bool checked,
              const Explained& explained) {
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float side = ui.px(16);
  const float top = std::floor(area.center().y - 0.5F * side);
  const Rectangle box{{area.min.x, top}, {area.min.x + side, top + side}};
  const float rounding = ui.px(3);
  if (press.enabled) {
    const ImU32 ground = checked ? color::k_accent_ground : press.hovered ? color::k_frame_hover : color::k_frame;
    list.AddRectFilled(box.min, box.max, ground, rounding);
  }
  const ImU32 edge = !press.enabled             ? color::k_border
                     : checked || press.focused ? color::k_accent
                                                : color::k_border_strong;
  outline(list, box, edge, rounding);
  if (press.focused) outline(list, area, color::k_accent, rounding);
  if (checked)
    draw_icon(ui, list, Icon::check, box.center(), press.enabled ? color::k_accent_hover : color::k_disabled);
  draw_text(list, ui.fonts.text, {box.max.x + ui.px(8), middle(area, ui.fonts.text)},
            press.enabled ? color::k_text : color::k_disabled, label);
  return press.pressed;
}

bool reset_arrow(Ui& ui, std::string_view name, ImVec2 center, bool differs, const Explained& explained) {
  if (!differs) return false;
  const float half = ui.px(8);
  const Rectangle area{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (press.focused) outline(list, area, color::k_accent, ui.px(3));
  draw_icon(ui, list, Icon::reset, center, press.hovered ? color::k_accent_hover : color::k_accent);
  return press.pressed;
}

void progress_bar(const Ui& ui, const Rectangle& area, double progress) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(2);
  list.AddRectFilled(area.min, area.max, color::k_frame_active, rounding);
  if (std::isnan(progress)) return;
  const float filled = area.min.x + static_cast<float>(progress) * area.width();
  if (filled > area.min.x) list.AddRectFilled(area.min, {filled, area.max.y}, color::k_accent, rounding);
}

}  // namespace glint::view
