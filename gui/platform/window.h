#pragma once
// A window of the desktop: OpenGL to draw with, and what mouse, keyboard and drops do in it.

#include <functional>
#include <memory>
#include <string>

#include "core/math/result.h"
#include "gui/input/input.h"
#include "viewers/gl/gl_context.h"

namespace glint::gui {

/// What a window can do beyond drawing. Belongs to the main thread.
class Window : public view::GlContext {
 public:
  /// From now on what happens goes into `input`, which must outlive the window.
  virtual void listen(InputQueue& input) = 0;
  /// Shows what was drawn.
  virtual void swap() = 0;
  /// True once after the desktop lost what was shown.
  [[nodiscard]] virtual bool take_exposure() = 0;
  /// Handles what has happened; waits up to `seconds` for something to happen first. True if anything has: input, a
  /// change of the window, or wake().
  virtual bool poll(double seconds) = 0;
  /// Ends a wait of poll(); from any thread.
  virtual void wake() = 0;
  /// The person asked to close it; stays so until refuse_close().
  [[nodiscard]] virtual bool close_requested() const = 0;
  virtual void refuse_close() = 0;
  virtual void set_title(const std::string& title) = 0;
  /// How much larger than 96 dots an inch the desktop asks things to be.
  [[nodiscard]] virtual float content_scale() const = 0;
  [[nodiscard]] virtual bool minimised() const = 0;
  [[nodiscard]] virtual bool maximised() const = 0;
  virtual void set_clipboard(const std::string& text) = 0;
  [[nodiscard]] virtual std::string clipboard() const = 0;
  enum class Cursor { arrow, text, hand, move, resize_horizontal, resize_vertical };
  virtual void set_cursor(Cursor cursor) = 0;
};

/// Fails with one sentence where there is no display, or none with OpenGL 3.3.
Result<std::unique_ptr<Window>> make_glfw_window(glm::ivec2 size, bool maximised, const std::string& title);

}  // namespace glint::gui
