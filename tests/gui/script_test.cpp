#include "gui/input/script.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/input/script_runner.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Script parsed(const std::string& text) {
  Result<Script> script = parse_script(text, "demo.txt");
  EXPECT_TRUE(script) << script.error().message();
  return script ? std::move(*script) : Script{"demo.txt", {}};
}

std::string fault_of(const std::string& text) {
  const Result<Script> script = parse_script(text, "demo.txt");
  if (script) return "none";
  EXPECT_EQ(script.error().kind, ErrorKind::request);
  return script.error().message();
}

template <class Action>
Action only(const std::string& text) {
  const Script script = parsed(text);
  EXPECT_EQ(script.steps.size(), 1U) << text;
  const Action* action = script.steps.empty() ? nullptr : std::get_if<Action>(&script.steps[0].action);
  EXPECT_TRUE(action) << text;
  return action ? *action : Action{};
}

TEST(Script, PassesOverCommentsAndBlankLinesButCountsThem) {
  const Script script = parsed("# a comment\r\n\r\n  \t\n  wait jobs \r\n  # another\nshot a.png");
  ASSERT_EQ(script.steps.size(), 2U);
  EXPECT_EQ(script.steps[0].line, 4);
  EXPECT_EQ(script.steps[1].line, 6);
  EXPECT_TRUE(parsed("").steps.empty());
}

TEST(Script, ReadsEveryAction) {
  EXPECT_EQ(only<step::Open>("open my maps/a b.png").path, "my maps/a b.png");
  EXPECT_EQ(only<step::OpenPreset>("preset scratched-steel").name, "scratched-steel");
  EXPECT_EQ(only<step::Point>("click pndf.scale.log").gesture, step::Gesture::click);
  EXPECT_EQ(only<step::Point>("double-click a").gesture, step::Gesture::double_click);
  EXPECT_EQ(only<step::Point>("right-click a").gesture, step::Gesture::right_click);
  EXPECT_EQ(only<step::Point>("hover  a").widget, "a");
  EXPECT_EQ(only<step::ClickMap>("map-click 512.5,-3e1").texel, glm::dvec2(512.5, -30));
  EXPECT_EQ(only<step::Drag>("drag a -40,0").by, glm::dvec2(-40, 0));
  EXPECT_EQ(only<step::Scroll>("scroll a -2.5").notches, -2.5);
  EXPECT_EQ(only<step::PressKey>("key Ctrl+Shift+S").chord, (Chord{Key::s, true, true}));
  EXPECT_EQ(only<step::PressKey>("hold Shift").gesture, step::KeyGesture::hold);
  EXPECT_EQ(only<step::PressKey>("release Shift").gesture, step::KeyGesture::release);
  EXPECT_EQ(only<step::Type>("type  # aß€😀 b ").text, U"# aß€😀 b");
  only<step::WaitForJobs>("wait jobs");
  EXPECT_EQ(only<step::WaitFrames>("wait 12").count, 12);
  EXPECT_EQ(only<step::Shot>("shot out/a b.png").path, "out/a b.png");
  EXPECT_EQ(only<step::Export>("export pndf a.exr").what, "pndf");
  EXPECT_EQ(only<step::Export>("export pndf a.exr").path, "a.exr");
  EXPECT_EQ(only<step::RunAction>("action file.open").name, "file.open");
}

TEST(Script, ReadsValuesAsTheCommandLineDoes) {
  const auto set = only<step::Set>("set footprint.center 8,32.5");
  EXPECT_EQ(set.parameter, find_parameter("footprint.center"));
  EXPECT_EQ(set.value, ParameterValue(std::vector<double>{8, 32.5}));
  EXPECT_EQ(only<step::Set>("set binning.samples 1e7").value, ParameterValue(std::uint64_t{10000000}));
  EXPECT_EQ(only<step::Set>("set methods exact,binning").value,
            ParameterValue(std::vector<std::string>{"exact", "binning"}));
  EXPECT_EQ(only<step::Set>("set grid.window fit").value, ParameterValue(std::string("fit")));
  EXPECT_EQ(only<step::Set>("set surface.path my maps/a.png").value, ParameterValue(std::string("my maps/a.png")));
  EXPECT_EQ(only<step::Set>("set surface.path").value, ParameterValue(std::string()));
  const auto expect = only<step::Expect>("expect intrinsic_roughness 0.02 1e-3");
  EXPECT_EQ(expect.value, ParameterValue(0.02));
  EXPECT_EQ(expect.tolerance, 1e-3);
  EXPECT_EQ(only<step::Expect>("expect seed 1").tolerance, 0);
}

