#include "gui/dialogs/file_browser.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/image/png_file.h"
#include "gui/input/chord.h"
#include "gui/input/input.h"
#include "tests/temporary_folder.h"
#include "tests/viewers/stage.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

class FileBrowserTest : public testing::Test {
 protected:
  FileBrowserTest() {
    setup_key_map(stage_.io());
    for (const char* name : {"apple.png", "bark.png", "brick.png"}) write_picture(folder_ / name);
    fs::create_directory(folder_ / "inner");
    write_picture(folder_ / "inner/deep.png");
    fs::create_directory(folder_ / "void");
    frame();
  }

  static void write_picture(const fs::path& file) {
    const std::vector<std::uint8_t> pixels(std::size_t{8} * 4 * 3, 128);
    ASSERT_TRUE(write_png_8(file, 8, 4, pixels));
  }

  void frame(int count = 1) {
    for (int k = 0; k < count; ++k) stage_.frame(body_);
  }
  void open(Purpose purpose, const fs::path& start, std::string name = {}) {
    browser_.open(purpose, start, std::move(name));
    frame(3);
  }
  void click(const std::string& widget) {
    stage_.click(widget.c_str(), body_);
    frame(2);  // an entry takes the keyboard
  }
  void double_click(const std::string& widget) {
    click(widget);
    const view::WidgetRecord::Entry* entry = stage_.widgets().find(widget);
    ASSERT_NE(entry, nullptr);
    stage_.io().MouseDown[0] = true;
    frame();
    stage_.io().MouseDown[0] = false;
    frame(2);
  }
  void press(Key key) {
    stage_.io().KeysDown[static_cast<int>(key)] = true;
    if (key == Key::enter) stage_.state().focus.activate = true;
    if (key == Key::down) stage_.state().focus.down = 1;
    if (key == Key::up) stage_.state().focus.down = -1;
    frame();
    stage_.io().KeysDown[static_cast<int>(key)] = false;
    frame();
  }
  void type(const std::string& text) {
    stage_.io().AddInputCharactersUTF8(text.c_str());
    frame();
  }
  [[nodiscard]] bool shows(const std::string& widget) const { return stage_.widgets().find(widget) != nullptr; }
  [[nodiscard]] std::string reason(const std::string& widget) const {
    const view::WidgetRecord::Entry* entry = stage_.widgets().find(widget);
    return entry ? entry->reason : "there is no such widget";
  }

  test::TemporaryFolder folder_;
  test::Stage stage_{{880, 620}};
  FileBrowser browser_;
  std::vector<fs::path> recent_;
  std::vector<Place> places_;
  std::optional<FileChoice> choice_;
  std::function<void(view::Ui&)> body_ = [this](view::Ui& ui) {
    std::optional<FileChoice> choice = browser_.draw(ui, {recent_, places_});
    if (choice) choice_ = std::move(choice);
  };
};

TEST_F(FileBrowserTest, NothingIsDrawnUntilItIsOpened) {
  EXPECT_FALSE(browser_.is_open());
  EXPECT_TRUE(stage_.widgets().order().empty());
}

TEST_F(FileBrowserTest, ListsTheFolderAndHasNothingToOpenAtFirst) {
  open(Purpose::open_map, folder_.path());
  EXPECT_TRUE(shows("browser.row.inner"));
  EXPECT_TRUE(shows("browser.row.apple.png"));
  EXPECT_FALSE(shows("browser.name"));
  EXPECT_EQ(reason("browser.accept"), "Select a file first.");
  EXPECT_EQ(browser_.folder(), folder_.path());
}

TEST_F(FileBrowserTest, AClickSelectsAndOpenTakesTheFile) {
  open(Purpose::open_map, folder_.path());
  click("browser.row.bark.png");
  EXPECT_EQ(reason("browser.accept"), "");
  EXPECT_FALSE(choice_);
  click("browser.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "bark.png");
  EXPECT_FALSE(browser_.is_open());
}

TEST_F(FileBrowserTest, ADoubleClickEntersAFolderAndOpensAFile) {
  open(Purpose::open_map, folder_.path());
  double_click("browser.row.inner");
  EXPECT_EQ(browser_.folder(), folder_ / "inner");
  double_click("browser.row.deep.png");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "inner/deep.png");
}

TEST_F(FileBrowserTest, TheKeyboardAloneGetsThere) {
  stage_.state().focus.name = "map.zoom";
  open(Purpose::open_map, folder_.path());
  press(Key::down);
  press(Key::enter);
  EXPECT_EQ(browser_.folder(), folder_ / "inner");
  press(Key::backspace);
  EXPECT_EQ(browser_.folder(), folder_.path());
  type("b");
  type("b");
  press(Key::up);
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "bark.png");
  EXPECT_EQ(stage_.state().focus.name, "map.zoom") << "the focus goes back to where it was";
}

