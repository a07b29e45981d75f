#include "core/surface/normal_pyramid.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace glint {
namespace {

std::shared_ptr<const NormalMap> test_map(int width, int height, Wrap wrap = Wrap::repeat) {
  std::vector<glm::vec2> normals;
  for (int k = 0; k < width * height; ++k) {
    normals.emplace_back(0.5F * std::sin(static_cast<float>(k * k)), 0.25F * std::cos(static_cast<float>(3 * k)));
  }
  return std::make_shared<const NormalMap>(width, height, std::move(normals), wrap);
}

NormalPyramid pyramid_of(std::shared_ptr<const NormalMap> map) {
  JobControl control;
  std::optional<NormalPyramid> pyramid = NormalPyramid::build(std::move(map), control);
  EXPECT_TRUE(pyramid);
  return *std::move(pyramid);
}

glm::dvec2 mean(const std::vector<glm::vec2>& texels) {
  glm::dvec2 sum{0, 0};
  for (const glm::vec2 texel : texels) sum += glm::dvec2(texel);
  return sum / static_cast<double>(texels.size());
}

TEST(NormalPyramid, KeepsTheMeanOfMapsWhoseSidesArePowersOfTwo) {
  const auto map = test_map(256, 64);
  const NormalPyramid pyramid = pyramid_of(map);
  ASSERT_EQ(pyramid.levels(), 9);
  EXPECT_EQ(&pyramid.texels(0), &map->normals());
  for (int level = 0; level < pyramid.levels(); ++level) {
    EXPECT_EQ(pyramid.width(level), std::max(256 >> level, 1));
    EXPECT_EQ(pyramid.height(level), std::max(64 >> level, 1));
    EXPECT_NEAR(mean(pyramid.texels(level)).x, mean(map->normals()).x, 1e-7);
    EXPECT_NEAR(mean(pyramid.texels(level)).y, mean(map->normals()).y, 1e-7);
  }
}

TEST(NormalPyramid, AveragesWhatThereIsAtAnOddBorder) {
  const auto map = test_map(5, 3);
  const NormalPyramid pyramid = pyramid_of(map);
  ASSERT_EQ(pyramid.levels(), 4);  // 5 x 3, 3 x 2, 2 x 1, 1 x 1
  ASSERT_EQ(pyramid.width(1), 3);
  ASSERT_EQ(pyramid.height(1), 2);
  const glm::vec2 inner = 0.25F * (map->texel(2, 0) + map->texel(3, 0) + map->texel(2, 1) + map->texel(3, 1));
  EXPECT_NEAR(pyramid.texel(1, 1, 0).x, inner.x, 1e-7);
  EXPECT_NEAR(pyramid.texel(1, 1, 0).y, inner.y, 1e-7);
  const glm::vec2 right = 0.5F * (map->texel(4, 0) + map->texel(4, 1));
  EXPECT_NEAR(pyramid.texel(1, 2, 0).x, right.x, 1e-7);
  EXPECT_EQ(pyramid.texel(1, 2, 1), map->texel(4, 2));
  EXPECT_EQ(pyramid.width(2), 2);
  EXPECT_EQ(pyramid.height(2), 1);
}

TEST(NormalPyramid, WrapsAsItsMapDoes) {
  const NormalPyramid repeats = pyramid_of(test_map(8, 8));
  EXPECT_EQ(repeats.texel(1, -1, 5), repeats.texel(1, 3, 1));
  const NormalPyramid clamps = pyramid_of(test_map(8, 8, Wrap::clamp));
  EXPECT_EQ(clamps.texel(1, -1, 5), clamps.texel(1, 0, 3));
}

TEST(NormalPyramid, OfASingleTexelIsThatTexel) {
  const auto map = test_map(1, 1);
  const NormalPyramid pyramid = pyramid_of(map);
  EXPECT_EQ(pyramid.levels(), 1);
  EXPECT_EQ(pyramid.texel(0, 0, 0), map->texel(0, 0));
  EXPECT_EQ(pyramid.bytes(), 0U);
}

TEST(NormalPyramid, IsNothingOnceCancelled) {
  JobControl control;
  control.cancel();
  EXPECT_FALSE(NormalPyramid::build(test_map(64, 64), control));
}

}  // namespace
}  // namespace glint
