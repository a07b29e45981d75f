// Exact evaluation at single normals against what is known in closed form, and against its own symmetries.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/folded_footprint.h"
#include "tests/core/pndf/reference_quadrature.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::density_of;
using test::MapPointer;

constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};
constexpr double k_quarter = std::numbers::pi / 4;

SymmetricMatrix2 isotropic(double deviation) {
  return {deviation * deviation, 0, deviation * deviation};
}

// sigma_r^2 I + J Sigma J^T.
SymmetricMatrix2 lobe_of_ramp(const glm::dmat2& j, const SymmetricMatrix2& c, double roughness) {
  const double r = roughness * roughness;
  const auto form = [&](int row, int other) {
    return j[0][row] * (c.xx * j[0][other] + c.xy * j[1][other]) +
           j[1][row] * (c.xy * j[0][other] + c.yy * j[1][other]);
  };
  return {r + form(0, 0), form(0, 1), r + form(1, 1)};
}

// n = a + J u, exact in float where the entries of J are multiples of 2^-13 and the map has 128 texels.
MapPointer ramp_map(glm::dvec2 a, const glm::dmat2& j) {
  return test::map_of(128, 128, Wrap::clamp,
                      [&](int column, int row) { return a + j[0] * (column + 0.5) + j[1] * (row + 0.5); });
}

glm::dmat2 dyadic(double a, double b, double c, double d) {
  return glm::dmat2(a, b, c, d) / 8192.0;
}

// Positions all over a lobe, out to six of its deviations.
std::vector<glm::dvec2> over_lobe(glm::dvec2 mean, const SymmetricMatrix2& covariance) {
  const CholeskyFactor factor = cholesky(covariance);
  std::vector<glm::dvec2> s;
  for (const double radius : {0.0, 1.0, 3.0, 6.0}) {
    for (const double angle : {0.1, 1.7, 3.6}) {
      s.push_back(mean + factor.apply({radius * std::cos(angle), radius * std::sin(angle)}));
    }
  }
  return s;
}

TEST(ExactPndf, OfAConstantMapIsTheRoughnessForEveryFootprint) {
  const glm::dvec2 normal{0.25, -0.125};
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const MapPointer map = test::constant_map(normal, wrap);
    for (const Interpolation interpolation : k_surfaces) {
      for (const double roughness : {1e-5, 0.3}) {
        const ExactPndf model(Surface(map, interpolation), roughness);
        for (const Footprint& footprint :
             {isotropic_footprint({3.2, 1}, 1e-6), isotropic_footprint({3.2, 1}, 0.3),
              isotropic_footprint({7.99, 0}, 5), test::turned_footprint({3.2, 9}, 20, 0.02, k_quarter),
              isotropic_footprint({-3.2, 1}, 35)}) {
          EXPECT_EQ(FoldedFootprint::pays(*map, footprint.covariance, 8.5),
                    wrap == Wrap::repeat && footprint.covariance.xx == 1225);
          for (const glm::dvec2 s : over_lobe(normal, isotropic(roughness))) {
            const double expected = test::slow_normal_density(s - normal, isotropic(roughness));
            EXPECT_NEAR(density_of(model, footprint, s) / expected, 1, 1e-10)
                << roughness << ' ' << footprint.covariance.xx << " surface " << static_cast<int>(interpolation);
          }
        }
      }
    }
  }
}

TEST(ExactPndf, OfARampIsTheGaussianThatTheRampMakesOfTheFootprint) {
  const glm::dvec2 a{-0.25, 0.125};
  for (const glm::dmat2& j :
       {dyadic(20, -7, 11, 30), dyadic(20, 10, 10, 5), dyadic(0, 0, 13, 0), dyadic(0, 0, 0, 0), dyadic(1, 0, 0, 1)}) {
    const MapPointer map = ramp_map(a, j);
    for (const Footprint& footprint : {isotropic_footprint({64.3, 60.1}, 0.2), Footprint{{64.3, 60.1}, {9, 2, 5}},
                                       test::turned_footprint({62, 65}, 4, 0.04, k_quarter)}) {
      for (const double roughness : {1e-5, 0.002, 0.2}) {
        const glm::dvec2 mean = a + j * footprint.center;
        const SymmetricMatrix2 lobe = lobe_of_ramp(j, footprint.covariance, roughness);
        for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
          const ExactPndf model(Surface(map, interpolation), roughness,
                                {interpolation == Interpolation::smooth ? 2 : 1});
          for (const glm::dvec2 s : over_lobe(mean, lobe)) {
            // 1e-10 of the value, and what rounding (n - s) / sigma_r to doubles moves far out on a narrow lobe.
            const double expected = test::slow_normal_density(s - mean, lobe);
            EXPECT_NEAR(density_of(model, footprint, s) / expected, 1, 1e-10 + 2e-15 / roughness)
                << roughness << ' ' << j[0][0] * 8192 << ' ' << footprint.covariance.xx;
          }
        }
      }
    }
  }
}

