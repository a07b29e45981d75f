#include "gui/input/chord.h"

#include <vector>

#include <gtest/gtest.h>

namespace glint::gui {
namespace {

std::vector<Key> named_keys() {
  std::vector<Key> keys;
  for (int code = 1; code < 512; ++code) {
    const Key key = static_cast<Key>(code);
    if (!chord_text({key}).empty()) keys.push_back(key);
  }
  return keys;
}

TEST(Chord, HasTheNamesThatPeopleKnow) {
  EXPECT_EQ(chord_text({Key::s, true, true}), "Ctrl+Shift+S");
  EXPECT_EQ(chord_text({Key::f1}), "F1");
  EXPECT_EQ(chord_text({Key::f12, false, false, true}), "Alt+F12");
  EXPECT_EQ(chord_text({Key::escape}), "Esc");
  EXPECT_EQ(chord_text({Key::left}), "Left");
  EXPECT_EQ(chord_text({Key::equal}), "+");
  EXPECT_EQ(chord_text({Key::equal, true}), "Ctrl++");
  EXPECT_EQ(chord_text({Key::digit_0, true}), "Ctrl+0");
  EXPECT_EQ(chord_text({Key::left_shift}), "Shift");
  EXPECT_EQ(chord_text({Key::none}), "");
}

TEST(Chord, HasTheKeyCodesOfGlfw) {
  EXPECT_EQ(static_cast<int>(Key::digit_9), 57);
  EXPECT_EQ(static_cast<int>(Key::slash), 47);
  EXPECT_EQ(static_cast<int>(Key::z), 90);
  EXPECT_EQ(static_cast<int>(Key::right_bracket), 93);
  EXPECT_EQ(static_cast<int>(Key::del), 261);
  EXPECT_EQ(static_cast<int>(Key::up), 265);
  EXPECT_EQ(static_cast<int>(Key::end), 269);
  EXPECT_EQ(static_cast<int>(Key::f12), 301);
  EXPECT_EQ(static_cast<int>(Key::keypad_enter), 335);
  EXPECT_EQ(static_cast<int>(Key::right_super), 347);
}

TEST(Chord, OfEveryKeyIsReadAsItIsWritten) {
  const std::vector<Key> keys = named_keys();
  EXPECT_EQ(keys.size(), 26U + 10U + 12U + 37U);
  for (const Key key : keys) {
    for (int modifiers = 0; modifiers < 8; ++modifiers) {
      const Chord chord{key, (modifiers & 1) != 0, (modifiers & 2) != 0, (modifiers & 4) != 0};
      const bool is_modifier = key >= Key::left_shift;
      if (is_modifier && modifiers != 0) continue;
      EXPECT_EQ(chord_named(chord_text(chord)), chord) << chord_text(chord);
    }
  }
}

TEST(Chord, IsReadInOtherSpellings) {
  EXPECT_EQ(chord_named("shift+CTRL+s"), (Chord{Key::s, true, true}));
  EXPECT_EQ(chord_named("Control+Escape"), (Chord{Key::escape, true}));
  EXPECT_EQ(chord_named("="), (Chord{Key::equal}));
  EXPECT_EQ(chord_named("Ctrl+="), (Chord{Key::equal, true}));
  EXPECT_EQ(chord_named("PgDn"), (Chord{Key::page_down}));
  EXPECT_EQ(chord_named("Ctrl+Shift"), (Chord{Key::left_shift, true}));
}

TEST(Chord, IsNothingElse) {
  for (const char* text : {"", " ", "Ctrl+", "+S", "++", "S+Ctrl", "Ctrl+Ctrl+S", "Ctrl+Ctrl", "Meta+S", "F0", "F13",
                           "Ctrl S", "ß", "Ctrl+Shift+"}) {
    EXPECT_EQ(chord_named(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace glint::gui
