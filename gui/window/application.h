#pragma once
// The program as a person meets it, in a window or headless: frames, keys, actions, dialogs, and what scripts may do.
// Main thread.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "gui/dialogs/overlays.h"
#include "gui/input/actions.h"
#include "gui/input/input.h"
#include "gui/input/script_runner.h"
#include "gui/memory/workbench.h"
#include "gui/window/exporter.h"
#include "gui/window/layout.h"
#include "gui/window/panels.h"
#include "viewers/screen.h"

namespace glint::gui {

/// What an application needs from where it runs.
struct ApplicationSetup {
  Workbench::Places places;
  bool headless = false;
  float scale = 1;                     ///< where the settings do not say otherwise
  std::function<void()> wake = [] {};  ///< from background threads: there is something new
  std::function<void(const std::string&)> set_clipboard = [](const std::string&) {};
  std::function<std::string()> clipboard = [] { return std::string(); };
};

class Application final : public ScriptTarget {
 public:
  static Result<std::unique_ptr<Application>> create(view::GlContext& context, ApplicationSetup setup);
  ~Application() override;

  [[nodiscard]] Workbench& workbench() { return workbench_; }
  [[nodiscard]] const Workbench& workbench() const { return workbench_; }
  [[nodiscard]] const Actions& actions() const { return actions_; }
  [[nodiscard]] Panels& panels() { return panels_; }
  [[nodiscard]] view::Screen& screen() { return *screen_; }
  InputQueue& input() override { return input_; }

  /// Runs a script from the next frame on.
  void start_script(Script script);
  [[nodiscard]] const std::optional<ScriptProgress>& script_progress() const { return script_progress_; }

  /// Draws one frame; screen().show() brings it to the window.
  void frame(glm::ivec2 size, double seconds, float step);
  /// How soon the next frame is wanted.
  enum class Pace {
    at_once,   ///< something moves under the hand
    soon,      ///< jobs make progress: some ten times a second
    on_event,  ///< nothing changes by itself
  };
  [[nodiscard]] Pace pace() const;
  /// True once the program may end: a person asked for it and nothing unsaved is lost against their will.
  [[nodiscard]] bool ended() const { return ended_; }
  void request_end();
  /// What the mouse is over asks for this shape.
  enum class MouseShape { arrow, text, hand, resize_horizontal };
  [[nodiscard]] MouseShape mouse_shape() const { return mouse_shape_; }

  // What actions do; each is one entry of the registry (application_actions.cpp).
  void undo();
  void redo();
  void save();
  void copy_values();
  void escape();
  void move_focus(bool backwards);
  void focus_panel(int step);
  void move_footprint(glm::dvec2 texels);
  void scale_footprint(double factor);
  void turn_footprint(double radians);
  void set_ui_scale(double scale);  ///< 0: automatic
  [[nodiscard]] double ui_scale() const { return screen_->scale(); }
  void toggle_maximised(Panel panel);
  void go_to_field(const std::string& path);
  void export_panel(Panel panel);
  [[nodiscard]] Overlays& overlays() { return overlays_; }
  [[nodiscard]] bool& flip_switch() { return flip_switch_; }
  /// Keeps what the registry's callbacks stand on for as long as the registry lives.
  void keep(std::shared_ptr<void> registrar) { registrars_.push_back(std::move(registrar)); }

  // ScriptTarget
  Status open(const std::filesystem::path& path) override;
  Status open_preset(const std::string& name) override;
  Result<bool> opening() override { return workbench_.opening(); }
  [[nodiscard]] const Document& document() const override { return workbench_.document(); }
  Status set(const Parameter& parameter, const ParameterValue& value) override;
  [[nodiscard]] const view::WidgetRecord& widgets() const override { return screen_->widgets(); }
  Result<bool> bring_to_view(const std::string& widget) override;
  [[nodiscard]] std::optional<ImVec2> map_position(glm::dvec2 texel) const override;
  [[nodiscard]] bool jobs_idle() const override { return workbench_.jobs().idle(); }
  Status shot(const std::filesystem::path& path) override;
  Status export_to(const std::string& what, const std::filesystem::path& path) override;
  std::string run_action(const std::string& name) override;

 private:
  explicit Application(ApplicationSetup setup);

  void feed_keys();
  void feed_chord(const Chord& chord);
  void draw(view::Ui& ui);
  void draw_splitters(view::Ui& ui, const Layout& layout);
  void draw_status(view::Ui& ui, const Layout& layout);
  void grant(PanelWishes wishes);
  void grant(OverlayWishes wishes);
  void after_drawing();
  [[nodiscard]] ExportSource export_source() const;

  ApplicationSetup setup_;
  Workbench workbench_;
  std::vector<std::shared_ptr<void>> registrars_;
  Actions actions_;
  InputQueue input_;
  Panels panels_;
  AboutFacts about_;
  std::unique_ptr<view::Screen> screen_;
  Overlays overlays_;
  std::optional<ScriptRunner> script_;
  std::optional<ScriptProgress> script_progress_;
  std::vector<ExportOrder> exports_;  // to be written once a frame without dialogs was drawn
  std::vector<std::uint8_t> pixels_;  // of the last frame, while something wants them
  glm::ivec2 size_{0, 0};
  Layout layout_;
  double seconds_ = 0;
  double frame_ms_ = 0;
  std::string wanted_action_;  // chosen while drawing, run after the frame
  std::size_t first_overlay_widget_ = 0;
  std::optional<float> wanted_scale_;
  bool flip_switch_ = false;
  bool arrows_move_footprint_ = false;  // a gesture of held arrow keys goes on
  bool input_left_ = false;
  bool end_requested_ = false;
  bool ended_ = false;
  MouseShape mouse_shape_ = MouseShape::arrow;
};

/// Fills the registry: every action of the window, with its chord and tooltip.
void add_actions(Actions& actions, Application& application);

}  // namespace glint::gui
