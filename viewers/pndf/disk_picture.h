#pragma once
// One picture of the projected hemisphere: where normals lie on screen, the image in it, rings, axes and crosshair.

#include <imgui.h>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/pndf/pndf_grid.h"
#include "viewers/gl/frame_pictures.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

inline constexpr glm::dvec4 k_whole_disk{-1, 1, -1, 1};

/// smin, smax, tmin, tmax of a grid.
glm::dvec4 window_of(const PndfGrid& grid);

/// Where a picture stands and which window of the disk it shows. A window that is not square is shown with its own
/// proportions in the middle of the square.
struct DiskPlace {
  Rectangle square;                  ///< of the panel, whole pixels
  glm::dvec4 window = k_whole_disk;  ///< smin, smax, tmin, tmax
  Rectangle shown;                   ///< the part of the square that the window fills

  [[nodiscard]] bool whole() const { return window == k_whole_disk; }
  [[nodiscard]] double pixels_per_unit() const { return shown.width() / (window.y - window.x); }
  [[nodiscard]] ImVec2 screen_of(glm::dvec2 s) const;
  [[nodiscard]] glm::dvec2 normal_at(ImVec2 screen) const;
  /// The normal under a position on screen: none outside the picture, or beyond the rim.
  [[nodiscard]] std::optional<glm::dvec2> normal_under(ImVec2 screen) const;
};
DiskPlace disk_place(const Rectangle& square, glm::dvec4 window);

/// The window after one or more notches of the wheel (positive: closer) about `s`, and after a drag that moved what was
/// under the mouse by `moved`: within [-1, 1] on both axes, with four digits beyond its width's first.
glm::dvec4 zoomed_window(glm::dvec4 window, glm::dvec2 s, double notches);
glm::dvec4 panned_window(glm::dvec4 window, glm::dvec2 moved);

/// Picture ground and border.
void draw_disk_ground(ImDrawList& list, const DiskPlace& place);

/// The texture of an image on `grid` where its cells lie, cut to the picture (and to the disk, when all of it is
/// shown). Cells are squares from 4 pixels a cell on, with their edges from 8. `opacity` below 1 dims it.
void draw_disk_image(Ui& ui, ImDrawList& list, const DiskPlace& place, const PndfGrid& grid, const Texture& texture,
                     Shading shading, float opacity);

/// Rim, rings at 30° and 60°, with their names if `labelled`.
void draw_disk_rings(const Ui& ui, ImDrawList& list, const DiskPlace& place, bool labelled);

/// Ticks and numbers of s under the picture; the name of t, and its ends where they are not -1 and 1, inside the
/// picture if `labelled`. `height` is what stands under the picture.
void draw_disk_axes(const Ui& ui, ImDrawList& list, const DiskPlace& place, bool labelled);

void draw_crosshair(const Ui& ui, ImDrawList& list, const DiskPlace& place, glm::dvec2 s);

/// Where the window lies in the disk, in the upper right corner. Nothing when all of the disk is shown.
void draw_window_inset(const Ui& ui, ImDrawList& list, const DiskPlace& place);

}  // namespace glint::view
