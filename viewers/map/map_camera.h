#pragma once
// Where on the map the panel looks: pan and zoom as a value. Two spaces: texels (u, v of the map, v down) and screen
// pixels.

#include <glm/vec2.hpp>

#include "core/surface/normal_map.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// The part of a map that a picture shows. Position and size only; nothing about a map is kept.
struct MapCamera {
  Rectangle picture;        ///< on the screen
  glm::dvec2 center{0, 0};  ///< the texel position in the middle of the picture
  double pixels_per_texel = 1;
};

ImVec2 screen_of_texel(const MapCamera& camera, glm::dvec2 u);
glm::dvec2 texel_of_screen(const MapCamera& camera, ImVec2 pixel);
/// The top left and bottom right texel positions of the picture.
struct TexelRange {
  glm::dvec2 min;
  glm::dvec2 max;
};
TexelRange visible_texels(const MapCamera& camera);

/// How far one can zoom: from the whole map with a margin to `nearest` pixels a texel; for a map so small that it does
/// not fill the picture even then, only that one.
struct ZoomRange {
  double lowest;
  double highest;
};
ZoomRange zoom_range(glm::ivec2 map_size, const Rectangle& picture, double nearest);

/// Zoomed by `factor`, as far as `range` allows; the texel position under `fixed` stays there.
MapCamera zoomed_about(const MapCamera& camera, ImVec2 fixed, double factor, const ZoomRange& range);
/// What lay under a pixel lies under that pixel + `by` afterwards.
MapCamera panned(const MapCamera& camera, ImVec2 by);
/// The zoom brought into `range` and the centre onto the map (of one that repeats, onto its first period), so that one
/// never loses it.
MapCamera kept_on_map(const MapCamera& camera, glm::ivec2 map_size, const ZoomRange& range);
/// The whole map in the picture.
MapCamera whole_map(const Rectangle& picture, glm::ivec2 map_size, const ZoomRange& range);

/// A position as it is stored: within [0, size) of a map that repeats; of one that clamps, the nearest on it.
glm::dvec2 stored_position(glm::dvec2 u, glm::ivec2 map_size, Wrap wrap);
/// Whether a map has something at u.
bool on_map(glm::dvec2 u, glm::ivec2 map_size, Wrap wrap);

/// The largest of 1, 2, 5 x 10^n that is not above `most`, which is positive: the length of a scale bar.
double rounded_down_step(double most);

}  // namespace glint::view
