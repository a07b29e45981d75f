#include "gui/input/input.h"

#include <cfloat>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::gui {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Modifiers k_none{};
constexpr Modifiers k_ctrl{.ctrl = true};

class InputQueueTest : public ::testing::Test {
 protected:
  // What one frame sees of the characters.
  std::u32string characters() {
    std::u32string text;
    for (const ImWchar c : io_.InputQueueCharacters) text += static_cast<char32_t>(c);
    io_.InputQueueCharacters.clear();
    return text;
  }
  bool is_down(Key key) const { return io_.KeysDown[static_cast<int>(key)]; }
  void press(Key key, Modifiers modifiers = k_none) { queue_.push(KeyChange{key, true, modifiers}); }
  void release(Key key, Modifiers modifiers = k_none) { queue_.push(KeyChange{key, false, modifiers}); }
  std::vector<Chord> presses() const { return {queue_.key_presses().begin(), queue_.key_presses().end()}; }

  InputQueue queue_;
  ImGuiIO io_;
};

TEST_F(InputQueueTest, BeginsWithNothingDown) {
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_EQ(io_.MousePos.x, -FLT_MAX);
  EXPECT_FALSE(io_.MouseDown[0]);
  EXPECT_THAT(presses(), IsEmpty());
}

TEST_F(InputQueueTest, SpreadsAClickOverTwoFrames) {
  queue_.push(MouseMove{{3, 4}});
  queue_.push(MouseMove{{5, 6}});
  queue_.push(MouseButton{0, true});
  queue_.push(MouseButton{0, false});
  queue_.push(MouseMove{{7, 8}});
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_EQ(io_.MousePos.x, 5);
  EXPECT_TRUE(io_.MouseDown[0]);
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_EQ(io_.MousePos.x, 5) << "released where the button was";
  EXPECT_FALSE(io_.MouseDown[0]);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_EQ(io_.MousePos.x, 7);
}

TEST_F(InputQueueTest, LetsDifferentButtonsChangeInOneFrame) {
  queue_.push(MouseButton{0, true});
  queue_.push(MouseButton{1, true});
  queue_.push(MouseButton{7, true});
  queue_.push(MouseButton{-1, true});
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_TRUE(io_.MouseDown[0] && io_.MouseDown[1]);
}

TEST_F(InputQueueTest, GivesTheWheelToOneFrameWhereTheMouseWas) {
  queue_.push(MouseWheel{{0, 1}});
  queue_.push(MouseWheel{{0.5F, 1}});
  queue_.push(MouseMove{{9, 9}});
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_EQ(io_.MouseWheel, 2);
  EXPECT_EQ(io_.MouseWheelH, 0.5F);
  EXPECT_NE(io_.MousePos.x, 9);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_EQ(io_.MouseWheel, 0);
  EXPECT_EQ(io_.MousePos.x, 9);
}

TEST_F(InputQueueTest, SpreadsAKeyOverTwoFrames) {
  press(Key::g);
  release(Key::g);
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_TRUE(is_down(Key::g));
  EXPECT_TRUE(queue_.is_down(Key::g));
  EXPECT_THAT(presses(), ElementsAre(Chord{Key::g}));
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_FALSE(is_down(Key::g));
  EXPECT_THAT(presses(), IsEmpty());
}

TEST_F(InputQueueTest, TellsRepeatsFromPresses) {
  press(Key::left);
  press(Key::left);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_THAT(presses(), ElementsAre(Chord{Key::left}));
  ASSERT_EQ(queue_.key_repeats().size(), 1U);
  press(Key::left);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_THAT(presses(), IsEmpty());
  EXPECT_EQ(queue_.key_repeats().size(), 1U);
}

TEST_F(InputQueueTest, KnowsModifiersWhateverThePlatformSaysOfTheirOwnKeys) {
  press(Key::left_ctrl, k_none);  // as X11 has it
  press(Key::s, k_ctrl);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_TRUE(io_.KeyCtrl);
  EXPECT_THAT(presses(), ElementsAre(Chord{Key::left_ctrl}, Chord{Key::s, true}));
  release(Key::s, k_ctrl);
  release(Key::left_ctrl, k_ctrl);
  EXPECT_TRUE(queue_.feed(io_)) << "the release of S has Ctrl, the next frame has not";
  EXPECT_TRUE(io_.KeyCtrl);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_FALSE(io_.KeyCtrl);
}

TEST_F(InputQueueTest, HoldsAModifierUntilBothOfItsKeysAreUp) {
  press(Key::left_shift);
  press(Key::right_shift);
  queue_.feed(io_);
  release(Key::left_shift);
  queue_.feed(io_);
  EXPECT_TRUE(io_.KeyShift);
  release(Key::right_shift);
  queue_.feed(io_);
  EXPECT_FALSE(io_.KeyShift);
}

TEST_F(InputQueueTest, HasOneStateOfModifiersInAFrame) {
  queue_.push(Character{U'a'});
  press(Key::left_ctrl, k_ctrl);
  queue_.push(MouseButton{0, true, k_ctrl});
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_FALSE(io_.KeyCtrl);
  EXPECT_FALSE(io_.MouseDown[0]);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_TRUE(io_.KeyCtrl && io_.MouseDown[0]);
}

TEST_F(InputQueueTest, LeavesTheDesktopItsChords) {
  press(Key::left_super);
  press(Key::d, {.super = true});
  queue_.feed(io_);
  EXPECT_TRUE(io_.KeySuper);
  EXPECT_THAT(presses(), IsEmpty());
}

TEST_F(InputQueueTest, KeepsTextAndEditingKeysInOrder) {
  press(Key::a);
  queue_.push(Character{U'a'});
  queue_.push(Character{U'ß'});
  press(Key::backspace);
  queue_.push(Character{U'c'});
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_EQ(characters(), U"aß");
  EXPECT_FALSE(is_down(Key::backspace));
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_TRUE(is_down(Key::backspace));
  EXPECT_EQ(characters(), U"");
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_EQ(characters(), U"c");
}

