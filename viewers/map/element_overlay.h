#pragma once
// The mixture's elements over the map: circles of their own extent, coloured by what they weigh under the footprint or
// by what they add to the density at the crosshair.

#include <imgui.h>
#include <vector>

#include "viewers/gl/texture.h"
#include "viewers/map/bar_legend.h"
#include "viewers/map/map_camera.h"
#include "viewers/map/map_elements.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

class ElementOverlay {
 public:
  /// Circles of radius sigma_h. The caller clips.
  void draw(Ui& ui, ImDrawList& list, const MapCamera& camera, const ShownElements& shown);

  /// What the colours mean, or why there is nothing to see; top left at `at`, at most `width` wide. Recorded as
  /// "map.elements", with that reason. Its areas are added to `taken`.
  void draw_legend(Ui& ui, ImDrawList& list, ImVec2 at, float width, const ShownElements& shown,
                   std::vector<Rectangle>& taken);

 private:
  Texture disc_;
  float disc_radius_ = 0;  // screen pixels
  float disc_scale_ = 0;
  BarLegend legend_;
};

}  // namespace glint::view
