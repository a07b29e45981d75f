#include "gui/input/chord.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace glint::gui {
namespace {

using namespace std::string_view_literals;

// Letters, digits and F1 to F12 follow from their codes. The first name of a key is the one that is written.
constexpr std::array k_key_names = {
    std::pair{Key::space, "Space"sv},
    std::pair{Key::apostrophe, "'"sv},
    std::pair{Key::comma, ","sv},
    std::pair{Key::minus, "-"sv},
    std::pair{Key::period, "."sv},
    std::pair{Key::slash, "/"sv},
    std::pair{Key::semicolon, ";"sv},
    std::pair{Key::equal, "+"sv},
    std::pair{Key::left_bracket, "["sv},
    std::pair{Key::backslash, "\\"sv},
    std::pair{Key::right_bracket, "]"sv},
    std::pair{Key::grave, "`"sv},
    std::pair{Key::escape, "Esc"sv},
    std::pair{Key::enter, "Enter"sv},
    std::pair{Key::tab, "Tab"sv},
    std::pair{Key::backspace, "Backspace"sv},
    std::pair{Key::insert, "Insert"sv},
    std::pair{Key::del, "Delete"sv},
    std::pair{Key::right, "Right"sv},
    std::pair{Key::left, "Left"sv},
    std::pair{Key::down, "Down"sv},
    std::pair{Key::up, "Up"sv},
    std::pair{Key::page_up, "PageUp"sv},
    std::pair{Key::page_down, "PageDown"sv},
    std::pair{Key::home, "Home"sv},
    std::pair{Key::end, "End"sv},
    std::pair{Key::keypad_minus, "KeypadMinus"sv},
    std::pair{Key::keypad_plus, "KeypadPlus"sv},
    std::pair{Key::keypad_enter, "KeypadEnter"sv},
    std::pair{Key::left_shift, "Shift"sv},
    std::pair{Key::left_ctrl, "Ctrl"sv},
    std::pair{Key::left_alt, "Alt"sv},
    std::pair{Key::left_super, "Super"sv},
    std::pair{Key::right_shift, "RightShift"sv},
    std::pair{Key::right_ctrl, "RightCtrl"sv},
    std::pair{Key::right_alt, "RightAlt"sv},
    std::pair{Key::right_super, "RightSuper"sv},
    // Other names, only read.
    std::pair{Key::comma, "Comma"sv},
    std::pair{Key::minus, "Minus"sv},
    std::pair{Key::period, "Period"sv},
    std::pair{Key::slash, "Slash"sv},
    std::pair{Key::equal, "="sv},
    std::pair{Key::equal, "Equal"sv},
    std::pair{Key::equal, "Plus"sv},
    std::pair{Key::escape, "Escape"sv},
    std::pair{Key::enter, "Return"sv},
    std::pair{Key::insert, "Ins"sv},
    std::pair{Key::del, "Del"sv},
    std::pair{Key::page_up, "PgUp"sv},
    std::pair{Key::page_down, "PgDn"sv},
    std::pair{Key::left_ctrl, "Control"sv},
};

bool is_between(Key key, Key first, Key last) {
  return key >= first && key <= last;
}

std::string key_text(Key key) {
  if (is_between(key, Key::a, Key::z) || is_between(key, Key::digit_0, Key::digit_9)) {
    return {static_cast<char>(key)};
  }
  if (is_between(key, Key::f1, Key::f12)) {
    return fmt::format("F{}", static_cast<int>(key) - static_cast<int>(Key::f1) + 1);
  }
  for (const auto& [named, name] : k_key_names) {
    if (named == key) return std::string(name);
  }
  return {};
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<Key> key_named(std::string_view text) {
  for (const auto& [key, name] : k_key_names) {
    if (same_letters(name, text)) return key;
  }
  const auto matches = [&](Key first, Key last) -> std::optional<Key> {
    for (int code = static_cast<int>(first); code <= static_cast<int>(last); ++code) {
      if (same_letters(key_text(static_cast<Key>(code)), text)) return static_cast<Key>(code);
    }
    return std::nullopt;
  };
  if (const auto letter = matches(Key::a, Key::z)) return letter;
  if (const auto digit = matches(Key::digit_0, Key::digit_9)) return digit;
  return matches(Key::f1, Key::f12);
}

// Where the chord holds the modifier of a key; null for a key that is none.
bool Chord::*modifier_of(Key key) {
  if (key == Key::left_ctrl || key == Key::right_ctrl) return &Chord::ctrl;
  if (key == Key::left_shift || key == Key::right_shift) return &Chord::shift;
  if (key == Key::left_alt || key == Key::right_alt) return &Chord::alt;
  return nullptr;
}

}  // namespace

std::string chord_text(Chord chord) {
  const std::string key = key_text(chord.key);
  if (key.empty()) return {};
  std::string text;
  if (chord.ctrl) text += "Ctrl+";
  if (chord.shift) text += "Shift+";
  if (chord.alt) text += "Alt+";
  return text + key;
}

std::optional<Chord> chord_named(std::string_view text) {
  Chord chord;
  for (std::size_t plus = text.find('+'); plus != std::string_view::npos && plus + 1 < text.size();
       plus = text.find('+')) {
    if (plus == 0) return std::nullopt;
    const std::optional<Key> key = key_named(text.substr(0, plus));
    bool Chord::*modifier = key ? modifier_of(*key) : nullptr;
    if (!modifier || chord.*modifier) return std::nullopt;
    chord.*modifier = true;
    text.remove_prefix(plus + 1);
  }
  const std::optional<Key> key = key_named(text);
  if (!key) return std::nullopt;
  chord.key = *key;
  if (bool Chord::*own = modifier_of(*key); own && chord.*own) return std::nullopt;
  return chord;
}

}  // namespace glint::gui
