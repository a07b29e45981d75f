// LEAN: the moments of slopes against a plain twin and closed forms, and the P-NDF made of them.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/lean_pndf.h"
#include "tests/core/pndf/slow_slopes.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::SlowMoments;

// One of each way in which footprints are merged.
const double k_radii[] = {0.01, 0.3, 0.8, 5.0, 9.0, 20.0, 70.0, 300.0};

LeanPndf smooth_model(const test::MapPointer& map, double roughness = 0.01) {
  return {Surface(map, Interpolation::smooth), roughness};
}

test::MapPointer map_of_slopes(int width, int height, Wrap wrap, const std::function<glm::dvec2(int, int)>& slope) {
  return test::map_of(width, height, wrap, [&](int i, int j) {
    const glm::dvec2 m = slope(i, j);
    return -m / std::sqrt(1 + m.x * m.x + m.y * m.y);
  });
}

// In shares of the deviation of all slopes, or of its square.
void expect_moments(const SlopeMoments& moments, const SlowMoments& expected, double tolerance,
                    const std::string& what) {
  const double variance = expected.xx + expected.yy;
  const double deviation = std::sqrt(variance);
  EXPECT_NEAR(moments.mean.x / deviation, expected.x / deviation, tolerance) << what;
  EXPECT_NEAR(moments.mean.y / deviation, expected.y / deviation, tolerance) << what;
  EXPECT_NEAR(moments.covariance.xx / variance, expected.xx / variance, tolerance) << what;
  EXPECT_NEAR(moments.covariance.xy / variance, expected.xy / variance, tolerance) << what;
  EXPECT_NEAR(moments.covariance.yy / variance, expected.yy / variance, tolerance) << what;
}

TEST(SlopeMomentsOf, APlaneHaveNoCovariance) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const LeanPndf model = smooth_model(test::constant_map({0.3, -0.5}, wrap, 37));
    const double z = std::sqrt(1 - 0.09 - 0.25);
    for (const double radius : k_radii) {
      const SlopeMoments moments = model.moments(isotropic_footprint({3, 33}, radius));
      EXPECT_NEAR(moments.mean.x, -0.3 / z, 1e-6) << radius;
      EXPECT_NEAR(moments.mean.y, 0.5 / z, 1e-6) << radius;
      EXPECT_LE(moments.covariance.xx + moments.covariance.yy, 1e-15) << radius << ": blocks round their mean";
    }
  }
}

TEST(SlopeMomentsOf, TwoSlopesAreTheSquareOfHalfTheirDifference) {
  const glm::dvec2 middle{0.2, -0.4};
  const glm::dvec2 d{0.03, 0.05};
  const auto map =
      map_of_slopes(32, 32, Wrap::repeat, [&](int i, int j) { return (i + j) % 2 == 0 ? middle + d : middle - d; });
  for (const double radius : {1.5, 20.0, 100.0}) {
    const SlopeMoments moments = smooth_model(map).moments(isotropic_footprint({9, 5}, radius));
    EXPECT_NEAR(moments.mean.x, middle.x, 1e-6);
    EXPECT_NEAR(moments.covariance.xx / (d.x * d.x), 1, 1e-5) << radius;
    EXPECT_NEAR(moments.covariance.xy / (d.x * d.y), 1, 1e-5) << radius;
    EXPECT_NEAR(moments.covariance.yy / (d.y * d.y), 1, 1e-5) << radius;
  }
}

TEST(SlopeMomentsOf, AWaveAreHalfTheSquareOfItsSteepestSlope) {
  const double k = 2 * std::numbers::pi / 16;
  const double amplitude = 0.8;
  const auto map = map_of_slopes(64, 48, Wrap::repeat,
                                 [&](int i, int) { return glm::dvec2(amplitude * k * std::cos(k * (i + 0.5)), 0); });
  const SlopeMoments moments = smooth_model(map).moments(isotropic_footprint({9, 5}, 200));
  EXPECT_NEAR(moments.covariance.xx / (0.5 * amplitude * amplitude * k * k), 1, 1e-6);
  EXPECT_NEAR(moments.covariance.xy, 0, 1e-8);
  EXPECT_NEAR(moments.covariance.yy, 0, 1e-8);
}

