#include "core/surface/scratches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/surface/engraving.h"
#include "tests/core/surface/map_slopes.h"

namespace glint {
namespace {

/// One scratch without dents or blur, of the given half width and flank slope.
ScratchSettings single_scratch(double half_width, double flank_slope) {
  ScratchSettings settings;
  settings.size = 512;
  settings.count = 1;
  settings.length = {250, 250};
  settings.half_width = {half_width, half_width};
  settings.flank_slope = {flank_slope, flank_slope};
  settings.spread = 0;
  settings.blur = 0;
  settings.dent_rms_slope = 0;
  return settings;
}

NormalMap generated(const ScratchSettings& settings) {
  JobControl control;
  return generate_scratches(settings, control).value();
}

double steepest(const NormalMap& map) {
  double largest = 0;
  for (const glm::dvec2 slope : test::slopes_of(map)) largest = std::max(largest, std::hypot(slope.x, slope.y));
  return largest;
}

std::vector<float> engraved(int size, const std::vector<Scratch>& scratches) {
  std::vector<float> heights(test::texel_count(size));
  JobControl control;
  EXPECT_TRUE(engrave(heights, size, scratches, control));
  return heights;
}

TEST(Scratches, AreExactlyFlatWithoutScratchesAndDents) {
  ScratchSettings settings = single_scratch(2, 0.2);
  settings.count = 0;
  settings.size = 64;
  EXPECT_TRUE(test::same_bytes(generated(settings),
                               NormalMap(64, 64, std::vector<glm::vec2>(test::texel_count(64)), Wrap::repeat)));
}

TEST(Scratches, LieOnDentsOfExactRmsSlope) {
  ScratchSettings settings;
  settings.size = 128;
  settings.count = 0;
  settings.dent_rms_slope = 0.03;
  EXPECT_NEAR(test::rms_slope(generated(settings)) / 0.03, 1, 1e-6);
}

TEST(Scratches, AddTheirSlopesToThoseOfTheDents) {
  ScratchSettings both = single_scratch(2, 0.2);
  both.dent_rms_slope = 0.03;
  ScratchSettings dents = both;
  dents.count = 0;
  const auto slopes = test::slopes_of(generated(both));
  const auto of_dents = test::slopes_of(generated(dents));
  const auto of_scratch = test::slopes_of(generated(single_scratch(2, 0.2)));
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    ASSERT_NEAR(slopes[k].x, of_dents[k].x + of_scratch[k].x, 1e-6);
    ASSERT_NEAR(slopes[k].y, of_dents[k].y + of_scratch[k].y, 1e-6);
  }
}

TEST(SingleScratch, ReachesItsFlankSlope) {
  EXPECT_NEAR(steepest(generated(single_scratch(8, 0.2))), 0.2, 0.002);
  EXPECT_NEAR(steepest(generated(single_scratch(8, 0.4))), 0.4, 0.004);
}

TEST(SingleScratch, LosesSlopeToTheBlurAsAGaussianDoes) {
  ScratchSettings settings = single_scratch(8, 0.2);
  settings.blur = 4;
  EXPECT_NEAR(steepest(generated(settings)), 0.2 * 64 / (64 + 16), 0.002);
}

TEST(SingleScratch, RunsInItsDirectionTowardsTheTop) {
  ScratchSettings settings = single_scratch(2, 0.2);
  settings.direction = 30;
  const glm::dvec2 along(std::cos(std::numbers::pi / 6), -std::sin(std::numbers::pi / 6));
  double power = 0;
  double power_along = 0;
  for (const glm::dvec2 slope : test::slopes_of(generated(settings))) {
    power += slope.x * slope.x + slope.y * slope.y;
    power_along += std::pow(slope.x * along.x + slope.y * along.y, 2);
  }
  EXPECT_GT(power, 0);
  EXPECT_LT(power_along / power, 0.02);  // only its ends; 0.75 if it ran towards the bottom
}

TEST(SingleScratch, IsWholeWhereverItCrossesTheBorder) {
  ScratchSettings settings = single_scratch(3, 0.2);
  std::vector<double> energies;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    settings.seed = seed;
    const NormalMap map = generated(settings);
    energies.push_back(std::pow(test::rms_slope(map), 2));
    const test::Jumps jumps = test::largest_jumps(map);
    EXPECT_LE(jumps.across_border, jumps.inside * 1.001);
  }
  const auto [least, most] = std::minmax_element(energies.begin(), energies.end());
  EXPECT_NEAR(*least / *most, 1, 1e-3);
}

TEST(Scratches, StayWhereTheyAreWhenTheirFlankSlopeChanges) {
  ScratchSettings settings = single_scratch(2, 0.1);
  settings.count = 20;
  settings.spread = 90;
  const auto gentle = test::slopes_of(generated(settings));
  settings.flank_slope = {0.2, 0.2};
  const auto steep = test::slopes_of(generated(settings));
  for (std::size_t k = 0; k < gentle.size(); ++k) {
    ASSERT_NEAR(steep[k].x, 2 * gentle[k].x, 1e-6);
    ASSERT_NEAR(steep[k].y, 2 * gentle[k].y, 1e-6);
  }
}

