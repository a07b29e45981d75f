#pragma once
// Action scripts, as text and as steps. One action a line; blank lines and lines that begin with '#' are passed over:
//
//   open PATH                a preset, image or recipe            type TEXT          into what has the keyboard
//   preset NAME              by name or file                      wait jobs          until nothing is computed
//   set FIELD VALUE          VALUE as the command line has it     wait FRAMES
//   click WIDGET             likewise double-click, right-click   shot PNG           the whole window
//   hover WIDGET                                                  export WHAT PATH
//   map-click X,Y            texel position u                     expect FIELD VALUE [TOLERANCE]
//   drag WIDGET DX,DY        in pixels, y down                    action NAME        of gui/input/actions.h
//   scroll WIDGET DY         notches of the wheel; up is positive
//   key CHORD                "Ctrl+Shift+S"
//   hold CHORD, release CHORD
//
// PATH, NAME, TEXT and the value of a text field reach to the end of their line; relative paths start at the current
// folder, as on the command line. Pure functions; any thread.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "core/document/parameter.h"
#include "core/math/result.h"
#include "gui/input/chord.h"

namespace glint::gui {

namespace step {

struct Open {
  std::filesystem::path path;
};
struct OpenPreset {
  std::string name;
};
struct Set {
  const Parameter* parameter;
  ParameterValue value;
};
enum class Gesture { hover, click, double_click, right_click };
struct Point {
  std::string widget;
  Gesture gesture;
};
struct ClickMap {
  glm::dvec2 texel;
};
struct Drag {
  std::string widget;
  glm::dvec2 by;  ///< pixels
};
struct Scroll {
  std::string widget;
  double notches;
};
enum class KeyGesture { press, hold, release };
struct PressKey {
  Chord chord;
  KeyGesture gesture;
};
struct Type {
  std::u32string text;
};
struct WaitForJobs {};
struct WaitFrames {
  int count;
};
struct Shot {
  std::filesystem::path path;
};
struct Export {
  std::string what;
  std::filesystem::path path;
};
struct Expect {
  const Parameter* parameter;
  ParameterValue value;
  double tolerance = 0;  ///< of each number
};
struct RunAction {
  std::string name;
};

}  // namespace step

using StepAction = std::variant<step::Open, step::OpenPreset, step::Set, step::Point, step::ClickMap, step::Drag,
                                step::Scroll, step::PressKey, step::Type, step::WaitForJobs, step::WaitFrames,
                                step::Shot, step::Export, step::Expect, step::RunAction>;

struct ScriptStep {
  int line = 1;
  StepAction action;
};

struct Script {
  std::string subject;  ///< the file, for errors
  std::vector<ScriptStep> steps;
};

/// The steps of a script's text, or the first fault as a request error whose subject is "subject:line". Fields, their
/// values, chords and numbers are checked here; names of widgets, presets and actions when they are used.
Result<Script> parse_script(std::string_view text, const std::string& subject);

/// Reads and parses a file of at most 1 MiB.
Result<Script> load_script(const std::filesystem::path& file);

}  // namespace glint::gui
