#pragma once
// The values under the cursor, as rows of the Inspector: the normal, where it points, and its density by every method.

#include "viewers/inspector/field_rows.h"
#include "viewers/pndf/pndf_view.h"

namespace glint::view {

inline constexpr float k_reading_pitch = 20;

/// Degrees between the normal of s and the flat one; 90 on the rim and beyond.
double tilt_of(glm::dvec2 s);
/// Degrees from the s axis towards the t axis, in [0, 360).
double azimuth_of(glm::dvec2 s);

/// Null: the cursor is nowhere.
void reading_rows(FieldPage& page, const PndfReading* reading);

}  // namespace glint::view
