#include "core/surface/map_diagnostics.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "core/surface/height_field.h"

namespace glint::test {
namespace {

constexpr int k_side = 64;

// Heights of a few waves that repeat after `period` texels.
std::vector<float> waves(double period) {
  std::vector<float> heights;
  const double step = 2 * std::numbers::pi / period;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) {
      heights.push_back(static_cast<float>(2 * std::sin(step * (i + 2 * j)) + std::cos(step * (3 * i - j))));
    }
  }
  return heights;
}

NormalMap map_of(const std::vector<float>& heights) {
  return normals_from_heights(heights, k_side, k_side, 1, Wrap::repeat).map;
}

NormalMap flipped(const NormalMap& map) {
  std::vector<glm::vec2> normals = map.normals();
  for (glm::vec2& normal : normals) normal.y = -normal.y;
  return {map.width(), map.height(), std::move(normals), map.wrap()};
}

TEST(CurlRatio, IsFarAboveOneForASurfaceAndFarBelowOnceFlipped) {
  const NormalMap map = map_of(waves(k_side));
  ASSERT_TRUE(curl_ratio(map));
  EXPECT_GT(*curl_ratio(map), 100);
  EXPECT_LT(*curl_ratio(flipped(map)), 0.01);
  EXPECT_NEAR(*curl_ratio(map) * *curl_ratio(flipped(map)), 1, 1e-9);
}

// h_u = a j and h_v = b i have curl a - b, and a + b once t is negated: the ratio is ((a + b) / (a - b))^2.
TEST(CurlRatio, IsTheQuotientOfMeanSquaredCurls) {
  constexpr double k_a = 0.003;
  constexpr double k_b = 0.001;
  std::vector<glm::vec2> normals;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) normals.emplace_back(normal_from_slopes(k_a * j, k_b * i));
  }
  EXPECT_NEAR(*curl_ratio({k_side, k_side, normals, Wrap::repeat}), 4, 1e-3);
}

TEST(CurlRatio, SaysNothingOfFlatOrTinyMaps) {
  EXPECT_FALSE(curl_ratio({k_side, k_side, std::vector<glm::vec2>(k_side * k_side, {0.1F, 0.2F}), Wrap::repeat}));
  EXPECT_FALSE(curl_ratio({2, 2, {{0.1F, 0.2F}, {0, 0}, {0.3F, 0}, {0, 0.5F}}, Wrap::repeat}));
  EXPECT_FALSE(curl_ratio({1, 1, {{0.1F, 0.2F}}, Wrap::repeat}));
  EXPECT_FALSE(curl_ratio({4096, 1, std::vector<glm::vec2>(4096, {0.1F, 0.2F}), Wrap::repeat}));
}

TEST(CurlRatio, IsNotDecidedByAFewVerticalNormals) {
  std::vector<glm::vec2> normals = map_of(waves(k_side)).normals();
  normals[1000] = {1, 0};
  normals[2000] = {0, -1};
  EXPECT_GT(*curl_ratio({k_side, k_side, normals, Wrap::repeat}), k_clear_curl_ratio);
}

TEST(SeamRatios, AreAboutOneForAMapThatRepeats) {
  const SeamRatios map = seam_ratios(map_of(waves(k_side)));
  EXPECT_NEAR(map.left_right, 1, 0.3);
  EXPECT_NEAR(map.top_bottom, 1, 0.3);
  const SeamRatios heights = seam_ratios(waves(k_side), k_side, k_side);
  EXPECT_NEAR(heights.left_right, 1, 0.3);
  EXPECT_NEAR(heights.top_bottom, 1, 0.3);
}

TEST(SeamRatios, TellWhichEdgesDoNotMeet) {
  std::vector<float> ramp;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) ramp.push_back(static_cast<float>(i) + static_cast<float>(j % 2));
  }
  const SeamRatios ratios = seam_ratios(ramp, k_side, k_side);
  EXPECT_NEAR(ratios.left_right, k_side - 1, 1e-6);
  EXPECT_NEAR(ratios.top_bottom, 1, 1e-6);
}

TEST(SeamRatios, AreZeroWhereThereIsNothingToTell) {
  const SeamRatios flat = seam_ratios(std::vector<float>(k_side * k_side, 1.F), k_side, k_side);
  EXPECT_EQ(flat.left_right, 0);
  EXPECT_EQ(flat.top_bottom, 0);
  EXPECT_EQ(seam_ratios(std::vector<float>{0, 1, 2, 9}, 4, 1).left_right, 0);
}

TEST(SeamRatios, LeaveOutHeightsThatAreNotFinite) {
  std::vector<float> heights = waves(k_side);
  heights[0] = heights[777] = std::nanf("");
  heights[5] = HUGE_VALF;
  EXPECT_NEAR(seam_ratios(heights, k_side, k_side).left_right, 1, 0.3);
}

// Unit vectors of a few waves as integers of `levels` + 1 values hold them, decoded as readers do.
NormalMap stored(double levels, bool three_channels) {
  std::vector<glm::vec2> normals;
  const auto decoded = [&](double x) { return 2 * std::round((x + 1) / 2 * levels) / levels - 1; };
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) {
      const glm::dvec3 n{decoded(0.4 * std::sin(0.2 * i + 0.1 * j)), decoded(0.3 * std::cos(0.15 * j)), decoded(0.9)};
      const double length = three_channels ? std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) : 1;
      normals.emplace_back(n.x / length, n.y / length);
    }
  }
  return {k_side, k_side, std::move(normals), Wrap::repeat};
}

TEST(ValueStep, IsFoundWithTwoChannelsAndBehindNormalising) {
  EXPECT_EQ(value_step(stored(255, false)), 2.0 / 255);
  EXPECT_EQ(value_step(stored(255, true)), 2.0 / 255);
  EXPECT_EQ(value_step(stored(65535, false)), 2.0 / 65535);
}

TEST(ValueStep, IsZeroOfFloatsAndOfWhatDoesNotVary) {
  EXPECT_EQ(value_step(map_of(waves(k_side))), 0);
  EXPECT_EQ(value_step(NormalMap(k_side, k_side, std::vector<glm::vec2>(k_side * k_side, {1 / 255.F, 1 / 255.F}),
                                 Wrap::repeat)),
            0);
  EXPECT_EQ(value_step(NormalMap(1, 1, {{0, 0}}, Wrap::repeat)), 0);
}

// Columns whose s is that of column / `width`.
bool columns_are_pieces(int width, double jump) {
  std::vector<glm::vec2> normals;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) normals.emplace_back(jump * (i / width), 0);
  }
  std::vector<glm::dvec2> everywhere;
  for (int k = 0; k < k_side * k_side; ++k) everywhere.emplace_back(k % k_side + 0.5, k / k_side + 0.5);
  return is_flat_in_pieces(NormalMap(k_side, k_side, std::move(normals), Wrap::clamp), everywhere);
}

TEST(FlatInPieces, IsAMapOfJumpsBetweenEqualNeighbours) {
  EXPECT_TRUE(columns_are_pieces(8, 0.05));
  EXPECT_FALSE(columns_are_pieces(8, 2.0 / 255));  // steps of a gentle slope
  EXPECT_FALSE(columns_are_pieces(1, 0.01));       // a ramp
  EXPECT_FALSE(columns_are_pieces(64, 0.05));      // flat all over
}

}  // namespace
}  // namespace glint::test
