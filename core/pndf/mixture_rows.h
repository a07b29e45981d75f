#pragma once
// The elements of a mixture under one footprint, a row of seeds at a time, made from the map on the fly: nothing is
// stored, so that step, kind, roughness and footprint change without any rebuild.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "core/pndf/mixture_settings.h"

namespace glint {

/// Of one footprint. Per element i with offset o_i = u_i - u_p:
///   D_P(s) = sum of a N(o_i; 0, V) N(s; s_i - J_i K o_i, diag(roughness^2) + J_i Sigma_e J_i^T)
/// with V = Sigma_p + sigma_h^2 I, K = sigma_h^2 V^-1, Sigma_e = sigma_h^2 Sigma_p V^-1 (the 2016 paper's slice of a
/// product of Gaussians, integrated, whose own form cancels). A footprint so much wider than a map that repeats
/// that its periods add up to a constant (to 1e-6) sees each seed of one period once: N(o_i; 0, V) is 1 / (map area), K
/// is 0 and Sigma_e is sigma_h^2 I.
struct MixtureFrame {
  /// Seeds along one axis, first to last.
  struct Seeds {
    std::int64_t first;
    std::int64_t last;
  };

  struct SeedRectangle {
    Seeds columns;
    Seeds rows;
  };

  const NormalMap* map;
  bool piecewise_constant;  ///< seeds take the normal of the texel they lie in
  MixtureElements elements;
  MixtureLattice lattice;
  double merge_bound;
  glm::dvec2 center;           ///< u_p, texels
  glm::dvec2 roughness;        ///< on each axis
  double cut;                  ///< joint cut R, deviations
  SymmetricMatrix2 footprint;  ///< Sigma_p
  SymmetricMatrix2 widened;    ///< V
  bool uniform;                ///< see above
  Whitening whitening;         ///< of V; 0 where uniform
  SymmetricMatrix2 drift;      ///< K
  CholeskyFactor spread;       ///< L with L L^T = Sigma_e
  double weight;               ///< a / (4 pi^2 sqrt(det V)); a / (2 pi map area) where uniform; a / 2 pi of a rectangle
  std::optional<SeedRectangle> rectangle = {};  ///< of seeds, in place of those that a footprint reaches

  MixtureFrame(const Surface& surface, const MixtureSettings& settings, const Footprint& footprint,
               glm::dvec2 roughness, double cut);

  /// No footprint, but the seeds of a rectangle, each with its whole weight a: sum of a N(s; s_i, diag(roughness^2) +
  /// sigma_h^2 J_i J_i^T). Offsets are from `origin`.
  MixtureFrame(const Surface& surface, const MixtureSettings& settings, const SeedRectangle& seeds, glm::dvec2 origin,
               glm::dvec2 roughness, double cut);

  /// Seeds that the footprint reaches along one axis.
  [[nodiscard]] Seeds rows() const;
  [[nodiscard]] Seeds columns() const;
  /// About how many elements are within the cut.
  [[nodiscard]] double elements_within() const;
  /// False where the exact method answers instead: what such a footprint sees it sees again and again, or single
  /// precision does not do.
  [[nodiscard]] bool sums_elements() const;
  /// The share of the mass that the cut keeps.
  [[nodiscard]] double kept() const;
};

/// Elements by field: the mean of s and the upper triangular W with W^T W = covariance^-1, by which distances from it
/// are sums of squares; `room` is R^2 less the squared distance in the plane, always positive.
struct ElementList {
  std::vector<float> x, y;           // mean
  std::vector<float> w11, w12, w22;  // whitening
  std::vector<float> amplitude;      // weight / sqrt(det covariance) exp(-d^2 / 2): the density at the mean
  std::vector<float> room;
  std::vector<float> u;  // of the seed, from the footprint's centre, texels
  std::size_t count = 0;

  void reserve(std::size_t size);
};

/// Makes rows one after another; each thread has its own.
class MixtureRows {
 public:
  explicit MixtureRows(const MixtureFrame& frame);
  MixtureRows(const MixtureRows&) = delete;
  MixtureRows& operator=(const MixtureRows&) = delete;
  ~MixtureRows();

  /// The elements of row l that are within the cut, behind those in `out`.
  void append(std::int64_t row, ElementList& out);

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace glint
