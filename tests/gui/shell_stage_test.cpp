// Menu bar, status bar and messages as a person meets them.

#include "tests/gui/shell_stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glint::gui {
namespace {

using MenuBar = ShellStage;
using StatusBar = ShellStage;
using MessageStrips = ShellStage;

TEST_F(MenuBar, OpensAsSoonAsTheButtonGoesDown) {
  move_to("menu.File");
  hold_mouse(true);
  EXPECT_TRUE(has("popup.file.open"));
  hold_mouse(false);
  frame();
  EXPECT_TRUE(has("popup.file.open"));
  click("popup.file.open");
  EXPECT_EQ(chosen, "file.open");
  EXPECT_FALSE(has("popup.file.open"));
}

TEST_F(MenuBar, HasMenusInTheOrderOfTheActionsAndNoneForTheRest) {
  EXPECT_LT(area("menu.File").max.x, area("menu.Edit").max.x);
  EXPECT_LT(area("menu.Preset").max.x, area("menu.Help").max.x);
  EXPECT_FALSE(has("menu."));
}

TEST_F(MenuBar, SaysWhyARowCannotBeChosen) {
  click("menu.File");
  ASSERT_TRUE(has("popup.file.reload"));
  EXPECT_EQ(stage.widgets().find("popup.file.reload")->reason, "The map is generated, not read from a file.");
  click("popup.file.reload");
  EXPECT_EQ(chosen, "");
  EXPECT_TRUE(has("popup.file.open"));
}

TEST_F(MenuBar, ChangesMenusWhereTheMouseRests) {
  click("menu.File");
  move_to("menu.Edit");
  frame();
  EXPECT_TRUE(has("popup.edit.undo"));
  EXPECT_FALSE(has("popup.file.open"));
}

TEST_F(MenuBar, TakesARowThatTheMouseWasDraggedTo) {
  move_to("menu.Edit");
  hold_mouse(true);
  frame();
  move_to("popup.edit.redo");
  EXPECT_EQ(chosen, "");
  hold_mouse(false);
  EXPECT_EQ(chosen, "edit.redo");
  frame();
  EXPECT_FALSE(has("popup.edit.redo"));
  click("menu.File");
  EXPECT_TRUE(has("popup.file.open"));
}

TEST_F(MenuBar, ClosesOnASecondClickEscapeAndAClickElsewhere) {
  click("menu.File");
  click("menu.File");
  EXPECT_FALSE(has("popup.file.open"));
  click("menu.File");
  EXPECT_TRUE(has("popup.file.open"));
  press(Key::escape);
  EXPECT_FALSE(has("popup.file.open"));
  click("menu.File");
  stage.io().MousePos = {640, 400};
  frame();
  hold_mouse(true);
  hold_mouse(false);
  EXPECT_FALSE(has("popup.file.open"));
  EXPECT_EQ(stage.state().open_popup, "");
  EXPECT_EQ(chosen, "");
}

TEST_F(MenuBar, OpensOverAnOpenList) {
  click("combo");
  ASSERT_EQ(stage.state().open_popup, "combo");
  click("menu.Edit");
  EXPECT_TRUE(has("popup.edit.undo"));
  EXPECT_FALSE(has("popup.one"));
}

TEST_F(MenuBar, WorksByKeyboardAlone) {
  stage.state().focus.name = "menu.File";
  step(1, 0);
  EXPECT_EQ(stage.state().focus.name, "menu.Edit");
  step(-1, 0);
  step(0, 1);
  EXPECT_TRUE(has("popup.file.open"));
  step(1, 0);
  EXPECT_TRUE(has("popup.edit.undo"));
  step(-1, 0);
  step(0, 1);  // over the disabled row
  step(0, 0, true);
  EXPECT_EQ(chosen, "file.quit");
  EXPECT_FALSE(has("popup.file.open"));
  EXPECT_EQ(stage.state().focus.name, "menu.File");
}

TEST_F(MenuBar, OpensAtTheFirstRowWhateverIsChecked) {
  click("menu.View");
  EXPECT_EQ(stage.state().popup_row, 0);
  step(0, 0, true);
  EXPECT_EQ(chosen, "view.normal");
}

TEST_F(MenuBar, LeadsToThePalette) {
  click("menu.palette");
  EXPECT_EQ(chosen, "help.find_action");
  EXPECT_TRUE(palette.is_open());
}

TEST_F(StatusBar, CancelsOnlyWhatRuns) {
  EXPECT_FALSE(has("status.cancel"));
  status.job = {true, "reading wood.png", 0.3, 9.0, std::nullopt};
  frame();
  move_to("status.cancel");
  hold_mouse(true);
  EXPECT_FALSE(events.cancel);
  hold_mouse(false);
  EXPECT_TRUE(events.cancel);
  frame();
  EXPECT_FALSE(events.cancel);
}

TEST_F(StatusBar, KeepsEverythingInItsPlaceWhileFiguresComeAndGo) {
  status.times = {{PndfMethod::exact, std::nullopt}, {PndfMethod::binning, std::nullopt}};
  status.machine = "2 threads, AVX-512";
  frame();
  const float exact = area("status.time.exact").min.x;
  const float machine = area("status.machine").min.x;
  status.job = {true, "reading a file with a very long name that finds no room.png", 0.3, 75.0, std::nullopt};
  status.times[0].ms = 203.4;
  status.times[1].ms = 1.0704;
  status.frame_ms = 123.4;
  frame();
  EXPECT_EQ(area("status.time.exact").min.x, exact);
  EXPECT_EQ(area("status.machine").min.x, machine);
  EXPECT_LE(area("status.cancel").max.x, exact);
}

TEST_F(StatusBar, DropsTheMachineBeforeTheFrameTime) {
  status.machine = "2 threads, AVX-512";
  status.times = {{PndfMethod::exact, 1.0}, {PndfMethod::binning, 2.0}};
  frame();
  EXPECT_TRUE(has("status.machine"));
  while (has("status.machine")) {
    ASSERT_TRUE(has("status.frame"));
    status.times.push_back({PndfMethod::binning, 3.0});
    frame();
  }
  EXPECT_TRUE(has("status.frame"));
  while (has("status.frame")) {
    status.times.push_back({PndfMethod::binning, 3.0});
    ASSERT_LT(status.times.size(), 20U);
    frame();
  }
}

TEST_F(StatusBar, NamesWhatDiffersFromRunToRun) {
  status.machine = "2 threads";
  status.times = {{PndfMethod::exact, 1.0}};
  status.note = "Saved.";
  frame();
  for (const char* name : {"status.job", "status.time.exact", "status.frame", "status.machine"}) {
    ASSERT_TRUE(has(name)) << name;
    EXPECT_TRUE(stage.widgets().find(name)->varies) << name;
  }
  EXPECT_FALSE(stage.widgets().find("status.note")->varies);
}

TEST_F(MessageStrips, TakeRoomOnlyWhileTheyAreThere) {
  EXPECT_EQ(height, 0);
  messages.post({Message::Kind::info, "One.", {}});
  frame();
  EXPECT_EQ(height, 36);
  messages.post({Message::Kind::info, "Two.", {}});
  frame();
  EXPECT_EQ(height, 72);
  EXPECT_GE(area("message.0").min.y, 26 + 6);
  EXPECT_LT(area("message.0").max.y, area("message.1").min.y);
  EXPECT_LE(area("message.1").max.y, 26 + height);
  click("message.0.close");
  EXPECT_EQ(height, 36);
  EXPECT_EQ(messages.newest()->text, "One.");
}

TEST_F(MessageStrips, StackToThree) {
  for (int k = 0; k < 5; ++k) messages.post({Message::Kind::error, fmt::format("Failure {}.", k), {}});
  frame();
  EXPECT_TRUE(has("message.2"));
  EXPECT_FALSE(has("message.3"));
  click("message.close_all");
  EXPECT_TRUE(messages.all().empty());
}

TEST_F(MessageStrips, GrowByOneLineAtMostAndCopyEverything) {
  std::string text = "−0.5 is no roughness";
  for (int k = 0; k < 80; ++k) text += fmt::format(", nor is −{}", k);
  messages.post({Message::Kind::error, text + ".", {}});
  frame();
  EXPECT_EQ(area("message.0").height(), 30 + 18);
  click("message.0.copy");
  const std::string copy = ImGui::GetClipboardText();
  EXPECT_TRUE(copy.starts_with("-0.5 is no roughness, nor is -0,"));
  EXPECT_TRUE(copy.ends_with(", nor is -79."));
  EXPECT_TRUE(has("message.0"));
}

TEST_F(MessageStrips, OfferActions) {
  messages.post({Message::Kind::error, "The map cannot be read.", {"file.open", "file.reload", "no.such"}});
  frame();
  EXPECT_FALSE(has("message.0.no.such"));
  click("message.0.file.reload");
  EXPECT_EQ(chosen, "");
  click("message.0.file.open");
  EXPECT_EQ(chosen, "file.open");
}

}  // namespace
}  // namespace glint::gui
