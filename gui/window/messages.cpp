#include "gui/window/messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/document/parameter.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace color = view::color;
using view::Rectangle;
using view::text_size;
using view::Ui;

constexpr std::size_t k_most_strips = 3;
constexpr std::size_t k_most_lines = 2;
constexpr float k_action_width = 144;  // room an action's button may take, known without its title

std::string capitalised(std::string_view text) {
  std::string changed(text);
  if (!changed.empty() && changed[0] >= 'a' && changed[0] <= 'z') changed[0] = static_cast<char>(changed[0] - 32);
  return changed;
}

struct Look {
  ImU32 ground, edge, text, icon, button;
};

Look look_of(Message::Kind kind) {
  if (kind == Message::Kind::error) {
    return {color::k_error_ground, color::k_error_edge, color::k_error_text, color::k_error_icon, view::rgb(0x8C5650)};
  }
  return {color::k_frame, color::k_text_2, color::k_text, color::k_text_2, view::rgb(0x5A5A5A)};
}

std::string count_text(int count) {
  if (count < 2) return {};
  return count == 2 ? "twice" : fmt::format("{} times", count);
}

// What stands small before the buttons: "2 of 5", "twice", or both.
std::string note_of(const Messages::Posted& posted, std::size_t index, std::size_t total) {
  std::string note = count_text(posted.count);
  if (total <= k_most_strips) return note;
  if (!note.empty()) note += ", ";
  return note + fmt::format("{} of {}", index + 1, total);
}

float strip_width(const Ui& ui, float window_width) {
  return window_width - 2 * ui.px(view::size::k_gap);
}

float text_left(const Ui& ui) {
  return ui.px(36);
}

bool has_close_all(std::size_t index, std::size_t total) {
  return index == 0 && total > k_most_strips;
}

// Room of the words in a strip.
float text_room(const Ui& ui, float width, const Messages::Posted& posted, std::size_t index, std::size_t total) {
  const float gap = ui.px(8);
  float room = width - text_left(ui) - ui.px(34) - view::button_width(ui, "Copy") - ui.px(14);
  room -= static_cast<float>(posted.message.action_names.size()) * (ui.px(k_action_width) + gap);
  if (has_close_all(index, total)) room -= view::button_width(ui, "Close all") + gap;
  const std::string note = note_of(posted, index, total);
  if (!note.empty()) room -= text_size(ui.fonts.small, note).x + ui.px(12);
  return std::max(room, ui.px(120));
}

struct Lines {
  std::vector<std::string> lines;
  bool complete = true;
};

// At most two lines; what finds no room is left out from a word on, never within one.
Lines lines_for(const ImFont* font, const std::string& text, float room) {
  Lines shown{view::wrapped_text(font, text, room), true};
  if (shown.lines.size() <= k_most_lines) return shown;
  shown.complete = false;
  shown.lines.resize(k_most_lines);
  std::string& last = shown.lines.back();
  while (!last.empty() && (last.back() == ' ' || text_size(font, last + " …").x > room)) {
    const std::size_t blank = last.find_last_of(' ');
    last.resize(blank == std::string::npos ? 0 : blank);
  }
  last += last.empty() ? "…" : " …";
  return shown;
}

float line_pitch(const Ui& ui) {
  return ui.px(18);
}

float strip_height(const Ui& ui, float window_width, const Messages::Posted& posted, std::size_t index,
                   std::size_t total) {
  const float room = text_room(ui, strip_width(ui, window_width), posted, index, total);
  const std::size_t lines = lines_for(ui.fonts.text, posted.message.text, room).lines.size();
  return ui.px(view::size::k_message) + static_cast<float>(std::max<std::size_t>(lines, 1) - 1) * line_pitch(ui);
}

void draw_icon_of(const Ui& ui, ImDrawList& list, Message::Kind kind, ImVec2 center, ImU32 ink) {
  if (kind != Message::Kind::info) {
    view::draw_icon(ui, list, view::Icon::warning, center, ink);
    return;
  }
  list.AddCircle(center, ui.px(6.5F), ink, 24, std::max(1.0F, 1.3F * ui.scale));
  const float half = std::max(0.5F, 0.75F * ui.scale);
  list.AddRectFilled({center.x - half, center.y - 1 * ui.scale}, {center.x + half, center.y + 3.5F * ui.scale}, ink);
  list.AddRectFilled({center.x - half, center.y - 3.5F * ui.scale}, {center.x + half, center.y - 2 * ui.scale}, ink);
}