TEST(Script, NamesTheLineOfAFault) {
  EXPECT_EQ(
      fault_of("wait jobs\n\nclik a"),
      "demo.txt:3: 'clik' is no action; the nearest is 'click' of open, preset, set, click, double-click, "
      "right-click, hover, map-click, drag, scroll, key, hold, release, type, wait, shot, export, expect, action");
  EXPECT_EQ(fault_of("click"), "demo.txt:1: click: WIDGET is missing");
  EXPECT_EQ(fault_of("click a b c"), "demo.txt:1: click: 'b c' is more than it takes");
  EXPECT_EQ(fault_of("open"), "demo.txt:1: open: PATH is missing");
  EXPECT_EQ(fault_of("export pndf"), "demo.txt:1: export: PATH is missing");
  EXPECT_EQ(fault_of("export"), "demo.txt:1: export: WHAT is missing");
  EXPECT_EQ(fault_of("drag a 3"), "demo.txt:1: drag: '3' is not DX,DY, two numbers");
  EXPECT_EQ(fault_of("drag a 3,4,5"), "demo.txt:1: drag: '3,4,5' is not DX,DY, two numbers");
  EXPECT_EQ(fault_of("map-click nan,1"), "demo.txt:1: map-click: 'nan,1' is not X,Y, two numbers");
  EXPECT_EQ(fault_of("scroll a up"), "demo.txt:1: scroll: 'up' is not DY, a number");
  EXPECT_EQ(fault_of("key Strg+S"), "demo.txt:1: key: 'Strg+S' is no key; expected for example S, Ctrl+Shift+S or F1");
  EXPECT_EQ(fault_of("wait 0"), "demo.txt:1: wait: '0' is neither 'jobs' nor a number of frames from 1 to 100000");
  EXPECT_EQ(fault_of("wait"), "demo.txt:1: wait: jobs or FRAMES is missing");
  EXPECT_EQ(fault_of("type \xFF"), "demo.txt:1: is not UTF-8 text");
}

TEST(Script, NamesTheFieldOfAFault) {
  EXPECT_EQ(fault_of("set sigma_r 0.1"),
            "demo.txt:1: set: field 'sigma_r' is unknown; the nearest field is 'intrinsic_roughness'");
  EXPECT_EQ(fault_of("set"), "demo.txt:1: set: FIELD is missing");
  EXPECT_EQ(fault_of("set seed"), "demo.txt:1: set: VALUE is missing");
  EXPECT_THAT(fault_of("set intrinsic_roughness 2"),
              HasSubstr("demo.txt:1: set: field 'intrinsic_roughness' is 2; allowed:"));
  EXPECT_THAT(fault_of("expect seed 1 2 3"), HasSubstr("'3' is more than it takes"));
  EXPECT_THAT(fault_of("expect seed 1 -2"), HasSubstr("TOLERANCE is below 0"));
  EXPECT_THAT(fault_of("expect surface.wrap repeat 1"), HasSubstr("is no number and has no TOLERANCE"));
}

TEST(Script, IsReadFromAFile) {
  const TemporaryFolder folder;
  test::write_text(folder / "a.txt", "wait 1\nwat 2");
  EXPECT_EQ(load_script(folder / "a.txt").error().subject, (folder / "a.txt").string() + ":2");
  EXPECT_FALSE(load_script(folder / "none.txt"));
}

// An application of plain values that writes down what is done to it; its frames feed a queue of real input.
class FakeTarget : public ScriptTarget {
 public:
  Status open(const std::filesystem::path& path) override {
    log("open " + path.string());
    opening_frames = 3;
    return open_status;
  }
  Status open_preset(const std::string& name) override {
    log("preset " + name);
    return open_status;
  }
  Result<bool> opening() override {
    if (--opening_frames > 0) return true;
    return opened;
  }
  const Document& document() const override { return edited; }
  Status set(const Parameter& parameter, const ParameterValue& value) override { return parameter.set(edited, value); }
  const view::WidgetRecord& widgets() const override { return record; }
  Result<bool> bring_to_view(const std::string& widget) override {
    if (scrolls == 0) return false;
    if (scrolls < 0) return content_error("", "'" + widget + "' cannot be scrolled to");
    --scrolls;
    place(widget, {200, 200});
    return true;
  }
  std::optional<ImVec2> map_position(glm::dvec2 texel) const override {
    if (texel.x < 0) return std::nullopt;
    return ImVec2(static_cast<float>(texel.x) + 100, static_cast<float>(texel.y));
  }
  InputQueue& input() override { return queue; }
  bool jobs_idle() const override { return frame >= busy_until; }
  Status shot(const std::filesystem::path& path) override { return log("shot " + path.string()), success(); }
  Status export_to(const std::string& what, const std::filesystem::path& path) override {
    return log("export " + what + " " + path.string()), success();
  }
  std::string run_action(const std::string& name) override { return log("action " + name), action_reason; }