TEST(ExactPndf, HasMassOneAndTheMomentsOfTheNormals) {
  for (const Interpolation interpolation : k_surfaces) {
    const Surface surface(test::rough_map(16, 16, Wrap::repeat, 0.15), interpolation);
    const Footprint footprint{{7.3, 8.8}, {1, 0.35, 0.6}};
    constexpr double roughness = 0.03;
    const ExactPndf model(surface, roughness, {2});
    const PndfGrid grid{-0.4, 0.4, -0.4, 0.4, 40, 40};  // 1.5 cells a deviation: the sum is exact to 1e-18
    std::vector<glm::dvec2> s;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) s.push_back(grid.center(column, row));
    }
    std::vector<double> density(s.size());
    JobControl control;
    ASSERT_TRUE(evaluate_all(model, footprint, s, density, control));
    double mass = 0;
    glm::dvec2 mean{0, 0};
    for (std::size_t k = 0; k < s.size(); ++k) {
      mass += density[k] * grid.cell_area();
      mean += density[k] * grid.cell_area() * s[k];
    }
    SymmetricMatrix2 covariance{0, 0, 0};
    for (std::size_t k = 0; k < s.size(); ++k) {
      const glm::dvec2 d = s[k] - mean;
      const double weight = density[k] * grid.cell_area();
      covariance.xx += weight * d.x * d.x;
      covariance.xy += weight * d.x * d.y;
      covariance.yy += weight * d.y * d.y;
    }
    const test::NormalMoments moments = test::SlowPndf(surface, 2, footprint, glm::dvec2(1)).moments();
    EXPECT_NEAR(moments.mass, 1, 1e-10);
    EXPECT_NEAR(mass, 1, 1e-8);
    EXPECT_NEAR(mean.x, moments.mean.x, 1e-8);
    EXPECT_NEAR(mean.y, moments.mean.y, 1e-8);
    EXPECT_NEAR(covariance.xx, roughness * roughness + moments.covariance.xx, 1e-8);
    EXPECT_NEAR(covariance.xy, moments.covariance.xy, 1e-8);
    EXPECT_NEAR(covariance.yy, roughness * roughness + moments.covariance.yy, 1e-8);
    EXPECT_GT(moments.covariance.xx, 1e-3);  // there was something to get wrong
  }
}

TEST(ExactPndf, TendsToAGaussianOfTheMomentsForLargeRoughness) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat, 0.02), Interpolation::linear);
  const Footprint footprint = isotropic_footprint({7.3, 8.8}, 2);
  const test::NormalMoments moments = test::SlowPndf(surface, 1, footprint, glm::dvec2(1)).moments();
  const ExactPndf model(surface, 1);
  for (const glm::dvec2 s : {glm::dvec2(0, 0), glm::dvec2(0.7, -0.4), glm::dvec2(-2, 1)}) {
    const SymmetricMatrix2 lobe{1 + moments.covariance.xx, moments.covariance.xy, 1 + moments.covariance.yy};
    EXPECT_NEAR(density_of(model, footprint, s) / test::slow_normal_density(s - moments.mean, lobe), 1, 2e-6);
  }
}