TEST(SlopeMomentsOf, SteepSlopesThatHardlyDifferKeepTheirVariance) {
  // In single precision E[m^2] - E[m]^2 is noise of 1e-7 here, ten times the variance, and negative half the time.
  const auto map = map_of_slopes(64, 64, Wrap::repeat,
                                 [&](int i, int j) { return glm::dvec2((i + j) % 2 == 0 ? 0.9001 : 0.8999, 0); });
  for (const double radius : {3.0, 12.0, 100.0}) {
    const Footprint footprint = isotropic_footprint({32, 32}, radius);
    const SlopeMoments moments = smooth_model(map).moments(footprint);
    EXPECT_NEAR(moments.covariance.xx / test::slow_moments(*map, isotropic_footprint({32, 32}, 3)).xx, 1, 2e-3);
    EXPECT_NEAR(moments.covariance.xx / 1e-8, 1, 0.02) << radius;
  }
}

TEST(SlopeMomentsOf, ARampAreTheFootprintSeenThroughItsSlope) {
  const glm::dvec2 du{0.004, 0.001};
  const glm::dvec2 dv{-0.002, 0.003};
  const auto map =
      map_of_slopes(160, 160, Wrap::clamp, [&](int i, int j) { return (i - 79.5) * du + (j - 79.5) * dv; });
  // Blocks, without the narrowing by their own spread, would add 1 to 3 percent.
  for (const SymmetricMatrix2& c :
       {SymmetricMatrix2{4, 1, 2}, SymmetricMatrix2{70, 0, 70}, SymmetricMatrix2{120, -30, 90}}) {
    const SlopeMoments moments = smooth_model(map).moments({{81.3, 79.9}, c});
    const auto quadratic = [&](double au, double av, double bu, double bv) {
      return au * (c.xx * bu + c.xy * bv) + av * (c.xy * bu + c.yy * bv);
    };
    const double xx = quadratic(du.x, dv.x, du.x, dv.x);
    const double yy = quadratic(du.y, dv.y, du.y, dv.y);
    EXPECT_NEAR(moments.covariance.xx / xx, 1, 1e-3) << c.xx;
    EXPECT_NEAR(moments.covariance.xy / xx, quadratic(du.x, dv.x, du.y, dv.y) / xx, 1e-3) << c.xx;
    EXPECT_NEAR(moments.covariance.yy / yy, 1, 1e-3) << c.xx;
    EXPECT_NEAR(moments.mean.x, 1.3 * du.x - 0.1 * dv.x, 1e-5) << c.xx;
  }
}

TEST(MomentSum, IsPositiveSemiDefiniteAfterAMillionMerges) {
  RandomStream random(3, 4);
  MomentSum sum;
  for (int k = 0; k < 1'000'000; ++k) {
    // Of all sizes, half of them of one direction only, around means that differ much or hardly.
    const double size = std::exp(20 * random.next_uniform() - 15);
    const double angle = 2 * std::numbers::pi * random.next_uniform();
    const double across = k % 2 == 0 ? 0 : random.next_uniform();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    if (k % 1000 == 0) sum = MomentSum();
    sum.add(random.next_uniform() + 1e-6, {glm::dvec2(0.9, -0.4) + size * glm::dvec2(c, s),
                                           {size * size * (c * c + across * s * s), size * size * (1 - across) * c * s,
                                            size * size * (s * s + across * c * c)}});
    const SymmetricMatrix2 covariance = sum.moments().covariance;
    ASSERT_TRUE(covariance.xx >= 0 && covariance.yy >= 0 && determinant(covariance) >= 0) << k;
  }
}

