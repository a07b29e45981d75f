// Palette and sheet of shortcuts as a person meets them.

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/gui/shell_stage.h"

namespace glint::gui {
namespace {

using PaletteDialog = ShellStage;
using Sheet = ShellStage;

TEST_F(PaletteDialog, RunsWhatIsTyped) {
  stage.state().focus.name = "combo";
  palette.open();
  frame();
  frame();
  type("redo");
  EXPECT_TRUE(has("palette.edit.redo"));
  EXPECT_FALSE(has("palette.file.open"));
  press(Key::enter);
  EXPECT_EQ(chosen, "edit.redo");
  EXPECT_FALSE(palette.is_open());
  EXPECT_EQ(stage.state().editing, "");
  EXPECT_EQ(stage.state().focus.name, "combo");
}

TEST_F(PaletteDialog, TypesBlanks) {
  palette.open();
  frame();
  frame();
  type("slope");
  stage.io().KeysDown[32] = true;
  stage.state().focus.activate = true;  // what Space means elsewhere
  type(" ");
  stage.io().KeysDown[32] = false;
  type("colours");
  EXPECT_TRUE(palette.is_open());
  EXPECT_EQ(chosen, "");
  EXPECT_EQ(stage.state().text, "slope colours");
  EXPECT_TRUE(has("palette.view.slope"));
}

TEST_F(PaletteDialog, IsWalkedWithTheArrows) {
  palette.open();
  frame();
  frame();
  step(0, 1);
  step(0, 1);
  step(0, -1);
  press(Key::enter);
  EXPECT_EQ(chosen, "file.quit");
}

TEST_F(PaletteDialog, IsWalkedWithTheKeysThemselvesWhereNobodyTellsTheFocus) {
  palette.open();
  frame();
  frame();
  press(Key::down);
  press(Key::down);
  press(Key::enter);
  EXPECT_EQ(chosen, "edit.undo");
}

TEST_F(PaletteDialog, ScrollsWithItsHighlight) {
  palette.open();
  frame();
  frame();
  EXPECT_TRUE(has("palette.file.open"));
  EXPECT_FALSE(has("palette.file.reload"));
  step(0, -1);  // round to the last
  EXPECT_FALSE(has("palette.file.open"));
  EXPECT_TRUE(has("palette.file.reload"));
  press(Key::enter);
  EXPECT_EQ(chosen, "") << "it is disabled";
  EXPECT_TRUE(palette.is_open());
}

TEST_F(PaletteDialog, RunsWhatIsClickedAndGoesOnTypingAfterAClickOnNothing) {
  palette.open();
  frame();
  frame();
  type("map again");
  click("palette.file.reload");
  EXPECT_TRUE(palette.is_open());
  frame();
  EXPECT_EQ(stage.state().editing, "palette.text");
  EXPECT_EQ(stage.state().text, "map again");
  type("rough");  // in place of what was selected
  click("palette.field:intrinsic_roughness");
  EXPECT_EQ(chosen, "field:intrinsic_roughness");
  EXPECT_FALSE(palette.is_open());
}

TEST_F(PaletteDialog, WaitsForASlowClick) {
  palette.open();
  frame();
  frame();
  move_to("palette.edit.undo");
  hold_mouse(true);
  for (int k = 0; k < 5; ++k) frame();
  hold_mouse(false);
  EXPECT_EQ(chosen, "edit.undo");
}

TEST_F(PaletteDialog, LeavesOnEscapeAndOnAClickElsewhere) {
  palette.open();
  frame();
  frame();
  press(Key::escape);
  EXPECT_FALSE(palette.is_open());
  EXPECT_FALSE(has("palette"));
  palette.open();
  frame();
  frame();
  stage.io().MousePos = {100, 600};
  frame();
  hold_mouse(true);
  hold_mouse(false);
  EXPECT_FALSE(palette.is_open());
  EXPECT_EQ(stage.state().editing, "");
  EXPECT_EQ(chosen, "");
}

TEST_F(Sheet, HasEveryChordOfTheRegistry) {
  const std::vector<SheetRow> rows = sheet_rows(actions);
  for (const Action& action : actions.all()) {
    std::vector<std::string> chords;
    if (action.chord) chords.push_back(chord_text(*action.chord));
    for (const Chord& chord : action.more_chords) chords.push_back(chord_text(chord));
    const auto has_it = [&](const SheetRow& row) { return row.title == action.title && row.keys == chords; };
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), has_it), chords.empty() ? 0 : 1) << action.name;
  }
}

TEST_F(Sheet, KeepsGroupsTogether) {
  actions.add(test::example_action("file.late", "File", "Late", "F9"));
  std::vector<std::string> groups;
  for (const SheetRow& row : sheet_rows(actions)) {
    EXPECT_FALSE(row.title.empty());
    EXPECT_FALSE(row.keys.empty());
    if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
  }
  EXPECT_EQ(groups.front(), "File");
  for (const char* group : {"File", "Other keys", "Normal map", "P-NDF"}) {
    EXPECT_EQ(std::count(groups.begin(), groups.end(), group), 1) << group;
  }
}

TEST_F(Sheet, StaysInsideTheWindowHoweverMuchItHolds) {
  for (int k = 0; k < 200; ++k) {
    actions.add(test::example_action(fmt::format("more.{}", k), fmt::format("Menu {}", k / 30),
                                     fmt::format("A title of some length, number {}", k), "F8"));
  }
  sheet.open();
  frame();
  frame();
  ASSERT_TRUE(has("sheet"));
  EXPECT_GE(area("sheet").min.y, 0);
  EXPECT_LE(area("sheet").max.y, 720);
  EXPECT_GE(area("sheet").min.x, 0);
  EXPECT_LE(area("sheet").max.x, 1280);
  const auto before = stage.pixels();
  step(0, 10);
  EXPECT_NE(stage.pixels(), before);
  step(0, -20);
  EXPECT_EQ(stage.pixels(), before);
}

TEST_F(Sheet, ClosesInEveryWay) {
  const auto open = [&] {
    sheet.open();
    frame();
    frame();
    EXPECT_TRUE(has("sheet"));
  };
  stage.state().focus.name = "combo";
  open();
  press(Key::escape);
  EXPECT_FALSE(sheet.is_open());
  EXPECT_EQ(stage.state().focus.name, "combo");
  open();
  step(0, 0, true);
  EXPECT_FALSE(sheet.is_open());
  open();
  click("sheet.close");
  EXPECT_FALSE(sheet.is_open());
  open();
  stage.io().MousePos = {4, 400};
  frame();
  hold_mouse(true);
  hold_mouse(false);
  EXPECT_FALSE(sheet.is_open());
}

}  // namespace
}  // namespace glint::gui