TEST(ExactPndf, TendsToTheRoughnessAtOnePointForASmallFootprint) {
  const MapPointer map = test::rough_map(16, 16, Wrap::repeat);
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::constant}) {
    const Surface surface(map, interpolation);
    const ExactPndf model(surface, 0.05);
    for (const glm::dvec2 center : {glm::dvec2(7.3, 8.8), glm::dvec2(0.1, 15.8), glm::dvec2(4.77, 3.02)}) {
      const glm::dvec2 normal = surface.normal(center);
      for (const glm::dvec2 s : over_lobe(normal, isotropic(0.05))) {
        EXPECT_NEAR(density_of(model, isotropic_footprint(center, 1e-6), s) /
                        test::slow_normal_density(s - normal, isotropic(0.05)),
                    1, 1e-8);
      }
    }
  }
}

TEST(ExactPndf, TendsToTheSumOverRootsForSmallRoughness) {
  const Surface surface(test::rough_map(12, 12, Wrap::repeat), Interpolation::linear);
  const Footprint footprint = isotropic_footprint({6.2, 5.7}, 1.5);
  const ExactPndf model(surface, 1e-6);
  const test::SlowPndf slow(surface, 1, footprint, glm::dvec2(1));
  RandomStream random(4, 0);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const glm::dvec2 s{0.4 * random.next_uniform() - 0.2, 0.4 * random.next_uniform() - 0.2};
    const test::SlowPndf::RootSum expected = slow.roots(s);
    if (expected.margin < 3e-4) continue;
    EXPECT_NEAR(density_of(model, footprint, s) / expected.density, 1, 1e-6) << s.x << ' ' << s.y;
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

TEST(ExactPndf, OfTwoTrianglesIsThatOf32OnARamp) {
  const glm::dmat2 j = dyadic(20, -7, 11, 30);
  const MapPointer map = ramp_map({-0.25, 0.125}, j);
  const Footprint footprint{{64.3, 60.1}, {4, 1, 2}};
  const ExactPndf linear(Surface(map, Interpolation::linear), 0.002);
  const ExactPndf one(Surface(map, Interpolation::smooth), 0.002, {1});
  const ExactPndf four(Surface(map, Interpolation::smooth), 0.002, {4});
  const ExactPndf seven(Surface(map, Interpolation::smooth), 0.002, {7, true});
  const glm::dvec2 mean = glm::dvec2(-0.25, 0.125) + j * footprint.center;
  for (const glm::dvec2 s : over_lobe(mean, lobe_of_ramp(j, footprint.covariance, 0.002))) {
    const double expected = density_of(linear, footprint, s);
    EXPECT_NEAR(density_of(one, footprint, s) / expected, 1, 1e-11);
    EXPECT_NEAR(density_of(four, footprint, s) / expected, 1, 1e-11);
    EXPECT_NEAR(density_of(seven, footprint, s) / expected, 1, 1e-11);
  }
}

// A change of the map, the footprint and the query that must leave D as it is.
struct Symmetry {
  MapPointer map;
  Footprint footprint;
  glm::dmat2 of_s;
};

void expect_symmetric(const MapPointer& map, const Footprint& footprint, const Symmetry& symmetry,
                      Interpolation interpolation) {
  const ExactPndf before(Surface(map, interpolation), 0.02);
  const ExactPndf after(Surface(symmetry.map, interpolation), 0.02);
  for (const glm::dvec2 s : {glm::dvec2(0.05, 0.1), glm::dvec2(-0.13, 0.02), glm::dvec2(0.2, -0.2)}) {
    EXPECT_NEAR(density_of(after, symmetry.footprint, symmetry.of_s * s) / density_of(before, footprint, s), 1, 1e-9)
        << "surface " << static_cast<int>(interpolation);
  }
}

class ExactSymmetry : public testing::Test {
 protected:
  const int width = 12;
  const int height = 10;
  const MapPointer map = test::rough_map(width, height, Wrap::repeat);
  const Footprint footprint{{6.3, 4.2}, {2, 0.6, 1}};
  const glm::dmat2 same{1};
};

TEST_F(ExactSymmetry, ShiftingByPeriodsChangesNothing) {
  const Footprint shifted{footprint.center + glm::dvec2(3 * width, -5 * height), footprint.covariance};
  for (const Interpolation interpolation : k_surfaces)
    expect_symmetric(map, footprint, {map, shifted, same}, interpolation);
}

TEST_F(ExactSymmetry, TransposingMapAndFootprintChangesNothing) {
  const MapPointer transposed =
      test::map_of(height, width, Wrap::repeat, [&](int i, int j) { return glm::dvec2(map->texel(j, i)); });
  const auto [xx, xy, yy] = footprint.covariance;
  const Footprint turned{{footprint.center.y, footprint.center.x}, {yy, xy, xx}};
  for (const Interpolation interpolation : k_surfaces) {
    expect_symmetric(map, footprint, {transposed, turned, same}, interpolation);
  }
}

TEST_F(ExactSymmetry, HalfATurnOfMapAndFootprintChangesNothing) {
  const MapPointer turned_map = test::map_of(
      width, height, Wrap::repeat, [&](int i, int j) { return glm::dvec2(map->texel(width - 1 - i, height - 1 - j)); });
  const Footprint turned{{width - footprint.center.x, height - footprint.center.y}, footprint.covariance};
  for (const Interpolation interpolation : k_surfaces) {
    expect_symmetric(map, footprint, {turned_map, turned, same}, interpolation);
  }
}

TEST_F(ExactSymmetry, AFlipOrAQuarterTurnChangesOnlyWhatTheDiagonalMakesOfIt) {
  const auto [xx, xy, yy] = footprint.covariance;
  const Symmetry flipped{
      test::map_of(width, height, Wrap::repeat, [&](int i, int j) { return glm::dvec2(map->texel(width - 1 - i, j)); }),
      {{width - footprint.center.x, footprint.center.y}, {xx, -xy, yy}},
      same};
  const Symmetry turned{test::map_of(height, width, Wrap::repeat,
                                     [&](int i, int j) { return glm::dvec2(map->texel(j, height - 1 - i)); }),
                        {{height - footprint.center.y, footprint.center.x}, {yy, -xy, xx}},
                        same};
  for (const Symmetry& symmetry : {flipped, turned}) {
    expect_symmetric(map, footprint, symmetry, Interpolation::constant);
    const glm::dvec2 s{0.05, 0.1};
    const double before = density_of(ExactPndf(Surface(map, Interpolation::linear), 0.02), footprint, s);
    const double after =
        density_of(ExactPndf(Surface(symmetry.map, Interpolation::linear), 0.02), symmetry.footprint, s);
    EXPECT_GT(std::abs(after / before - 1), 1e-4);
  }
}

TEST_F(ExactSymmetry, TurningAllNormalsTurnsTheLobe) {
  const MapPointer turned = test::map_of(
      width, height, Wrap::repeat, [&](int i, int j) { return glm::dvec2(-map->texel(i, j).y, map->texel(i, j).x); });
  for (const Interpolation interpolation : k_surfaces) {
    expect_symmetric(map, footprint, {turned, footprint, {0, 1, -1, 0}}, interpolation);
  }
}

TEST(ExactPndf, IsRightThirtyDeviationsOutAndZeroWhereNoDoubleHoldsIt) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const double radius : {0.3, 3.0, 40.0}) {  // the widest is folded on the map that repeats
      const ExactPndf model(Surface(test::constant_map({0.1, 0.2}, wrap), Interpolation::linear), 0.01);
      const glm::dvec2 normal(glm::vec2(0.1F, 0.2F));
      const Footprint footprint = isotropic_footprint({3, 4}, radius);
      for (const double distance : {9.0, 15.0, 30.0, 35.0}) {
        const glm::dvec2 offset = 0.01 * distance * glm::dvec2(0.6, -0.8);
        const double expected = test::slow_normal_density(offset, isotropic(0.01));
        ASSERT_GT(expected, 0);
        EXPECT_NEAR(density_of(model, footprint, normal + offset) / expected, 1, 1e-8) << distance << ' ' << radius;
      }
      for (const double distance : {45.0, 1e3, 1e9}) {
        EXPECT_EQ(density_of(model, footprint, normal + 0.01 * distance * glm::dvec2(0.6, -0.8)), 0) << distance;
      }
    }
  }
}