  void place(const std::string& name, ImVec2 corner, const std::string& reason = {}) {
    record.record(name, {.area = {corner, {corner.x + 20, corner.y + 10}}, .reason = reason});
  }
  void log(const std::string& line) { lines.push_back(std::to_string(frame) + " " + line); }

  view::WidgetRecord record;
  InputQueue queue;
  Document edited;
  Status open_status = success();
  Result<bool> opened = false;
  int opening_frames = 0;
  int scrolls = 0;
  int busy_until = 0;
  int frame = 0;
  std::string action_reason;
  std::vector<std::string> lines;
};

class ScriptRunnerTest : public ::testing::Test {
 protected:
  // Runs the script to its end or for 1000 frames; logs what the input did in each.
  ScriptProgress run(const std::string& text, double seconds_a_frame = 0.01) {
    ScriptRunner runner(parsed(text), target_, [&] { return seconds_a_frame * target_.frame; });
    ScriptProgress progress;
    for (int k = 0; k < 1000 && progress.state == ScriptProgress::State::running; ++k) {
      progress = runner.step();
      feed();
      each_frame_();
      ++target_.frame;
    }
    EXPECT_EQ(runner.step().state, progress.state);
    while (target_.queue.feed(io_)) {
    }
    for (const bool key : io_.KeysDown) EXPECT_FALSE(key);
    EXPECT_FALSE(io_.MouseDown[0] || io_.MouseDown[1] || io_.KeyShift || io_.KeyCtrl || io_.KeyAlt);
    return progress;
  }
  std::string error_of(const std::string& text, double seconds_a_frame = 0.01) {
    const ScriptProgress progress = run(text, seconds_a_frame);
    EXPECT_EQ(progress.state, ScriptProgress::State::failed);
    return progress.error ? progress.error->message() : "none";
  }
  void expect_finished(const std::string& text) {
    const ScriptProgress progress = run(text);
    EXPECT_EQ(progress.state, ScriptProgress::State::finished) << (progress.error ? progress.error->message() : "");
  }

  FakeTarget target_;
  ImGuiIO io_;
  std::function<void()> each_frame_ = [] {};

 private:
  void feed() {
    const ImVec2 before = io_.MousePos;
    const bool left = io_.MouseDown[0];
    const bool right = io_.MouseDown[1];
    target_.queue.feed(io_);
    if (before.x != io_.MousePos.x || before.y != io_.MousePos.y) {
      target_.log("move " + std::to_string(static_cast<int>(io_.MousePos.x)) + "," +
                  std::to_string(static_cast<int>(io_.MousePos.y)));
    }
    if (left != io_.MouseDown[0]) target_.log(left ? "left up" : "left down");
    if (right != io_.MouseDown[1]) target_.log(right ? "right up" : "right down");
    if (io_.MouseWheel != 0) target_.log("wheel " + std::to_string(static_cast<int>(io_.MouseWheel)));
    for (const Chord& chord : target_.queue.key_presses()) target_.log("key " + chord_text(chord));
    std::string typed;
    for (const ImWchar c : io_.InputQueueCharacters) typed += static_cast<char>(c);
    io_.InputQueueCharacters.clear();
    if (!typed.empty()) target_.log("text " + typed);
  }
};

TEST_F(ScriptRunnerTest, FinishesAnEmptyScriptAtOnce) {
  expect_finished("# nothing");
  EXPECT_EQ(target_.frame, 1);
}

TEST_F(ScriptRunnerTest, ClicksTheCentreOneChangeAFrame) {
  target_.place("a", {10, 10});
  expect_finished("click a\nright-click a\nhover a");
  EXPECT_THAT(target_.lines, ElementsAre("0 move 20,15", "1 left down", "2 left up", "6 right down", "7 right up"));
}

