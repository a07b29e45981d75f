#pragma once
// Zooming and panning the window of the P-NDF grid with the mouse: each gesture is one step of undo.

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "viewers/edit.h"
#include "viewers/pndf/disk_picture.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

class WindowGesture {
 public:
  /// For every picture in every frame. `hovered` is whether the mouse is over it and may act.
  std::optional<Edit> over_picture(Ui& ui, std::string_view name, const DiskPlace& place, bool hovered,
                                   const Document& document);
  /// Once a frame, after the pictures: ends a zoom when the wheel has rested, and a drag when its button was let go.
  std::optional<Edit> rest(Ui& ui, const Document& document);

  /// The window after so many notches about `s`, as an edit.
  static Edit zoomed(const Document& document, glm::dvec4 window, glm::dvec2 s, double notches, bool finished);

 private:
  struct Pan {
    std::string picture;
    int button = 1;
    glm::dvec4 window;
    glm::dvec2 grabbed{0, 0};  // screen position where it began
    double pixels_per_unit = 1;
    bool moved = false;
  };
  std::optional<Pan> pan_;
  std::optional<double> last_notch_;  // when
};

}  // namespace glint::view
