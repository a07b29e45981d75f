#pragma once
// What surrounds the map's picture: toolbar, the empty panel, what the mouse is told, and the names of its places.

#include <optional>
#include <string>

#include "viewers/edit.h"
#include "viewers/map/map_gesture.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// Which colours, and the zoom; the words that do not fit are left out.
std::optional<Edit> draw_map_toolbar(Ui& ui, const Rectangle& area, const Document& document, double zoom);

/// Before the first map: why, and a button. True when that was pressed.
bool draw_empty_map(Ui& ui, const Rectangle& area, const std::string& error, bool loading);

/// The mouse as far as it concerns the picture, which takes hold of the buttons that go down over it.
MapMouse mouse_over(Ui& ui, const Rectangle& picture);

/// map.picture, map.center, map.handle.1 to .4 (ends of the first and second axis, then those opposite), map.minimap.
void record_map_places(Ui& ui, const MapScene& scene);

/// The tooltip of what the mouse rests on.
void explain_map_target(Ui& ui, const MapScene& scene, const MapTarget& target);

}  // namespace glint::view