TEST(Scratches, StayWhereTheyAreWhenOneIsAdded) {
  ScratchSettings settings = single_scratch(2, 0.1);
  settings.count = 5;
  settings.spread = 90;
  const NormalMap five = generated(settings);
  settings.count = 6;
  const NormalMap six = generated(settings);
  std::size_t changed = 0;
  for (std::size_t k = 0; k < five.normals().size(); ++k) changed += five.normals()[k] != six.normals()[k] ? 1 : 0;
  EXPECT_GT(changed, 1000U);
  EXPECT_LT(changed, 7620U);  // no more than the box of one scratch
}

TEST(Scratches, GiveTheSameBytesForAnyNumberOfThreads) {
  ScratchSettings settings;
  settings.size = 256;
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return generated(settings);
  };
  const NormalMap one = with_threads(1);
  EXPECT_TRUE(test::same_bytes(one, with_threads(2)));
  EXPECT_TRUE(test::same_bytes(one, with_threads(4)));
  settings.seed += 1;
  EXPECT_FALSE(test::same_bytes(one, generated(settings)));
}

TEST(Scratches, RepeatWithoutASeamAndAreTheSlopeOfAHeightField) {
  ScratchSettings settings;
  settings.size = 256;
  settings.blur = 2;
  const NormalMap map = generated(settings);
  EXPECT_EQ(map.wrap(), Wrap::repeat);
  const test::Jumps jumps = test::largest_jumps(map);
  EXPECT_LE(jumps.across_border, jumps.inside);
  EXPECT_LT(test::relative_curl(map), 0.02);
}

TEST(Scratches, SayThatTheyWereCancelled) {
  JobControl control;
  control.cancel();
  const auto result = generate_scratches(ScratchSettings{}, control);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::content);
  EXPECT_NE(result.error().sentence.find("cancelled"), std::string::npos);
}

TEST(Engraving, HasItsProfileAcrossAndSmoothEnds) {
  const std::vector<float> heights = engraved(128, {{{64.5, 64.5}, 0, 80, 3, 0.2}});
  const double depth = 0.2 * 3 * std::sqrt(std::numbers::e);
  for (int x = -10; x <= 10; ++x) {
    const double expected = -depth * std::exp(-x * x / 18.0);
    EXPECT_NEAR(static_cast<double>(heights[test::index_of(64, 64 + x, 128)]), expected, 1e-6) << x;
  }
  const auto along = [&](int i) { return static_cast<double>(heights[test::index_of(i, 64, 128)]); };
  EXPECT_NEAR(along(24 + 12), -depth, 1e-6);     // 4 w inside
  EXPECT_NEAR(along(24 + 6), -depth / 2, 1e-6);  // half of that
  EXPECT_EQ(along(24), 0);                       // the end
  EXPECT_EQ(along(23), 0);
  EXPECT_EQ(along(104), 0);
}

TEST(Engraving, IsTheSameScratchAfterAShift) {
  const Scratch inside{{64.25, 60.5}, 0.7, 90, 1.5, 0.3};
  Scratch over_the_corner = inside;
  over_the_corner.center -= 64.0;
  Scratch image = over_the_corner;
  image.center += glm::dvec2(128, -256);
  const std::vector<float> whole = engraved(128, {inside});
  const std::vector<float> split = engraved(128, {over_the_corner});
  EXPECT_EQ(split, engraved(128, {image}));
  for (std::size_t j = 0; j < 128; ++j) {
    for (std::size_t i = 0; i < 128; ++i) {
      ASSERT_NEAR(whole[j * 128 + i], split[(j + 64) % 128 * 128 + (i + 64) % 128], 1e-6F) << i << ", " << j;
    }
  }
}

TEST(Engraving, ComesRoundAgainWhenLongerThanTheMap) {
  const std::vector<float> heights = engraved(32, {{{3, 16.5}, 0, 100, 1, 0.2}});
  for (int i = 0; i < 32; ++i) {
    EXPECT_NEAR(heights[test::index_of(i, 16, 32)], -0.2F * 1.6487213F, 1e-6F) << i;
  }
}

TEST(Engraving, CrossingScratchesDoNotAddUp) {
  const Scratch shallow{{32.5, 32.5}, 0, 40, 2, 0.1};
  const Scratch deep{{32.5, 32.5}, std::numbers::pi / 2, 40, 2, 0.3};
  const std::vector<float> both = engraved(64, {shallow, deep});
  EXPECT_EQ(both, engraved(64, {deep, shallow}));
  EXPECT_EQ(both[test::index_of(32, 32, 64)], engraved(64, {deep})[test::index_of(32, 32, 64)]);
  EXPECT_EQ(both[test::index_of(47, 32, 64)], engraved(64, {shallow})[test::index_of(47, 32, 64)]);
}

