#pragma once
// Flakes by the cells of a uniform grid over their periodic domain, and what each weighs under a footprint.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "core/pndf/footprint_window.h"
#include "core/surface/flakes.h"

namespace glint {

struct FlakeWeight {
  std::uint32_t flake;
  double weight;  ///< in proportion to w_i
};

/// Flake i is the Gaussian N(u; u_i, sigma_h^2 I) over positions, all with the same share a = domain / count of the
/// area; its weight under a footprint is the sum of a N(o; 0, V) over its offsets o from the footprint's centre in all
/// periods, V = Sigma_p + sigma_h^2 I. Immutable.
class FlakeGrid {
 public:
  /// At least one flake and a domain, in texels, that is not empty; centres may lie in any period.
  FlakeGrid(std::vector<Flake> flakes, glm::dvec2 domain);

  /// In order of cells.
  [[nodiscard]] const std::vector<Flake>& flakes() const { return flakes_; }
  /// sigma_h = sqrt(a) / sqrt(8 ln 2), texels.
  [[nodiscard]] double deviation() const { return deviation_; }
  [[nodiscard]] std::size_t bytes() const;

  /// Whether the footprint is so much wider than the domain that its periods add up to the same weight for all flakes,
  /// to 1e-10.
  [[nodiscard]] bool sees_all_alike(const Footprint& footprint) const;

  /// The flakes' weights but for those below the largest one's by more than exp(-cut^2 / 2); at least one, however far
  /// the nearest flake is. Costs as many steps as flakes are within the footprint, or in the domain if that is less,
  /// times a number below some thirty; of footprints that are narrower than the domain but longer by far, and along a
  /// simple direction (an axis, a diagonal), up to 3 sqrt(count). Memory is a few numbers a flake at most.
  [[nodiscard]] std::vector<FlakeWeight> weights(const Footprint& footprint, double cut) const;
  /// Those of footprints that see all alike.
  [[nodiscard]] std::vector<FlakeWeight> equal_weights() const { return folded({}, {0, 0}); }

 private:
  // Of the sum over periods as a Fourier series in offsets: 2 exp(-2 pi^2 f^T V f) cos(turn.o).
  struct Wave {
    glm::dvec2 turn;
    double amplitude;
  };

  [[nodiscard]] SymmetricMatrix2 widened(const SymmetricMatrix2& covariance) const;
  // A square deviation of V as a share of the domain's area.
  [[nodiscard]] double share_of_domain(const SymmetricMatrix2& widened) const;
  [[nodiscard]] std::vector<Wave> waves(const SymmetricMatrix2& widened) const;
  [[nodiscard]] std::vector<FlakeWeight> folded(const std::vector<Wave>& waves, glm::dvec2 center) const;
  [[nodiscard]] std::vector<FlakeWeight> one_by_one(const FootprintWindow& window, double share, glm::dvec2 center,
                                                    double cut) const;

  /// Hands on see(flake, squared distance in deviations) for the flakes of the plane within the cut.
  template <class See>
  void visit(const FootprintWindow& window, glm::dvec2 center, double cut, const See& see) const;

  glm::dvec2 domain_;
  double deviation_;
  glm::ivec2 cells_;
  glm::dvec2 cell_;
  std::vector<Flake> flakes_;
  std::vector<std::uint32_t> begin_;  // of each cell in flakes_, by rows, and the end
};

}  // namespace glint
