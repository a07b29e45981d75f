#include "gui/window/menu_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace color = view::color;
using view::Rectangle;
using view::Ui;

constexpr std::string_view k_palette_action = "help.find_action";

struct Menu {
  std::string name;  // "menu.File"
  std::string title;
  Rectangle area;
  std::vector<const Action*> actions;
};

std::vector<Menu> placed_menus(const Ui& ui, const Rectangle& bar, const Actions& actions) {
  std::vector<Menu> menus;
  for (const Action& action : actions.all()) {
    if (action.menu.empty()) continue;
    auto menu = std::find_if(menus.begin(), menus.end(), [&](const Menu& m) { return m.title == action.menu; });
    if (menu == menus.end()) menu = menus.insert(menus.end(), {"menu." + action.menu, action.menu, {}, {}});
    menu->actions.push_back(&action);
  }
  float x = bar.min.x + ui.px(23);
  for (Menu& menu : menus) {
    const float width = std::ceil(view::text_size(ui.fonts.text, menu.title).x) + 2 * ui.px(11);
    menu.area = {{x, bar.min.y}, {x + width, bar.max.y - 1}};
    x += width;
  }
  return menus;
}

std::vector<view::PopupRow> menu_rows(const Menu& menu) {
  std::vector<view::PopupRow> rows;
  rows.reserve(menu.actions.size());
  for (const Action* action : menu.actions) {
    rows.push_back({action->name, action->title, action->chord ? chord_text(*action->chord) : std::string(),
                    action->disabled_because(), action->tooltip, action->is_checked(),
                    action->separator_before && !rows.empty()});
  }
  return rows;
}

// The program's sign: a glint in a frame.
void draw_sign(const Ui& ui, ImDrawList& list, ImVec2 center) {
  const float half = ui.px(6.5F);
  const ImVec2 corner{std::floor(center.x - half), std::floor(center.y - half)};
  const float side = 2 * half;
  list.AddRect(corner, {corner.x + side, corner.y + side}, color::k_accent, ui.px(2), 0,
               std::max(1.0F, 1.2F * ui.scale));
  const ImVec2 middle{corner.x + half, corner.y + half};
  const float reach = 4.6F * ui.scale;
  const float waist = 1.1F * ui.scale;
  const auto at = [&](float x, float y) { return ImVec2(middle.x + x, middle.y + y); };
  const std::array wide{at(-reach, 0), at(0, -waist), at(reach, 0), at(0, waist)};
  const std::array high{at(0, -reach), at(waist, 0), at(0, reach), at(-waist, 0)};
  for (const auto& ray : {wide, high}) {
    list.AddConvexPolyFilled(ray.data(), static_cast<int>(ray.size()), color::k_accent_hover);
  }
}

std::optional<std::size_t> open_menu(const Ui& ui, const std::vector<Menu>& menus) {
  for (std::size_t k = 0; k < menus.size(); ++k) {
    if (view::popup_open(ui, menus[k].name)) return k;
  }
  return std::nullopt;
}

// While a menu is open, Dear ImGui hides the bar from the mouse, so its place decides.
void steer_open_menu(Ui& ui, const std::vector<Menu>& menus, std::size_t open) {
  view::KeyboardFocus& focus = ui.state.focus;
  if (ImGui::IsKeyPressed(static_cast<int>(Key::escape), false)) {
    ui.state.open_popup.clear();
    return;
  }
  std::size_t wanted = open;
  const ImGuiIO& io = ImGui::GetIO();
  if (focus.right != 0) {
    wanted = (open + (focus.right > 0 ? 1 : menus.size() - 1)) % menus.size();
    focus.right = 0;
  } else if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) {
    for (std::size_t k = 0; k < menus.size(); ++k) {
      if (menus[k].area.contains(io.MousePos)) wanted = k;
    }
  }
  if (wanted == open) return;
  if (focus.name == menus[open].name) focus.name = menus[wanted].name;
  view::open_popup(ui, menus[wanted].name);
}