TEST(ExactPndf, IsNeverNegativeOrNotANumberWhateverTheQuery) {
  for (const Interpolation interpolation : k_surfaces) {
    const ExactPndf model(Surface(test::rough_map(8, 8, Wrap::repeat), interpolation), 1e-3);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at({{3, 4}, {1, 0.3, 2}}, workspace);
    for (const double x : {-1e6, -2.0, -0.4, -0.31, 0.0, 0.299, 0.33, 1.0, 1e12}) {
      for (const double y : {-1e6, -0.35, 0.1, 0.5, 1e12}) {
        const double density = pndf.pdf({x, y});
        EXPECT_TRUE(density >= 0 && std::isfinite(density)) << x << ' ' << y;
      }
    }
  }
}

TEST(ExactPndf, CountsAQueryOnASharedVertexOrEdgeOnce) {
  const MapPointer map = test::rough_map(10, 10, Wrap::repeat);
  const Surface surface(map, Interpolation::linear);
  const Footprint footprint = isotropic_footprint({5.1, 4.9}, 0.7);
  for (const double roughness : {1e-3, 0.05}) {
    const ExactPndf model(surface, roughness);
    const test::SlowPndf slow(surface, 1, footprint, glm::dvec2(roughness));
    for (const glm::dvec2 u : {glm::dvec2(4.5, 4.5), glm::dvec2(5.5, 4.5), glm::dvec2(5.0, 4.5), glm::dvec2(4.5, 5.25),
                               glm::dvec2(5.0, 5.0)}) {
      EXPECT_NEAR(density_of(model, footprint, surface.normal(u)) / slow.density(surface.normal(u)), 1, 1e-9) << u.x;
    }
  }
}

