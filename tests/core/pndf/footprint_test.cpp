#include "core/pndf/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/pndf/folded_footprint.h"
#include "core/pndf/footprint_window.h"
#include "tests/core/pndf/reference_quadrature.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using testing::HasSubstr;

std::string fault(const Footprint& footprint) {
  return footprint_fault(footprint).value_or("none");
}

TEST(Footprint, IsRefusedWithTheReasonWhenItCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault({{512, 512}, {9, 2, 5}}), "none");
  EXPECT_EQ(fault(isotropic_footprint({0, 0}, 1e-5)), "none");
  EXPECT_EQ(fault(isotropic_footprint({-1e8, 0}, 9e4)), "none");
  EXPECT_THAT(fault({{nan, 0}, {1, 0, 1}}), HasSubstr("five finite numbers"));
  EXPECT_THAT(fault({{0, infinity}, {1, 0, 1}}), HasSubstr("five finite numbers"));
  EXPECT_THAT(fault({{0, 0}, {1, nan, 1}}), HasSubstr("five finite numbers"));
  EXPECT_THAT(fault({{1e10, 0}, {1, 0, 1}}), HasSubstr("1e9 texels"));
  for (const SymmetricMatrix2& c :
       {SymmetricMatrix2{1, 2, 1}, SymmetricMatrix2{-1, 0, 1}, SymmetricMatrix2{1, 0, 0}, SymmetricMatrix2{1, 1, 1},
        SymmetricMatrix2{-1, 0, -1}, SymmetricMatrix2{0, 0, 0}}) {
    EXPECT_THAT(fault({{0, 0}, c}), HasSubstr("positive definite")) << c.xx << ' ' << c.xy << ' ' << c.yy;
  }
  EXPECT_THAT(fault(isotropic_footprint({0, 0}, 2e5)), HasSubstr("100000 texels"));
  EXPECT_THAT(fault({{0, 0}, {1, 0, 1e-14}}), HasSubstr("at least 1e-6"));
}

TEST(Footprint, IsotropicHasTheRadiusAsItsDeviation) {
  EXPECT_EQ(isotropic_footprint({3, 4}, 5), (Footprint{{3, 4}, {25, 0, 25}}));
}

class FootprintWindowOf : public testing::TestWithParam<SymmetricMatrix2> {};
INSTANTIATE_TEST_SUITE_P(Covariances, FootprintWindowOf,
                         testing::Values(SymmetricMatrix2{1, 0, 1}, SymmetricMatrix2{9, 2, 5},
                                         SymmetricMatrix2{2, -3, 7}, SymmetricMatrix2{50, 49.9, 50}));

double distance(const FootprintWindow& window, glm::dvec2 d) {
  const glm::dvec2 w = window.whitening().apply(d);
  return std::hypot(w.x, w.y);
}

TEST_P(FootprintWindowOf, ReachesAsFarAsItsEllipseAndNoFarther) {
  const FootprintWindow window(GetParam());
  double x = 0;
  double y = 0;
  const CholeskyFactor factor = cholesky(GetParam());
  for (double angle = 0; angle < 6.3; angle += 1e-3) {
    const glm::dvec2 d = 3.0 * factor.apply({std::cos(angle), std::sin(angle)});
    EXPECT_NEAR(distance(window, d), 3, 1e-9);
    x = std::max(x, d.x);
    y = std::max(y, d.y);
  }
  EXPECT_NEAR(window.reach_x(3) / x, 1, 1e-6);
  EXPECT_NEAR(window.reach_y(3) / y, 1, 1e-6);
}

TEST_P(FootprintWindowOf, ColumnsHoldTheEllipseWithinTheBandTightly) {
  const FootprintWindow window(GetParam());
  const double reach = window.reach_y(3);
  const CholeskyFactor factor = cholesky(GetParam());
  for (const Interval band : {Interval{-0.9 * reach, -0.5 * reach}, Interval{-0.2 * reach, 0.3 * reach},
                              Interval{0.5 * reach, 2 * reach}, Interval{-5 * reach, 5 * reach}}) {
    const auto columns = window.columns(band, 3);
    ASSERT_TRUE(columns);
    Interval seen{1e9, -1e9};
    for (double radius = 0; radius <= 3; radius += 0.01) {
      for (double angle = 0; angle < 6.3; angle += 0.004) {
        const glm::dvec2 d = radius * factor.apply({std::cos(angle), std::sin(angle)});
        if (d.y < band.lo || d.y > band.hi) continue;
        seen = {std::min(seen.lo, d.x), std::max(seen.hi, d.x)};
      }
    }
    const double slack = 0.02 * window.reach_x(3);
    EXPECT_LE(columns->lo, seen.lo + 1e-9);
    EXPECT_GE(columns->hi, seen.hi - 1e-9);
    EXPECT_NEAR(columns->lo, seen.lo, slack);
    EXPECT_NEAR(columns->hi, seen.hi, slack);
  }
  EXPECT_FALSE(window.columns({1.01 * reach, 2 * reach}, 3));
  EXPECT_FALSE(window.columns({-2 * reach, -1.01 * reach}, 3));
}