TEST_F(FileBrowserTest, EscapeAndCancelLeaveWithoutAChoice) {
  open(Purpose::open_map, folder_ / "apple.png");
  press(Key::escape);
  EXPECT_FALSE(browser_.is_open());
  open(Purpose::open_map, folder_ / "apple.png");
  click("browser.cancel");
  EXPECT_FALSE(browser_.is_open());
  EXPECT_FALSE(choice_);
}

TEST_F(FileBrowserTest, EscapeEndsTypingBeforeItClosesTheDialog) {
  open(Purpose::open_map, folder_.path());
  click("browser.path");
  ASSERT_EQ(stage_.state().editing, "browser.path");
  press(Key::escape);
  EXPECT_TRUE(browser_.is_open());
  EXPECT_EQ(stage_.state().editing, "");
  press(Key::escape);
  EXPECT_FALSE(browser_.is_open());
}

TEST_F(FileBrowserTest, ATypedFolderIsEnteredAndATypedFileSelected) {
  open(Purpose::open_map, "/");
  click("browser.path");
  type((folder_ / "inner").string());
  press(Key::enter);
  EXPECT_EQ(browser_.folder(), folder_ / "inner");
  click("browser.path");
  type("../brick.png");
  press(Key::enter);
  EXPECT_EQ(browser_.folder(), folder_.path());
  click("browser.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "brick.png");
}

TEST_F(FileBrowserTest, WhatIsNotThereIsRefusedWithASentence) {
  open(Purpose::open_map, folder_.path());
  click("browser.path");
  type("nowhere");
  press(Key::enter);
  EXPECT_EQ(stage_.state().editing, "browser.path");
  EXPECT_EQ(stage_.state().editing_error, "There is nothing at “" + (folder_ / "nowhere").string() + "”.");
  EXPECT_EQ(browser_.folder(), folder_.path());
}

TEST_F(FileBrowserTest, TypingOffersHowThePathCanGoOn) {
  open(Purpose::open_map, folder_.path());
  click("browser.path");
  type("b");
  frame();
  EXPECT_TRUE(shows("browser.suggestion.bark.png"));
  EXPECT_TRUE(shows("browser.suggestion.brick.png"));
  EXPECT_FALSE(shows("browser.suggestion.apple.png"));
  click("browser.suggestion.brick.png");
  click("browser.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "brick.png");
}

TEST_F(FileBrowserTest, ARowOfSuggestionsIsChosenByTheArrowKeys) {
  open(Purpose::open_map, folder_.path());
  click("browser.path");
  type("b");
  press(Key::down);
  press(Key::down);
  press(Key::enter);
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "brick.png");
}

TEST_F(FileBrowserTest, AStartThatIsGoneBeginsAtTheNearestFolderAbove) {
  open(Purpose::open_map, folder_ / "inner/gone/further.png");
  EXPECT_EQ(browser_.folder(), folder_ / "inner");
}

TEST_F(FileBrowserTest, SavingAddsTheExtension) {
  open(Purpose::save_preset, folder_.path(), "steel 0.5");
  ASSERT_EQ(stage_.state().editing, "browser.name") << "the name can be typed at once";
  type("iron");
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "iron.json");
}

TEST_F(FileBrowserTest, SavingSaysWhatIsMissing) {
  open(Purpose::export_file, folder_.path(), "picture.png");
  press(Key::backspace);
  frame();
  EXPECT_EQ(reason("browser.accept"), "Type a name first.");
  type("nowhere/a");
  frame();
  EXPECT_EQ(reason("browser.accept"), "There is no folder “" + (folder_ / "nowhere").string() + "”.");
}

TEST_F(FileBrowserTest, ReplacingAFileIsAskedForInPlace) {
  test::write_text(folder_ / "steel.json", "{}");
  open(Purpose::save_preset, folder_.path(), "steel");
  press(Key::enter);
  EXPECT_FALSE(choice_) << "it exists";
  EXPECT_TRUE(browser_.is_open());
  press(Key::escape);
  EXPECT_TRUE(browser_.is_open()) << "Escape takes the question back";
  click("browser.accept");
  EXPECT_FALSE(choice_);
  click("browser.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "steel.json");
}

TEST_F(FileBrowserTest, TheQuestionIsAskedAnewForAnotherName) {
  test::write_text(folder_ / "a.json", "{}");
  test::write_text(folder_ / "b.json", "{}");
  open(Purpose::save_preset, folder_.path(), "a");
  press(Key::enter);
  click("browser.row.b.json");
  click("browser.accept");
  EXPECT_FALSE(choice_);
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "b.json");
}

