// glintscope screenshot: the whole window without a display, after an optional action script.

#include <charconv>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/document/preset.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"
#include "gui/commandline/opening.h"
#include "gui/platform/headless.h"

namespace glint::gui {
namespace {

constexpr int k_largest_side = 8192;

Result<glm::ivec2> window_size(const std::string& words) {
  glm::ivec2 size{0, 0};
  const char* end = words.data() + words.size();
  const auto [at, fault] = std::from_chars(words.data(), end, size.x);
  const bool split = fault == std::errc() && at != end && *at == 'x';
  const auto [stop, second] = split ? std::from_chars(at + 1, end, size.y) : std::from_chars_result{at, std::errc()};
  const bool whole = split && second == std::errc() && stop == end;
  if (!whole || size.x < 320 || size.y < 200 || size.x > k_largest_side || size.y > k_largest_side) {
    return request_error("--size", fmt::format("'{}' is not WIDTHxHEIGHT in pixels, from 320x200 to {}x{}", words,
                                               k_largest_side, k_largest_side));
  }
  return size;
}

class ScreenshotCommand final : public Command {
 public:
  explicit ScreenshotCommand(CLI::App& app)
      : app_(*app.add_subcommand("screenshot", "Draw the whole window without a display, after an action script.")) {
    add_words_option(app_, document_, "DOCUMENT", "PRESET|IMAGE",
                     "What to open: a preset by name or file, an EXR with a recipe, or a map. Default: the preset "
                     "scratched-steel.");
    add_words_option(app_, size_, "--size", "WxH", "Pixels of the window. Default: 1600x1000.");
    add_words_option(app_, scale_, "--scale", "F", "How large the interface is drawn, from 0.5 to 4. Default: 1.");
    add_words_option(app_, script_, "--script", "FILE", "An action script, one action a line.");
    add_words_option(app_, output_, "-o,--output", "OUT.png", "Write the window as it is at the end.");
    app_.add_flag("--quiet", quiet_, "No messages; errors are still printed.");
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  Status run(JobControl& control) override {
    const Result<glm::ivec2> size = size_.given() ? window_size(size_.words) : glm::ivec2(1600, 1000);
    if (!size) return size.error();
    const Result<float> scale = interface_scale();
    if (!scale) return scale.error();
    if (!output_.given() && !script_.given()) {
      return request_error("", "nothing to do: give -o OUT.png or --script FILE");
    }
    std::optional<Script> script;
    if (script_.given()) {
      Result<Script> read = load_script(script_.words);
      if (!read) return read.error();
      script = std::move(*read);
    }
    if (output_.given()) {
      if (Status writable = check_output(output_.words, {}, {".png"}); !writable) return writable;
    }
    Workbench::Places places;
    places.preset_folders = preset_folders(executable_path());
    Result<std::unique_ptr<HeadlessWindow>> window = HeadlessWindow::create(*size, *scale, std::move(places));
    if (!window) return window.error();
    return play(**window, std::move(script), control);
  }

 private:
  [[nodiscard]] Result<float> interface_scale() const {
    if (!scale_.given()) return 1.0F;
    float scale = 0;
    const char* end = scale_.words.data() + scale_.words.size();
    const auto [stop, fault] = std::from_chars(scale_.words.data(), end, scale);
    if (fault != std::errc() || stop != end || !(scale >= 0.5F && scale <= 4)) {
      return request_error("--scale", fmt::format("'{}' is not a number from 0.5 to 4", scale_.words));
    }
    return scale;
  }

  Status play(HeadlessWindow& window, std::optional<Script> script, JobControl& control) {
    Application& application = window.application();
    if (Status opened = open_document(application, document_.given() ? document_.words : "scratched-steel"); !opened) {
      return opened;
    }
    while (true) {
      window.frame();
      const Result<bool> opening = application.opening();
      if (!opening) return opening.error();
      if (!*opening) break;
      if (control.cancelled()) return content_error("", "cancelled");
    }
    if (script) {
      if (Status played = window.run_script(std::move(*script), control); !played) return played;
    }
    if (!output_.given()) return success();
    if (Status settled = window.settle(control); !settled) return settled;
    Status written = application.shot(output_.words);
    if (written) print_message(quiet_, "wrote " + output_.words);
    return written;
  }

  CLI::App& app_;
  WordsOption document_;
  WordsOption size_;
  WordsOption scale_;
  WordsOption script_;
  WordsOption output_;
  bool quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> add_screenshot_command(CLI::App& app) {
  return std::make_unique<ScreenshotCommand>(app);
}

}  // namespace glint::gui
