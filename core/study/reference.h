#pragma once
// The reference of a surface: the exact method in double precision, with its own error.

#include <optional>

#include "core/math/parallel.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/pndf_model.h"
#include "core/surface/surface.h"

namespace glint {

/// Where the refinement of the smooth surface ended.
struct ReferenceRefinement {
  int subdivision = 4;  ///< sub-cells per axis and texel
  double change = 0;    ///< relative L1 to half of that subdivision
};

struct ReferenceImage {
  Interpolation surface;
  PndfImage image;
  /// Smooth: the relative L1 between the last two refinements. Linear and constant: the bound of what the image's cut
  /// leaves out, for there the triangles are the surface.
  double own_error = 0;
  ReferenceRefinement refinement;  ///< of the smooth surface
};

/// What the cells of an image hold: the value at their centre, or the mean over them (binning).
enum class CellContent { point, mean };

/// How much a reference may take.
struct ReferenceEffort {
  double converged = 2e-4;  ///< the smooth surface is refined until its relative L1 changes by less
  double image_cut = 8;     ///< the joint cut; what it leaves out is far below `converged` from 5 on
};

/// Linear and constant surfaces are evaluated as they are. The smooth surface is evaluated with shifted vertices on
/// 4 x 4, 8 x 8, … sub-cells a texel until the relative L1 changes by less than that; `known` is the refinement
/// of another image of the same request, which is then not sought again. Means over the cells are
/// those of a density whose roughness is widened by pitch^2 / 12 per axis: right to about 1e-3 (pitch / sigma_r)^4.
/// Nothing if cancelled.
std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, CellContent content,
                                              JobControl& control,
                                              std::optional<ReferenceRefinement> known = std::nullopt,
                                              const ReferenceEffort& effort = {});

}  // namespace glint
