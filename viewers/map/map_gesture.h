#pragma once
// What the mouse does to the map: pan, zoom, place and shape the footprint. A state machine without drawing; it reads
// no input but what it is given.

#include <array>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "viewers/map/footprint_shape.h"
#include "viewers/map/map_camera.h"

namespace glint::view {

/// Where everything lies that the mouse can take hold of.
struct MapScene {
  MapCamera camera;
  glm::ivec2 map_size{1, 1};
  Wrap wrap = Wrap::repeat;
  ZoomRange zooms{1, 1};
  Footprint footprint;            ///< the document's
  std::array<ImVec2, 4> handles;  ///< in the order of k_axis_ends
  std::optional<Rectangle> minimap;
  float scale = 1;
};

struct MapMouse {
  ImVec2 at{0, 0};
  bool over = false;     ///< the picture, and nothing lies above it
  bool pressed = false;  ///< the left button went down over it
  bool pans = false;     ///< … and Space or Alt is held, or it was the middle button
  bool held = false;     ///< the button that was pressed is still down
  float wheel = 0;       ///< notches; up is positive
  bool shift = false;
  bool ctrl = false;
};

/// What lies under the mouse, nearest first.
struct MapTarget {
  enum class Kind { nothing, ground, center, handle, minimap };
  Kind kind = Kind::nothing;  ///< nothing: outside a map that clamps
  int handle = 0;             ///< index into k_axis_ends

  friend bool operator==(const MapTarget&, const MapTarget&) = default;
};
MapTarget target_at(const MapScene& scene, ImVec2 mouse);

/// A new footprint.
struct FootprintEdit {
  Footprint footprint;
  std::string label;
  bool finished = true;
};

class MapGesture {
 public:
  struct Step {
    MapCamera camera;
    std::optional<FootprintEdit> edit;
  };
  /// Once a frame. Edits of one drag carry one label; the last one is finished.
  Step step(const MapScene& scene, const MapMouse& mouse);
  /// Forgets the drag under way: no finished edit will follow.
  void abandon() { held_ = Held::nothing; }

  /// The name of what is dragged, "" while nothing is: map.picture, map.pan, map.center, map.handle.1 …, map.minimap.
  [[nodiscard]] std::string dragged() const;
  /// The shape while a handle is dragged, with the axes numbered as they were at the begin.
  [[nodiscard]] std::optional<FootprintShape> shape() const;
  /// What is held, for drawing it so.
  [[nodiscard]] MapTarget target() const;

 private:
  enum class Held { nothing, view, ground, center, handle, minimap };

  void press(const MapScene& scene, const MapMouse& mouse);
  void move_view(const MapScene& scene, const MapMouse& mouse, MapCamera& camera);
  std::optional<FootprintEdit> drag(const MapScene& scene, const MapMouse& mouse);
  [[nodiscard]] Footprint dragged_footprint(const MapScene& scene, const MapMouse& mouse);

  Held held_ = Held::nothing;
  int handle_ = 0;
  bool moved_ = false;  // beyond the tremor of a click
  ImVec2 pressed_at_{0, 0};
  ImVec2 last_{0, 0};  // mouse position of the last step
  bool last_shift_ = false;
  bool last_ctrl_ = false;
  ImVec2 grab_{0, 0};     // from the point that is dragged to the mouse, pixels
  FootprintShape start_;  // at the begin of the drag of a handle
  FootprintShape shape_;
};

/// The texel position of a point of the minimap.
glm::dvec2 texel_of_minimap(const Rectangle& minimap, glm::ivec2 map_size, ImVec2 pixel);
ImVec2 minimap_of_texel(const Rectangle& minimap, glm::ivec2 map_size, glm::dvec2 u);

}  // namespace glint::view
