#pragma once
// One Dear ImGui context on one OpenGL context: what a window, a headless run and a test of a panel have in common.

#include <cstdint>
#include <functional>
#include <imgui.h>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/result.h"
#include "viewers/gl/draw_damage.h"
#include "viewers/gl/draw_renderer.h"
#include "viewers/gl/framebuffer.h"
#include "viewers/gl/gl_context.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// Belongs to the thread of its GlContext, which must outlive it. ImGui knows one current context: one Screen at a
/// time.
class Screen {
 public:
  static Result<std::unique_ptr<Screen>> create(GlContext& context, float scale);
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

  [[nodiscard]] float scale() const { return scale_; }
  /// From the next frame on: style and letters of that size.
  void set_scale(float scale);

  struct Frame {
    double seconds = 0;      ///< since the program began
    float step = 1.0F / 60;  ///< since the last frame
    bool headless = false;
    bool blocked = false;  ///< something lies over the panels
  };
  /// Draws one frame into memory of its own, only where it differs from the one before: `body` draws inside a window
  /// that covers all of `size`. Input stands in ImGui's io before the call.
  void draw(glm::ivec2 size, const Frame& frame, const std::function<void(Ui&)>& body);

  /// Copies the last frame to the window of the context, if it has changed since or `anyway`; returns whether it did.
  bool show(bool anyway = false);

  /// Of the last frame.
  [[nodiscard]] const WidgetRecord& widgets() const { return widgets_; }
  [[nodiscard]] UiState& state() { return state_; }
  /// The last frame: RGB bytes, rows from the top.
  [[nodiscard]] std::vector<std::uint8_t> pixels() const;

 private:
  explicit Screen(GlContext& context) : context_(context) {}
  void paint(glm::ivec2 size);

  GlContext& context_;
  ImGuiContext* imgui_ = nullptr;
  std::unique_ptr<DrawRenderer> renderer_;
  Fonts fonts_;
  FramePictures pictures_;
  WidgetRecord widgets_;
  UiState state_;
  std::unique_ptr<Framebuffer> canvas_;
  DrawDamage damage_;
  bool changed_ = false;
  float scale_ = 1;
};

}  // namespace glint::view