TEST_F(ScriptRunnerTest, DoubleClicksInFourFrames) {
  target_.place("a", {10, 10});
  expect_finished("double-click a");
  EXPECT_THAT(target_.lines, ElementsAre("0 move 20,15", "1 left down", "2 left up", "3 left down", "4 left up"));
}

TEST_F(ScriptRunnerTest, MakesDoubleClicksOnlyOfDoubleClicks) {
  target_.place("a", {10, 10});
  std::vector<bool> may_be_second;
  bool was_down = false;
  each_frame_ = [&] {
    if (io_.MouseDown[0] && !was_down) may_be_second.push_back(io_.MouseClickedTime[0] == 0);
    was_down = io_.MouseDown[0];
    io_.MouseClickedTime[0] = 0;
  };
  io_.MouseClickedTime[0] = 0;
  expect_finished("click a\nclick a\ndouble-click a");
  EXPECT_THAT(may_be_second, ElementsAre(false, false, false, true));
}

TEST_F(ScriptRunnerTest, WaitsForAWidgetToAppearBeEnabledAndRest) {
  each_frame_ = [&] {
    if (target_.frame == 4) target_.place("a", {0, 0}, "not yet");
    if (target_.frame == 9) target_.place("a", {0, 0});
    if (target_.frame == 10) target_.place("a", {0, 50});
  };
  expect_finished("click a");
  EXPECT_THAT(target_.lines, ElementsAre("10 move 10,5", "11 move 10,55", "12 left down", "13 left up"));
}

TEST_F(ScriptRunnerTest, BringsAWidgetToViewBeforeItIsClicked) {
  target_.place("a", {10, 1000});
  target_.scrolls = 1;
  expect_finished("click a");
  EXPECT_THAT(target_.lines, ElementsAre("1 move 210,205", "2 left down", "3 left up"));
  target_.scrolls = -1;
  EXPECT_EQ(error_of("click a"), "demo.txt:1: 'a' cannot be scrolled to");
  target_.scrolls = 1000;
  EXPECT_EQ(error_of("click a"), "demo.txt:1: 'a' does not come to rest");
}

TEST_F(ScriptRunnerTest, SaysWhichWidgetIsMissing) {
  EXPECT_EQ(error_of("wait 1\nclick a"), "demo.txt:2: there is no widget 'a'; the window shows none");
  target_.place("pndf.scale.log", {0, 0});
  target_.place("map", {0, 0});
  EXPECT_EQ(error_of("click pndf.scale"),
            "demo.txt:1: there is no widget 'pndf.scale'; the nearest is 'pndf.scale.log'");
}

TEST_F(ScriptRunnerTest, SaysWhyAWidgetIsDisabled) {
  target_.place("a", {0, 0}, "there is no map");
  EXPECT_EQ(error_of("click a"), "demo.txt:1: 'a' is disabled: there is no map");
  EXPECT_EQ(error_of("drag a 1,1"), "demo.txt:1: 'a' is disabled: there is no map");
  expect_finished("hover a\nscroll a 1");
}

TEST_F(ScriptRunnerTest, ClicksTexelsThatAreInView) {
  expect_finished("map-click 5.5,7");
  EXPECT_THAT(target_.lines, ElementsAre("0 move 105,7", "1 left down", "2 left up"));
  EXPECT_EQ(error_of("map-click -1,2"), "demo.txt:1: texel -1,2 is not in view");
}

TEST_F(ScriptRunnerTest, DragsInEightSteps) {
  target_.place("a", {10, 10});
  expect_finished("drag a 80,-16");
  EXPECT_THAT(target_.lines,
              ElementsAre("0 move 20,15", "1 left down", "2 move 30,13", "3 move 40,11", "4 move 50,9", "5 move 60,7",
                          "6 move 70,5", "7 move 80,3", "8 move 90,1", "9 move 100,-1", "10 left up"));
}

TEST_F(ScriptRunnerTest, ScrollsOverAWidget) {
  target_.place("a", {10, 10});
  expect_finished("scroll a -3");
  EXPECT_THAT(target_.lines, ElementsAre("0 move 20,15", "1 wheel -3"));
}

TEST_F(ScriptRunnerTest, PressesChordsWithTheirModifierKeys) {
  bool shift = false;
  each_frame_ = [&] { shift = shift || io_.KeyShift; };
  expect_finished("key Ctrl+Shift+S\nkey F1");
  EXPECT_TRUE(shift);
  EXPECT_THAT(target_.lines, ElementsAre("0 key Shift+Ctrl", "0 key Ctrl+Shift", "0 key Ctrl+Shift+S", "4 key F1"));
}