TEST(MomentSum, DoesNotDependOnTheOrder) {
  RandomStream random(8, 4);
  std::vector<std::pair<double, SlopeMoments>> parts;
  for (int k = 0; k < 300; ++k) {
    const double a = random.next_uniform();
    parts.push_back({random.next_uniform(), {{random.next_uniform(), -random.next_uniform()}, {a, 0.3 * a, 0.5 * a}}});
  }
  MomentSum forwards;
  for (const auto& [weight, part] : parts) forwards.add(weight, part);
  MomentSum backwards;
  std::reverse(parts.begin(), parts.end());
  for (const auto& [weight, part] : parts) backwards.add(weight, part);
  MomentSum halves[2];
  for (std::size_t k = 0; k < parts.size(); ++k) halves[k % 2].add(parts[k].first, parts[k].second);
  MomentSum whole;
  for (const MomentSum& half : halves) whole.add(half.weight(), half.moments());
  const SlopeMoments expected = forwards.moments();
  for (const SlopeMoments& other : {backwards.moments(), whole.moments()}) {
    EXPECT_NEAR(other.mean.x, expected.mean.x, 1e-14);
    EXPECT_NEAR(other.covariance.xx, expected.covariance.xx, 1e-14);
    EXPECT_NEAR(other.covariance.xy, expected.covariance.xy, 1e-14);
    EXPECT_NEAR(other.covariance.yy, expected.covariance.yy, 1e-14);
  }
}

TEST(MomentChain, HoldsTheMomentsOfItsBlocksAtOddBordersToo) {
  const auto map = test::rough_map(37, 22, Wrap::repeat);
  const MomentChain chain(*map, {0, 0, 37, 22});
  EXPECT_EQ(chain.levels(), 5);  // blocks of 4, 8, 16, 32 and 64
  for (int level = 0; level < chain.levels(); ++level) {
    const std::int64_t size = MomentChain::block_size(level);
    for (std::int64_t j = 0; j * size < 22; ++j) {
      for (std::int64_t i = 0; i * size < 37; ++i) {
        SlowMoments sum;
        for (int pass = 0; pass < 2; ++pass) {
          for (std::int64_t y = j * size; y < std::min<std::int64_t>((j + 1) * size, 22); ++y) {
            for (std::int64_t x = i * size; x < std::min<std::int64_t>((i + 1) * size, 37); ++x) {
              const glm::dvec2 m = test::slow_slope(map->texel(x, y));
              sum.weight += pass == 0 ? 1 : 0;
              sum.x += pass == 0 ? m.x : 0;
              sum.y += pass == 0 ? m.y : 0;
              sum.xx += pass == 0 ? 0 : (m.x - sum.x) * (m.x - sum.x) / sum.weight;
              sum.xy += pass == 0 ? 0 : (m.x - sum.x) * (m.y - sum.y) / sum.weight;
              sum.yy += pass == 0 ? 0 : (m.y - sum.y) * (m.y - sum.y) / sum.weight;
            }
          }
          if (pass == 0) sum.x /= sum.weight;
          if (pass == 0) sum.y /= sum.weight;
        }
        expect_moments(chain.block(level, i, j), sum, 1e-6, "level " + std::to_string(level));
      }
    }
  }
}

TEST(LeanMoments, ClampAndCountTexelsTooSteepToHaveASlope) {
  const auto map = test::map_of(16, 16, Wrap::repeat, [](int i, int j) {
    if (i == 3 && j == 5) return glm::dvec2(0.8, 0.6);  // on the rim
    if (i == 9 && j == 5) return glm::dvec2(0, -0.9999);
    return glm::dvec2(0);
  });
  const LeanMoments moments(*map);
  EXPECT_EQ(moments.clamped_texels(), 2U);
  EXPECT_EQ(moments.map().whole().mean, glm::dvec2(glm::vec2(glm::dvec2(-40, -30 + 50) / 256.0)));
  EXPECT_FALSE(texel_slope({0, -0.99979}).clamped) << "z is 0.0205";
  EXPECT_TRUE(texel_slope({0, -0.99981}).clamped) << "z is 0.0195";
}

TEST(LeanMoments, TakeLessThanTwoBytesATexel) {
  const LeanPndf model = smooth_model(test::wavy_map(512, 256, Wrap::repeat));
  EXPECT_EQ(model.info().bytes, 0U) << "nothing is built before it is needed";
  EXPECT_TRUE(std::isfinite(model.moments(isotropic_footprint({5, 5}, 5)).mean.x));
  EXPECT_EQ(model.info().bytes, 0U) << "small footprints do not need it";
  EXPECT_TRUE(std::isfinite(model.moments(isotropic_footprint({5, 5}, 50)).mean.x));
  EXPECT_GT(model.info().bytes, 512U * 256U);
  EXPECT_LE(model.info().bytes, 2U * 512U * 256U);
}