TEST_P(FootprintWindowOf, SquaredDistanceToABoxIsTheLeastOverTheBox) {
  const FootprintWindow window(GetParam());
  RandomStream random(6, 0);
  for (int k = 0; k < 200; ++k) {
    const double x = 20 * random.next_uniform() - 10;
    const double y = 20 * random.next_uniform() - 10;
    const OffsetBox box{{x, x + 4 * random.next_uniform()}, {y, y + 4 * random.next_uniform()}};
    double least = 1e300;
    constexpr int k_steps = 60;
    for (int b = 0; b <= k_steps; ++b) {
      for (int a = 0; a <= k_steps; ++a) {
        const glm::dvec2 d{box.x.lo + (box.x.hi - box.x.lo) * a / k_steps,
                           box.y.lo + (box.y.hi - box.y.lo) * b / k_steps};
        least = std::min(least, distance(window, d));
      }
    }
    const double computed = std::sqrt(window.squared_distance(box));
    EXPECT_LE(computed, least + 1e-9);
    // One step of the scan, in deviations of the narrowest axis.
    EXPECT_GE(computed, least - 4.0 * std::sqrt(2.0) / k_steps / std::sqrt(eigenvalues(GetParam()).y));
  }
}

double lattice_sum(const NormalMap& map, const Footprint& footprint, glm::dvec2 u) {
  double sum = 0;
  for (int j = -12; j <= 12; ++j) {
    for (int i = -12; i <= 12; ++i) {
      const glm::dvec2 shift(i * map.width(), j * map.height());
      sum += test::slow_normal_density(u + shift - footprint.center, footprint.covariance);
    }
  }
  return sum;
}

TEST(FoldedFootprint, IsTheSumOverAllPeriodsAnywhereInACell) {
  for (const SymmetricMatrix2& covariance : {SymmetricMatrix2{144, 0, 144}, SymmetricMatrix2{500, 200, 400}}) {
    const auto map = test::constant_map({0, 0}, Wrap::repeat, 48);
    const Footprint footprint{{13.37, 41.2}, covariance};
    for (const double border : {0.0, 0.5}) {
      const FoldedFootprint folded(*map, footprint, border);
      const double largest = lattice_sum(*map, footprint, footprint.center);
      for (const auto& [i, j] : {std::pair(13, 40), std::pair(0, 0), std::pair(47, 47), std::pair(30, 10)}) {
        const CellPolynomial f = folded.over_cell(i, j);
        for (const glm::dvec2 position :
             {glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(0.3, 0.9), glm::dvec2(0.5, 0.5)}) {
          const glm::dvec2 u = glm::dvec2(i + border, j + border) + position;
          EXPECT_NEAR(f(position) / largest, lattice_sum(*map, footprint, u) / largest, 2e-11) << i << ' ' << j;
        }
      }
    }
  }
}

TEST(FoldedFootprint, HasMassOneOverOnePeriodHoweverWideItIs) {
  const auto map = test::constant_map({0, 0}, Wrap::repeat, 5);
  for (const double radius : {12.0, 1e3, 1e5}) {
    const FoldedFootprint folded(*map, isotropic_footprint({1.3, 4.1}, radius), 0.5);
    double mass = 0;
    for (int j = 0; j < 5; ++j) {
      for (int i = 0; i < 5; ++i) mass += folded.over_cell(i, j)({0.5, 0.5});
    }
    EXPECT_NEAR(mass, 1, 1e-12) << radius;
  }
}

TEST(FoldedFootprint, PaysOnlyForWideFootprintsOnMapsThatRepeat) {
  const auto map = test::constant_map({0, 0}, Wrap::repeat, 32);
  EXPECT_TRUE(FoldedFootprint::pays(*map, isotropic_footprint({0, 0}, 20.1).covariance, 8.5));
  EXPECT_FALSE(FoldedFootprint::pays(*map, isotropic_footprint({0, 0}, 19.9).covariance, 8.5));
  EXPECT_FALSE(FoldedFootprint::pays(*map, {1e6, 0, 300}, 8.5));  // too narrow for the polynomial
  EXPECT_FALSE(FoldedFootprint::pays(*test::constant_map({0, 0}, Wrap::clamp, 32), {1600, 0, 1600}, 8.5));
  EXPECT_FALSE(FoldedFootprint::pays(*test::constant_map({0, 0}, Wrap::repeat, 512), {1600, 0, 1600}, 8.5));
}

}  // namespace
}  // namespace glint