TEST_F(InputQueueTest, GivesWhatIsTypedAfterAClickToWhatWasClicked) {
  queue_.push(MouseButton{0, true});
  queue_.push(Character{U'a'});
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_EQ(characters(), U"");
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_EQ(characters(), U"a");
}

TEST_F(InputQueueTest, ReleasesEverythingWithoutAClickWhenTheFocusIsLost) {
  queue_.push(MouseMove{{5, 5}});
  queue_.push(MouseButton{0, true, k_ctrl});
  queue_.feed(io_);
  press(Key::g, k_ctrl);
  queue_.push(FocusLost{});
  press(Key::g);
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_TRUE(is_down(Key::g));
  EXPECT_TRUE(queue_.feed(io_));
  EXPECT_FALSE(is_down(Key::g) || io_.MouseDown[0] || io_.KeyCtrl);
  EXPECT_EQ(io_.MousePos.x, -FLT_MAX);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_TRUE(is_down(Key::g));
  EXPECT_EQ(io_.MousePos.x, 5);
}

TEST_F(InputQueueTest, ForgetsWhatWaitsWhenCleared) {
  press(Key::g);
  queue_.feed(io_);
  press(Key::h);
  queue_.clear();
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_FALSE(is_down(Key::g) || is_down(Key::h));
  EXPECT_TRUE(queue_.is_empty());
}

TEST_F(InputQueueTest, HandsOverDroppedFilesOnce) {
  queue_.push(FileDrop{{"/a", "/b"}});
  queue_.push(FileDrop{{"/c"}});
  EXPECT_THAT(queue_.take_drops(), IsEmpty());
  queue_.feed(io_);
  EXPECT_THAT(queue_.take_drops(), ElementsAre("/a", "/b", "/c"));
  EXPECT_THAT(queue_.take_drops(), IsEmpty());
}

TEST_F(InputQueueTest, TakesKeysThatHaveNoCode) {
  press(static_cast<Key>(-1));
  press(static_cast<Key>(512));
  press(Key::none);
  EXPECT_FALSE(queue_.feed(io_));
  EXPECT_THAT(presses(), IsEmpty());
  EXPECT_FALSE(queue_.is_down(static_cast<Key>(100000)));
}

// A window of Dear ImGui without a picture: what its widgets make of the events.
class ImGuiInputTest : public ::testing::Test {
 protected:
  ImGuiInputTest() {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {400, 300};
    io.DeltaTime = 1.0F / 60;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    setup_key_map(io);
    frame();
    frame();
  }
  ~ImGuiInputTest() override { ImGui::DestroyContext(context_); }

  void frame() {
    queue_.feed(ImGui::GetIO());
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({400, 300});
    ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
    if (ImGui::Button("button", {100, 20})) ++clicks_;
    button_ = {ImGui::GetItemRectMin().x + 50, ImGui::GetItemRectMin().y + 10};
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) ++double_clicks_;
    ImGui::InputText("text", text_, sizeof text_);
    field_ = {ImGui::GetItemRectMin().x + 50, ImGui::GetItemRectMin().y + 10};
    ImGui::End();
    ImGui::EndFrame();
  }
  void frames_until_empty() {
    do {
      frame();
    } while (!queue_.is_empty());
    frame();
  }
  void click(ImVec2 position, bool never_double = false) {
    queue_.push(MouseMove{position});
    queue_.push(MouseButton{0, true, {}, never_double});
    queue_.push(MouseButton{0, false});
  }

  ImGuiContext* context_ = ImGui::CreateContext();
  InputQueue queue_;
  ImVec2 button_{0, 0};
  ImVec2 field_{0, 0};
  int clicks_ = 0;
  int double_clicks_ = 0;
  char text_[32] = "";
};

TEST_F(ImGuiInputTest, ClicksAButtonHoweverFast) {
  click(button_);
  click(button_);
  frames_until_empty();
  EXPECT_EQ(clicks_, 2);
  EXPECT_EQ(double_clicks_, 1);
}

TEST_F(ImGuiInputTest, MakesNoDoubleClickOfWhatIsNone) {
  for (int k = 0; k < 3; ++k) click(button_, true);
  frames_until_empty();
  EXPECT_EQ(clicks_, 3);
  EXPECT_EQ(double_clicks_, 0);
}

TEST_F(ImGuiInputTest, DoesNotClickWhenTheFocusIsLost) {
  queue_.push(MouseMove{button_});
  queue_.push(MouseButton{0, true});
  queue_.push(FocusLost{});
  frames_until_empty();
  EXPECT_EQ(clicks_, 0);
  click(button_);
  frames_until_empty();
  EXPECT_EQ(clicks_, 1);
}

TEST_F(ImGuiInputTest, TypesAndEditsText) {
  click(field_);
  for (const char32_t c : U"0.25x") {
    if (c) queue_.push(Character{c});
  }
  queue_.push(KeyChange{Key::backspace, true});
  queue_.push(KeyChange{Key::backspace, false});
  queue_.push(Character{U'7'});
  frames_until_empty();
  EXPECT_STREQ(text_, "0.257");
  queue_.push(KeyChange{Key::left_ctrl, true, k_ctrl});
  queue_.push(KeyChange{Key::a, true, k_ctrl});
  queue_.push(KeyChange{Key::a, false, k_ctrl});
  queue_.push(KeyChange{Key::left_ctrl, false});
  queue_.push(Character{U'1'});
  frames_until_empty();
  EXPECT_STREQ(text_, "1");
}

}  // namespace
}  // namespace glint::gui
