#pragma once
// Runs an action script on the application, a little in each frame, with the events a person would cause. Main thread.

#include <deque>
#include <functional>
#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/document/document.h"
#include "core/document/parameter.h"
#include "core/math/result.h"
#include "gui/input/input.h"
#include "gui/input/script.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

/// What a script can do to the application, which implements it. All of it is called from ScriptRunner::step().
class ScriptTarget {
 public:
  virtual ~ScriptTarget() = default;

  /// Begins to open a file; see opening().
  virtual Status open(const std::filesystem::path& path) = 0;
  /// Begins to open a preset, by name or file.
  virtual Status open_preset(const std::string& name) = 0;
  /// True while what was opened last is on its way; an error if that failed.
  virtual Result<bool> opening() = 0;

  [[nodiscard]] virtual const Document& document() const = 0;
  /// As one edit, which can be undone. The value is as Parameter::checked gives it.
  virtual Status set(const Parameter& parameter, const ParameterValue& value) = 0;

  /// Of the newest whole frame.
  [[nodiscard]] virtual const view::WidgetRecord& widgets() const = 0;
  /// Scrolls what holds a widget of the record so that its centre can be clicked. True where it had to scroll: the
  /// widget then stands elsewhere in a later frame.
  virtual Result<bool> bring_to_view(const std::string& widget) = 0;
  /// Where a texel position u of the map is on screen, if it can be clicked there.
  [[nodiscard]] virtual std::optional<ImVec2> map_position(glm::dvec2 texel) const = 0;
  virtual InputQueue& input() = 0;

  /// Whether nothing is being computed or waits to be.
  [[nodiscard]] virtual bool jobs_idle() const = 0;
  /// Writes the newest whole frame as PNG.
  virtual Status shot(const std::filesystem::path& path) = 0;
  /// Writes what a menu entry exports, before it returns.
  virtual Status export_to(const std::string& what, const std::filesystem::path& path) = 0;
  /// Empty, or why the action did not run: Actions::run.
  virtual std::string run_action(const std::string& name) = 0;
};

struct ScriptProgress {
  enum class State { running, finished, failed };
  State state = State::running;
  std::optional<Error> error;  ///< if failed; its subject is "file:line"
};

class ScriptRunner {
 public:
  /// `seconds` is the time that limits are held against; by default the steady clock's.
  ScriptRunner(Script script, ScriptTarget& target, std::function<double()> seconds = {});
  ScriptRunner(const ScriptRunner&) = delete;
  ScriptRunner& operator=(const ScriptRunner&) = delete;

  /// Once a frame, before InputQueue::feed. When it has finished or failed it stays so, and what it
  /// held is on its way up: go on feeding the queue.
  ScriptProgress step();

 private:
  /// What is left of one piece of a step after it ran in a frame.
  enum class Rest {
    again,    ///< it goes on in the next frame
    frame,    ///< done; what follows waits for the next frame
    nothing,  ///< done; what follows may run in this frame
  };
  using Piece = std::function<Result<Rest>()>;

  void plan(const step::Open& action);
  void plan(const step::OpenPreset& action);
  void plan(const step::Set& action);
  void plan(const step::Point& action);
  void plan(const step::ClickMap& action);
  void plan(const step::Drag& action);
  void plan(const step::Scroll& action);
  void plan(const step::PressKey& action);
  void plan(const step::Type& action);
  void plan(const step::WaitForJobs& action);
  void plan(const step::WaitFrames& action);
  void plan(const step::Shot& action);
  void plan(const step::Export& action);
  void plan(const step::Expect& action);
  void plan(const step::RunAction& action);

  void then(Piece piece) { plan_.push_back(std::move(piece)); }
  void then_do(std::function<Status()> work);
  void then_button(int button, bool is_down, bool never_double = true);
  void then_click(int button, bool never_double = true);
  void then_settle(int frames);
  void then_aim(const std::string& widget, bool must_be_enabled);
  void then_wait(std::string what, std::function<Result<bool>()> is_done);
  void then_wait_until_open();

  void press(Chord chord);
  void release(Chord chord);
  void release_everything();
  [[nodiscard]] Modifiers modifiers() const;
  [[nodiscard]] std::string no_such_widget(const std::string& widget) const;

  Script script_;
  ScriptTarget& target_;
  std::function<double()> seconds_;
  std::size_t next_ = 0;  // step of the script
  int line_ = 0;          // of the step that runs
  std::deque<Piece> plan_;
  std::vector<Chord> held_;
  ImVec2 aim_{0, 0};  // where the mouse was moved last
  ScriptProgress progress_;
};

}  // namespace glint::gui
