#include "viewers/pndf/color_range.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace glint::view {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

TEST(FittedDensityRange, HoldsFourDecadesBelowTheRoundedLargest) {
  const DensityRange range = fitted_density_range(ColorScale::logarithmic, 137);
  EXPECT_DOUBLE_EQ(range.highest, 200);
  EXPECT_DOUBLE_EQ(range.lowest, 0.02);
  EXPECT_TRUE(range.logarithmic);
}

TEST(FittedDensityRange, BeginsAtZeroWhenLinear) {
  EXPECT_EQ(fitted_density_range(ColorScale::linear, 137), (DensityRange{0, 200, false}));
}

TEST(FittedDensityRange, IsUsableForAnyPicture) {
  for (const ColorScale scale : {ColorScale::logarithmic, ColorScale::linear}) {
    for (const double largest : {0.0, -1.0, k_nan, k_infinity, 1e-300, 1e300}) {
      const DensityRange range = fitted_density_range(scale, largest);
      EXPECT_LT(range.lowest, range.highest) << largest;
      const Shading shading = range.shading(false);
      EXPECT_TRUE(std::isfinite(shading.hi) && shading.lo < shading.hi) << largest;
    }
  }
  EXPECT_DOUBLE_EQ(fitted_density_range(ColorScale::logarithmic, 0).highest, 1) << "zeros fit like 1";
}

TEST(ShownDensityRange, IsTheDocumentsWhereItHasOne) {
  ViewSettings view;
  EXPECT_EQ(shown_density_range(view, 137), fitted_density_range(ColorScale::logarithmic, 137));
  view.density_range = glm::dvec2(0.5, 7);
  EXPECT_EQ(shown_density_range(view, 137), (DensityRange{0.5, 7, true}));
  view.density_scale = ColorScale::linear;
  EXPECT_EQ(shown_density_range(view, 137), (DensityRange{0.5, 7, false}));
}

TEST(DensityRange, PositionAndAtAreInverse) {
  for (const DensityRange& range : {DensityRange{0.01, 100, true}, DensityRange{0, 20, false}}) {
    for (const double position : {0.0, 0.25, 1.0, 1.5}) {
      EXPECT_NEAR(range.position(range.at(position)), position, 1e-12);
    }
  }
  EXPECT_DOUBLE_EQ((DensityRange{0.01, 100, true}.position(1)), 0.5);
}

TEST(DensityRange, PutsZeroBelowEveryLogarithmicRange) {
  EXPECT_LT((DensityRange{1e-30, 1, true}.position(0)), 0);
}

TEST(ShownDifferenceRange, IsFittedOrSet) {
  ViewSettings view;
  EXPECT_DOUBLE_EQ(shown_difference_range(view, 0.84).highest, 1);
  EXPECT_DOUBLE_EQ(shown_difference_range(view, 0).highest, 1);
  EXPECT_DOUBLE_EQ(shown_difference_range(view, k_nan).highest, 1);
  view.difference_range = 3;
  EXPECT_DOUBLE_EQ(shown_difference_range(view, 0.84).highest, 3);
}

TEST(DensityRangeFault, NamesWhatIsWrong) {
  EXPECT_FALSE(density_range_fault({0.01, 100}));
  EXPECT_EQ(density_range_fault({0, 1}), "An end of the colour bar must be a density above 0.");
  EXPECT_EQ(density_range_fault({-1, 1}), "An end of the colour bar must be a density above 0.");
  EXPECT_EQ(density_range_fault({2, 1}), "The lower end of the colour bar must be below its upper end.");
  EXPECT_TRUE(density_range_fault({1, 1}));
  EXPECT_TRUE(density_range_fault({1e-40, 1}));
}

TEST(DifferenceRangeFault, WantsAPositiveEnd) {
  EXPECT_FALSE(difference_range_fault(0.5));
  EXPECT_TRUE(difference_range_fault(0));
  EXPECT_TRUE(difference_range_fault(-1));
}

TEST(DraggedDensityRange, ShiftsALogarithmicRangeWithTheMouse) {
  // A quarter of four decades up: what had the colour of 1 now is 0.1.
  const glm::dvec2 range = dragged_density_range({0.01, 100, true}, 0.5, 0.25);
  EXPECT_DOUBLE_EQ(range.x, 0.001);
  EXPECT_DOUBLE_EQ(range.y, 10);
}

TEST(DraggedDensityRange, ScalesALinearRange) {
  const glm::dvec2 range = dragged_density_range({0, 10, false}, 0.5, -0.25);
  EXPECT_DOUBLE_EQ(range.y, 20) << "the value at half of the bar was taken to a quarter";
  EXPECT_GT(range.x, 0) << "a set range may not begin at 0";
}

TEST(DraggedDensityRange, StaysAllowedHoweverFarItGoes) {
  for (const double share : {-100.0, -1.0, 1.0, 100.0}) {
    for (const bool logarithmic : {true, false}) {
      const DensityRange start{logarithmic ? 0.01 : 0, 100, logarithmic};
      EXPECT_FALSE(density_range_fault(dragged_density_range(start, 0.9, share)) &&
                   dragged_density_range(start, 0.9, share) != glm::dvec2(start.lowest, start.highest))
          << share;
    }
  }
}

}  // namespace
}  // namespace glint::view
