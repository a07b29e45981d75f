#pragma once
// The cheapest method that meets a tolerance, footprint by footprint: model only what a scene needs.

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/pndf/lean_pndf.h"
#include "core/pndf/mixture_pndf.h"
#include "core/pndf/pndf_model.h"

namespace glint {

inline constexpr double k_least_tolerance = 1e-4;
inline constexpr double k_largest_tolerance = 0.5;

struct AutoSettings {
  double tolerance = 0.01;  ///< relative L1 against the surface, 1e-4 to 0.5

  friend bool operator==(const AutoSettings&, const AutoSettings&) = default;
};

/// Who answers for a footprint, and what is known of its error, merging and atlas apart. Estimates compare a method
/// with the next finer one at normals drawn from both, on footprints of at most k_probed_deviation texels within a
/// wider one: the error of a sum of footprints is at most the mean of theirs.
struct AutoChoice {
  enum class Answer { lean, mixture, exact };
  Answer answer = Answer::exact;
  double step = 0;       ///< of a mixture
  double estimated = 0;  ///< relative L1, two standard errors of the estimate and the cut of images added
  bool known = false;    ///< whether the estimate meets the tolerance: exact answers where none does

  /// "LEAN", "mixture, h = 0.5", "exact".
  [[nodiscard]] std::string text() const;
};

/// Tries LEAN, mixtures of h = 2, 1, 1/2 and 1/4 and exact evaluation, in this order. Images of wide footprints are
/// looked up in the atlas where it holds them; near-flat maps are merged (MixturePndf). Exact is
/// that of 32 triangles a texel with shifted vertices.
class AutoPndf final : public PndfModel {
 public:
  static constexpr double k_probed_deviation = 16;
  static constexpr std::array<double, 4> k_steps{2, 1, 0.5, 0.25};

  AutoPndf(const Surface& surface, double intrinsic_roughness, const AutoSettings& settings = {},
           std::shared_ptr<const MixtureAtlas> atlas = nullptr);
  ~AutoPndf() override;

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  /// Of the method chosen; `answer` and `error` say which it was and what is known of it.
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

  /// Without counting it. Not to be used if `control` was cancelled meanwhile.
  [[nodiscard]] AutoChoice choose(const Footprint& footprint, const JobControl& control = JobControl()) const;

  /// Footprints answered by at() and image() so far.
  struct Statistics {
    std::size_t lean = 0;
    std::array<std::size_t, k_steps.size()> mixture{};  ///< by step
    std::size_t exact = 0;
    std::size_t unknown = 0;  ///< of those by exact: where no estimate met the tolerance
  };
  [[nodiscard]] Statistics statistics() const;

 private:
  struct Exact;

  [[nodiscard]] const PndfModel& model_of(const AutoChoice& choice) const;
  [[nodiscard]] const Exact& exact() const;
  /// From the atlas, where what that may be off is within the tolerance too.
  [[nodiscard]] std::optional<PndfImage> looked_up(const AutoChoice& choice, const Footprint& footprint,
                                                   const PndfGrid& grid) const;
  void count(const AutoChoice& choice) const;
  [[nodiscard]] double merging_share() const;
  [[nodiscard]] double elements_within(const Footprint& footprint, double step) const;

  Surface surface_;
  double intrinsic_roughness_;
  AutoSettings settings_;
  LeanPndf lean_;
  std::array<std::unique_ptr<const MixturePndf>, k_steps.size()> mixtures_;  // by step
  std::shared_ptr<const MixtureAtlas> atlas_;
  mutable std::once_flag exact_built_;
  mutable std::unique_ptr<const Exact> exact_;  // built when a footprint first asks for it
  mutable std::atomic<std::size_t> exact_bytes_{0};
  mutable std::array<std::atomic<std::size_t>, k_steps.size() + 3> counts_{};
};

}  // namespace glint
