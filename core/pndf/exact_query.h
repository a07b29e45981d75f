#pragma once
// D_P(s) at single normals in single precision, with vector instructions: the pyramid of boxes finds the cells that
// matter, 16 children a test, and their triangles are integrated a vector at a time. Several normals of one footprint
// share the search. The kernel of FastExactPndf::at.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint_window.h"
#include "core/pndf/normal_bounds.h"
#include "core/pndf/surface_cells.h"

namespace glint {

/// Below this roughness a float does not hold a normal to a deviation.
inline constexpr double k_least_single_roughness = 1e-6;

/// Normals that are searched together, at most.
inline constexpr std::size_t k_query_batch = 8;

/// A group of cells that the footprint reaches, in some period of the map.
struct QueryGroup {
  const NormalNode* bounds;
  std::int32_t tile_column;  ///< of its first tile
  std::int32_t tile_row;
  float left, top;  ///< offset of its first cell from the footprint's centre, texels
};

/// What all queries of one footprint have in common.
struct QueryFrame {
  const SurfaceCells* cells;
  const NormalBounds* bounds;
  float w11, w12, w22;  ///< whitening of offsets
  float inverse_roughness;
  float cut;    ///< joint cut R, deviations
  float scale;  ///< det W / (4 pi^2 sigma_r^2)
  std::vector<QueryGroup> groups;
};

/// Memory of one query, reused from one to the next.
class QueryScratch {
 public:
  QueryScratch();
  QueryScratch(const QueryScratch&) = delete;
  QueryScratch& operator=(const QueryScratch&) = delete;
  ~QueryScratch();

  struct Arrays;
  [[nodiscard]] Arrays& arrays() { return *arrays_; }

 private:
  std::unique_ptr<Arrays> arrays_;
};

/// False where only double precision does: triangles of other sizes than 2 or 32 a texel, a roughness
/// below what floats tell apart, a footprint whose whitening cancels, that holds too many periods of a small map, or
/// that leaves a map that clamps.
bool can_query(const SurfaceCells& cells, const FootprintWindow& window, glm::dvec2 center, double roughness,
               double cut);

QueryFrame make_query_frame(const SurfaceCells& cells, const NormalBounds& bounds, const FootprintWindow& window,
                            glm::dvec2 center, double roughness, double cut);

/// D_P(s[k]) into out[k], of 1 to k_query_batch normals; never negative, NaN or infinite, and the same whichever
/// normals are asked together. Nothing where a triangle is too long for single precision.
void exact_query(const QueryFrame& frame, std::span<const glm::dvec2> s, QueryScratch& scratch, std::span<double> out);

}  // namespace glint
