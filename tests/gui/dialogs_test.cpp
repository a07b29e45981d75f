#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "gui/dialogs/about_dialog.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/dialogs/preset_name_dialog.h"
#include "gui/dialogs/question_dialog.h"
#include "gui/input/chord.h"
#include "gui/input/input.h"
#include "tests/temporary_folder.h"
#include "tests/viewers/stage.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

class DialogTest : public testing::Test {
 protected:
  DialogTest() { setup_key_map(stage_.io()); }

  void frame(int count = 1) {
    for (int k = 0; k < count; ++k) stage_.frame(body_);
  }
  void click(const std::string& widget) {
    stage_.click(widget.c_str(), body_);
    frame(2);
  }
  void press(Key key) {
    stage_.io().KeysDown[static_cast<int>(key)] = true;
    stage_.state().focus.activate = key == Key::enter;
    stage_.state().focus.down = key == Key::down ? 1 : key == Key::up ? -1 : 0;
    frame();
    stage_.io().KeysDown[static_cast<int>(key)] = false;
    frame();
  }
  void type(const std::string& text) {
    stage_.io().AddInputCharactersUTF8(text.c_str());
    frame();
  }
  [[nodiscard]] std::string reason(const std::string& widget) const {
    const view::WidgetRecord::Entry* entry = stage_.widgets().find(widget);
    return entry ? entry->reason : "there is no such widget";
  }

  test::TemporaryFolder folder_;
  test::Stage stage_{{640, 540}};
  std::function<void(view::Ui&)> body_;
};

class QuestionDialogTest : public DialogTest {
 protected:
  QuestionDialogTest() {
    body_ = [this](view::Ui& ui) {
      if (auto answer = dialog_.draw(ui)) answer_ = std::move(answer);
    };
  }
  void ask(const std::string& cannot_save = {}) {
    dialog_.open(unsaved_changes_question("steel", "when the window closes", cannot_save));
    frame(2);
  }

  QuestionDialog dialog_;
  std::optional<Answer> answer_;
};

TEST_F(QuestionDialogTest, EveryAnswerIsAButton) {
  for (const std::string key : {"save", "discard", "cancel"}) {
    ask();
    click("unsaved." + key);
    ASSERT_TRUE(answer_);
    EXPECT_EQ(answer_->question, "unsaved");
    EXPECT_EQ(answer_->key, key);
    EXPECT_FALSE(dialog_.is_open());
  }
}

TEST_F(QuestionDialogTest, EnterGivesTheLastAnswerAndEscapeNone) {
  ask();
  press(Key::escape);
  EXPECT_FALSE(dialog_.is_open());
  EXPECT_FALSE(answer_);
  ask();
  press(Key::enter);
  ASSERT_TRUE(answer_);
  EXPECT_EQ(answer_->key, "save");
}

TEST_F(QuestionDialogTest, TheEnterThatOpenedItDoesNotAnswer) {
  dialog_.open(unsaved_changes_question("steel", "when the window closes"));
  stage_.state().focus.activate = true;
  frame(2);
  EXPECT_TRUE(dialog_.is_open());
}

TEST_F(QuestionDialogTest, AnAnswerThatIsNotPossibleSaysWhy) {
  ask("The disk is full.");
  EXPECT_EQ(reason("unsaved.save"), "The disk is full.");
  press(Key::enter);
  EXPECT_TRUE(dialog_.is_open());
}

TEST_F(QuestionDialogTest, DeletingHasTheKeyboardOnCancel) {
  dialog_.open(delete_preset_question("steel", "/presets/steel.json"));
  frame(2);
  press(Key::enter);
  ASSERT_TRUE(answer_);
  EXPECT_EQ(answer_->key, "cancel");
}

class PresetNameDialogTest : public DialogTest {
 protected:
  PresetNameDialogTest() {
    body_ = [this](view::Ui& ui) {
      if (auto result = dialog_.draw(ui)) result_ = std::move(result);
    };
  }

  PresetNameDialog dialog_;
  std::optional<PresetName> result_;
};

