#include "gui/dialogs/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/document/parameter.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace color = view::color;
using view::Rectangle;
using view::Ui;

constexpr const char* k_window = "##palette";
constexpr const char* k_entry = "palette.text";
constexpr int k_most_rows = 12;

std::string lower(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lowered;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  const std::string lowered = lower(text);
  for (std::size_t at = 0; at < lowered.size();) {
    const std::size_t begin = lowered.find_first_not_of(' ', at);
    if (begin == std::string::npos) break;
    at = std::min(lowered.find(' ', begin), lowered.size());
    words.push_back(lowered.substr(begin, at - begin));
  }
  return words;
}

bool has_all(std::string_view text, const std::vector<std::string>& words) {
  const std::string lowered = lower(text);
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return lowered.find(word) != std::string::npos; });
}

PaletteRow action_row(const Action& action) {
  return {action.name,        action.title,
          action.menu,        action.chord ? chord_text(*action.chord) : std::string(),
          action.tooltip,     action.disabled_because(),
          action.is_checked()};
}

// "surface.generator.seed" stands in "Surface generator".
std::string place_of(std::string_view path) {
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string_view::npos) return "Inspector";
  std::string place(path.substr(0, dot));
  std::replace(place.begin(), place.end(), '.', ' ');
  place[0] = static_cast<char>(place[0] >= 'a' && place[0] <= 'z' ? place[0] - 32 : place[0]);
  return place;
}

PaletteRow field_row(const Parameter& field) {
  const std::string_view label = field.short_label.empty() ? field.label : field.short_label;
  return {"field:" + std::string(field.path),
          "Go to " + std::string(label),
          place_of(field.path),
          {},
          std::string(field.help),
          {},
          false};
}

// Those that say it in their name before those that say it elsewhere.
void add_fields(std::vector<PaletteRow>& rows, const std::vector<std::string>& words) {
  std::vector<PaletteRow> others;
  for (const Parameter& field : parameters()) {
    PaletteRow row = field_row(field);
    const std::string named = row.title + " " + std::string(field.label);
    const std::string text = named + " " + std::string(field.path) + " " + std::string(field.symbol);
    if (has_all(named, words)) {
      rows.push_back(std::move(row));
    } else if (has_all(text, words)) {
      others.push_back(std::move(row));
    }
  }
  std::move(others.begin(), others.end(), std::back_inserter(rows));
}

// Everything in the palette's window, from top to bottom.
struct Layout {
  Rectangle window, entry, list, footer;
  int visible = k_most_rows;
};

// `rows` is how many there are to show.
Layout layout_for(const Ui& ui, std::size_t rows) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui.px(10);
  const float row = ui.px(view::size::k_row);
  const float footer = ui.px(44);
  const float head = margin + ui.px(28) + ui.px(8);
  const float top = ui.px(view::size::k_bar + 14);
  Layout layout;
  const float room = screen.y - top - margin - head - footer;
  constexpr int k_fewest_rows = 3;
  const int wanted = static_cast<int>(std::clamp<std::size_t>(rows, k_fewest_rows, k_most_rows));
  layout.visible = std::clamp(static_cast<int>(room / row), 1, wanted);
  const float width = std::min(ui.px(560), screen.x - 2 * margin);
  const float left = std::floor(0.5F * (screen.x - width));
  const float list_height = static_cast<float>(layout.visible) * row;
  layout.window = {{left, top}, {left + width, top + head + list_height + footer}};
  layout.entry = {{left + margin, top + margin}, {left + width - margin, top + margin + ui.px(28)}};
  layout.list = {{left + ui.px(6), top + head}, {left + width - ui.px(6), top + head + list_height}};
  layout.footer = {{left + margin, layout.list.max.y + ui.px(6)}, {left + width - margin, layout.window.max.y}};
  return layout;
}

bool key_pressed(Key key, bool repeats = false) {
  return ImGui::IsKeyPressed(static_cast<int>(key), repeats);
}

