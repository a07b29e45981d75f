#include "gui/dialogs/shortcut_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace color = view::color;
using view::Rectangle;
using view::text_size;
using view::Ui;

constexpr const char* k_window = "##shortcut sheet";
constexpr const char* k_sheet = "sheet";

struct Gesture {
  std::string_view group, keys, title;
};

// What no action stands for.
constexpr std::array k_gestures = {
    Gesture{"Normal map", "Click", "Place the footprint"},
    Gesture{"Normal map", "Drag", "Move the footprint, or shape it at a handle"},
    Gesture{"Normal map", "Shift+drag", "Whole texels; at a handle: keep the angle"},
    Gesture{"Normal map", "Ctrl+drag", "At a handle: keep the proportions"},
    Gesture{"Normal map", "Middle drag", "Move the map; also Alt+drag"},
    Gesture{"Normal map", "Wheel", "Zoom at the mouse"},
    Gesture{"P-NDF", "Click", "Keep the crosshair at this normal"},
    Gesture{"P-NDF", "Wheel", "Zoom at the mouse"},
    Gesture{"P-NDF", "Right drag", "Move the disks"},
    Gesture{"P-NDF", "Double click", "Show the whole disk"},
    Gesture{"P-NDF", "Hold R", "Show the reference in every disk"},
    Gesture{"Controls", "Tab", "Next control; Shift+Tab: the one before"},
    Gesture{"Controls", "Enter", "Use the control, or type its value"},
    Gesture{"Controls", "Arrows", "Move a slider; with Shift: ten steps"},
};

float chip_width(const Ui& ui, const std::string& keys) {
  return std::ceil(text_size(ui.fonts.small, keys).x) + 2 * ui.px(6);
}

float chips_width(const Ui& ui, const SheetRow& row) {
  float width = -ui.px(4);
  for (const std::string& keys : row.keys) width += chip_width(ui, keys) + ui.px(4);
  return width;
}

struct Group {
  std::string title;
  std::vector<SheetRow> rows;
  std::size_t column = 0;
};

std::vector<Group> groups_of(std::vector<SheetRow> rows) {
  std::vector<Group> groups;
  for (SheetRow& row : rows) {
    if (groups.empty() || groups.back().title != row.group) groups.push_back({row.group, {}, 0});
    groups.back().rows.push_back(std::move(row));
  }
  return groups;
}

float group_height(const Ui& ui, const Group& group) {
  return ui.px(26) + static_cast<float>(group.rows.size()) * ui.px(23) + ui.px(12);
}

// Fills the columns from the left, none higher than `height` except by a group that alone is; the number that it takes.
std::size_t fill_columns(const Ui& ui, std::vector<Group>& groups, float height) {
  std::size_t column = 0;
  float filled = 0;
  for (Group& group : groups) {
    const float more = group_height(ui, group);
    if (filled > 0 && filled + more > height) {
      ++column;
      filled = 0;
    }
    group.column = column;
    filled += more;
  }
  return column + 1;
}

// One column: the chips, then the words.
struct Column {
  float keys = 0;
  float width = 0;
};

struct Layout {
  std::vector<Column> columns;
  float content_height = 0;
  Rectangle window, content;
};

// The widths of the columns as the groups stand in them now.
std::vector<Column> columns_of(const Ui& ui, const std::vector<Group>& groups, std::size_t count) {
  std::vector<Column> columns(count);
  for (const Group& group : groups) {
    for (const SheetRow& row : group.rows) {
      columns[group.column].keys = std::max(columns[group.column].keys, chips_width(ui, row));
    }
  }
  for (const Group& group : groups) {
    Column& column = columns[group.column];
    for (const SheetRow& row : group.rows) {
      column.width = std::max(column.width, column.keys + ui.px(10) + std::ceil(text_size(ui.fonts.text, row.title).x));
    }
  }
  return columns;
}

