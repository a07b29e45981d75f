#include "gui/platform/headless.h"

#include <chrono>
#include <thread>
#include <utility>

#include "gui/platform/osmesa_context.h"

namespace glint::gui {
namespace {

constexpr float k_step = 1.0F / 60;
constexpr int k_settling_frames = 4;  // what appears is laid out in one frame and drawn in the next

}  // namespace

Result<std::unique_ptr<HeadlessWindow>> HeadlessWindow::create(glm::ivec2 size, float scale, Workbench::Places places) {
  Result<std::unique_ptr<view::GlContext>> context = make_osmesa_context(size);
  if (!context) return context.error();
  std::unique_ptr<HeadlessWindow> made(new HeadlessWindow());
  made->context_ = std::move(*context);
  ApplicationSetup setup;
  setup.places = std::move(places);
  setup.headless = true;
  setup.scale = scale;
  setup.set_clipboard = [clipboard = made->clipboard_](const std::string& text) { *clipboard = text; };
  setup.clipboard = [clipboard = made->clipboard_] { return *clipboard; };
  Result<std::unique_ptr<Application>> application = Application::create(*made->context_, std::move(setup));
  if (!application) return application.error();
  made->application_ = std::move(*application);
  return made;
}

HeadlessWindow::~HeadlessWindow() = default;

void HeadlessWindow::frame(bool rests) {
  seconds_ += k_step;
  application_->frame(context_->size(), seconds_, k_step);
  // Drawing takes the processor from the jobs, and nobody watches.
  if (rests && !application_->jobs_idle()) std::this_thread::sleep_for(std::chrono::milliseconds(40));
}

Status HeadlessWindow::settle(JobControl& control) {
  int settled = 0;
  while (settled < k_settling_frames) {
    frame();
    settled = application_->jobs_idle() ? settled + 1 : 0;
    if (control.cancelled()) return content_error("", "cancelled");
  }
  return success();
}

Status HeadlessWindow::run_script(Script script, JobControl& control) {
  application_->start_script(std::move(script));
  while (application_->script_progress()->state == ScriptProgress::State::running) {
    frame();
    if (control.cancelled()) return content_error("", "cancelled");
    if (application_->ended()) break;
  }
  const ScriptProgress& progress = *application_->script_progress();
  if (progress.error) return *progress.error;
  return success();
}

}  // namespace glint::gui
