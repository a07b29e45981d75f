#include "core/study/error_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace glint {

PndfErrors compare(const PndfImage& image, const PndfImage& reference) {
  assert(image.grid == reference.grid);
  double difference = 0;
  double mass = 0;
  double largest_difference = 0;
  double peak = 0;
  for (std::size_t k = 0; k < reference.density.size(); ++k) {
    const double off = std::abs(image.density[k] - reference.density[k]);
    difference += off;
    mass += reference.density[k];
    largest_difference = std::max(largest_difference, off);
    peak = std::max(peak, reference.density[k]);
  }
  return {difference / mass, largest_difference / peak, std::abs(integral(image) - integral(reference))};
}

}  // namespace glint
