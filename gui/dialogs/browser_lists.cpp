#include "gui/dialogs/browser_lists.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gui/dialogs/dialog_frame.h"
#include "gui/input/chord.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

using view::Rectangle;
using view::Ui;
namespace color = view::color;
namespace size = view::size;

struct Columns {
  float name = 0;        // left ends, from the left of the list
  float size_right = 0;  // right ends
  float date_right = 0;
  float name_width = 0;
  bool with_time = false;
};

Columns columns_of(const Ui& ui, float width) {
  Columns columns;
  columns.with_time = width >= ui.px(470);
  columns.date_right = width - ui.px(14);
  columns.size_right = columns.date_right - ui.px(columns.with_time ? 132 : 88);
  columns.name = ui.px(30);
  columns.name_width = columns.size_right - ui.px(62) - columns.name;
  return columns;
}

bool has_keyboard(const Ui& ui, std::string_view list) {
  return ui.state.focus.name == list && ui.state.editing.empty() && ui.state.open_popup.empty();
}

// Every second of several quick clicks: a double click that enters a folder may be followed by another at once.
bool double_clicked() {
  return ImGui::IsMouseClicked(0) && ImGui::GetMouseClickedCount(0) % 2 == 0;
}

bool take_activation(Ui& ui) {
  const bool activate = ui.state.focus.activate;
  ui.state.focus.activate = false;
  return activate;
}

std::string utf8_of(unsigned code) {
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | (code >> 6U)), static_cast<char>(0x80U | (code & 0x3FU))};
  return {static_cast<char>(0xE0U | (code >> 12U)), static_cast<char>(0x80U | ((code >> 6U) & 0x3FU)),
          static_cast<char>(0x80U | (code & 0x3FU))};
}

bool begins_with(std::string_view name, std::string_view letter) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return name.size() >= letter.size() &&
         std::equal(letter.begin(), letter.end(), name.begin(), [&](char a, char b) { return small(a) == small(b); });
}

// The next row whose name begins with what was typed in this frame, after the selected one and then from the top.
std::optional<int> row_of_typed_letter(const FolderListing& listing, int selected) {
  const auto& typed = ImGui::GetIO().InputQueueCharacters;
  if (typed.empty() || typed.back() <= ' ' || ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyAlt) return std::nullopt;
  const std::string letter = utf8_of(typed.back());
  const int count = static_cast<int>(listing.entries.size());
  for (int step = 1; step <= count; ++step) {
    const int row = (std::max(selected, -1) + step) % count;
    if (begins_with(listing.entries[static_cast<std::size_t>(row)].name, letter)) return row;
  }
  return std::nullopt;
}

void ground_of_row(const Ui& ui, const Rectangle& row, ImU32 marked_ground, bool marked, bool hovered) {
  if (!marked && !hovered) return;
  const ImU32 ground = marked ? marked_ground : color::k_frame_hover;
  ImGui::GetWindowDrawList()->AddRectFilled(row.min, row.max, ground, ui.px(3));
}

// A row of a list is reached by the arrow keys, not by Tab; a click leaves the focus with the list.
view::Press row_press(Ui& ui, std::string_view list, const std::string& name, const Rectangle& area,
                      const view::Explained& explained) {
  const view::Press press = view::pressable(ui, name, area, explained);
  ui.widgets.record(name, {area, explained.reason, false, false});
  if (press.hovered && ImGui::IsMouseClicked(0)) ui.state.focus.name = list;
  if (press.pressed) ui.state.focus.name = list;
  return press;
}

void reveal(float top, float height, float page) {
  const float scroll = ImGui::GetScrollY();
  if (top < scroll) ImGui::SetScrollY(top);
  if (top + height > scroll + page) ImGui::SetScrollY(top + height - page);
}

