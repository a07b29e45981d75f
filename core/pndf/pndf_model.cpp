#include "core/pndf/pndf_model.h"

#include <algorithm>

namespace glint {

bool evaluate_all(const PndfModel& model, const Footprint& footprint, std::span<const glm::dvec2> s,
                  std::span<double> density, JobControl& control) {
  // Few queries may be slow ones: then each is a block of its own.
  const std::size_t block_size = std::clamp<std::size_t>(s.size() / 256, 1, 16);
  PndfWorkspace workspace;
  const FootprintPndf& prepared = model.at(footprint, workspace);
  prepared.expect_queries(s.size());
  return parallel_blocks((s.size() + block_size - 1) / block_size, control, [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * block_size, s.size());
    for (std::size_t k = block * block_size; k < end && !control.cancelled(); ++k) {
      prepared.evaluate(s.subspan(k, 1), density.subspan(k, 1));
    }
  });
}

}  // namespace glint
