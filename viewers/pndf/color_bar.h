#pragma once
// The colour bars: that of the densities, beside the pictures which share it, and that of the difference under its
// picture. Their ends are entries.

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "viewers/pndf/color_range.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// A change of the ends of a bar, in the terms of an Edit.
struct RangeChange {
  std::optional<glm::dvec2> range;  ///< none: fitted
  std::string label;
  bool finished = true;
};

struct DensityBarInput {
  DensityRange range;
  bool fitted = true;            ///< the range follows the pictures
  std::optional<double> cursor;  ///< density under the crosshair
};

/// Where the upright bar stands: as high as the pictures, its title above and its button below.
struct DensityBarPlace {
  Rectangle column;
  float title_top = 0;
};

/// The upright bar: draws, edits, and remembers the drag under way.
class DensityBar {
 public:
  std::optional<RangeChange> draw(Ui& ui, const DensityBarPlace& place, const DensityBarInput& input);

 private:
  std::optional<RangeChange> drag(Ui& ui, const Rectangle& bar, const DensityBarInput& input);

  struct Drag {
    DensityRange start;
    float mouse = 0;     // where it began
    double grabbed = 0;  // position on the bar
    bool moved = false;
  };
  std::optional<Drag> drag_;
};

/// A new end of the difference's bar; none: fitted.
struct DifferenceChange {
  std::optional<double> highest;
};

/// The flat bar of a difference, 9 high, with its ends and 0 in the line below; the right end is an entry. `area` is as
/// wide as the picture and difference_bar_height() high.
std::optional<DifferenceChange> draw_difference_bar(Ui& ui, const Rectangle& area, const DifferenceRange& range,
                                                    bool fitted, std::optional<double> cursor);
float difference_bar_height(const Ui& ui);

}  // namespace glint::view
