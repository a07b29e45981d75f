#pragma once
// The Inspector's rows of the methods: which of them run, and the settings of each beside its name.

#include "core/surface/surface.h"
#include "viewers/inspector/field_rows.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::view {

/// The surface that `document` asks for on `map`, which tells what `auto` is (null: not known yet, smooth).
Interpolation interpolation_on(const Document& document, const NormalMap* map);

/// `header`: of the section, in whose gutter the choice of the methods is reset. What was found of a method that runs
/// stands under its rows (null: nothing yet).
void method_rows(FieldPage& page, const Rectangle& header, const NormalMap* map, const PndfResults* results);

}  // namespace glint::view