TEST(Lean, MergesTexelsAsItsTwin) {
  const std::vector<std::pair<std::string, Footprint>> footprints = {
      {"isotropic", isotropic_footprint({20.3, 11.1}, 0.8)},
      {"isotropic", isotropic_footprint({20.3, 11.1}, 2.5)},
      {"across the border", isotropic_footprint({60.9, 46.8}, 1.5)},
      {"across the other border", isotropic_footprint({0.1, 0.2}, 2)},
      {"many periods away", isotropic_footprint({61 * 90 + 3.3, -47 * 70}, 1)},
      {"long and turned", test::turned_footprint({13.3, 40.1}, 30, 1, 0.7)},
      {"long and turned back", test::turned_footprint({13.3, 40.1}, 30, 1, -0.4)},
      {"long and level", test::turned_footprint({13.3, 40.1}, 60, 2, 0)},
      {"far longer than the map", test::turned_footprint({13.3, 40.1}, 300, 4, 1.2)}};
  for (const auto& [name, map] : {std::pair("rough", test::rough_map(61, 47, Wrap::repeat)),
                                  std::pair("wavy", test::wavy_map(61, 47, Wrap::repeat))}) {
    for (const auto& [what, footprint] : footprints) {
      expect_moments(smooth_model(map).moments(footprint), test::slow_moments(*map, footprint), 3e-5,
                     std::string(name) + ", " + what);
    }
  }
}

TEST(Lean, MergesTexelsAlikeAlongTheDiagonal) {
  const auto map = test::rough_map(16, 16, Wrap::repeat);
  const Footprint footprint = test::turned_footprint({13.3, 10.1}, 150, 0.9, std::numbers::pi / 4);
  expect_moments(smooth_model(map).moments(footprint), test::slow_moments(*map, footprint), 3e-5, "folded");
  // Waves of so many turns that walking is cheaper.
  const Footprint longer = test::turned_footprint({13.3, 10.1}, 1700, 0.9, std::numbers::pi / 4);
  const SlopeMoments folded = smooth_model(map).moments(longer);
  const SymmetricMatrix2& c = folded.covariance;
  expect_moments(smooth_model(test::tiled(*map, 10, 10)).moments(longer),
                 {1, folded.mean.x, folded.mean.y, c.xx, c.xy, c.yy}, 3e-5, "walked");
}

TEST(Lean, OfMapsOneTexelWideMergesAsItsTwin) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const glm::ivec2 size : {glm::ivec2(1, 37), glm::ivec2(37, 1)}) {
      const auto map = test::wavy_map(size.x, size.y, wrap);
      for (const Footprint& footprint : {isotropic_footprint({0.3, 0.6}, 2.5), isotropic_footprint({0.3, 0.6}, 9),
                                         test::turned_footprint({0.2, 0.9}, 20, 1, 0.7)}) {
        expect_moments(smooth_model(map).moments(footprint), test::slow_moments(*map, footprint), 5e-3,
                       std::to_string(size.x) + ", " + std::to_string(footprint.covariance.xx));
      }
    }
    const auto map = test::constant_map({0.3, -0.5}, wrap, 1);
    for (const double radius : k_radii) {
      const SlopeMoments moments = smooth_model(map).moments(isotropic_footprint({0.2, 7.4}, radius));
      EXPECT_NEAR(moments.mean.x, -0.3 / std::sqrt(1 - 0.09 - 0.25), 1e-6) << radius;
      EXPECT_LE(moments.covariance.xx + moments.covariance.yy, 1e-15) << radius;
    }
  }
}

