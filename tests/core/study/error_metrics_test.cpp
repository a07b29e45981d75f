#include "core/study/error_metrics.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

PndfImage image_of(std::vector<double> density) {
  PndfImage image;
  image.grid = {0, 1, 0, 0.5, 2, 2};  // cells of 0.5 x 0.25: area 0.125
  image.density = std::move(density);
  return image;
}

// Hand-computed, with differences of both signs: without the absolute value they would cancel.
TEST(ErrorMetrics, HaveTheirHandComputedValues) {
  const PndfImage reference = image_of({4, 2, 1, 1});
  const PndfErrors errors = compare(image_of({3, 3, 1, 2}), reference);
  EXPECT_DOUBLE_EQ(errors.relative_l1, 3.0 / 8.0);             // |-1| + 1 + 0 + 1 over 8
  EXPECT_DOUBLE_EQ(errors.peak_error, 1.0 / 4.0);              // largest difference 1 over the reference's peak 4
  EXPECT_DOUBLE_EQ(errors.energy_error, (9.0 - 8.0) * 0.125);  // sums times the cell's area
}

TEST(ErrorMetrics, EnergyErrorIsPositiveWhereEnergyIsLost) {
  EXPECT_DOUBLE_EQ(compare(image_of({1, 1, 1, 1}), image_of({4, 2, 1, 1})).energy_error, 4 * 0.125);
}

TEST(ErrorMetrics, AreZeroForEqualImages) {
  const PndfErrors errors = compare(image_of({1, 2, 3, 4}), image_of({1, 2, 3, 4}));
  EXPECT_EQ(errors.relative_l1, 0);
  EXPECT_EQ(errors.peak_error, 0);
  EXPECT_EQ(errors.energy_error, 0);
}

// The peak error divides by the reference's peak, not by the image's and not by the value at the worst cell.
TEST(ErrorMetrics, AreNotSymmetric) {
  const PndfImage a = image_of({8, 0, 0, 0});
  const PndfImage b = image_of({2, 2, 0, 0});
  EXPECT_DOUBLE_EQ(compare(a, b).peak_error, 3.0);
  EXPECT_DOUBLE_EQ(compare(b, a).peak_error, 0.75);
  EXPECT_DOUBLE_EQ(compare(a, b).relative_l1, 2.0);
  EXPECT_DOUBLE_EQ(compare(b, a).relative_l1, 1.0);
}

}  // namespace
}  // namespace glint