// A button on the ground of a strip: an outline in its colours.
bool strip_button(Ui& ui, const std::string& name, const Rectangle& area, const std::string& text, const Look& look,
                  const view::Explained& explained) {
  const view::Press press = view::pressable(ui, name, area, explained);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (press.enabled && press.hovered) {
    list.AddRectFilled(area.min, area.max, view::rgb(0xFFFFFF, press.held ? 40 : 22), ui.px(3));
  }
  list.AddRect(area.min, area.max, press.focused ? color::k_accent : look.button, ui.px(3));
  const ImU32 ink = press.enabled ? look.text : color::k_disabled;
  view::draw_text_centered(list, ui.fonts.text, area.center(), ink,
                           view::fitted_text(ui.fonts.text, text, area.width() - ui.px(8)));
  return press.pressed;
}

bool close_button(Ui& ui, const std::string& name, ImVec2 center, const Look& look) {
  const float half = ui.px(10);
  const Rectangle area{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
  const view::Press press = view::pressable(ui, name, area, {"Close this message", {}, {}});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (press.hovered) list.AddRectFilled(area.min, area.max, view::rgb(0xFFFFFF, 22), ui.px(3));
  if (press.focused) list.AddRect(area.min, area.max, color::k_accent, ui.px(3));
  view::draw_icon(ui, list, view::Icon::close, center, look.text);
  return press.pressed;
}

// A person reads a real minus; a copy has the one of ASCII.
std::string copied(std::string text) {
  constexpr std::string_view k_minus = "−";
  for (std::size_t at = text.find(k_minus); at != std::string::npos; at = text.find(k_minus, at)) {
    text.replace(at, k_minus.size(), "-");
  }
  return text;
}

struct StripEvents {
  std::string action;
  bool close = false;
  bool close_all = false;
};

void draw_frame(const Ui& ui, const Rectangle& strip, Message::Kind kind, const Look& look) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(3);
  list.AddRectFilled(strip.min, strip.max, look.ground, rounding);
  list.AddRectFilled(strip.min, {strip.min.x + ui.px(4), strip.max.y}, look.edge, rounding,
                     ImDrawFlags_RoundCornersLeft);
  const ImU32 outline = kind == Message::Kind::error ? look.edge : color::k_border_strong;
  list.AddRect(strip.min, strip.max, outline, rounding);
}

void draw_words(Ui& ui, const std::string& name, const Rectangle& strip, const std::string& text, float room,
                const Look& look) {
  const Lines shown = lines_for(ui.fonts.text, text, room);
  const float left = strip.min.x + text_left(ui);
  const float height = static_cast<float>(shown.lines.size()) * line_pitch(ui);
  float y = strip.center().y - 0.5F * height + 0.5F * (line_pitch(ui) - ui.fonts.text->FontSize);
  for (const std::string& line : shown.lines) {
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text, {left, y}, look.text, line);
    y += line_pitch(ui);
  }
  const Rectangle words{{left, strip.min.y}, {left + room, strip.max.y}};
  ui.widgets.record(name, {words, {}, false, false});
  if (!shown.complete) view::explain(ui, name, words, {{}, text, {}});
}