TEST(Lean, MergesBlocksNearlyAsItsTwinMergesTexels) {
  const std::vector<std::pair<std::string, Footprint>> footprints = {
      {"isotropic", isotropic_footprint({20.3, 11.1}, 8)},
      {"isotropic", isotropic_footprint({20.3, 11.1}, 15)},
      {"across the border", isotropic_footprint({60.9, 46.8}, 10)},
      {"as wide as the map", isotropic_footprint({13.3, 40.1}, 17)},
      {"half as wide as the map", isotropic_footprint({13.3, 40.1}, 30)},
      {"wider than the map", isotropic_footprint({13.3, 40.1}, 40)},
      {"much wider than the map", isotropic_footprint({13.3, 40.1}, 150)},
      {"long and turned", test::turned_footprint({13.3, 40.1}, 80, 9, 0.7)},
      {"longer than the map", test::turned_footprint({13.3, 40.1}, 270, 9, 0.3)},
      {"longer than the map and level", test::turned_footprint({13.3, 40.1}, 270, 9, 0)}};
  for (const auto& [what, footprint] : footprints) {
    const auto rough = test::rough_map(61, 47, Wrap::repeat);
    expect_moments(smooth_model(rough).moments(footprint), test::slow_moments(*rough, footprint), 1e-2, what);
    const auto wavy = test::wavy_map(61, 47, Wrap::repeat);
    expect_moments(smooth_model(wavy).moments(footprint), test::slow_moments(*wavy, footprint), 2e-3, what);
  }
}

TEST(Lean, OfAMapThatClampsGoesOnWithItsBorder) {
  const std::vector<std::pair<std::string, Footprint>> footprints = {
      {"inside", isotropic_footprint({30, 20}, 2.5)},
      {"at the left", isotropic_footprint({0.3, 20}, 2.5)},
      {"at the right", isotropic_footprint({60.9, 20}, 2.5)},
      {"at the top", isotropic_footprint({30, 0.2}, 2.5)},
      {"at the bottom", isotropic_footprint({30, 46.7}, 2.5)},
      {"at a corner", isotropic_footprint({60.5, 0.5}, 4)},
      {"at a corner, blocks", isotropic_footprint({0.5, 46.5}, 10)},
      {"at a border, turned", test::turned_footprint({59, 30}, 30, 3, 0.7)},
      {"at a border, turned, blocks", test::turned_footprint({59, 30}, 50, 9, -0.5)},
      {"wider than the map", isotropic_footprint({20, 30}, 70)},
      {"far wider than the map", isotropic_footprint({20, 30}, 400)}};
  const auto map = test::wavy_map(61, 47, Wrap::clamp);
  for (const auto& [what, footprint] : footprints) {
    const SlopeMoments moments = smooth_model(map).moments(footprint);
    expect_moments(moments, test::slow_moments(*map, footprint), 5e-3, what);
  }
}

TEST(Lean, OfFlakesWeighsThemByTheirSquares) {
  const auto map = test::rough_map(24, 19, Wrap::repeat);
  const LeanPndf model(Surface(map, Interpolation::constant), 0.01);
  const std::vector<std::pair<Footprint, int>> footprints = {{isotropic_footprint({7.3, 18.1}, 0.1), 400},
                                                             {isotropic_footprint({7.3, 18.1}, 0.4), 100},
                                                             {isotropic_footprint({7.3, 18.1}, 1.5), 30},
                                                             {isotropic_footprint({7.3, 18.1}, 3), 16},
                                                             {isotropic_footprint({7.3, 18.1}, 12), 4},
                                                             {test::turned_footprint({7.3, 18.1}, 3, 0.2, 0.7), 100},
                                                             {test::turned_footprint({7.3, 18.1}, 0.2, 4, 0.2), 100}};
  for (const auto& [footprint, points] : footprints) {
    expect_moments(model.moments(footprint), test::slow_moments(*map, footprint, points),
                   footprint.covariance.xx > 100 ? 5e-3 : 5e-4, std::to_string(footprint.covariance.xx));
  }
  // Not those of their centres alone, whose footprint would be narrower by 1 / 12.
  const auto gentle = test::wavy_map(61, 47, Wrap::repeat);
  const Footprint round = isotropic_footprint({20.2, 30.4}, 2.1);
  expect_moments(LeanPndf(Surface(gentle, Interpolation::constant), 0.01).moments(round),
                 test::slow_moments(*gentle, round, 16), 5e-4, "gentle");
  // Inside one flake there is one slope only.
  const SlopeMoments one = model.moments(isotropic_footprint({7.5, 3.5}, 0.01));
  EXPECT_NEAR(one.mean.x, test::slow_slope(map->texel(7, 3)).x, 1e-12);
  EXPECT_LE(one.covariance.xx, 1e-20);
}