TEST_F(FileBrowserTest, PlacesLeadToFoldersAndRecentFilesAreSelected) {
  places_ = {{"Inner", folder_ / "inner"}, {"Missing", folder_ / "missing"}};
  recent_ = {folder_ / "bark.png", folder_ / "gone.png", folder_ / "notes.json"};
  open(Purpose::open_map, folder_ / "void");
  EXPECT_NE(reason("browser.place.missing"), "");
  EXPECT_EQ(reason("browser.recent.gone.png"), "No longer there.");
  EXPECT_FALSE(shows("browser.recent.notes.json")) << "it is no picture";
  click("browser.place.inner");
  EXPECT_EQ(browser_.folder(), folder_ / "inner");
  click("browser.recent.bark.png");
  EXPECT_EQ(browser_.folder(), folder_.path());
  click("browser.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->path, folder_ / "bark.png");
}

TEST_F(FileBrowserTest, OtherFilesAreShownWhenAskedFor) {
  test::write_text(folder_ / "notes.txt", "x");
  test::write_text(folder_ / ".hidden.png", "x");
  open(Purpose::open_map, folder_.path());
  EXPECT_FALSE(shows("browser.row.notes.txt"));
  click("browser.hidden");
  EXPECT_TRUE(shows("browser.row..hidden.png"));
  click("browser.filter");
  click("popup.All files");
  frame(2);
  EXPECT_TRUE(shows("browser.row.notes.txt"));
}

TEST_F(FileBrowserTest, EscapeClosesAnOpenListBeforeTheDialog) {
  open(Purpose::open_map, folder_.path());
  click("browser.filter");
  EXPECT_TRUE(shows("popup.All files"));
  press(Key::escape);
  frame(2);
  EXPECT_FALSE(shows("popup.All files"));
  EXPECT_TRUE(browser_.is_open());
  press(Key::escape);
  EXPECT_FALSE(browser_.is_open());
}

TEST_F(FileBrowserTest, OnlyItsOwnControlsAreStopsOfTheTabKey) {
  const auto own = body_;
  body_ = [own](view::Ui& ui) {
    ui.widgets.record("map.zoom", {{}, {}, true, false});
    own(ui);
  };
  open(Purpose::open_map, folder_.path());
  for (const auto& [name, entry] : stage_.widgets().entries()) {
    EXPECT_TRUE(!entry.focusable || name.starts_with("browser.")) << name;
  }
  EXPECT_EQ(stage_.state().focus.name, "browser.list");
}

TEST(FileBrowser, StaysInsideSmallAndScaledWindowsWithAllItsControls) {
  const test::TemporaryFolder folder;
  for (const float scale : {1.0F, 2.0F}) {
    test::Stage stage({1280, 720}, scale);
    FileBrowser browser;
    const auto body = [&](view::Ui& ui) { browser.draw(ui, {}); };
    browser.open(Purpose::save_preset, folder.path(), "a");
    stage.frame(body);
    stage.frame(body);
    for (const auto& [name, entry] : stage.widgets().entries()) {
      EXPECT_GE(entry.area.min.x, 0) << name;
      EXPECT_GE(entry.area.min.y, 0) << name;
      EXPECT_LE(entry.area.max.x, 1280) << name;
      EXPECT_LE(entry.area.max.y, 720) << name;
      EXPECT_GE(entry.area.height(), 16 * scale) << name;
    }
  }
}

TEST(FileBrowser, ListsAgainWhatChangesOnTheDisk) {
  const test::TemporaryFolder folder;
  const fs::path watched = folder / "watched";
  fs::create_directory(watched);
  fs::last_write_time(watched, fs::file_time_type::clock::now() - std::chrono::hours(1));
  test::Stage stage({320, 240});  // small, for it takes many frames
  FileBrowser browser;
  const auto shows_it_after_a_second = [&] {
    for (int k = 0; k < 70; ++k) stage.frame([&](view::Ui& ui) { browser.draw(ui, {}); });
    return stage.widgets().find("browser.row.new.png") != nullptr;
  };
  browser.open(Purpose::open_map, watched);
  EXPECT_FALSE(shows_it_after_a_second());
  test::write_text(watched / "new.png", "x");
  EXPECT_TRUE(shows_it_after_a_second());
  fs::remove_all(watched);
  EXPECT_FALSE(shows_it_after_a_second());
}

}  // namespace
}  // namespace glint::gui