TEST(PresetName, FollowsTheRulesOfTheDocument) {
  EXPECT_EQ(preset_name_fault("Scratched Steel σ"), "");
  EXPECT_EQ(preset_name_fault("  "), "Type a name first.");
  EXPECT_NE(preset_name_fault("a\tb"), "");
  EXPECT_NE(preset_name_fault("bad\xFF"), "");
}

TEST_F(PresetNameDialogTest, TheNameCanBeTypedAtOnceAndEnterSaves) {
  dialog_.open_to_save("old", folder_.path());
  frame(3);
  type("My Steel");
  press(Key::enter);
  ASSERT_TRUE(result_);
  EXPECT_EQ(result_->wish, PresetName::Wish::save);
  EXPECT_EQ(result_->name, "My Steel");
  EXPECT_EQ(result_->file, folder_ / "my-steel.json");
}

TEST_F(PresetNameDialogTest, ReplacingIsAskedForInPlace) {
  test::write_text(folder_ / "my-steel.json", "{}");
  dialog_.open_to_save("My Steel", folder_.path());
  frame(3);
  press(Key::enter);
  EXPECT_FALSE(result_);
  press(Key::enter);
  ASSERT_TRUE(result_);
  EXPECT_EQ(result_->file, folder_ / "my-steel.json");
}

TEST_F(PresetNameDialogTest, AnEmptyNameIsRefusedWhileItIsTyped) {
  dialog_.open_to_save("x", folder_.path());
  frame(3);
  press(Key::backspace);
  frame();
  EXPECT_EQ(reason("preset_name.accept"), "Type a name first.");
  press(Key::enter);
  EXPECT_FALSE(result_);
  EXPECT_TRUE(dialog_.is_open());
}

TEST_F(PresetNameDialogTest, RenamingKeepsTheFolderAndReplacesNothing) {
  test::write_text(folder_ / "steel.json", "{}");
  test::write_text(folder_ / "iron.json", "{}");
  dialog_.open_to_rename("iron", folder_ / "steel.json");
  frame(3);
  EXPECT_EQ(reason("preset_name.accept"), "There is a preset in “iron.json” already: take another name.");
  type("Steel");
  frame();
  EXPECT_EQ(reason("preset_name.accept"), "") << "its own file may stay";
  press(Key::enter);
  ASSERT_TRUE(result_);
  EXPECT_EQ(result_->wish, PresetName::Wish::rename);
  EXPECT_EQ(result_->file, folder_ / "steel.json");
}

TEST_F(PresetNameDialogTest, WithoutAFolderOnlyAnotherOneIsLeft) {
  dialog_.open_to_save("steel", std::nullopt);
  frame(3);
  EXPECT_NE(reason("preset_name.accept"), "");
  click("preset_name.elsewhere");
  ASSERT_TRUE(result_);
  EXPECT_EQ(result_->wish, PresetName::Wish::elsewhere);
  EXPECT_EQ(result_->file.filename(), "steel.json");
}

class ExportDialogTest : public DialogTest {
 protected:
  ExportDialogTest() {
    input_.document = "My Steel";
    input_.folder = folder_.path();
    body_ = [this](view::Ui& ui) {
      if (auto choice = dialog_.draw(ui, input_)) choice_ = std::move(choice);
    };
  }
  void open(ExportWhat what = ExportWhat::window) {
    dialog_.open(what);
    frame(2);
  }

  ExportDialog dialog_;
  ExportInput input_;
  std::optional<ExportChoice> choice_;
};

TEST(ExportKinds, AreOneForEveryChoiceWithItsOwnKey) {
  std::set<std::string_view> keys;
  for (const ExportKind& kind : export_kinds()) {
    keys.insert(kind.key);
    EXPECT_FALSE(kind.extensions.empty()) << kind.key;
    EXPECT_TRUE(kind.text.ends_with('.')) << kind.key;
  }
  EXPECT_EQ(keys.size(), 8U);
}

TEST_F(ExportDialogTest, SuggestsAFileForWhatIsChosen) {
  open(ExportWhat::pndf_images);
  click("export.accept");
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->what, ExportWhat::pndf_images);
  EXPECT_EQ(choice_->file, folder_ / "my-steel-images.exr");
  EXPECT_FALSE(choice_->browse);
  EXPECT_FALSE(dialog_.is_open());
}

