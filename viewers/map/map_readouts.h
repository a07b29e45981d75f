#pragma once
// The values of the map at one position: stored in the file, decoded, on the surface, and as shown.

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "core/image/color_map.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

struct MapReading {
  glm::ivec2 texel{0, 0};       ///< that holds the position, on the map
  glm::dvec2 position{0, 0};    ///< on the map
  std::string raw;              ///< as the file holds it, or why there is none
  glm::vec2 decoded{0, 0};      ///< (s, t) of the texel: the map itself
  glm::dvec2 at_cursor{0, 0};   ///< n(u) of the surface in use, exactly at the position
  DisplayColor color{0, 0, 0};  ///< shown on the screen there
  double slope = 0;             ///< of the texel
  double curvature = 0;         ///< at the texel, per texel
};

/// `level` is the level of the pyramid that is shown; `u` may lie in any period. None beyond a map that clamps.
std::optional<MapReading> reading_at(const SurfaceInUse& surface, MapColors colors, int level, glm::dvec2 u);
/// Lines for the clipboard: full precision, ASCII minus.
std::string clipboard_text(const MapReading& reading);

/// The height that the read-outs need below a picture of this width, in pixels.
float readouts_height(const Ui& ui, const SurfaceInUse* surface, float width, bool compact);
/// `reading` none: dashes in the same places. Compact: two lines without captions.
void draw_readouts(Ui& ui, const Rectangle& area, const SurfaceInUse* surface, MapColors colors,
                   const std::optional<MapReading>& reading, bool compact);

}  // namespace glint::view
