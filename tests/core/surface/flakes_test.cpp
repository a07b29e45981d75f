#include "core/surface/flakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/pndf/mixture_pndf.h"
#include "tests/core/pndf/beckmann.h"
#include "tests/core/pndf/test_maps.h"
#include "tests/core/surface/map_slopes.h"

namespace glint {
namespace {

FlakeSettings settings_of(int size, double radius) {
  FlakeSettings settings;
  settings.size = size;
  settings.radius = radius;
  return settings;
}

std::vector<Flake> placed(const FlakeSettings& settings) {
  JobControl control;
  return place_flakes(settings, control).value();
}

NormalMap generated(const FlakeSettings& settings) {
  JobControl control;
  return generate_flakes(settings, control).value();
}

double wrapped_distance(glm::dvec2 a, glm::dvec2 b, double size) {
  const auto along = [&](double d) { return d - size * std::round(d / size); };
  return std::hypot(along(a.x - b.x), along(a.y - b.y));
}

// The distance from a place to the nearest flake, and which one that is.
std::pair<double, std::size_t> nearest(const std::vector<Flake>& flakes, glm::dvec2 place, double size) {
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k < flakes.size(); ++k) {
    best = std::min(best, std::pair(wrapped_distance(place, flakes[k].center, size), k));
  }
  return best;
}

TEST(Flakes, AreNoNearerThanTheirRadiusOverTheBorderToo) {
  for (const auto& [size, radius] :
       {std::pair(200, 6.0), std::pair(97, 3.3), std::pair(24, 6.0), std::pair(8, 1.0), std::pair(64, 16.0)}) {
    const std::vector<Flake> flakes = placed(settings_of(size, radius));
    double least = size;
    for (std::size_t a = 0; a < flakes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        least = std::min(least, wrapped_distance(flakes[a].center, flakes[b].center, size));
      }
      EXPECT_TRUE(flakes[a].center.x >= 0 && flakes[a].center.x < size);
      EXPECT_TRUE(flakes[a].center.y >= 0 && flakes[a].center.y < size);
    }
    EXPECT_GE(least, radius * (1 - 1e-12)) << size;
    EXPECT_LE(least, radius * 1.25) << "they are as near as that somewhere";
  }
}

TEST(Flakes, LeaveNoRoomForAnother) {
  const int size = 120;
  const std::vector<Flake> flakes = placed(settings_of(size, 5));
  RandomStream random(1, 2);
  for (int k = 0; k < 20'000; ++k) {
    const double x = size * random.next_uniform();
    ASSERT_LE(nearest(flakes, {x, size * random.next_uniform()}, size).first, 5 * (1 + 1e-4));
  }
}

TEST(Flakes, AreAsDenseAsRandomDisksCanBe) {
  const double area_of_radius = 512.0 * 512.0 / 36.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    FlakeSettings settings = settings_of(512, 6);
    settings.seed = seed;
    // Random sequential packing covers 0.547: 0.547 4 / pi = 0.697 flakes per squared radius.
    EXPECT_NEAR(static_cast<double>(placed(settings).size()) / area_of_radius, 0.697, 0.01);
  }
}

TEST(Flakes, HaveTheSlopesOfTheirBeckmannDistribution) {
  FlakeSettings settings = settings_of(1024, 4);
  for (const double alpha : {0.1, 0.3, 1.41}) {
    settings.alpha = alpha;
    const std::vector<Flake> flakes = placed(settings);
    const auto count = static_cast<double>(flakes.size());
    glm::dvec2 sum{0, 0};
    glm::dvec2 squares{0, 0};
    double product = 0;
    double steep = 0;
    for (const Flake& flake : flakes) {
      const glm::dvec2 slope = test::slope_of(flake.normal);
      sum += slope;
      squares += slope * slope;
      product += slope.x * slope.y;
      steep += glm::dot(slope, slope) > alpha * alpha ? 1 : 0;
    }
    const double variance = alpha * alpha / 2;
    const double noise = 4 / std::sqrt(count);
    for (const int axis : {0, 1}) {
      EXPECT_NEAR(sum[axis] / count / std::sqrt(variance), 0, noise);
      EXPECT_NEAR(squares[axis] / count / variance, 1, noise * std::numbers::sqrt2);
    }
    EXPECT_NEAR(product / count / variance, 0, noise);
    EXPECT_NEAR(steep / count, std::exp(-1.0), noise / 2) << "not merely of that variance";
  }
}

TEST(Flakes, AreLevelInTheShareThatIsAsked) {
  FlakeSettings settings = settings_of(512, 4);
  settings.flat_share = 0.4;
  const std::vector<Flake> some = placed(settings);
  const auto level = [](const Flake& flake) { return flake.normal == glm::dvec2(0); };
  const auto count = static_cast<double>(std::count_if(some.begin(), some.end(), level));
  EXPECT_NEAR(count / static_cast<double>(some.size()), 0.4, 0.02);
  settings.flat_share = 0.5;
  const std::vector<Flake> more = placed(settings);
  for (std::size_t k = 0; k < some.size(); ++k) {
    ASSERT_EQ(more[k].center, some[k].center);
    ASSERT_TRUE(level(more[k]) || more[k].normal == some[k].normal) << "those that stay are as they were";
    ASSERT_TRUE(level(more[k]) || !level(some[k]));
  }
  settings.flat_share = 1;
  EXPECT_TRUE(test::same_bytes(
      generated(settings), NormalMap(512, 512, std::vector<glm::vec2>(test::texel_count(512)), Wrap::repeat, true)));
}

