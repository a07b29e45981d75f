#pragma once
// What the mouse and the keyboard do to the pictures of the P-NDF panel: one crosshair through all, which follows the
// mouse or is pinned, and the window of the disk, which is zoomed, dragged and toggled.

#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "viewers/edit.h"
#include "viewers/pndf/disk_picture.h"
#include "viewers/pndf/window_gesture.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

class PndfCrosshair {
 public:
  /// Before the pictures of a frame. `window` is what they show, `cell` the step of an arrow key.
  void begin_frame(glm::dvec4 window, glm::dvec2 cell);
  /// For every picture in every frame; `key` names it: "exact", "difference".
  std::optional<Edit> over_picture(Ui& ui, const std::string& key, const DiskPlace& place, const Document& document);
  /// After the pictures of a frame.
  std::optional<Edit> end_frame(Ui& ui, const Document& document);

  /// Where it is: at the mouse, else at the pin.
  [[nodiscard]] std::optional<glm::dvec2> position() const { return hovered_ ? hovered_ : pinned_; }
  /// The picture under the mouse; empty if there is none.
  [[nodiscard]] const std::string& hovered_picture() const { return hovered_picture_; }
  /// The picture that has the keyboard; empty if there is none.
  [[nodiscard]] const std::string& focused_picture() const { return focused_picture_; }
  /// One step towards the pin, else the middle.
  [[nodiscard]] Edit zoomed(const Document& document, double notches) const;

 private:
  std::optional<Edit> press(const Ui& ui, const DiskPlace& place, const Document& document);
  void move_pin(KeyboardFocus& focus);
  [[nodiscard]] glm::dvec2 middle() const;

  WindowGesture gesture_;
  glm::dvec4 window_ = k_whole_disk;
  glm::dvec2 cell_{1.0 / 128, 1.0 / 128};
  std::optional<glm::dvec2> hovered_;
  std::optional<glm::dvec2> pinned_;
  std::optional<glm::dvec2> pinned_before_;  // the last press, for a double click to take it back
  std::string hovered_picture_;
  std::string focused_picture_;
};

}  // namespace glint::view
