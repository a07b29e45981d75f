#pragma once
// The footprint over the map: its rings, handles and labels.

#include <array>
#include <imgui.h>
#include <vector>

#include <glm/vec2.hpp>

#include "viewers/map/footprint_shape.h"
#include "viewers/map/map_camera.h"
#include "viewers/map/map_gesture.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

struct FootprintPicture {
  MapCamera camera;
  glm::ivec2 map_size{1, 1};
  Wrap wrap = Wrap::repeat;
  glm::dvec2 center{0, 0};  ///< texels
  FootprintShape shape;
  MapTarget hot;  ///< what the mouse is over or holds
};

/// Where its four handles stand, in the order of k_axis_ends.
std::array<ImVec2, 4> footprint_handles(const Ui& ui, const FootprintPicture& footprint);

/// Rings at 1, 3 and 5 sigma; on a map that repeats, that at 1 sigma faintly in its other periods too.
void draw_footprint_rings(const Ui& ui, ImDrawList& list, const FootprintPicture& footprint);
/// Centre, handles and the rings' labels, which keep clear of `taken` and are added to it.
void draw_footprint_handles(const Ui& ui, ImDrawList& list, const FootprintPicture& footprint,
                            std::vector<Rectangle>& taken);

/// Whether `area` shares anything with one of the others.
bool overlaps_any(const Rectangle& area, const std::vector<Rectangle>& others);

}  // namespace glint::view
