#include "core/pndf/lean_footprint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pndf/cell_visit.h"
#include "core/pndf/lean_lattice.h"
#include "core/pndf/lean_points.h"

namespace glint {
namespace {

// The largest block of which the footprint is wide enough; 0 for texels, k + 1 for level k.
int lattice_level(double deviation, const NormalMap& map) {
  int level = 0;
  const std::int64_t longest = std::max(map.width(), map.height());
  while (deviation >= k_least_block_deviation * static_cast<double>(MomentChain::block_size(level)) &&
         (level == 0 || MomentChain::block_size(level - 1) < longest)) {
    ++level;
  }
  return level;
}

// min over whole k, not both 0, of k^T Q k, by Gauss' reduction of the two axes.
double shortest_squared(SymmetricMatrix2 q) {
  for (;;) {
    if (q.xx > q.yy) std::swap(q.xx, q.yy);
    const double turns = std::round(q.xy / q.xx);
    if (!(std::abs(turns) >= 1)) return q.xx;
    const double before = q.yy;
    q.yy += turns * (turns * q.xx - 2 * q.xy);
    q.xy -= turns * q.xx;
    if (!(q.yy < before)) return std::min(q.xx, before);
  }
}

// Whether all of a map that repeats weighs the same, to 2 exp(-2 pi^2 0.81) = 2e-7.
bool is_uniform(const NormalMap& map, const SymmetricMatrix2& c) {
  constexpr double k_uniform = 0.81;
  if (map.wrap() == Wrap::clamp) return false;
  const double w = map.width();
  const double h = map.height();
  return shortest_squared({c.xx / (w * w), c.xy / (w * h), c.yy / (h * h)}) >= k_uniform;
}

}  // namespace

SlopeMoments footprint_moments(const Surface& surface, const Footprint& footprint,
                               const std::function<const LeanMoments&()>& chain) {
  const NormalMap& map = surface.map();
  const bool flakes = surface.interpolation() == Interpolation::constant;
  const Footprint reduced{reduced_center(map, footprint.center), footprint.covariance};
  const double deviation = std::sqrt(eigenvalues(footprint.covariance).y);
  if (!(deviation >= (flakes ? k_least_flake_deviation : k_least_texel_deviation))) {
    return flakes ? flake_moments(surface, reduced) : point_moments(surface, reduced);
  }
  if (is_uniform(map, footprint.covariance)) return chain().map().whole();
  Footprint lattice = reduced;
  if (flakes) {  // the mass of a texel's square is the density of a footprint widened by it
    lattice.covariance.xx += 1.0 / 12;
    lattice.covariance.yy += 1.0 / 12;
  }
  const int level = lattice_level(deviation, map);
  return lattice_moments(LeanLattice(map, level, level > 0 ? &chain() : nullptr), lattice);
}

}  // namespace glint