glm::dvec2 surface_slope(const Surface& surface, glm::dvec2 u) {
  const glm::dvec2 s = surface.normal(u);
  return -s / std::sqrt(1 - s.x * s.x - s.y * s.y);
}

TEST(Lean, OfATinyFootprintIsTheFootprintSeenThroughTheSlopesJacobian) {
  const Surface surface(test::wavy_map(24, 24, Wrap::repeat, 0.3), Interpolation::smooth);
  const glm::dvec2 u{7.2, 23.4};
  const double step = 1e-5;
  const glm::dvec2 du =
      (surface_slope(surface, u + glm::dvec2(step, 0)) - surface_slope(surface, u - glm::dvec2(step, 0))) / (2 * step);
  const glm::dvec2 dv =
      (surface_slope(surface, u + glm::dvec2(0, step)) - surface_slope(surface, u - glm::dvec2(0, step))) / (2 * step);
  for (const Footprint& footprint : {isotropic_footprint(u, 1e-3), test::turned_footprint(u, 2e-3, 1e-4, 0.6),
                                     test::turned_footprint(u, 2e-3, 1e-4, 2)}) {
    const SymmetricMatrix2& p = footprint.covariance;
    const auto quadratic = [&](double au, double av, double bu, double bv) {
      return au * (p.xx * bu + p.xy * bv) + av * (p.xy * bu + p.yy * bv);
    };
    const double xx = quadratic(du.x, dv.x, du.x, dv.x);
    const double yy = quadratic(du.y, dv.y, du.y, dv.y);
    const SlopeMoments moments = LeanPndf(surface, 0.01).moments(footprint);
    EXPECT_NEAR(moments.covariance.xx / xx, 1, 1e-4);
    EXPECT_NEAR(moments.covariance.yy / yy, 1, 1e-4);
    EXPECT_NEAR(moments.covariance.xy / std::sqrt(xx * yy), quadratic(du.x, dv.x, du.y, dv.y) / std::sqrt(xx * yy),
                1e-4);
    EXPECT_NEAR(moments.mean.x, surface_slope(surface, u).x, 1e-6);
  }
}

TEST(Lean, OfAFootprintNarrowerThanATexelHasTheMomentsOfTheSmoothSurface) {
  const Surface surface(test::rough_map(24, 24, Wrap::repeat), Interpolation::smooth);
  for (const Footprint& footprint :
       {isotropic_footprint({7.2, 23.4}, 0.3), isotropic_footprint({7.2, 23.4}, 0.7),
        test::turned_footprint({7.2, 3.4}, 5, 0.4, 0.8), test::turned_footprint({7.2, 3.4}, 0.4, 5, 0.3)}) {
    const CholeskyFactor factor = cholesky(footprint.covariance);
    SlowMoments sum;
    for (int pass = 0; pass < 2; ++pass) {
      for (int l = -400; l <= 400; ++l) {
        for (int k = -400; k <= 400; ++k) {
          const glm::dvec2 xi(0.015 * k, 0.015 * l);
          const double weight = std::exp(-0.5 * (xi.x * xi.x + xi.y * xi.y));
          const glm::dvec2 m = surface_slope(surface, footprint.center + factor.apply(xi));
          sum.weight += pass == 0 ? weight : 0;
          sum.x += pass == 0 ? weight * m.x : 0;
          sum.y += pass == 0 ? weight * m.y : 0;
          sum.xx += pass == 0 ? 0 : weight * (m.x - sum.x) * (m.x - sum.x) / sum.weight;
          sum.xy += pass == 0 ? 0 : weight * (m.x - sum.x) * (m.y - sum.y) / sum.weight;
          sum.yy += pass == 0 ? 0 : weight * (m.y - sum.y) * (m.y - sum.y) / sum.weight;
        }
      }
      if (pass == 0) sum.x /= sum.weight;
      if (pass == 0) sum.y /= sum.weight;
    }
    expect_moments(LeanPndf(surface, 0.01).moments(footprint), sum, 2e-3, std::to_string(footprint.covariance.xx));
  }
}

}  // namespace
}  // namespace glint