TEST_F(ExportDialogTest, ArrowKeysChooseAndEnterExports) {
  open();
  press(Key::down);
  press(Key::down);
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->what, ExportWhat::pndf_panel);
  EXPECT_EQ(choice_->file, folder_ / "my-steel-pndf.png");
}

TEST_F(ExportDialogTest, ATypedNameKeepsItsStemWhenTheKindChanges) {
  open();
  click("export.path");
  type("a.png");
  press(Key::enter);
  ASSERT_TRUE(choice_);
  EXPECT_EQ(choice_->file, folder_ / "a.png");
  open();
  dialog_.set_file(folder_ / "b.png");
  click("export.what.images");
  click("export.accept");
  EXPECT_EQ(choice_->file, folder_ / "b.exr");
}

TEST_F(ExportDialogTest, AnEndingOfAnotherKindIsRefused) {
  open(ExportWhat::normal_map);
  dialog_.set_file(folder_ / "map.csv");
  frame(2);
  EXPECT_EQ(reason("export.accept"), "The name of this file ends in .exr or .png.");
  dialog_.set_file(folder_ / "gone/map.png");
  frame(2);
  EXPECT_EQ(reason("export.accept"), "There is no folder “" + (folder_ / "gone").string() + "”.");
  dialog_.set_file(folder_ / "map.png");
  frame(2);
  EXPECT_EQ(reason("export.accept"), "");
}

TEST_F(ExportDialogTest, WhatCannotBeExportedSaysWhy) {
  input_.reason_disabled = [](ExportWhat what) {
    return what == ExportWhat::values ? std::string("Put the crosshair into a picture first.") : std::string();
  };
  open(ExportWhat::values);
  EXPECT_EQ(reason("export.accept"), "Put the crosshair into a picture first.");
  EXPECT_EQ(reason("export.what.values"), "Put the crosshair into a picture first.");
  press(Key::enter);
  EXPECT_FALSE(choice_);
}

TEST_F(ExportDialogTest, ReplacingIsAskedForUnlessTheBrowserHasAsked) {
  test::write_text(folder_ / "my-steel-window.png", "x");
  open();
  press(Key::enter);
  EXPECT_FALSE(choice_);
  press(Key::escape);
  EXPECT_TRUE(dialog_.is_open()) << "Escape takes the question back";
  click("export.browse");
  ASSERT_TRUE(choice_);
  EXPECT_TRUE(choice_->browse);
  EXPECT_TRUE(dialog_.is_open());
  choice_.reset();
  dialog_.set_file(folder_ / "my-steel-window.png");
  frame(2);
  click("export.accept");
  ASSERT_TRUE(choice_);
  EXPECT_FALSE(choice_->browse);
}

TEST_F(DialogTest, AboutClosesByItsButton) {
  AboutDialog dialog;
  body_ = [&](view::Ui& ui) { dialog.draw(ui, {"1.0", "Apache License 2.0", "a machine", "a renderer"}); };
  dialog.open();
  frame(2);
  click("about.accept");
  EXPECT_FALSE(dialog.is_open());
  EXPECT_EQ(about_text({"1.0", "", "a machine", "a renderer"}),
            "Glintscope 1.0\nMachine: a machine\nGraphics: a renderer\n");
}

TEST_F(DialogTest, OfTwoDialogsTheUpperOneHasTheKeyboard) {
  QuestionDialog lower;
  AboutDialog upper;
  body_ = [&](view::Ui& ui) {
    lower.draw(ui);
    upper.draw(ui, {});
  };
  lower.open(delete_preset_question("steel", "/presets/steel.json"));
  frame(2);
  upper.open();
  frame(2);
  EXPECT_EQ(stage_.state().focus.name, "about.accept");
  press(Key::escape);
  EXPECT_FALSE(upper.is_open());
  EXPECT_TRUE(lower.is_open());
  EXPECT_EQ(stage_.state().focus.name, "delete_preset.cancel");
  frame(2);
  press(Key::escape);
  EXPECT_FALSE(lower.is_open());
}

}  // namespace
}  // namespace glint::gui