TEST(Flakes, StayWhereTheyAreWhenTheirSlopesChange) {
  FlakeSettings settings = settings_of(128, 5);
  const std::vector<Flake> gentle = placed(settings);
  settings.alpha *= 2;
  const std::vector<Flake> steep = placed(settings);
  ASSERT_EQ(gentle.size(), steep.size());
  for (std::size_t k = 0; k < gentle.size(); ++k) {
    ASSERT_EQ(gentle[k].center, steep[k].center);
    const glm::dvec2 twice = 2.0 * test::slope_of(gentle[k].normal);
    ASSERT_LE(glm::distance(test::slope_of(steep[k].normal), twice), 1e-9 * (1 + glm::length(twice)));
  }
}

TEST(FlakeMap, TakesTheNearestFlakeOfEveryTexelOverTheBorderToo) {
  for (const auto& [size, radius] : {std::pair(60, 6.0), std::pair(37, 9.2), std::pair(24, 6.0), std::pair(8, 2.0)}) {
    const FlakeSettings settings = settings_of(size, radius);
    const std::vector<Flake> flakes = placed(settings);
    const NormalMap map = generated(settings);
    EXPECT_TRUE(map.piecewise_constant());
    EXPECT_EQ(map.wrap(), Wrap::repeat);
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const Flake& flake = flakes[nearest(flakes, {i + 0.5, j + 0.5}, size).second];
        ASSERT_EQ(map.texel(i, j), glm::vec2(flake.normal)) << size << ": " << i << ", " << j;
      }
    }
  }
}

TEST(FlakeMap, IsTheSameBytesForAnyNumberOfThreads) {
  const auto with_threads = [&](int threads, const FlakeSettings& settings) {
    const ThreadLimit limit(threads);
    return generated(settings);
  };
  FlakeSettings settings = settings_of(200, 6);
  const NormalMap one = with_threads(1, settings);
  EXPECT_TRUE(test::same_bytes(one, with_threads(2, settings)));
  EXPECT_TRUE(test::same_bytes(one, with_threads(4, settings)));
  settings.seed += 1;
  EXPECT_FALSE(test::same_bytes(one, with_threads(1, settings)));
}

TEST(FlakeMap, UnderAHugeFootprintIsBeckmannsDistributionConvolvedWithTheRoughness) {
  const double alpha = 0.3;
  const double roughness = 0.1;
  FlakeSettings settings = settings_of(512, 3);
  settings.alpha = alpha;
  const Surface surface(std::make_shared<const NormalMap>(generated(settings)), Interpolation::constant);
  const PndfImage image = test::image_of(MixturePndf(surface, roughness), isotropic_footprint({20, 300}, 3000),
                                         PndfGrid{-1, 1, -1, 1, 40, 40});
  // 20000 flakes of unequal area: some 2 % of noise.
  EXPECT_LE(test::relative_l1(image.density, test::beckmann_image(image.grid, alpha, roughness)), 0.04);
}

TEST(Flakes, RefuseWhatCannotBeAndNameTheField) {
  const auto subject = [](auto change) {
    FlakeSettings settings;
    change(settings);
    JobControl control;
    const auto map = generate_flakes(settings, control);
    const auto flakes = place_flakes(settings, control);
    EXPECT_FALSE(map);
    EXPECT_FALSE(flakes);
    if (map || flakes) return std::string("made");
    EXPECT_EQ(map.error().kind, ErrorKind::request);
    EXPECT_EQ(map.error().message(), flakes.error().message());
    return map.error().subject;
  };
  for (const int size : {-1, 0, 7, 16385}) {
    EXPECT_EQ(subject([&](auto& s) { s.size = size; }), "surface.generator.size");
  }
  for (const double radius : {-1.0, 0.0, 0.99, 256.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(subject([&](auto& s) { s.radius = radius; }), "surface.generator.radius");
  }
  EXPECT_EQ(subject([](auto& s) { s.size = 16; }), "surface.generator.radius") << "6 is more than a quarter";
  EXPECT_EQ(subject([](auto& s) {
              s.size = 16384;
              s.radius = 5;
            }),
            "surface.generator.radius")
      << "too many flakes";
  for (const double alpha : {-0.1, 10.1, std::nan("")}) {
    EXPECT_EQ(subject([&](auto& s) { s.alpha = alpha; }), "surface.generator.alpha");
  }
  for (const double share : {-0.1, 1.1, std::nan("")}) {
    EXPECT_EQ(subject([&](auto& s) { s.flat_share = share; }), "surface.generator.flat_share");
  }
}

TEST(Flakes, SayThatTheyWereCancelled) {
  JobControl control;
  control.cancel();
  const auto map = generate_flakes(FlakeSettings{}, control);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::content);
  EXPECT_NE(map.error().sentence.find("cancelled"), std::string::npos);
  EXPECT_FALSE(place_flakes(FlakeSettings{}, control));
}

}  // namespace
}  // namespace glint
