#pragma once
// Draws panels or widgets without a display and without the application: for tests of one panel, and for looking at it.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <imgui.h>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "viewers/widgets/ui.h"

namespace glint::test {

/// One ImGui context on OSMesa. Only one may be alive at a time.
class Stage {
 public:
  Stage(glm::ivec2 size, float scale = 1);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage();

  [[nodiscard]] const view::GlFunctions& gl() const;
  [[nodiscard]] glm::ivec2 size() const;
  [[nodiscard]] ImGuiIO& io() const;     ///< mouse position, buttons, keys (by GLFW code) for the next frame
  [[nodiscard]] view::UiState& state();  ///< focus, editing …
  [[nodiscard]] const view::WidgetRecord& widgets() const;  ///< of the last frame

  /// One frame: `body` draws inside a window that covers the whole stage.
  void frame(const std::function<void(view::Ui&)>& body);
  /// Moves the mouse to the middle of the widget and clicks: four frames.
  void click(const char* widget, const std::function<void(view::Ui&)>& body);
  /// The last frame as RGB bytes, rows from the top, or as a PNG.
  [[nodiscard]] std::vector<std::uint8_t> pixels() const;
  void save(const std::filesystem::path& png) const;

 private:
  struct Own;
  std::unique_ptr<Own> own_;
};

}  // namespace glint::test