float width_of(const Ui& ui, const std::vector<Column>& columns) {
  float width = 2 * ui.px(20) + static_cast<float>(columns.size() - 1) * ui.px(36);
  for (const Column& column : columns) width += column.width;
  return width;
}

// As many columns as fit beside each other, then as low as they can be.
Layout layout_for(const Ui& ui, std::vector<Group>& groups) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui.px(20);
  float all = 0;
  for (const Group& group : groups) all += group_height(ui, group);
  Layout layout;
  float height = all;
  for (float tried = all; tried > 0; tried -= ui.px(12)) {
    const std::size_t count = fill_columns(ui, groups, tried);
    const std::vector<Column> columns = columns_of(ui, groups, count);
    if (count > 4 || width_of(ui, columns) > screen.x - 2 * margin) break;
    height = tried;
  }
  layout.columns = columns_of(ui, groups, fill_columns(ui, groups, height));
  std::vector<float> heights(layout.columns.size(), 0);
  for (const Group& group : groups) heights[group.column] += group_height(ui, group);
  layout.content_height = *std::max_element(heights.begin(), heights.end());
  const float head = ui.px(44);
  const float width = std::min(width_of(ui, layout.columns), screen.x - 2 * margin);
  const float shown = std::min(head + layout.content_height, screen.y - 2 * margin);
  layout.window.min = {std::floor(0.5F * (screen.x - width)), std::floor(0.5F * (screen.y - shown))};
  layout.window.max = {layout.window.min.x + width, layout.window.min.y + shown};
  layout.content = {{layout.window.min.x, layout.window.min.y + head}, layout.window.max};
  return layout;
}

void draw_row(const Ui& ui, ImDrawList& list, ImVec2 at, float keys_width, const SheetRow& row) {
  const float middle = at.y + ui.px(11);
  float x = at.x;
  for (const std::string& keys : row.keys) {
    const Rectangle chip{{x, middle - ui.px(9)}, {x + chip_width(ui, keys), middle + ui.px(9)}};
    list.AddRectFilled(chip.min, chip.max, color::k_frame, ui.px(3));
    list.AddRect(chip.min, chip.max, color::k_border_strong, ui.px(3));
    view::draw_text_centered(list, ui.fonts.small, chip.center(), color::k_text, keys);
    x = chip.max.x + ui.px(4);
  }
  view::draw_text(list, ui.fonts.text, {at.x + keys_width + ui.px(10), middle - 0.5F * ui.fonts.text->FontSize},
                  color::k_text_2, row.title);
}

void draw_groups(const Ui& ui, const Layout& layout, const std::vector<Group>& groups, float scrolled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(layout.content.min, {layout.content.max.x, layout.content.max.y - 1}, true);
  float x = layout.content.min.x + ui.px(20);
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const Column& column = layout.columns[k];
    float y = layout.content.min.y - scrolled;
    for (const Group& group : groups) {
      if (group.column != k) continue;
      view::draw_text(list, ui.fonts.title, {x, y + ui.px(3)}, color::k_text, group.title);
      y += ui.px(26);
      for (const SheetRow& row : group.rows) {
        draw_row(ui, list, {x, y}, column.keys, row);
        y += ui.px(23);
      }
      y += ui.px(12);
    }
    x += column.width + ui.px(36);
  }
  list.PopClipRect();
}

// The window's ground, over everything else, which is dimmed.
void draw_ground(const Ui& ui, const Rectangle& window) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, view::rgb(0x000000, 140));
  list.PopClipRect();
  list.AddRectFilled(window.min, window.max, color::k_popup, ui.px(4));
  list.AddRect(window.min, window.max, color::k_border_strong, ui.px(4));
}

bool key_pressed(Key key, bool repeats = false) {
  return ImGui::IsKeyPressed(static_cast<int>(key), repeats);
}

}  // namespace

