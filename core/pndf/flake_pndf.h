#pragma once
// The P-NDF of flakes that were placed directly, without any map (Yan et al. 2016, car paint): for a renderer that
// wants a metallic paint, or that brings flakes of its own.
//
//   JobControl control;
//   const Result<std::vector<Flake>> flakes = place_flakes(settings, control);
//   const FlakePndf paint(*flakes, glm::dvec2(settings.size), /* sigma_r */ 0.01);
//   PndfWorkspace workspace;  // one a thread
//   const FootprintPndf& pndf = paint.at(footprint, workspace);
//   const glm::dvec2 s = pndf.sample(random);  // with density pndf.pdf(s)

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/flake_grid.h"
#include "core/pndf/pndf_model.h"
#include "core/pndf/prepared_flakes.h"

namespace glint {

/// A mixture whose elements are the flakes themselves, flat (J = 0) and each with the same share a = domain / count of
/// the area:
///   D_P(s) = sum of w_i N(s; s_i, sigma_r^2 I) / sum of w_i,   w_i = a N(u_p - u_i; 0, Sigma_p + sigma_h^2 I),
///   sigma_h = sqrt(a) / sqrt(8 ln 2),
/// over all periods. Flakes cover the plane unevenly, so the sum of the w_i is not 1; dividing by it (the 2016 paper
/// leaves that open) gives every footprint unit energy, also one between flakes, or far from all of them: that one sees
/// the nearest. evaluate(), pdf() and sample() agree on it exactly. Multiplied by the sum, they would be the mixture's.
///
/// Cuts are joint: single normals at R = 5, in double precision, images at R = 4.2, each counted from the nearest flake
/// and scaled by what it keeps.
///
/// at() costs some 50 ns a flake within 5 deviations of the footprint, and some 200 ns a flake of the domain for one
/// that is wider; more where it is narrow but far longer than the domain, along an axis or a diagonal (FlakeGrid).
/// Those that see the whole domain alike share one preparation. A normal then only meets the flakes that nearly face
/// it. The surface is the flakes' own: info() says `constant`, the nearest in kind, but a map of their Voronoi cells is
/// another surface.
class FlakePndf final : public PndfModel {
 public:
  static constexpr double k_image_cut = 4.2;
  static constexpr double k_query_cut = 5;

  /// At least one flake, in a domain of width x height texels that repeats; centres may lie in any period.
  /// `intrinsic_roughness` is sigma_r in (0, 1].
  FlakePndf(std::vector<Flake> flakes, glm::dvec2 domain, double intrinsic_roughness);

  /// sigma_h, texels.
  [[nodiscard]] double deviation() const { return grid_.deviation(); }

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

 private:
  [[nodiscard]] PreparedFlakes prepare(const Footprint& footprint, glm::dvec2 roughness, double cut) const;
  /// Of footprints that see all flakes alike; prepared when one first asks for it.
  [[nodiscard]] std::shared_ptr<const PreparedFlakes> whole() const;

  FlakeGrid grid_;
  double intrinsic_roughness_;
  mutable std::once_flag whole_prepared_;
  mutable std::shared_ptr<const PreparedFlakes> whole_;
};

}  // namespace glint