// Left and Right go along the titles as long as none is open.
void walk_titles(Ui& ui, const std::vector<Menu>& menus) {
  view::KeyboardFocus& focus = ui.state.focus;
  const auto here = std::find_if(menus.begin(), menus.end(), [&](const Menu& m) { return m.name == focus.name; });
  if (here == menus.end() || focus.right == 0) return;
  const auto index = static_cast<std::size_t>(here - menus.begin());
  focus.name = menus[(index + (focus.right > 0 ? 1 : menus.size() - 1)) % menus.size()].name;
  focus.right = 0;
}

// A press on a title while another list lay open only closes that list: the menu follows one frame later.
bool was_pressed_last_frame(const Rectangle& area) {
  const ImGuiIO& io = ImGui::GetIO();
  return io.MouseDownDurationPrev[0] == 0.0F && area.contains(io.MouseClickedPos[0]);
}

void draw_title(Ui& ui, const Menu& menu, bool any_is_open) {
  view::KeyboardFocus& focus = ui.state.focus;
  const bool is_open = view::popup_open(ui, menu.name);
  const bool opened_by_key = focus.name == menu.name && !any_is_open && (focus.activate || focus.down > 0);
  const bool was_blocked = !any_is_open && !ui.state.open_popup.empty();
  const view::Press press = view::pressable(ui, menu.name, menu.area, {});
  const bool opened_by_mouse = !any_is_open && press.hovered && !ui.blocked && ImGui::IsMouseClicked(0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rectangle ground{{menu.area.min.x + ui.px(3), menu.area.min.y + ui.px(2)},
                         {menu.area.max.x - ui.px(3), menu.area.max.y - ui.px(2)}};
  if (is_open || press.hovered) {
    list.AddRectFilled(ground.min, ground.max, is_open ? color::k_frame_active : color::k_frame_hover, ui.px(3));
  }
  if (press.focused) list.AddRect(ground.min, ground.max, color::k_accent, ui.px(3));
  view::draw_text_centered(list, ui.fonts.text, menu.area.center(), color::k_text, menu.title);
  if (opened_by_key) focus.down = 0;
  if (opened_by_key || opened_by_mouse || (was_blocked && was_pressed_last_frame(menu.area))) {
    view::open_popup(ui, menu.name);
  }
}

// "Find an action  Ctrl+P" at the right end; true when pressed. `left` becomes its left edge.
bool draw_palette_hint(Ui& ui, const Rectangle& bar, const Actions& actions, float& left) {
  left = bar.max.x - ui.px(10);
  const Action* action = actions.find(k_palette_action);
  if (action == nullptr) return false;
  constexpr std::string_view k_text = "Find an action";
  const ImFont* font = ui.fonts.small;
  const std::string chord = action->chord ? chord_text(*action->chord) : std::string();
  const float chord_width = chord.empty() ? 0 : view::text_size(font, chord).x + ui.px(10);
  const float right = left;
  left = std::floor(right - view::text_size(font, k_text).x - chord_width);
  const Rectangle area{{left - ui.px(6), bar.min.y + ui.px(2)}, {right + ui.px(6), bar.max.y - 1 - ui.px(2)}};
  const view::Press press =
      view::pressable(ui, "menu.palette", area, {action->title, action->tooltip, action->disabled_because()});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (press.hovered) list.AddRectFilled(area.min, area.max, color::k_frame_hover, ui.px(3));
  if (press.focused) list.AddRect(area.min, area.max, color::k_accent, ui.px(3));
  const ImU32 ink = press.hovered ? color::k_text : color::k_hint;
  const float top = std::floor(area.center().y - 0.5F * font->FontSize);
  view::draw_text(list, font, {left, top}, ink, k_text);
  view::draw_text_right(list, font, {right, top}, ink, chord);
  left = area.min.x;
  return press.pressed;
}

// In the middle of the bar, if it can, and between the menus and the hint in any case.
void draw_document_title(const Ui& ui, const Rectangle& bar, float left, float right, const std::string& title) {
  const float room = right - left - 2 * ui.px(12);
  if (title.empty() || room < ui.px(40)) return;
  const std::string shown = view::fitted_text(ui.fonts.text, title, room);
  const float width = view::text_size(ui.fonts.text, shown).x;
  const float x = std::clamp(bar.center().x - 0.5F * width, left + ui.px(12), right - ui.px(12) - width);
  view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text, {x, bar.center().y - 0.5F * ui.fonts.text->FontSize},
                  color::k_text_2, shown);
}