// Far out in the tail of a narrow lobe, only positions far outside the footprint have the normal that is asked for.
TEST(ExactPndf, KeepsItsAccuracyWhereOnlyDistantPositionsContribute) {
  const glm::dmat2 j = dyadic(64, 0, 0, 0);
  constexpr double roughness = 1e-3;
  const ExactPndf model(Surface(ramp_map({-0.5, 0}, j), Interpolation::linear), roughness);
  const Footprint footprint = isotropic_footprint({64, 64}, 1);
  const SymmetricMatrix2 lobe = lobe_of_ramp(j, footprint.covariance, roughness);
  for (const double deviations : {8.0, 13.0, 20.0, 30.0}) {
    const glm::dvec2 offset{deviations * std::sqrt(lobe.xx), 0};
    EXPECT_NEAR(density_of(model, footprint, offset) / test::slow_normal_density(offset, lobe), 1, 1e-9) << deviations;
  }
}

// Across the map this footprint all but vanishes: its Fourier series is rounding there, and must not go below zero.
TEST(ExactPndf, OfAFoldedFootprintIsNeverNegative) {
  const MapPointer map = test::map_of(8, 1600, Wrap::repeat, [](int, int row) { return glm::dvec2(row / 2048.0, 0); });
  const Footprint footprint{{4, 800}, {1e8, 0, 1056.25}};
  ASSERT_TRUE(FoldedFootprint::pays(*map, footprint.covariance, 8.5));
  const ExactPndf model(Surface(map, Interpolation::constant), 1e-5);
  const double peak = density_of(model, footprint, {800 / 2048.0, 0});
  const auto row_mass = [](double row) { return normal_cdf((row + 1) / 32.5) - normal_cdf(row / 32.5); };
  EXPECT_NEAR(density_of(model, footprint, {850 / 2048.0, 0}) / peak / (row_mass(50) / row_mass(0)), 1, 1e-8);
  for (int row = 0; row < 1600; row += 7) {
    const double density = density_of(model, footprint, {row / 2048.0, 0});
    EXPECT_GE(density, 0) << row;
    EXPECT_LE(density, peak * (1 + 1e-9)) << row;
  }
}

