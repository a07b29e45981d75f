#include "core/pndf/fitted_window.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/pndf/exact_pndf.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

TEST(FittedWindow, HoldsAllButAHairOfTheLobe) {
  for (const double roughness : {0.002, 0.02, 0.1}) {
    for (const double radius : {0.3, 3.0, 20.0}) {
      const Surface surface(test::rough_map(64, 64, Wrap::repeat, 0.2), Interpolation::smooth);
      const Footprint footprint = isotropic_footprint({31.2, 7.7}, radius);
      const PndfGrid grid = fitted_window(surface, footprint, roughness, 64);
      EXPECT_FALSE(grid_fault(grid));
      EXPECT_EQ(grid.columns, 64);
      EXPECT_EQ(grid.rows, 64);
      EXPECT_NEAR(grid.s_max - grid.s_min, grid.t_max - grid.t_min, 1e-12);
      // Counted by draws: those outside, of which 1e-3 are allowed.
      PndfWorkspace workspace;
      const ExactPndf model(surface, roughness);
      const FootprintPndf& pndf = model.at(footprint, workspace);
      RandomStream random(5, 0);
      int outside = 0;
      for (int k = 0; k < 20000; ++k) {
        const glm::dvec2 s = pndf.sample(random);
        if (s.x < grid.s_min || s.x > grid.s_max || s.y < grid.t_min || s.y > grid.t_max) ++outside;
      }
      EXPECT_LE(outside, 20) << roughness << ' ' << radius;
    }
  }
}

TEST(FittedWindow, IsNoLargerThanTheLobeNeeds) {
  const Surface surface(test::constant_map({0.25, -0.5}), Interpolation::linear);
  const PndfGrid grid = fitted_window(surface, isotropic_footprint({3, 3}, 2), 0.01, 128);
  EXPECT_GE(grid.s_max - grid.s_min, 0.09);
  EXPECT_LE(grid.s_max - grid.s_min, 0.09 * 1.08);
  EXPECT_NEAR(0.5 * (grid.s_min + grid.s_max), 0.25, 0.003);
  EXPECT_NEAR(0.5 * (grid.t_min + grid.t_max), -0.5, 0.003);
}

TEST(FittedWindow, HasShortNumbersForItsEnds) {
  const Surface surface(test::rough_map(64, 64, Wrap::repeat, 0.2), Interpolation::smooth);
  const PndfGrid grid = fitted_window(surface, isotropic_footprint({31.2, 7.7}, 5), 0.01, 64);
  for (const double end : {grid.s_min, grid.s_max, grid.t_min, grid.t_max}) {
    EXPECT_NEAR(end * 1000, std::round(end * 1000), 1e-9) << end;
  }
}

TEST(FittedWindow, StaysWithinTheSquareRoundTheDisk) {
  for (const glm::dvec2 normal : {glm::dvec2(0.99, 0), glm::dvec2(0, -0.999), glm::dvec2(-0.7, 0.7)}) {
    for (const double roughness : {0.01, 0.3, 1.0}) {
      const PndfGrid grid = fitted_window(Surface(test::constant_map(normal), Interpolation::linear),
                                          isotropic_footprint({3, 3}, 2), roughness, 16);
      EXPECT_FALSE(grid_fault(grid));
      EXPECT_GE(grid.s_min, -1);
      EXPECT_GE(grid.t_min, -1);
      EXPECT_LE(grid.s_max, 1 + 1e-12);
      EXPECT_LE(grid.t_max, 1 + 1e-12);
    }
  }
}

TEST(FittedWindow, FollowsTheFootprintByWholePeriods) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const PndfGrid here = fitted_window(surface, isotropic_footprint({3.25, 4.5}, 2), 0.01, 64);
  const PndfGrid there = fitted_window(surface, isotropic_footprint({3.25 + 160, 4.5 - 32}, 2), 0.01, 64);
  EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace glint
