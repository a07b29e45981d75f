#pragma once
// The whole application without a display, for tests.

#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "gui/input/script.h"
#include "gui/platform/headless.h"
#include "tests/gui/golden.h"
#include "tests/temporary_folder.h"

namespace glint::test {

/// A small document whose P-NDF takes milliseconds.
inline constexpr std::string_view k_small_preset = R"({
  "glintscope": "preset", "version": 1, "name": "small",
  "surface": {"source": "noise", "generator": {"size": 128, "seed": 7, "rms_slope": 0.2, "wavelengths": [8, 32]}},
  "footprint": {"center": [64, 60], "covariance": [9, 3, 5]},
  "intrinsic_roughness": 0.03,
  "methods": ["exact", "binning"], "binning": {"samples": 200000}, "grid": {"size": 96}
})";

class ApplicationStage {
 public:
  explicit ApplicationStage(glm::ivec2 size = {1280, 720}, float scale = 1) {
    gui::Workbench::Places places;
    places.preset_folders = {std::filesystem::path(GLINTSCOPE_SOURCE_DIR) / "presets", folder.path() / "own"};
    places.user_presets = folder.path() / "own";
    std::filesystem::create_directories(*places.user_presets);
    auto made = gui::HeadlessWindow::create(size, scale, std::move(places));
    if (!made) throw std::runtime_error(made.error().message());
    window = std::move(*made);
    size_ = size;
  }

  [[nodiscard]] gui::Application& app() const { return window->application(); }
  [[nodiscard]] const Document& document() const { return app().document(); }
  [[nodiscard]] const view::WidgetRecord::Entry* widget(std::string_view name) const {
    return app().widgets().find(name);
  }

  void frames(int count) const {
    for (int k = 0; k < count; ++k) window->frame();
  }
  void settle() const {
    const Status settled = window->settle(control);
    ASSERT_TRUE(settled) << settled.error().message();
  }
  /// Plays the lines of a script; fails the test where one fails.
  void play(std::string_view lines) const {
    Result<gui::Script> script = gui::parse_script(lines, "script");
    ASSERT_TRUE(script) << script.error().message();
    const Status played = window->run_script(std::move(*script), control);
    ASSERT_TRUE(played) << played.error().message();
  }
  /// Opens the small document and waits for its pictures and errors.
  void open_small() const {
    write_text(folder / "small.json", k_small_preset);
    play("open " + (folder / "small.json").string() + "\nwait jobs\n");
  }
  [[nodiscard]] Picture picture() const {
    Picture picture{size_, app().screen().pixels()};
    cover_what_varies(picture, app().widgets());
    return picture;
  }

  TemporaryFolder folder;
  mutable JobControl control;
  std::unique_ptr<gui::HeadlessWindow> window;

 private:
  glm::ivec2 size_{0, 0};
};

}  // namespace glint::test
