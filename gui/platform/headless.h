#pragma once
// The window without a display: the same application, drawn by OSMesa with steady time steps. For screenshots, scripts
// and tests. Main thread.

#include <memory>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "gui/window/application.h"
#include "viewers/gl/gl_context.h"

namespace glint::gui {

class HeadlessWindow {
 public:
  /// Remembers nothing and reads no settings; `places` beyond the presets are for tests.
  static Result<std::unique_ptr<HeadlessWindow>> create(glm::ivec2 size, float scale, Workbench::Places places);
  ~HeadlessWindow();

  [[nodiscard]] Application& application() { return *application_; }
  /// What was last copied.
  [[nodiscard]] std::string& clipboard() { return *clipboard_; }
  [[nodiscard]] const view::GlFunctions& gl() const { return context_->gl(); }

  /// One frame, a sixtieth of a second after the last. `rests`: then leaves the processor to the jobs for a moment, if
  /// they work.
  void frame(bool rests = true);
  /// Frames until the jobs are done and what they made has been drawn. An error when `control` was cancelled.
  Status settle(JobControl& control);
  /// Frames until the script has ended.
  Status run_script(Script script, JobControl& control);

 private:
  HeadlessWindow() : clipboard_(std::make_shared<std::string>()) {}

  std::shared_ptr<std::string> clipboard_;
  std::unique_ptr<view::GlContext> context_;
  std::unique_ptr<Application> application_;
  double seconds_ = 0;
};

}  // namespace glint::gui
