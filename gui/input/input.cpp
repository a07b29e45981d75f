#include "gui/input/input.h"

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>

namespace glint::gui {
namespace {

// Whether ImGui may do something with the key before or after the characters of the same frame.
bool is_editing_key(Key key) {
  return key >= Key::escape && key < Key::left_shift;
}

bool Modifiers::*modifier_of(Key key) {
  switch (key) {
    case Key::left_ctrl:
    case Key::right_ctrl:
      return &Modifiers::ctrl;
    case Key::left_shift:
    case Key::right_shift:
      return &Modifiers::shift;
    case Key::left_alt:
    case Key::right_alt:
      return &Modifiers::alt;
    case Key::left_super:
    case Key::right_super:
      return &Modifiers::super;
    default:
      return nullptr;
  }
}

Key other_side(Key modifier_key) {
  constexpr int k_apart = static_cast<int>(Key::right_shift) - static_cast<int>(Key::left_shift);
  const int code = static_cast<int>(modifier_key);
  return static_cast<Key>(modifier_key < Key::right_shift ? code + k_apart : code - k_apart);
}

// ImGui's own field of when a button was last pressed; this far back, nothing is a double click.
constexpr double k_long_ago = -1e9;  // seconds

}  // namespace

bool InputQueue::feed(ImGuiIO& io) {
  applied_ = {};
  presses_.clear();
  repeats_.clear();
  characters_.clear();
  never_double_ = {};
  wheel_ = {0, 0};
  is_mouse_hidden_ = false;
  while (!events_.empty() && !applied_.everything_released &&
         std::visit([this](const auto& event) { return take(event); }, events_.front())) {
    events_.pop_front();
  }
  write(io);
  return !events_.empty();
}

// A click or the wheel belongs to where the mouse was.
bool InputQueue::take(const MouseMove& event) {
  if (applied_.any_button || applied_.any_wheel) return false;
  position_ = event.position;
  return true;
}

bool InputQueue::take(const MouseButton& event) {
  if (event.button < 0 || event.button >= static_cast<int>(k_buttons)) return true;
  const auto button = static_cast<std::size_t>(event.button);
  if (applied_.buttons[button] || !take_modifiers(event.modifiers)) return false;
  if (buttons_[button] == event.is_down) return true;
  buttons_[button] = event.is_down;
  never_double_[button] = event.is_down && event.never_double;
  applied_.buttons[button] = applied_.any_button = applied_.any_with_modifiers = true;
  return true;
}

bool InputQueue::take(const MouseWheel& event) {
  if (applied_.any_button) return false;
  wheel_ = {wheel_.x + event.notches.x, wheel_.y + event.notches.y};
  applied_.any_wheel = applied_.any_with_modifiers = true;
  return true;
}

bool InputQueue::take(const KeyChange& event) {
  const int code = static_cast<int>(event.key);
  if (code <= 0 || code >= static_cast<int>(k_keys)) return true;
  bool& key = keys_[static_cast<std::size_t>(code)];
  const bool is_repeated = key && event.is_down;
  const bool is_changed = key != event.is_down;
  if (is_changed && std::find(applied_.keys.begin(), applied_.keys.end(), event.key) != applied_.keys.end()) {
    return false;
  }
  // What a click activates gets the key in the next frame; ImGui reads characters before keys, whatever came first.
  if (applied_.any_button || (is_editing_key(event.key) && applied_.any_character)) return false;
  Modifiers modifiers = event.modifiers;
  bool Modifiers::*own = modifier_of(event.key);
  if (own) modifiers.*own = event.is_down || is_down(other_side(event.key));
  if (!take_modifiers(modifiers)) return false;
  key = event.is_down;
  if (!is_changed && !is_repeated) return true;
  if (own) modifiers.*own = false;
  const Chord chord{event.key, modifiers.ctrl, modifiers.shift, modifiers.alt};
  if (event.is_down && !modifiers_.super) (is_repeated ? repeats_ : presses_).push_back(chord);
  if (is_changed) applied_.keys.push_back(event.key);
  if (!own) applied_.any_with_modifiers = true;
  if (is_editing_key(event.key)) applied_.any_editing_key = true;
  return true;
}

bool InputQueue::take(const Character& event) {
  if (applied_.any_button || applied_.any_editing_key) return false;
  characters_.push_back(event.code);
  applied_.any_character = applied_.any_with_modifiers = true;
  return true;
}

bool InputQueue::take(const FocusLost& /*event*/) {
  if (applied_.any_button || applied_.any_character || !applied_.keys.empty()) return false;
  is_mouse_hidden_ = std::find(buttons_.begin(), buttons_.end(), true) != buttons_.end();
  buttons_ = {};
  keys_ = {};
  modifiers_ = {};
  applied_.everything_released = true;
  return true;
}

bool InputQueue::take(const FileDrop& event) {
  drops_.insert(drops_.end(), event.files.begin(), event.files.end());
  return true;
}

// One frame has one state of the modifiers; once something happened under it, another has to wait.
bool InputQueue::take_modifiers(const Modifiers& modifiers) {
  if (applied_.any_with_modifiers && modifiers != modifiers_) return false;
  modifiers_ = modifiers;
  return true;
}

void InputQueue::write(ImGuiIO& io) const {
  static_assert(std::tuple_size_v<decltype(keys_)> == std::extent_v<decltype(io.KeysDown)>);
  io.MousePos = is_mouse_hidden_ ? ImVec2(-FLT_MAX, -FLT_MAX) : position_;
  for (std::size_t button = 0; button < k_buttons; ++button) {
    io.MouseDown[button] = buttons_[button];
    if (never_double_[button]) io.MouseClickedTime[button] = k_long_ago;
  }
  io.MouseWheel = wheel_.y;
  io.MouseWheelH = wheel_.x;
  std::copy(keys_.begin(), keys_.end(), std::begin(io.KeysDown));
  io.KeyCtrl = modifiers_.ctrl;
  io.KeyShift = modifiers_.shift;
  io.KeyAlt = modifiers_.alt;
  io.KeySuper = modifiers_.super;
  for (const char32_t character : characters_) io.AddInputCharacter(character);
}

bool InputQueue::is_down(Key key) const {
  const int code = static_cast<int>(key);
  return code > 0 && code < static_cast<int>(k_keys) && keys_[static_cast<std::size_t>(code)];
}

std::vector<std::filesystem::path> InputQueue::take_drops() {
  return std::exchange(drops_, {});
}

void InputQueue::clear() {
  events_.clear();
  events_.emplace_back(FocusLost{});
}

void setup_key_map(ImGuiIO& io) {
  static constexpr std::pair<ImGuiKey, Key> k_map[] = {
      {ImGuiKey_Tab, Key::tab},
      {ImGuiKey_LeftArrow, Key::left},
      {ImGuiKey_RightArrow, Key::right},
      {ImGuiKey_UpArrow, Key::up},
      {ImGuiKey_DownArrow, Key::down},
      {ImGuiKey_PageUp, Key::page_up},
      {ImGuiKey_PageDown, Key::page_down},
      {ImGuiKey_Home, Key::home},
      {ImGuiKey_End, Key::end},
      {ImGuiKey_Insert, Key::insert},
      {ImGuiKey_Delete, Key::del},
      {ImGuiKey_Backspace, Key::backspace},
      {ImGuiKey_Space, Key::space},
      {ImGuiKey_Enter, Key::enter},
      {ImGuiKey_Escape, Key::escape},
      {ImGuiKey_KeyPadEnter, Key::keypad_enter},
      {ImGuiKey_A, Key::a},
      {ImGuiKey_C, Key::c},
      {ImGuiKey_V, Key::v},
      {ImGuiKey_X, Key::x},
      {ImGuiKey_Y, Key::y},
      {ImGuiKey_Z, Key::z},
  };
  static_assert(std::size(k_map) == ImGuiKey_COUNT);
  for (const auto& [imgui_key, key] : k_map) io.KeyMap[imgui_key] = static_cast<int>(key);
}

}  // namespace glint::gui
