#pragma once
// What the map panel draws of the map itself: its tiles, the texel grid, arrows of the normals, rulers, scale bar and
// the small overview. Everything is clipped by the caller.

#include <imgui.h>
#include <vector>

#include "core/surface/normal_pyramid.h"
#include "viewers/map/map_camera.h"
#include "viewers/map/map_tiles.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// The level whose texels are nearest to a screen pixel, not larger than two; 0 where the map is magnified.
int level_shown(const NormalPyramid& pyramid, double pixels_per_texel);

/// The map on every period that is in view (once, if it clamps). `tiles` must have begun the frame.
void draw_map(Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalPyramid& pyramid, MapTiles& tiles);
/// Darkens what lies outside the first period and draws the map's border.
void draw_map_border(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map);
/// Lines between texels, from 8 pixels a texel on.
void draw_texel_grid(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map);
/// The projected normals as arrows, from 20 pixels a texel on; the longest in view just fits its texel.
void draw_normal_arrows(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map);
/// A white outline round the texel at u, from 4 pixels a texel on.
void draw_texel_outline(const Ui& ui, ImDrawList& list, const MapCamera& camera, glm::dvec2 u);

/// "20 texels" at the lower right; its area is added to `taken`.
void draw_scale_bar(const Ui& ui, ImDrawList& list, const MapCamera& camera, std::vector<Rectangle>& taken);
/// Ticks inside the left and bottom edges of the first period; numbers that would hit `taken` are left out.
void draw_rulers(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map,
                 std::vector<Rectangle>& taken);

}  // namespace glint::view