TEST(ExactPndf, OfAWideFootprintIsThatOfTheTiledMapUnfolded) {
  for (const Interpolation interpolation : k_surfaces) {
    const MapPointer map = test::wavy_map(100, 104, Wrap::repeat);
    const MapPointer many = test::tiled(*map, 9, 9);
    const Footprint footprint{{13.7, 31.2}, {2100, 450, 1800}};
    ASSERT_TRUE(FoldedFootprint::pays(*map, footprint.covariance, 8.5));
    ASSERT_FALSE(FoldedFootprint::pays(*many, footprint.covariance, 8.5));
    for (const double roughness : {1e-4, 0.01, 0.3}) {
      const ExactPndf folded(Surface(map, interpolation), roughness, {2});
      const ExactPndf unfolded(Surface(many, interpolation), roughness, {2});
      PndfWorkspace workspace;
      const FootprintPndf& pndf = folded.at(footprint, workspace);
      RandomStream random(8, 0);
      for (int k = 0; k < 2; ++k) {
        const glm::dvec2 s = pndf.sample(random);
        EXPECT_NEAR(pndf.pdf(s) / density_of(unfolded, footprint, s), 1, 5e-9)
            << roughness << " surface " << static_cast<int>(interpolation);
      }
    }
  }
}

TEST(ExactPndf, ShiftedVerticesTakeTheBiasFromSecondToFourthOrder) {
  const Surface surface(test::wavy_map(8, 8, Wrap::repeat, 0.15), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({4.2, 3.6}, 1);
  constexpr double roughness = 0.03;
  const PndfGrid grid{-0.25, 0.25, -0.25, 0.25, 6, 6};
  std::vector<glm::dvec2> s;
  std::vector<double> expected;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      s.push_back(grid.center(column, row));
      expected.push_back(test::slow_smooth_density(surface, footprint, roughness, s.back()));
    }
  }
  const auto error = [&](int subdivision, bool shift) {
    std::vector<double> density(s.size());
    JobControl control;
    EXPECT_TRUE(evaluate_all(ExactPndf(surface, roughness, {subdivision, shift}), footprint, s, density, control));
    return test::relative_l1(density, expected);
  };
  EXPECT_NEAR(error(2, false) / error(4, false), 4, 0.8);
  EXPECT_NEAR(error(4, false) / error(8, false), 4, 0.8);
  EXPECT_GT(error(2, true) / error(4, true), 8);
  EXPECT_GT(error(4, true) / error(8, true), 8);
  EXPECT_LT(error(4, true), error(4, false) / 50);
  RecordProperty("plain, 4", std::to_string(error(4, false) * 1e6) + "e-6");
  RecordProperty("shifted, 2", std::to_string(error(2, true) * 1e6) + "e-6");
  RecordProperty("shifted, 4", std::to_string(error(4, true) * 1e6) + "e-6");
  RecordProperty("shifted, 8", std::to_string(error(8, true) * 1e6) + "e-6");
}

TEST(ExactPndf, SaysWhatItIs) {
  const MapPointer map = test::rough_map(40, 24, Wrap::repeat);
  const ExactPndf model(Surface(map, Interpolation::smooth), 0.02);
  EXPECT_EQ(model.info().name, "exact");
  EXPECT_EQ(model.info().surface, Interpolation::smooth);
  EXPECT_EQ(model.info().bytes, 6 * sizeof(NormalBox));  // 3 x 2 tiles of 16 x 16 cells
  PndfWorkspace workspace;
  EXPECT_EQ(model.at({}, workspace).error().estimated, 0);
  EXPECT_LE(model.at({}, workspace).error().bounded, 1e-9);
}

TEST(EvaluateAll, GivesTheSameBytesForAnyNumberOfThreadsAndNothingOnceCancelled) {
  const ExactPndf model(Surface(test::rough_map(8, 8, Wrap::repeat), Interpolation::linear), 0.05);
  const Footprint footprint{{3, 4}, {1, 0.3, 2}};
  std::vector<glm::dvec2> s;
  for (int k = 0; k < 101; ++k) s.emplace_back(0.005 * k - 0.2, 0.1 - 0.003 * k);
  std::vector<double> one(s.size());
  std::vector<double> two(s.size());
  JobControl control;
  {
    const ThreadLimit limit(1);
    ASSERT_TRUE(evaluate_all(model, footprint, s, one, control));
  }
  {
    const ThreadLimit limit(2);
    ASSERT_TRUE(evaluate_all(model, footprint, s, two, control));
  }
  EXPECT_EQ(one, two);
  EXPECT_EQ(one[100], density_of(model, footprint, s[100]));
  control.cancel();
  EXPECT_FALSE(evaluate_all(model, footprint, s, one, control));
}

}  // namespace
}  // namespace glint
