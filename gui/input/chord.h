#pragma once
// Keys and chords ("Ctrl+Shift+S"), and how they are written in menus, the list of shortcuts and scripts. Pure values;
// any thread.

#include <optional>
#include <string>
#include <string_view>

namespace glint::gui {

/// A key. The values are GLFW's key codes (GLFW_KEY_*: ASCII of the US layout for what types a character, from 256 on
/// for the rest), so that any code of a GLFW callback may be cast to it; those named here have a name in chords.
enum class Key : int {
  none = 0,  ///< no key of GLFW has this code
  space = 32,
  apostrophe = 39,
  comma = 44,
  minus,
  period,
  slash,
  digit_0 = 48,
  digit_1,
  digit_2,
  digit_3,
  digit_4,
  digit_5,
  digit_6,
  digit_7,
  digit_8,
  digit_9,
  semicolon = 59,
  equal = 61,  ///< written "+", what people read on it: zooming in is Ctrl and this key
  a = 65,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,
  left_bracket = 91,
  backslash,
  right_bracket,
  grave = 96,
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  page_up,
  page_down,
  home,
  end,
  f1 = 290,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
  keypad_minus = 333,
  keypad_plus,
  keypad_enter,
  left_shift = 340,
  left_ctrl,
  left_alt,
  left_super,
  right_shift,
  right_ctrl,
  right_alt,
  right_super,
};

/// A key with the modifiers that are held with it. A modifier key alone is a chord without its own modifier.
struct Chord {
  Key key = Key::none;
  bool ctrl = false;
  bool shift = false;
  bool alt = false;

  friend bool operator==(const Chord&, const Chord&) = default;
};

/// "Ctrl+Shift+S", "F1", "Esc", "Left", "+". Empty for a key without a name.
std::string chord_text(Chord chord);

/// The chord of that text, modifiers in any order, upper or lower case; also the usual other names ("Escape", "Del",
/// "PgUp", "=", "Control+S"). Nothing for what is no chord.
std::optional<Chord> chord_named(std::string_view text);

}  // namespace glint::gui