// One row of the folder; its events.
void draw_file(Ui& ui, const ListedFile& file, int index, const Rectangle& area, ListState& state, ListEvents& events) {
  const Columns columns = columns_of(ui, area.width());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string shown = view::fitted_text(ui.fonts.text, file.name, columns.name_width);
  const view::Explained explained{shown == file.name ? std::string() : file.name, {}, {}};
  const view::Press press = row_press(ui, "browser.list", "browser.row." + file.name, area, explained);
  if (press.pressed) {
    events.selected = events.selected || state.selected != index;
    state.selected = index;
  }
  if (press.hovered && double_clicked() && state.selected == index) events.opened = true;
  ground_of_row(ui, area, color::k_accent_ground, state.selected == index, press.hovered);
  const float middle = area.center().y;
  const bool is_picture = !file.is_folder && file.path.extension() != ".json";
  const view::Icon icon = file.is_folder ? view::Icon::folder : is_picture ? view::Icon::picture : view::Icon::file;
  view::draw_icon(ui, list, icon, {area.min.x + ui.px(16), middle}, color::k_text_2);
  view::draw_text(list, ui.fonts.text, {area.min.x + columns.name, middle - 0.5F * ui.fonts.text->FontSize},
                  color::k_text, shown);
  const float top = middle - 0.5F * ui.fonts.small->FontSize;
  view::draw_text_right(list, ui.fonts.small, {area.min.x + columns.size_right, top}, color::k_text_2, file.size);
  const std::size_t letters = columns.with_time ? file.date.size() : std::min<std::size_t>(10, file.date.size());
  view::draw_text_right(list, ui.fonts.small, {area.min.x + columns.date_right, top}, color::k_text_2,
                        std::string_view(file.date).substr(0, letters));
}

void draw_captions(const Ui& ui, const Rectangle& bar) {
  const Columns columns = columns_of(ui, bar.width());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = bar.center().y - 0.5F * ui.fonts.small->FontSize;
  view::draw_text(list, ui.fonts.small, {bar.min.x + columns.name, top}, color::k_hint, "Name");
  view::draw_text_right(list, ui.fonts.small, {bar.min.x + columns.size_right, top}, color::k_hint, "Size");
  view::draw_text_right(list, ui.fonts.small, {bar.min.x + columns.date_right, top}, color::k_hint, "Changed");
}

void keys_of_files(Ui& ui, const FolderListing& listing, int page, ListState& state, ListEvents& events) {
  if (!has_keyboard(ui, "browser.list")) return;
  if (ImGui::IsKeyPressed(static_cast<int>(Key::backspace))) events.parent = true;
  const int count = static_cast<int>(listing.entries.size());
  std::optional<int> row = moved_row(ui, state.selected, count, page);
  if (!row) row = row_of_typed_letter(listing, state.selected);
  if (row) {
    state.selected = *row;
    state.reveal = true;
    events.selected = true;
  }
  if (state.selected >= 0 && take_activation(ui)) events.opened = true;
}

// The frame of a list, recorded as a stop of the Tab key; true where a click went to its empty part.
void begin_list(Ui& ui, const char* name, const Rectangle& area, const Rectangle& rows) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_window, ui.px(3));
  ui.widgets.record(name, {area, {}, true, false});
  ImGui::SetCursorScreenPos(rows.min);
  ImGui::BeginChild((std::string("##") + name).c_str(), rows.size(), false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
  if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) ui.state.focus.name = name;
}

void end_list(Ui& ui, const char* name, const Rectangle& area) {
  ImGui::EndChild();
  const bool focused = has_keyboard(ui, name);
  ImGui::GetWindowDrawList()->AddRect(area.min, area.max, focused ? color::k_accent : color::k_border, ui.px(3));
}

float height_of(const Ui& ui, const PlaceRow& row) {
  return ui.px(row.is_heading ? 26 : row.detail.empty() ? size::k_row : 38);
}

void draw_place(Ui& ui, const PlaceRow& row, int index, const Rectangle& area, ListState& state, ListEvents& events) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row.is_heading) {
    view::draw_text(list, ui.fonts.small, {area.min.x + ui.px(8), area.max.y - ui.px(4) - ui.fonts.small->FontSize},
                    color::k_hint, row.label);
    return;
  }
  const float room = area.width() - ui.px(30 + 8);
  const view::Explained explained{row.label, row.detail, row.reason};
  const view::Press press = row_press(ui, "browser.places", "browser." + row.key, area, explained);
  if (press.pressed) {
    state.selected = index;
    events.selected = true;
  }
  if (press.hovered && press.enabled && double_clicked()) events.opened = true;
  const bool focused = has_keyboard(ui, "browser.places") && state.selected == index;
  ground_of_row(ui, area, color::k_frame, row.is_current, press.hovered && press.enabled);
  if (focused) list.AddRect(area.min, area.max, color::k_accent, ui.px(3));
  const ImU32 ink = press.enabled ? color::k_text : color::k_disabled;
  const float first = area.min.y + ui.px(12);
  view::draw_icon(ui, list, row.icon, {area.min.x + ui.px(15), first}, press.enabled ? color::k_text_2 : ink);
  view::draw_text(list, ui.fonts.text, {area.min.x + ui.px(30), first - 0.5F * ui.fonts.text->FontSize}, ink,
                  view::fitted_text(ui.fonts.text, row.label, room));
  if (row.detail.empty()) return;
  view::draw_text(list, ui.fonts.small, {area.min.x + ui.px(30), area.min.y + ui.px(20)},
                  press.enabled ? color::k_hint : color::k_disabled,
                  row.reason.empty() ? fitted_path(ui.fonts.small, row.detail, room)
                                     : view::fitted_text(ui.fonts.small, row.reason, room));
}

