#include "core/pndf/pndf_model.h"

#include <algorithm>

namespace glint {

bool evaluate_all(const PndfModel& model, const Footprint& footprint, std::span<const glm::dvec2> s,
                  std::span<double> density, JobControl& control) {
  constexpr std::size_t k_block = 16;
  PndfWorkspace workspace;
  const FootprintPndf& prepared = model.at(footprint, workspace);
  return parallel_blocks((s.size() + k_block - 1) / k_block, control, [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * k_block, s.size());
    for (std::size_t k = block * k_block; k < end && !control.cancelled(); ++k) {
      prepared.evaluate(s.subspan(k, 1), density.subspan(k, 1));
    }
  });
}

}  // namespace glint