// True when the row was pressed with the mouse.
bool draw_row(Ui& ui, const PaletteRow& row, const Rectangle& area, bool highlighted, bool& mouse_is_on) {
  const std::string name = "palette." + row.key;
  const view::Explained explained{row.reason.empty() ? std::string() : row.title, {}, row.reason};
  const view::Press press = view::pressable(ui, name, area, explained);
  ui.widgets.record(name, {area, row.reason, false, false});  // the arrow keys reach it, Tab does not
  const ImGuiIO& io = ImGui::GetIO();
  mouse_is_on = press.hovered && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (highlighted) list.AddRectFilled(area.min, area.max, color::k_frame_hover, ui.px(3));
  const float middle = area.center().y;
  const float text_top = middle - 0.5F * ui.fonts.text->FontSize;
  const float small_top = middle - 0.5F * ui.fonts.small->FontSize;
  const ImU32 ink = press.enabled ? color::k_text : color::k_disabled;
  if (row.checked) {
    view::draw_icon(ui, list, view::Icon::check, {area.min.x + ui.px(13), middle},
                    press.enabled ? color::k_accent_hover : ink);
  }
  float right = area.max.x - ui.px(8);
  if (!row.shortcut.empty()) {
    view::draw_text_right(list, ui.fonts.small, {right, small_top}, color::k_hint, row.shortcut);
    right -= view::text_size(ui.fonts.small, row.shortcut).x + ui.px(16);
  }
  const float left = area.min.x + ui.px(26);
  const std::string title = view::fitted_text(ui.fonts.text, row.title, right - left);
  view::draw_text(list, ui.fonts.text, {left, text_top}, ink, title);
  const float place = left + view::text_size(ui.fonts.text, title).x + ui.px(10);
  if (place + view::text_size(ui.fonts.small, row.place).x <= right) {
    view::draw_text(list, ui.fonts.small, {place, small_top}, press.enabled ? color::k_hint : color::k_disabled,
                    row.place);
  }
  return press.pressed;
}

void draw_scroll_mark(const Ui& ui, const Rectangle& list, int first, int visible, std::size_t count) {
  if (count <= static_cast<std::size_t>(visible)) return;
  const float all = static_cast<float>(count);
  const float top = list.min.y + list.height() * static_cast<float>(first) / all;
  const float height = list.height() * static_cast<float>(visible) / all;
  const float right = list.max.x + ui.px(4);
  ImGui::GetWindowDrawList()->AddRectFilled({right - ui.px(3), top}, {right, top + height}, view::rgb(0x5A5A5A),
                                            ui.px(1));
}

// What the highlighted row does, or why it cannot be used now.
void draw_footer(const Ui& ui, const Rectangle& area, const PaletteRow& row) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float edge = area.min.y - ui.px(2);
  list.AddLine({area.min.x, edge}, {area.max.x, edge}, color::k_border_strong);
  const bool usable = row.reason.empty();
  std::vector<std::string> lines = view::wrapped_text(ui.fonts.small, usable ? row.help : row.reason, area.width());
  if (lines.size() > 2) {
    lines[1] = view::fitted_text(ui.fonts.small, lines[1] + lines[2], area.width());
    lines.resize(2);
  }
  float y = area.min.y + ui.px(2);
  for (const std::string& line : lines) {
    view::draw_text(list, ui.fonts.small, {area.min.x, y}, usable ? color::k_hint : color::k_text_2, line);
    y += ui.px(16);
  }
}

void draw_nothing_found(const Ui& ui, const Rectangle& area, const std::string& words) {
  const std::string sentence = "Nothing is called “" + words + "”. Try fewer letters.";
  view::draw_text_centered(*ImGui::GetWindowDrawList(), ui.fonts.text, {area.center().x, area.center().y},
                           color::k_hint, view::fitted_text(ui.fonts.text, sentence, area.width()));
}

}  // namespace

std::vector<PaletteRow> palette_rows(const Actions& actions, std::string_view words) {
  const std::vector<std::string> wanted = words_of(words);
  std::vector<PaletteRow> rows;
  std::vector<PaletteRow> from_afar;
  std::vector<PaletteRow> disabled;
  for (const Action* action : actions.matching(words)) {
    const bool says_so = has_all(action->title + " " + action->menu + " " + action->name, wanted);
    PaletteRow row = action_row(*action);
    (!row.reason.empty() ? disabled : says_so ? rows : from_afar).push_back(std::move(row));
  }
  add_fields(rows, wanted);
  for (std::vector<PaletteRow>* more : {&from_afar, &disabled}) {
    std::move(more->begin(), more->end(), std::back_inserter(rows));
  }
  return rows;
}

void Palette::open() {
  if (open_) return;
  open_ = opening_ = true;
  focus_tells_ = false;
  words_.clear();
  highlighted_ = first_ = 0;
}

void Palette::finish(Ui& ui) {
  open_ = opening_ = false;
  if (ui.state.editing == k_entry) {
    ui.state.editing.clear();
    ui.state.text.clear();
  }
  if (ui.state.focus.name == k_entry) ui.state.focus.name = focus_before_;
}

bool Palette::type(Ui& ui, const Rectangle& area) {
  const view::UiState& state = ui.state;
  view::entry(ui, k_entry, area, words_, {}, {}, {}, true);
  const bool changed = state.editing == k_entry && state.text != words_;
  if (changed) {
    words_ = state.text;
    highlighted_ = first_ = 0;
  }
  if (words_.empty()) {
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text,
                    {area.min.x + ui.px(12), area.center().y - 0.5F * ui.fonts.text->FontSize}, color::k_hint,
                    "Find an action or a setting");
  }
  return changed;
}

