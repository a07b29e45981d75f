#pragma once
// Neighbouring elements of a mixture that are nearly alike become one Gaussian, with a bound on what that moves: on
// near-flat maps most of them do.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pndf/mixture_rows.h"

namespace glint {

/// Each thread has its own.
///
/// A tile's elements, of weights w_i, means m_i and covariances S_i, become the Gaussian of the same weight, mean and
/// covariance where the L1 distance between the two is below merge_bound of their weight. The bound, for this footprint
/// and roughness: let R = diag(roughness^2), |.| lengths whitened by it, S the mean covariance and e the largest
/// |S_i - S| (Frobenius), so that B = S - e R is below every S_i and above (1 - e) R. Tile and Gaussian are both N(0,
/// B) convolved with densities p and q of equal mean and covariance; by Taylor's formula their distance is at most c /
/// 6 (E_p |x|^3 + E_q |x|^3) / (1 - e)^(3/2), c = 1.51 being the L1 norm of the normal density's third derivative. With
/// r_i = |m_i - m|^2 + tr(S_i - B) <= |m_i - m|^2 + 3.42 e both fourth moments are at most 3 sum w_i r_i^2, and
/// Lyapunov's inequality gives 1.15 (sum w_i r_i^2 / (1 - e)^2)^(3/4): of third order in the means' distances, where
/// the difference of the entropies would give a bound of first order.
/// It is one on elements that are not cut: a joint cut leaves out other tails of one Gaussian than of many, up to what
/// it leaves out of all, exp(-R^2 / 2) (1 + R^2 / 2).
class ElementMerger {
 public:
  static constexpr std::int64_t k_rows = 4;  ///< of seeds in a band
  static constexpr std::int64_t k_columns = 4;

  explicit ElementMerger(const MixtureFrame& frame);

  /// Merges within tiles of k_rows x k_columns seeds, and then what has become one with its neighbours along the band.
  /// `band` holds the elements of k_rows rows; what is left of it is in order of tiles, unless nothing was merged.
  /// Returns a bound on the L1 distance between what was and what is, at most twice merge_bound of the band's weight.
  /// Vectors cut tiles: which elements merge depends on the instruction set, and scalar code merges none.
  double merge(ElementList& band);

  /// The elements of a band by tile: tile t has order[begin[t]] … order[begin[t + 1] - 1].
  struct Tiles {
    std::vector<std::int32_t> order;
    std::vector<std::int32_t> begin;
  };
  /// What vectors need of the frame.
  struct Limits {
    float r_xx, r_yy;   // squared roughness
    float bound;        // largest distance, of a tile's weight
    float x, y;         // means farther apart than this are never merged
    float squared_cut;  // R^2
  };

 private:
  void sort(const ElementList& band);

  Limits limits_;
  float left_;
  float per_tile_;
  std::size_t tile_count_;
  Tiles tiles_;
  Tiles next_;
  ElementList merged_;
};

}  // namespace glint