std::vector<SheetRow> sheet_rows(const Actions& actions) {
  std::vector<SheetRow> rows;
  const auto add = [&](SheetRow row) {
    const auto same = std::find_if(rows.rbegin(), rows.rend(), [&](const SheetRow& r) { return r.group == row.group; });
    rows.insert(same == rows.rend() ? rows.end() : same.base(), std::move(row));
  };
  for (const Action& action : actions.all()) {
    SheetRow row{action.menu.empty() ? "Other keys" : action.menu, {}, action.title};
    if (action.chord) row.keys.push_back(chord_text(*action.chord));
    for (const Chord& chord : action.more_chords) row.keys.push_back(chord_text(chord));
    if (!row.keys.empty()) add(std::move(row));
  }
  for (const Gesture& gesture : k_gestures) {
    add({std::string(gesture.group), {std::string(gesture.keys)}, std::string(gesture.title)});
  }
  return rows;
}

void ShortcutSheet::open() {
  if (open_) return;
  open_ = opening_ = true;
  scrolled_ = 0;
}

void ShortcutSheet::finish(Ui& ui) {
  open_ = opening_ = false;
  if (ui.state.focus.name == k_sheet) ui.state.focus.name = focus_before_;
}

void ShortcutSheet::scroll(Ui& ui, float step, float page, float farthest) {
  view::KeyboardFocus& focus = ui.state.focus;
  float moved = static_cast<float>(focus.down) * step - 3 * step * ImGui::GetIO().MouseWheel;
  focus.down = focus.right = 0;
  if (key_pressed(Key::page_down, true)) moved += page;
  if (key_pressed(Key::page_up, true)) moved -= page;
  scrolled_ = std::floor(std::clamp(scrolled_ + moved, 0.0F, farthest));
}

void ShortcutSheet::draw(Ui& ui, const Actions& actions) {
  if (!open_) return;
  view::UiState& state = ui.state;
  std::vector<Group> groups = groups_of(sheet_rows(actions));
  const Layout layout = layout_for(ui, groups);
  const bool opens = std::exchange(opening_, false);
  if (opens) {
    ImGui::OpenPopup(k_window);
    focus_before_ = state.focus.name;
  }
  ImGui::SetNextWindowPos(layout.window.min);
  ImGui::SetNextWindowSize(layout.window.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_PopupBorderSize, 0);
  constexpr ImGuiWindowFlags k_flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                                       ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground;
  const bool shown = ImGui::BeginPopup(k_window, k_flags);
  ImGui::PopStyleVar(2);
  if (!shown) {
    finish(ui);
    return;
  }
  const bool blocked = std::exchange(ui.blocked, false);
  ui.widgets.record(k_sheet, {layout.window, {}, false, false});
  state.focus.name = k_sheet;
  const bool leaves = !opens && (state.focus.activate || key_pressed(Key::escape));
  state.focus.activate = false;
  draw_ground(ui, layout.window);
  const float top = layout.window.min.y + ui.px(12);
  view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.title, {layout.window.min.x + ui.px(20), top}, color::k_text,
                  "Keyboard and mouse");
  const ImVec2 cross{layout.window.max.x - ui.px(22), top + ui.px(8)};
  const bool closed = view::icon_button(ui, "sheet.close", cross, view::Icon::close, {"Close", {}, {}});
  const float farthest = std::max(0.0F, layout.content_height - layout.content.height());
  scroll(ui, ui.px(23), layout.content.height() - ui.px(46), farthest);
  draw_groups(ui, layout, groups, scrolled_);
  if (farthest > 0) {
    const float share = layout.content.height() / layout.content_height;
    const float mark = layout.content.min.y + scrolled_ * share;
    const float right = layout.window.max.x - ui.px(4);
    ImGui::GetWindowDrawList()->AddRectFilled({right - ui.px(4), mark},
                                              {right, mark + layout.content.height() * share - ui.px(4)},
                                              view::rgb(0x5A5A5A), ui.px(2));
  }
  if (closed || leaves) {
    ImGui::CloseCurrentPopup();
    finish(ui);
  }
  ui.blocked = blocked;
  ImGui::EndPopup();
}

}  // namespace glint::gui
