// glintscope [PRESET|IMAGE]: the window.

#include <chrono>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/document/preset.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"
#include "gui/commandline/opening.h"
#include "gui/memory/user_folders.h"
#include "gui/platform/window.h"
#include "gui/window/application.h"

namespace glint::gui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double k_wait = 0.05;                   // seconds; short, so that Ctrl-C in a terminal is heard
constexpr std::chrono::milliseconds k_frame(16);  // sixty a second, also on displays that could show more
constexpr int k_settling_frames = 3;              // what appears is laid out in one frame and drawn in the next

Workbench::Places places_of_this_user(bool remember) {
  Workbench::Places places;
  places.preset_folders = preset_folders(executable_path());
  if (const auto config = config_folder()) {
    places.user_presets = *config / "presets";
    places.preset_folders.push_back(*places.user_presets);
    if (remember) places.config_folder = config;
  }
  if (remember) places.state_folder = state_folder();
  return places;
}

Window::Cursor cursor_of(Application::MouseShape shape) {
  switch (shape) {
    case Application::MouseShape::text:
      return Window::Cursor::text;
    case Application::MouseShape::hand:
      return Window::Cursor::hand;
    case Application::MouseShape::resize_horizontal:
      return Window::Cursor::resize_horizontal;
    case Application::MouseShape::arrow:
      break;
  }
  return Window::Cursor::arrow;
}

// Frames until the program ends.
class WindowLoop {
 public:
  WindowLoop(Window& window, Application& application, const JobControl& control)
      : window_(window), application_(application), control_(control) {}

  Status run() {
    int frames_left = k_settling_frames;
    while (!application_.ended() && !script_ended_ && !control_.cancelled()) {
      const Application::Pace pace = application_.pace();
      const bool hurry = !window_.minimised() && (pace == Application::Pace::at_once || frames_left > 0);
      const bool happened = hurry ? poll_until_next_frame() : window_.poll(k_wait);
      frames_left = happened ? k_settling_frames : std::max(0, frames_left - 1);
      if (window_.close_requested()) {
        window_.refuse_close();
        application_.request_end();
      }
      if (window_.minimised() || (!hurry && !happened && pace == Application::Pace::on_event)) continue;
      draw();
      if (Status played = script_state(); !played) return played;
    }
    return success();
  }

 private:
  // A window that nothing changed in is not shown again, so nothing else slows the frames down. True if something
  // happened meanwhile.
  bool poll_until_next_frame() {
    const Clock::time_point next = last_ + k_frame;
    bool happened = window_.poll(0);
    for (Clock::time_point now = Clock::now(); now < next; now = Clock::now()) {
      happened = window_.poll(std::chrono::duration<double>(next - now).count()) || happened;
    }
    return happened;
  }

  void draw() {
    const Clock::time_point now = Clock::now();
    const float step = std::chrono::duration<float>(now - last_).count();
    last_ = now;
    application_.frame(window_.size(), std::chrono::duration<double>(now - begin_).count(), step);
    if (application_.screen().show(window_.take_exposure())) window_.swap();
    window_.set_cursor(cursor_of(application_.mouse_shape()));
    const std::string title = application_.workbench().title() + " – Glintscope";
    if (title != title_) window_.set_title(title_ = title);
    Settings& settings = application_.workbench().settings();
    settings.maximised = window_.maximised();
    if (!settings.maximised) settings.window_size = window_.size();
  }

  // A script that has ended ends the program.
  Status script_state() {
    const auto& progress = application_.script_progress();
    if (!progress || progress->state == ScriptProgress::State::running) return success();
    if (progress->error) return *progress->error;
    script_ended_ = true;
    return success();
  }

  Window& window_;
  Application& application_;
  const JobControl& control_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  std::string title_;
  bool script_ended_ = false;
};

class WindowCommand final : public Command {
 public:
  explicit WindowCommand(CLI::App& app) {
    add_words_option(app, document_, "DOCUMENT", "PRESET|IMAGE",
                     "Open the window on a preset, an EXR with a recipe, or a map. Default: the last session, else the "
                     "preset scratched-steel.");
    add_words_option(app, script_, "--script", "FILE",
                     "Play an action script in the window, then end; nothing is remembered.");
  }

  [[nodiscard]] bool chosen() const override { return true; }  // what is left when no subcommand was named

  Status run(JobControl& control) override {
    std::optional<Script> script;
    if (script_.given()) {
      Result<Script> read = load_script(script_.words);
      if (!read) return read.error();
      script = std::move(*read);
    }
    if (document_.given()) {
      if (const Result<std::filesystem::path> file = named_document(document_.words); !file) return file.error();
    }
    Workbench::Places places = places_of_this_user(!script);
    Settings settings;
    if (places.config_folder) settings = load_settings(*places.config_folder).settings;
    Result<std::unique_ptr<Window>> window = make_glfw_window(settings.window_size, settings.maximised, "Glintscope");
    if (!window) {
      Error error = window.error();
      error.sentence +=
          "; without one, `glintscope screenshot -o window.png` draws it into a file, and the other "
          "commands work as ever";
      return error;
    }
    return show(**window, std::move(places), std::move(script), control);
  }

 private:
  Status show(Window& window, Workbench::Places places, std::optional<Script> script, JobControl& control) {
    const BackgroundPriority smooth;  // frames come before jobs
    ApplicationSetup setup;
    setup.places = std::move(places);
    setup.scale = window.content_scale();
    setup.wake = [&window] { window.wake(); };
    setup.set_clipboard = [&window](const std::string& text) { window.set_clipboard(text); };
    setup.clipboard = [&window] { return window.clipboard(); };
    Result<std::unique_ptr<Application>> application = Application::create(window, std::move(setup));
    if (!application) return application.error();
    window.listen((*application)->input());
    if (document_.given()) {
      if (Status opened = open_document(**application, document_.words); !opened) return opened;
    } else if (!(*application)->workbench().resume_session()) {
      if (Status opened = open_document(**application, "scratched-steel"); !opened) return opened;
    }
    if (script) (*application)->start_script(std::move(*script));
    Status ended = WindowLoop(window, **application, control).run();
    (*application)->workbench().end();
    return ended;
  }

  WordsOption document_;
  WordsOption script_;
};

}  // namespace

std::unique_ptr<Command> add_window_command(CLI::App& app) {
  return std::make_unique<WindowCommand>(app);
}

}  // namespace glint::gui