TEST(Engraving, DropsTheRestWhenCancelled) {
  std::vector<float> heights(test::texel_count(64));
  JobControl control;
  control.cancel();
  EXPECT_FALSE(engrave(heights, 64, std::vector<Scratch>{{{32, 32}, 0, 40, 2, 0.1}}, control));
  EXPECT_EQ(heights, std::vector<float>(test::texel_count(64)));
}

TEST(Blur, IsAGaussianOfItsDeviationAndKeepsTheMean) {
  constexpr int k_size = 64;
  std::vector<float> heights(test::texel_count(k_size));
  heights[test::index_of(61, 2, k_size)] = 1;  // near the corner: the blur must come round
  JobControl control;
  ASSERT_TRUE(blur_heights(heights, k_size, 2.5, control));
  double sum = 0;
  glm::dvec2 second{0, 0};
  for (int j = 0; j < k_size; ++j) {
    for (int i = 0; i < k_size; ++i) {
      const double weight = static_cast<double>(heights[test::index_of(i, j, k_size)]);
      const double x = (i - 61 + 96) % k_size - 32;
      const double y = (j - 2 + 96) % k_size - 32;
      sum += weight;
      second += weight * glm::dvec2(x * x, y * y);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(second.x, 6.25, 1e-4);
  EXPECT_NEAR(second.y, 6.25, 1e-4);
}

TEST(Blur, MayBeWiderThanTheMap) {
  std::vector<float> heights(test::texel_count(8));
  heights[0] = 1;
  JobControl control;
  ASSERT_TRUE(blur_heights(heights, 8, 16, control));
  for (const float height : heights) EXPECT_NEAR(height, 1.0F / 64, 1e-6F);
}

TEST(Blur, OfNothingChangesNothing) {
  std::vector<float> heights = engraved(32, {{{8, 8}, 1, 20, 1, 0.2}});
  const std::vector<float> before = heights;
  JobControl control;
  ASSERT_TRUE(blur_heights(heights, 32, 0, control));
  EXPECT_EQ(heights, before);
}

std::vector<std::pair<std::string, ScratchSettings>> bad_scratches() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::pair<std::string, ScratchSettings>> bad;
  const auto add = [&](const char* field, auto change) { change(bad.emplace_back(field, ScratchSettings{}).second); };
  for (const int size : {std::numeric_limits<int>::min(), -1, 0, 16, 1000, 32768}) {
    add("size", [&](ScratchSettings& s) { s.size = size; });
  }
  for (const int count : {-1, 100'001}) add("count", [&](ScratchSettings& s) { s.count = count; });
  const std::pair<const char*, glm::dvec2 ScratchSettings::*> intervals[] = {
      {"length", &ScratchSettings::length},
      {"half_width", &ScratchSettings::half_width},
      {"flank_slope", &ScratchSettings::flank_slope}};
  for (const auto& [field, member] : intervals) {
    for (const glm::dvec2 interval : {glm::dvec2(2, 1), glm::dvec2(0, 1), glm::dvec2(-1, 1), glm::dvec2(nan, 1),
                                      glm::dvec2(1, nan), glm::dvec2(1, infinity), glm::dvec2(1, 1e6)}) {
      add(field, [&, m = member](ScratchSettings& s) { s.*m = interval; });
    }
  }
  const std::pair<const char*, double ScratchSettings::*> numbers[] = {
      {"direction", &ScratchSettings::direction},
      {"spread", &ScratchSettings::spread},
      {"blur", &ScratchSettings::blur},
      {"dent_rms_slope", &ScratchSettings::dent_rms_slope}};
  for (const auto& [field, member] : numbers) {
    for (const double number : {-361.0, 361.0, nan, infinity, -infinity}) {
      add(field, [&, m = member](ScratchSettings& s) { s.*m = number; });
    }
  }
  add("spread", [](ScratchSettings& s) { s.spread = 90.1; });
  add("blur", [](ScratchSettings& s) { s.blur = 16.1; });
  add("blur", [](ScratchSettings& s) { s.blur = -0.1; });
  add("dent_rms_slope", [](ScratchSettings& s) { s.dent_rms_slope = -0.01; });
  return bad;
}

TEST(ScratchSettingsCheck, NamesTheFieldOfEveryBadNumber) {
  for (const auto& [field, settings] : bad_scratches()) {
    JobControl control;
    const auto result = generate_scratches(settings, control);
    ASSERT_FALSE(result) << field;
    EXPECT_EQ(result.error().kind, ErrorKind::request);
    EXPECT_EQ(result.error().subject, "surface.generator." + field) << result.error().sentence;
    EXPECT_EQ(result.error().sentence.rfind("must be ", 0), 0U) << result.error().sentence;
  }
}

TEST(ScratchSettingsCheck, RefusesWorkWithoutEnd) {
  ScratchSettings settings;
  settings.count = 100'000;
  settings.length.y = 10'000;
  settings.half_width.y = 50;
  JobControl control;
  const auto result = generate_scratches(settings, control);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message(),
            "surface.generator.count: must be at most 333 for scratches as long and wide as these, not 100000");
}

}  // namespace
}  // namespace glint
