#pragma once
// What lies in the corners of the map's picture: the small overview with where one is, and the legend of the colours.

#include <imgui.h>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/surface/normal_pyramid.h"
#include "viewers/gl/texture.h"
#include "viewers/map/bar_legend.h"
#include "viewers/map/map_camera.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

class MapInset {
 public:
  /// Where the overview of a map stands, at most `side` pixels long; none while the whole map is in view.
  static std::optional<Rectangle> area(const Ui& ui, const MapCamera& camera, const NormalMap& map, float side);

  /// The overview with the part in view and the footprint's centre.
  void draw(Ui& ui, ImDrawList& list, const Rectangle& area, const MapCamera& camera,
            const std::shared_ptr<const NormalPyramid>& pyramid, MapColors colors, glm::dvec2 footprint_center);

  /// The bar of the colours with its ends and its colours beyond them, top left at `at`; nothing for normals, whose
  /// colours are what a normal map stores. At most `width` wide. Returns the area it covers.
  std::optional<Rectangle> draw_legend(Ui& ui, ImDrawList& list, ImVec2 at, float width, MapColors colors);

 private:
  Texture overview_;
  std::shared_ptr<const NormalPyramid> of_;
  MapColors colors_ = MapColors::normal;
  int side_ = 0;
  BarLegend legend_;
};

}  // namespace glint::view
