#include "core/surface/height_field.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/surface/map_slopes.h"

namespace glint {
namespace {

std::vector<float> plane(int width, int height, double along_u, double along_v) {
  std::vector<float> heights;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) heights.push_back(static_cast<float>(along_u * i + along_v * j));
  }
  return heights;
}

TEST(NormalFromSlopes, LeansAgainstTheSlopeAndTowardsTheTopWhereTheGroundFallsAway) {
  const glm::dvec2 rising_right = normal_from_slopes(0.75, 0);
  EXPECT_DOUBLE_EQ(rising_right.x, -0.6);
  EXPECT_EQ(rising_right.y, 0);
  const glm::dvec2 rising_down = normal_from_slopes(0, 0.75);
  EXPECT_EQ(rising_down.x, 0);
  EXPECT_DOUBLE_EQ(rising_down.y, 0.6);
}

TEST(NormalFromSlopes, IsUndoneByItsInverseAndStaysInTheDisk) {
  for (const glm::dvec2 slope : {glm::dvec2(0.1, -0.3), glm::dvec2(-5, 2), glm::dvec2(0, -900)}) {
    const glm::dvec2 normal = normal_from_slopes(slope.x, slope.y);
    EXPECT_LT(std::hypot(normal.x, normal.y), 1);
    const glm::dvec2 back = test::slope_of(normal);
    EXPECT_NEAR(back.x, slope.x, 1e-9 * std::pow(1 + std::abs(slope.y), 3));
    EXPECT_NEAR(back.y, slope.y, 1e-9 * std::pow(1 + std::abs(slope.y), 3));
  }
}

TEST(NormalFromSlopes, LevelGroundHasNoNegativeZero) {
  EXPECT_FALSE(std::signbit(normal_from_slopes(0, 0).x));
  EXPECT_FALSE(std::signbit(normal_from_slopes(0, 0).y));
}

TEST(HeightField, ARampIsExactEverywhereOnAMapThatClamps) {
  const HeightFieldNormals result = normals_from_heights(plane(7, 5, 3, -2), 7, 5, 0.125, Wrap::clamp);
  const auto expected = glm::vec2(normal_from_slopes(0.375, -0.25));
  EXPECT_EQ(result.bad_slopes, 0U);
  EXPECT_EQ(result.map.width(), 7);
  EXPECT_EQ(result.map.height(), 5);
  EXPECT_EQ(result.map.wrap(), Wrap::clamp);
  for (const glm::vec2 normal : result.map.normals()) EXPECT_EQ(normal, expected);  // one-sided at the border
}

TEST(HeightField, ARampIsExactInsideAMapThatRepeats) {
  const HeightFieldNormals result = normals_from_heights(plane(7, 5, 3, -2), 7, 5, 0.125, Wrap::repeat);
  const auto expected = glm::vec2(normal_from_slopes(0.375, -0.25));
  for (int j = 1; j < 4; ++j) {
    for (int i = 1; i < 6; ++i) EXPECT_EQ(result.map.texel(i, j), expected);
  }
  // Over the border the ramp falls back: from 18 to 3 over two texels.
  EXPECT_EQ(result.map.texel(0, 2), glm::vec2(normal_from_slopes(0.125 * (3 - 18) / 2, -0.25)));
  EXPECT_EQ(result.map.texel(3, 4), glm::vec2(normal_from_slopes(0.375, 0.125 * (0 + 6) / 2)));
}

TEST(HeightField, IsSeamlessWhereTheHeightsRepeat) {
  std::vector<float> heights;
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) heights.push_back(std::sin(static_cast<float>(i + 2 * j) * 0.19634954F));
  }
  const NormalMap map = normals_from_heights(heights, 32, 32, 1, Wrap::repeat).map;
  const test::Jumps jumps = test::largest_jumps(map);
  EXPECT_LE(jumps.across_border, jumps.inside * 1.0001);
  EXPECT_LT(test::relative_curl(map), 1e-4);
}

TEST(HeightField, CountsSlopesThatCannotBeAndNamesTheFirst) {
  std::vector<float> heights = plane(6, 6, 0.5, 0);
  heights[3 * 6 + 2] = std::numeric_limits<float>::quiet_NaN();
  const HeightFieldNormals result = normals_from_heights(heights, 6, 6, 1, Wrap::clamp);
  EXPECT_EQ(result.bad_slopes, 4U);  // the neighbours: a central difference does not look at its own texel
  EXPECT_EQ(result.first_bad, glm::ivec2(2, 2));
  EXPECT_EQ(result.map.texel(2, 2), glm::vec2(0, 0));
  EXPECT_EQ(result.map.texel(1, 3), glm::vec2(0, 0));
  EXPECT_EQ(result.map.texel(4, 4), glm::vec2(normal_from_slopes(0.5, 0)));
}

TEST(HeightField, TakesSlopesUpToAThousand) {
  EXPECT_EQ(normals_from_heights(plane(4, 4, 1000, 0), 4, 4, 1, Wrap::clamp).bad_slopes, 0U);
  const HeightFieldNormals steep = normals_from_heights(plane(4, 4, 1001, 0), 4, 4, 1, Wrap::clamp);
  EXPECT_EQ(steep.bad_slopes, 16U);
  EXPECT_EQ(steep.first_bad, glm::ivec2(0, 0));
  std::vector<float> infinite(16, 0.0F);
  infinite[5] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(normals_from_heights(infinite, 4, 4, 1, Wrap::clamp).bad_slopes, 4U);
}

TEST(HeightField, TakesMapsOneTexelWideOrHigh) {
  for (const Wrap wrap : {Wrap::clamp, Wrap::repeat}) {
    const HeightFieldNormals row = normals_from_heights(plane(5, 1, 0.5, 0), 5, 1, 1, wrap);
    EXPECT_EQ(row.map.texel(2, 0), glm::vec2(normal_from_slopes(0.5, 0)));
    const HeightFieldNormals column = normals_from_heights(plane(1, 5, 0, 0.5), 1, 5, 1, wrap);
    EXPECT_EQ(column.map.texel(0, 2), glm::vec2(normal_from_slopes(0, 0.5)));
    const HeightFieldNormals point = normals_from_heights(plane(1, 1, 0, 0), 1, 1, 1, wrap);
    EXPECT_EQ(point.map.texel(0, 0), glm::vec2(0, 0));
    const HeightFieldNormals pair = normals_from_heights(plane(2, 1, 0.5, 0), 2, 1, 1, wrap);
    const double slope = wrap == Wrap::clamp ? 0.5 : 0;  // repeating, both neighbours are the same texel
    EXPECT_EQ(pair.map.texel(1, 0), glm::vec2(normal_from_slopes(slope, 0)));
  }
}

}  // namespace
}  // namespace glint
