#pragma once
// The footprint in the Inspector: its centre, its widths and angle as the ellipse of the map has them, and the
// covariance that stands behind them.

#include <string_view>

#include "core/document/document.h"
#include "core/math/result.h"
#include "core/surface/normal_map.h"
#include "viewers/edit.h"
#include "viewers/inspector/field_rows.h"

namespace glint::view {

/// In degrees from the u axis towards the top of the picture, in (-90, 90]; 0 for a circle.
double footprint_angle(const Footprint& footprint);

/// The footprint turned to that angle, its widths kept; a finished edit. An error where it is a circle, which has no
/// direction.
Result<Edit> turned_footprint(const Document& document, double degrees);

/// The footprint with its larger (0) or smaller (1) width set, its other width and the direction of both axes kept; a
/// finished edit, or an error that says what is allowed.
Result<Edit> widened_footprint(const Document& document, int axis, double width);

/// The fault of an edit's footprint on `map` (null: unknown), as the edit's error.
Result<Edit> placed_on(const NormalMap* map, Result<Edit> edit);

/// The rows of the section. `map` tells where a clamping map ends; null: not known yet.
void footprint_rows(FieldPage& page, const NormalMap* map);

}  // namespace glint::view