StripEvents draw_strip(Ui& ui, const Rectangle& strip, const Messages::Posted& posted, std::size_t index,
                       std::size_t total, const Actions& actions) {
  const Message& message = posted.message;
  const Look look = look_of(message.kind);
  const std::string name = fmt::format("message.{}", index);
  StripEvents events;
  draw_frame(ui, strip, message.kind, look);
  ui.widgets.record(name, {strip, {}, false, false});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = strip.min.y + ui.px(0.5F * view::size::k_message);
  draw_icon_of(ui, list, message.kind, {strip.min.x + ui.px(19), middle}, look.icon);
  draw_words(ui, name + ".text", strip, message.text, text_room(ui, strip.width(), posted, index, total), look);

  // Placed from the right, drawn (and reached by Tab) from the left.
  struct Placed {
    std::string name, text;
    view::Explained explained;
    float width;
  };
  std::vector<Placed> buttons;
  for (const std::string& action_name : message.action_names) {
    const Action* action = actions.find(action_name);
    if (action == nullptr) continue;
    buttons.push_back({fmt::format("{}.{}", name, action_name),
                       action->title,
                       {action->title, action->tooltip, action->disabled_because()},
                       std::min(view::button_width(ui, action->title), ui.px(k_action_width))});
  }
  const std::size_t action_count = buttons.size();
  buttons.push_back(
      {name + ".copy", "Copy", {"Copy", "Copies the whole message.", {}}, view::button_width(ui, "Copy")});
  if (has_close_all(index, total)) {
    buttons.push_back({"message.close_all",
                       "Close all",
                       {"Close all", fmt::format("Closes all {} messages.", total), {}},
                       view::button_width(ui, "Close all")});
  }
  float x = strip.max.x - ui.px(34);
  for (const Placed& button : buttons) x -= button.width;
  x -= static_cast<float>(buttons.size() - 1) * ui.px(8);
  if (const std::string note = note_of(posted, index, total); !note.empty()) {
    view::draw_text_right(list, ui.fonts.small, {x - ui.px(12), middle - 0.5F * ui.fonts.small->FontSize}, look.text,
                          note);
  }
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    const Placed& button = buttons[k];
    const Rectangle area{{x, middle - ui.px(11)}, {x + button.width, middle + ui.px(11)}};
    x += button.width + ui.px(8);
    if (!strip_button(ui, button.name, area, button.text, look, button.explained)) continue;
    if (k < action_count) events.action = button.name.substr(name.size() + 1);
    if (k == action_count) ImGui::SetClipboardText(copied(message.text).c_str());
    if (k > action_count) events.close_all = true;
  }
  events.close = close_button(ui, name + ".close", {strip.max.x - ui.px(16), middle}, look);
  return events;
}

}  // namespace

std::string error_text(const Error& error) {
  std::string text = capitalised(error.sentence);
  if (!error.subject.empty()) {
    const Parameter* field = find_parameter(error.subject);
    const std::string subject = field == nullptr ? error.subject : capitalised(field->label);
    constexpr std::array<std::string_view, 8> k_verbs{"is ",  "cannot ", "lies ",  "has ",
                                                      "was ", "does ",   "needs ", "holds "};
    const bool goes_on = std::any_of(k_verbs.begin(), k_verbs.end(),
                                     [&](std::string_view verb) { return error.sentence.starts_with(verb); });
    text = goes_on ? subject + " " + error.sentence : subject + ": " + text;
  }
  if (!text.empty() && std::string_view(".!?").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

void Messages::post(Message message) {
  const auto same = std::find_if(posted_.begin(), posted_.end(), [&](const Posted& posted) {
    return posted.message.kind == message.kind && posted.message.text == message.text;
  });
  Posted newest{std::move(message), 1};
  if (same != posted_.end()) {
    newest.count = same->count + 1;
    posted_.erase(same);
  }
  posted_.push_front(std::move(newest));
}

void Messages::post_error(const Error& error, std::vector<std::string> action_names) {
  post({Message::Kind::error, error_text(error), std::move(action_names)});
}

void Messages::dismiss(std::size_t index) {
  if (index < posted_.size()) posted_.erase(posted_.begin() + static_cast<std::ptrdiff_t>(index));
}

float Messages::height(const Ui& ui, float width) const {
  float height = 0;
  for (std::size_t k = 0; k < std::min(posted_.size(), k_most_strips); ++k) {
    height += ui.px(view::size::k_gap) + strip_height(ui, width, posted_[k], k, posted_.size());
  }
  return height;
}

std::string Messages::draw(Ui& ui, const Rectangle& area, const Actions& actions) {
  const float gap = ui.px(view::size::k_gap);
  const std::size_t total = posted_.size();
  std::string chosen;
  std::optional<std::size_t> closed;
  bool close_all = false;
  float y = area.min.y;
  for (std::size_t k = 0; k < std::min(total, k_most_strips); ++k) {
    const float height = strip_height(ui, area.width(), posted_[k], k, total);
    const Rectangle strip{{area.min.x + gap, y + gap}, {area.max.x - gap, y + gap + height}};
    StripEvents events = draw_strip(ui, strip, posted_[k], k, total, actions);
    if (!events.action.empty()) chosen = std::move(events.action);
    if (events.close) closed = k;
    close_all = close_all || events.close_all;
    y = strip.max.y;
  }
  if (closed) dismiss(*closed);
  if (close_all) dismiss_all();
  return chosen;
}

}  // namespace glint::gui