void Palette::steer(Ui& ui, const std::vector<PaletteRow>& rows, int visible) {
  view::KeyboardFocus& focus = ui.state.focus;
  const int count = static_cast<int>(rows.size());
  focus_tells_ = focus_tells_ || focus.down != 0;
  int step = focus.down;
  if (!focus_tells_) step = (key_pressed(Key::down, true) ? 1 : 0) - (key_pressed(Key::up, true) ? 1 : 0);
  focus.down = 0;
  const int pages = (key_pressed(Key::page_down, true) ? 1 : 0) - (key_pressed(Key::page_up, true) ? 1 : 0);
  const int last_first = std::max(0, count - visible);
  if (count > 0 && (step != 0 || pages != 0)) {
    // A step beyond an end comes in at the other; a page stops there.
    highlighted_ = pages != 0 ? std::clamp(highlighted_ + pages * (visible - 1), 0, count - 1)
                              : ((highlighted_ + step) % count + count) % count;
    first_ = std::clamp(first_, highlighted_ - visible + 1, highlighted_);
  }
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel != 0 && ImGui::IsWindowHovered()) first_ -= static_cast<int>(std::lround(3 * wheel));
  first_ = std::clamp(first_, 0, last_first);
  highlighted_ = std::clamp(highlighted_, 0, std::max(0, count - 1));
}

std::string Palette::draw_rows(Ui& ui, const Rectangle& area, const std::vector<PaletteRow>& rows, int visible) {
  std::string chosen;
  const float height = ui.px(view::size::k_row);
  const int end = std::min(static_cast<int>(rows.size()), first_ + visible);
  for (int k = first_; k < end; ++k) {
    const float y = area.min.y + static_cast<float>(k - first_) * height;
    const Rectangle row{{area.min.x, y}, {area.max.x, y + height}};
    bool mouse_is_on = false;
    if (draw_row(ui, rows[static_cast<std::size_t>(k)], row, k == highlighted_, mouse_is_on)) {
      chosen = rows[static_cast<std::size_t>(k)].key;
    }
    if (mouse_is_on) highlighted_ = k;
  }
  draw_scroll_mark(ui, area, first_, visible, rows.size());
  return chosen;
}

std::string Palette::draw(Ui& ui, const Actions& actions) {
  if (!open_) return {};
  view::UiState& state = ui.state;
  std::vector<PaletteRow> rows = palette_rows(actions, words_);
  const Layout layout = layout_for(ui, rows.size());
  const bool opens = std::exchange(opening_, false);
  if (opens) {
    ImGui::OpenPopup(k_window);
    focus_before_ = state.focus.name;
    view::refuse_entry(ui, k_entry, {}, {});  // begins to type
  }
  ImGui::SetNextWindowPos(layout.window.min);
  ImGui::SetNextWindowSize(layout.window.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_Border, color::k_border_strong);
  constexpr ImGuiWindowFlags k_flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                                       ImGuiWindowFlags_NoScrollWithMouse;
  const bool shown = ImGui::BeginPopup(k_window, k_flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (!shown) {
    finish(ui);
    return {};
  }
  const bool blocked = std::exchange(ui.blocked, false);
  ui.widgets.record("palette", {layout.window, {}, false, false});
  state.focus.name = k_entry;
  const bool leaves = !opens && key_pressed(Key::escape);
  // Space types a blank here, though it activates elsewhere.
  const bool entered = !opens && (key_pressed(Key::enter) || key_pressed(Key::keypad_enter) ||
                                  (state.focus.activate && !ImGui::IsKeyDown(static_cast<int>(Key::space))));
  state.focus.activate = false;
  if (type(ui, layout.entry)) rows = palette_rows(actions, words_);
  steer(ui, rows, layout.visible);
  std::string chosen = draw_rows(ui, layout.list, rows, layout.visible);
  if (rows.empty()) {
    draw_nothing_found(ui, layout.list, words_);
  } else {
    const PaletteRow& row = rows[static_cast<std::size_t>(highlighted_)];
    draw_footer(ui, layout.footer, row);
    if (entered && row.reason.empty()) chosen = row.key;
  }
  if (leaves || !chosen.empty()) {
    ImGui::CloseCurrentPopup();
    finish(ui);
  } else if (state.editing != k_entry && !ImGui::IsAnyMouseDown()) {
    view::refuse_entry(ui, k_entry, words_, {});  // a click in the window ended the typing
  }
  ui.blocked = blocked;
  ImGui::EndPopup();
  return chosen;
}

}  // namespace glint::gui
