// Values that are typed or slid: the entry and the slider of widgets.h.

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <string>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

void begin_editing(Ui& ui, std::string_view name, std::string_view value) {
  ui.state.editing = name;
  ui.state.text = value;
  ui.state.editing_began = true;
  ui.state.editing_error.clear();
  ui.state.focus.name = name;
}

// The entry while a person types in it; what they typed, once they end it.
std::optional<std::string> edit_text(Ui& ui, std::string_view name, const Rectangle& area) {
  UiState& state = ui.state;
  ui.widgets.record(name, {area, {}, true, false});
  ImGui::SetCursorScreenPos(area.min);
  ImGui::PushID(name.data(), name.data() + name.size());
  ImGui::PushFont(ui.fonts.numbers);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, color::k_frame_active);
  const float padding = std::floor(0.5F * (area.height() - ImGui::GetFontSize()));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(6), padding});
  ImGui::SetNextItemWidth(area.width());
  const bool began = state.editing_began;
  if (began) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##text", &state.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool active = ImGui::IsItemActive();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PopID();
  const bool refused = !state.editing_error.empty();
  ImGui::GetWindowDrawList()->AddRect(area.min, area.max, refused ? color::k_error_edge : color::k_accent, ui.px(3));
  if (refused) {
    ImGui::SetNextWindowPos({area.min.x, area.max.y + ui.px(4)});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ui.px(300));
    ImGui::PushFont(ui.fonts.small);
    ImGui::TextUnformatted(state.editing_error.c_str());
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  if (began && active) state.editing_began = false;
  if (ImGui::GetIO().KeysDown[256] && !began) {  // Escape: as it was
    state.editing.clear();
    return std::nullopt;
  }
  const bool left = !began && !state.editing_began && !active && !entered;
  if (!entered && !left) return std::nullopt;
  state.editing.clear();
  state.focus.activate = false;  // the Enter that ended it
  return state.text;
}

double share_of(double value, double lowest, double highest, bool logarithmic) {
  const double share = logarithmic ? std::log(std::max(value, lowest) / lowest) / std::log(highest / lowest)
                                   : (value - lowest) / (highest - lowest);
  return std::clamp(share, 0.0, 1.0);
}

double value_at(double share, double lowest, double highest, bool logarithmic) {
  const double inside = std::clamp(share, 0.0, 1.0);
  return logarithmic ? lowest * std::pow(highest / lowest, inside) : lowest + inside * (highest - lowest);
}

}  // namespace

std::optional<std::string> entry(Ui& ui, std::string_view name, const Rectangle& area, std::string_view value,
                                 std::string_view unit, const Explained& explained, std::string_view edited,
                                 bool left_aligned) {
  if (ui.state.editing == name) return edit_text(ui, name, area);
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(3);
  if (press.enabled) {
    list.AddRectFilled(area.min, area.max, press.hovered ? color::k_frame_hover : color::k_frame, rounding);
  }
  if (press.focused || !press.enabled) {
    list.AddRect(area.min, area.max, press.focused ? color::k_accent : color::k_border, rounding);
  }
  const ImU32 ink = press.enabled ? color::k_text : color::k_disabled;
  float padding = ui.px(7);
  const float unit_width = unit.empty() ? 0 : text_size(ui.fonts.small, unit).x + ui.px(4);
  const ImFont* font = ui.fonts.numbers;
  if (text_size(font, value).x > area.width() - unit_width - 2 * padding) {
    font = ui.fonts.small_numbers;
    padding = ui.px(4);
  }
  const float top = area.min.y + 0.5F * (area.height() - font->FontSize);
  float right = area.max.x - padding;
  if (!unit.empty()) {
    const float small_top = area.min.y + 0.5F * (area.height() - ui.fonts.small->FontSize);
    draw_text_right(list, ui.fonts.small, {right, small_top}, press.enabled ? color::k_text_2 : color::k_disabled,
                    unit);
    right -= unit_width;
  }
  const float room = right - area.min.x - padding;
  const std::string shown = fitted_text(font, value, room);
  if (left_aligned) {
    draw_text(list, font, {area.min.x + padding, top}, ink, shown);
  } else {
    draw_text_right(list, font, {right, top}, ink, shown);
  }
  if (press.pressed) begin_editing(ui, name, edited.empty() ? value : edited);
  return std::nullopt;
}

void refuse_entry(Ui& ui, std::string_view name, std::string_view text, std::string_view why) {
  begin_editing(ui, name, text);
  ui.state.editing_error = why;
}

std::optional<Slide> slider(Ui& ui, std::string_view name, const Rectangle& area, double value, double lowest,
                            double highest, bool logarithmic, const Explained& explained) {
  const Press press = pressable(ui, name, area, explained);
  UiState& state = ui.state;
  std::optional<Slide> slide;
  const float grab = ui.px(8);
  const float track = area.width() - grab;
  if (press.held) {
    const float mouse = ImGui::GetIO().MousePos.x;
    const double share = (mouse - area.min.x - 0.5 * grab) / track;
    if (state.dragging != name) {
      state.dragging = name;
      state.drag_start = mouse;
    }
    const bool moves = mouse != static_cast<float>(state.drag_start) || ImGui::GetIO().MouseDelta.x != 0;
    const double wanted = value_at(share, lowest, highest, logarithmic);
    if ((moves || ImGui::IsMouseClicked(0)) && wanted != value) slide = {wanted, false};
  } else if (state.dragging == name) {
    state.dragging.clear();
    slide = {value, true};
  } else if (press.focused && state.open_popup.empty() && (state.focus.right != 0 || state.focus.down != 0)) {
    const double steps = state.focus.right - state.focus.down;
    const double share = share_of(value, lowest, highest, logarithmic) + 0.01 * steps;
    slide = {value_at(share, lowest, highest, logarithmic), true};
    state.focus.right = state.focus.down = 0;
  }
  const double shown = slide && !slide->finished ? slide->value : value;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = std::floor(area.center().y);
  const float x = std::floor(area.min.x + static_cast<float>(share_of(shown, lowest, highest, logarithmic)) * track);
  const float half = ui.px(2);
  list.AddRectFilled({area.min.x, y - half}, {area.max.x, y + half},
                     press.enabled ? color::k_frame_active : color::k_border, half);
  if (press.enabled) list.AddRectFilled({area.min.x, y - half}, {x + 0.5F * grab, y + half}, color::k_accent, half);
  const ImU32 ink = !press.enabled                ? color::k_frame_active
                    : press.held || press.hovered ? rgb(0xFFFFFF)
                                                  : rgb(0xDADADA);
  list.AddRectFilled({x, y - ui.px(8)}, {x + grab, y + ui.px(8)}, ink, ui.px(2));
  if (press.focused) list.AddRect(area.min, area.max, color::k_accent, ui.px(3));
  return slide;
}

}  // namespace glint::view
