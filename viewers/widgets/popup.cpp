// The list that lies over everything, and the combo that opens one.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

float list_width(const Ui& ui, const Rectangle& anchor, std::span<const PopupRow> rows) {
  float width = anchor.width();
  for (const PopupRow& row : rows) {
    float wanted = ui.px(30) + text_size(ui.fonts.text, row.label).x + ui.px(14);
    if (!row.shortcut.empty()) wanted += ui.px(28) + text_size(ui.fonts.small, row.shortcut).x;
    width = std::max(width, wanted);
  }
  return std::ceil(width);
}

float list_height(const Ui& ui, std::span<const PopupRow> rows) {
  const auto separators = std::count_if(rows.begin(), rows.end(), [](const PopupRow& r) { return r.separator_before; });
  return ui.px(8) + static_cast<float>(rows.size()) * ui.px(size::k_row) + static_cast<float>(separators) * ui.px(9);
}

void move_highlight(Ui& ui, std::span<const PopupRow> rows) {
  int& row = ui.state.popup_row;
  const int count = static_cast<int>(rows.size());
  if (ui.state.focus.down != 0) {
    const int step = ui.state.focus.down > 0 ? 1 : -1;
    for (int tries = 0; tries < count; ++tries) {
      row = (row + step + count) % count;
      if (rows[static_cast<std::size_t>(row)].reason.empty()) break;
    }
    ui.state.focus.down = 0;
  }
}

// One row; true when it was chosen.
bool draw_row(Ui& ui, const PopupRow& row, int index, const Rectangle& area) {
  const std::string name = "popup." + row.key;
  const std::string focused = ui.state.focus.name;
  const bool chosen_by_key = ui.state.popup_row == index && ui.state.focus.activate;
  const Press press = pressable(ui, name, area, {row.label, row.tooltip, row.reason});
  ui.state.focus.name = focused;
  if (press.hovered && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0)) {
    ui.state.popup_row = index;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ui.state.popup_row == index) list.AddRectFilled(area.min, area.max, color::k_frame_hover, ui.px(3));
  const ImU32 ink = press.enabled ? color::k_text : color::k_disabled;
  const float middle = area.center().y;
  if (row.checked) {
    draw_icon(ui, list, Icon::check, {area.min.x + ui.px(14), middle}, press.enabled ? color::k_accent_hover : ink);
  }
  draw_text(list, ui.fonts.text, {area.min.x + ui.px(28), middle - 0.5F * ui.fonts.text->FontSize}, ink, row.label);
  draw_text_right(list, ui.fonts.small, {area.max.x - ui.px(8), middle - 0.5F * ui.fonts.small->FontSize},
                  color::k_hint, row.shortcut);
  if (chosen_by_key) ui.state.focus.activate = false;
  return press.pressed || (chosen_by_key && press.enabled);
}

}  // namespace

void open_popup(Ui& ui, std::string_view name) {
  ui.state.open_popup = name;
  ui.state.popup_row = -1;
}

bool popup_open(const Ui& ui, std::string_view name) {
  return ui.state.open_popup == name;
}

std::optional<int> popup_list(Ui& ui, std::string_view name, const Rectangle& anchor, std::span<const PopupRow> rows) {
  const std::string id = "##list " + std::string(name);
  if (!popup_open(ui, name)) {
    if (ImGui::IsPopupOpen(id.c_str()) && ImGui::BeginPopup(id.c_str())) {  // it was left by a key
      ImGui::CloseCurrentPopup();
      ImGui::EndPopup();
    }
    return std::nullopt;
  }
  if (ui.state.popup_row < 0) {
    ImGui::OpenPopup(id.c_str());
    const auto checked = std::find_if(rows.begin(), rows.end(), [](const PopupRow& r) { return r.checked; });
    ui.state.popup_row = checked == rows.end() ? 0 : static_cast<int>(checked - rows.begin());
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = list_width(ui, anchor, rows);
  const float wanted = list_height(ui, rows);
  const float below = screen.y - anchor.max.y - ui.px(8);
  const float above = anchor.min.y - ui.px(8);
  const bool under = wanted <= below || below >= above;
  const float height = std::min(wanted, under ? below : above);
  ImGui::SetNextWindowPos({std::clamp(anchor.min.x, 0.0F, std::max(0.0F, screen.x - width)),
                           under ? anchor.max.y + ui.px(2) : anchor.min.y - height - ui.px(2)});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_Border, color::k_border_strong);
  std::optional<int> chosen;
  const bool open = ImGui::BeginPopup(id.c_str(), ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (!open) {
    ui.state.open_popup.clear();
    return std::nullopt;
  }
  move_highlight(ui, rows);
  const bool blocked = ui.blocked;
  ui.blocked = false;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float y = origin.y + ui.px(4);
  for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
    const PopupRow& row = rows[static_cast<std::size_t>(k)];
    if (row.separator_before) {
      ImGui::GetWindowDrawList()->AddLine({origin.x + ui.px(8), y + ui.px(4)},
                                          {origin.x + width - ui.px(8), y + ui.px(4)}, color::k_border_strong);
      y += ui.px(9);
    }
    const Rectangle area{{origin.x + ui.px(4), y}, {origin.x + width - ui.px(4), y + ui.px(size::k_row)}};
    if (draw_row(ui, row, k, area)) chosen = k;
    y += ui.px(size::k_row);
  }
  ui.blocked = blocked;
  if (chosen || ui.state.open_popup.empty()) {
    ImGui::CloseCurrentPopup();
    if (popup_open(ui, name)) ui.state.open_popup.clear();
  }
  ImGui::EndPopup();
  return chosen;
}

std::optional<int> combo(Ui& ui, std::string_view name, const Rectangle& area, std::span<const std::string_view> labels,
                         int chosen, const Explained& explained) {
  const Press press = pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(3);
  if (press.enabled) {
    const ImU32 ground = press.held ? color::k_frame_active : press.hovered ? color::k_frame_hover : color::k_frame;
    list.AddRectFilled(area.min, area.max, ground, rounding);
  }
  if (press.focused || !press.enabled) {
    list.AddRect(area.min, area.max, press.focused ? color::k_accent : color::k_border, rounding);
  }
  const ImU32 ink = press.enabled ? color::k_text : color::k_disabled;
  const std::string_view label = chosen >= 0 ? labels[static_cast<std::size_t>(chosen)] : std::string_view("–");
  const float room = area.width() - ui.px(8 + 22);
  draw_text(list, ui.fonts.text, {area.min.x + ui.px(8), area.center().y - 0.5F * ui.fonts.text->FontSize}, ink,
            fitted_text(ui.fonts.text, label, room));
  draw_icon(ui, list, Icon::arrow_down, {area.max.x - ui.px(13), area.center().y},
            press.enabled ? color::k_text_2 : color::k_disabled);
  if (press.pressed) open_popup(ui, name);
  if (!popup_open(ui, name)) return std::nullopt;
  std::vector<PopupRow> rows;
  rows.reserve(labels.size());
  for (std::size_t k = 0; k < labels.size(); ++k) {
    PopupRow row;
    row.key = labels[k];
    row.label = labels[k];
    row.checked = static_cast<int>(k) == chosen;
    rows.push_back(std::move(row));
  }
  const std::optional<int> picked = popup_list(ui, name, area, rows);
  return picked && *picked != chosen ? picked : std::nullopt;
}

}  // namespace glint::view