// Over headings and places that are missing.
void keys_of_places(Ui& ui, const std::vector<PlaceRow>& rows, ListState& state, ListEvents& events) {
  if (!has_keyboard(ui, "browser.places")) return;
  std::vector<int> able;
  for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
    const PlaceRow& row = rows[static_cast<std::size_t>(k)];
    if (!row.is_heading && row.reason.empty()) able.push_back(k);
  }
  const auto at = std::ranges::find(able, state.selected);
  const int selected = at == able.end() ? -1 : static_cast<int>(at - able.begin());
  if (const std::optional<int> moved = moved_row(ui, selected, static_cast<int>(able.size()), 8)) {
    state.selected = able[static_cast<std::size_t>(*moved)];
    state.reveal = true;
  }
  if (selected >= 0 && take_activation(ui)) events.selected = true;
}

}  // namespace

ListEvents draw_file_list(Ui& ui, const Rectangle& area, const FolderListing& listing, std::string_view empty_text,
                          ListState& state) {
  ListEvents events;
  const float pitch = ui.px(size::k_row);
  const Rectangle bar{area.min, {area.max.x, area.min.y + ui.px(22)}};
  const Rectangle rows{{area.min.x + 1, bar.max.y + 1}, {area.max.x - 1, area.max.y - 1}};
  const int count = static_cast<int>(listing.entries.size());
  keys_of_files(ui, listing, std::max(1, static_cast<int>(rows.height() / pitch) - 1), state, events);
  begin_list(ui, "browser.list", area, rows);
  if (state.reveal && state.selected >= 0) {
    reveal(static_cast<float>(state.selected) * pitch, pitch, rows.height());
    state.reveal = false;
  }
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float scroll = ImGui::GetScrollY();
  const int first = std::max(0, static_cast<int>(scroll / pitch));
  const int last = std::min(count, static_cast<int>((scroll + rows.height()) / pitch) + 1);
  for (int k = first; k < last; ++k) {
    const float y = origin.y + static_cast<float>(k) * pitch;
    draw_file(ui, listing.entries[static_cast<std::size_t>(k)], k,
              {{rows.min.x + ui.px(2), y}, {rows.max.x - ui.px(10), y + pitch}}, state, events);
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({1, static_cast<float>(count) * pitch});
  if (count == 0) {
    const float width = rows.width() - 2 * ui.px(20);
    const float text = std::min(width, view::text_size(ui.fonts.small, empty_text).x);
    draw_sentences(ui, {rows.center().x - 0.5F * text, rows.min.y + 0.4F * rows.height()}, width, color::k_hint,
                   empty_text);
  }
  end_list(ui, "browser.list", area);
  ImGui::GetWindowDrawList()->AddLine({area.min.x + 1, bar.max.y}, {area.max.x - 1, bar.max.y}, color::k_border);
  draw_captions(ui, {{rows.min.x + ui.px(2), bar.min.y}, {rows.max.x - ui.px(10), bar.max.y}});
  return events;
}

ListEvents draw_places(Ui& ui, const Rectangle& area, const std::vector<PlaceRow>& rows, ListState& state) {
  ListEvents events;
  keys_of_places(ui, rows, state, events);
  const Rectangle inside{{area.min.x + 1, area.min.y + 1}, {area.max.x - 1, area.max.y - 1}};
  begin_list(ui, "browser.places", area, inside);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float y = origin.y;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const float height = height_of(ui, rows[k]);
    const int index = static_cast<int>(k);
    if (state.reveal && state.selected == index) {
      reveal(y - origin.y, height, inside.height());
      state.reveal = false;
    }
    draw_place(ui, rows[k], index, {{inside.min.x + ui.px(2), y}, {inside.max.x - ui.px(10), y + height}}, state,
               events);
    y += height;
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({1, y - origin.y});
  end_list(ui, "browser.places", area);
  return events;
}

}  // namespace glint::gui