TEST_F(ScriptRunnerTest, HoldsKeysOverOtherSteps) {
  target_.place("a", {10, 10});
  std::vector<bool> shifts;
  each_frame_ = [&] {
    if (io_.MouseDown[0]) shifts.push_back(io_.KeyShift);
  };
  expect_finished("hold Shift\nkey Shift+X\nclick a\nrelease Shift\nclick a");
  EXPECT_THAT(shifts, ElementsAre(true, false));
  EXPECT_EQ(error_of("hold Ctrl+G\nrelease G"), "demo.txt:2: G is not held");
}

TEST_F(ScriptRunnerTest, ReleasesWhatAScriptLeavesHeld) {
  expect_finished("hold Ctrl+G\nhold Shift");  // run() expects that nothing is down
}

TEST_F(ScriptRunnerTest, TypesAFewCharactersAFrame) {
  expect_finished("type 0.123456789");
  EXPECT_THAT(target_.lines, ElementsAre("0 text 0.123456", "1 text 789"));
}

TEST_F(ScriptRunnerTest, WaitsUntilAFileIsOpen) {
  expect_finished("open a.png\nshot b.png\npreset steel\nexport pndf c.exr");
  EXPECT_THAT(target_.lines, ElementsAre("0 open a.png", "6 shot b.png", "7 preset steel", "11 export pndf c.exr"));
  target_.opened = content_error("a.png", "is no picture");
  EXPECT_EQ(error_of("open a.png"), "demo.txt:1: a.png: is no picture");
  target_.open_status = request_error("steel", "is no known preset");
  EXPECT_EQ(error_of("preset steel"), "demo.txt:1: steel: is no known preset");
}

TEST_F(ScriptRunnerTest, WaitsForJobsAndForFrames) {
  target_.busy_until = 20;
  expect_finished("wait jobs\naction a\nwait 5\naction b");
  EXPECT_THAT(target_.lines, ElementsAre("21 action a", "29 action b"));
}

TEST_F(ScriptRunnerTest, GivesUpWaitingForJobsAfterTwoMinutes) {
  target_.busy_until = 100000;
  EXPECT_EQ(error_of("wait jobs", 1.0), "demo.txt:1: what is computed did not end within 120 s");
  EXPECT_NEAR(target_.frame, 123, 2);
}

TEST_F(ScriptRunnerTest, SetsAndExpectsFields) {
  expect_finished(
      "set intrinsic_roughness 0.03\nexpect intrinsic_roughness 0.03\nexpect intrinsic_roughness 0.031 0.0011\n"
      "set footprint.center 8,32\nexpect footprint.center 8.5,31.5 0.5\nexpect grid.window fit\n"
      "set seed 12\nexpect seed 10 2\nexpect methods exact\nexpect surface.wrap repeat");
  EXPECT_EQ(target_.edited.intrinsic_roughness, 0.03);
  EXPECT_EQ(error_of("wait 1\nexpect intrinsic_roughness 0.02"),
            "demo.txt:2: field 'intrinsic_roughness': expected 0.02, is 0.03");
  EXPECT_EQ(error_of("expect footprint.center 8.5,31 0.5"),
            "demo.txt:1: field 'footprint.center': expected [8.5, 31], is [8, 32]");
  EXPECT_EQ(error_of("expect grid.window 0,1,0,1 5"),
            "demo.txt:1: field 'grid.window': expected [0, 1, 0, 1], is \"fit\"");
  EXPECT_EQ(error_of("expect seed 10 1"), "demo.txt:1: field 'seed': expected 10, is 12");
}

TEST_F(ScriptRunnerTest, SaysWhyAnActionDidNotRun) {
  target_.action_reason = "nothing to undo";
  EXPECT_EQ(error_of("action edit.undo\naction b"), "demo.txt:1: action 'edit.undo' did not run: nothing to undo");
  EXPECT_THAT(target_.lines, ElementsAre("0 action edit.undo"));
}

TEST_F(ScriptRunnerTest, ReleasesWhatIsHeldWhenItFails) {
  target_.action_reason = "no";
  error_of("hold Alt+G\naction b");  // run() expects that nothing is down
}

}  // namespace
}  // namespace glint::gui