// Press on a title, drag to a row, let go: the list itself knows only whole clicks.
std::optional<std::size_t> dragged_to_row(Ui& ui, const std::vector<Menu>& menus,
                                          const std::vector<view::PopupRow>& rows) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.MouseDown[0] && !io.MouseReleased[0]) return std::nullopt;
  const bool began_on_title = std::any_of(menus.begin(), menus.end(),
                                          [&](const Menu& menu) { return menu.area.contains(io.MouseClickedPos[0]); });
  if (!began_on_title) return std::nullopt;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const view::WidgetRecord::Entry* entry = ui.widgets.find("popup." + rows[k].key);
    if (entry == nullptr || !entry->area.contains(io.MousePos)) continue;
    ui.state.popup_row = static_cast<int>(k);
    if (io.MouseReleased[0] && rows[k].reason.empty()) return k;
  }
  return std::nullopt;
}

// Draws the list of an open menu; the action that was chosen in it.
const Action* draw_menu(Ui& ui, const std::vector<Menu>& menus, const Menu& menu) {
  const std::vector<view::PopupRow> rows = menu_rows(menu);
  const bool opens = ui.state.popup_row < 0;
  const std::optional<int> chosen = view::popup_list(ui, menu.name, menu.area, rows);
  if (chosen) return menu.actions[static_cast<std::size_t>(*chosen)];
  if (opens) {  // at the first row that can be used, whatever is checked
    const auto usable = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.reason.empty(); });
    ui.state.popup_row = usable == rows.end() ? 0 : static_cast<int>(usable - rows.begin());
  }
  if (!view::popup_open(ui, menu.name)) return nullptr;
  const std::optional<std::size_t> dragged = dragged_to_row(ui, menus, rows);
  if (!dragged) return nullptr;
  ui.state.open_popup.clear();
  return menu.actions[*dragged];
}

}  // namespace

std::string draw_menu_bar(Ui& ui, const Rectangle& area, const MenuBarInput& input) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_bar);
  list.AddRectFilled({area.min.x, area.max.y - 1}, area.max, color::k_border);
  draw_sign(ui, list, {area.min.x + ui.px(16.5F), area.min.y + ui.px(12.5F)});

  const std::vector<Menu> menus = placed_menus(ui, area, input.actions);
  const std::optional<std::size_t> open = open_menu(ui, menus);
  // Enter belongs to the list, not to the title that keeps the focus above it.
  const bool activate = open && std::exchange(ui.state.focus.activate, false);
  if (open) {
    steer_open_menu(ui, menus, *open);
  } else {
    walk_titles(ui, menus);
  }
  for (const Menu& menu : menus) draw_title(ui, menu, open.has_value());
  float right = area.max.x;
  std::string chosen;
  if (draw_palette_hint(ui, area, input.actions, right)) chosen = k_palette_action;
  const float left = menus.empty() ? area.min.x + ui.px(30) : menus.back().area.max.x;
  draw_document_title(ui, area, left, right, input.title);

  if (open) ui.state.focus.activate = activate;
  if (const std::optional<std::size_t> now = open_menu(ui, menus)) {
    if (const Action* action = draw_menu(ui, menus, menus[*now])) chosen = action->name;
  }
  return chosen;
}

}  // namespace glint::gui
