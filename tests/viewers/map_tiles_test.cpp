#include "viewers/map/map_tiles.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "viewers/map/map_colors.h"

namespace glint::view {
namespace {

constexpr auto k_no_limit = std::chrono::steady_clock::duration::max();
constexpr auto k_no_time = std::chrono::steady_clock::duration::zero();

std::shared_ptr<const NormalPyramid> pyramid_of(int width, int height, std::vector<glm::vec2> normals, Wrap wrap) {
  JobControl control;
  auto map = std::make_shared<const NormalMap>(width, height, std::move(normals), wrap);
  return std::make_shared<const NormalPyramid>(*NormalPyramid::build(std::move(map), control));
}

std::shared_ptr<const NormalPyramid> random_pyramid(int width, int height, Wrap wrap = Wrap::repeat) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-0.6F, 0.6F);
  std::vector<glm::vec2> normals(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (glm::vec2& normal : normals) normal = {value(random), value(random)};
  return pyramid_of(width, height, std::move(normals), wrap);
}

// Just enough of OpenGL to count textures.
std::set<GLuint>& alive() {
  static std::set<GLuint> names;
  return names;
}
GlFunctions counting_gl() {
  static GLuint next = 1;
  GlFunctions gl;
  gl.GenTextures = [](GLsizei, GLuint* name) { alive().insert(*name = next++); };
  gl.DeleteTextures = [](GLsizei, const GLuint* name) { alive().erase(*name); };
  gl.BindTexture = [](GLenum, GLuint) {};
  gl.PixelStorei = [](GLenum, GLint) {};
  gl.TexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {};
  return gl;
}

TEST(MapColors, OfNormalsAreWhatANormalMapStores) {
  EXPECT_EQ(normal_color({0, 0}), DisplayColor(128, 128, 255));
  // z of (0.6, 0) is 0.8: 255 * 0.8 = 204, 127.5, 255 * 0.9 = 229.5.
  EXPECT_EQ(normal_color({0.6F, 0}), DisplayColor(204, 128, 230));
  EXPECT_EQ(normal_color({-1, 0}), DisplayColor(0, 128, 128));
  EXPECT_EQ(normal_color({0, 1}), DisplayColor(128, 255, 128));  // green up
}

TEST(MapColors, OfSlopeFollowItsTangent) {
  EXPECT_DOUBLE_EQ(slope_of({0, 0}), 0);
  EXPECT_NEAR(slope_of({0.6F, 0}), 0.75, 1e-7);
  EXPECT_TRUE(std::isinf(slope_of({1, 0})));
  const auto pyramid = pyramid_of(3, 1, {{0, 0}, {0.6F, 0}, {0.8F, 0}}, Wrap::clamp);
  const auto color = [&](int i) { return texel_color(*pyramid, MapColors::slope, 0, i, 0); };
  EXPECT_EQ(color(0), viridis(0));
  EXPECT_EQ(color(1), viridis(191 / 255.0));  // 0.75 in 256 steps
  EXPECT_EQ(color(2), k_overflow_color);      // 4 / 3
}

TEST(MapColors, OfCurvatureFollowTheNormOfTheJacobianPerTexel) {
  // s grows by 0.01 a texel along u, t by 0.02 along v: the norm is sqrt(5) / 100.
  std::vector<glm::vec2> normals;
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 8; ++i) normals.emplace_back(0.01F * static_cast<float>(i), 0.02F * static_cast<float>(j));
  }
  const auto pyramid = pyramid_of(8, 8, std::move(normals), Wrap::clamp);
  EXPECT_NEAR(curvature_of(*pyramid, 0, 3, 3), std::sqrt(5) / 100, 1e-7);
  EXPECT_NEAR(curvature_of(*pyramid, 1, 1, 1), std::sqrt(5) / 100, 1e-7);  // still per texel of the map
  const double position = k_curvature_scale.position(std::sqrt(5) / 100);
  EXPECT_EQ(texel_color(*pyramid, MapColors::curvature, 0, 3, 3), viridis(std::round(255 * position) / 255));
  const auto flat = pyramid_of(2, 2, std::vector<glm::vec2>(4), Wrap::repeat);
  EXPECT_EQ(texel_color(*flat, MapColors::curvature, 0, 0, 0), k_underflow_color);
}

TEST(MapColors, OfATileAreThoseOfItsTexelsAndOfTheirNeighboursBeyondTheBorder) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const auto pyramid = random_pyramid(9, 5, wrap);
    for (const MapColors colors : {MapColors::normal, MapColors::slope, MapColors::curvature}) {
      const std::vector<std::uint8_t> texels = colored_texels(*pyramid, colors, 0, {-1, -1}, {11, 7});
      ASSERT_EQ(texels.size(), 11U * 7 * 4);
      for (int j = -1; j < 6; ++j) {
        for (int i = -1; i < 10; ++i) {
          const auto at = static_cast<std::size_t>((j + 1) * 11 + i + 1) * 4;
          const DisplayColor color = texel_color(*pyramid, colors, 0, i, j);
          EXPECT_EQ(DisplayColor(texels[at], texels[at + 1], texels[at + 2]), color);
          EXPECT_EQ(texels[at + 3], 255);
        }
      }
    }
  }
}

TEST(Overview, IsTheSmallestLevelThatIsLargeEnough) {
  const auto pyramid = random_pyramid(300, 100);
  EXPECT_EQ(overview_of(*pyramid, MapColors::normal, 62).size, glm::ivec2(75, 25));
  EXPECT_EQ(overview_of(*pyramid, MapColors::slope, 62).texels.size(), 75U * 25 * 4);
  const auto small = random_pyramid(5, 3);
  EXPECT_EQ(overview_of(*small, MapColors::curvature, 62).size, glm::ivec2(5, 3));
}

TEST(Overview, StretchesWeakContrast) {
  std::vector<glm::vec2> normals(64 * 64);
  for (std::size_t k = 0; k < normals.size(); ++k) normals[k].x = k % 64 < 32 ? 0.1F : -0.1F;
  const Overview overview = overview_of(*pyramid_of(64, 64, std::move(normals), Wrap::repeat), MapColors::normal, 64);
  EXPECT_EQ(overview.texels[0], 217);      // 0.1 stretched to 0.7: 255 * 0.85 = 216.75
  EXPECT_EQ(overview.texels[4 * 63], 38);  // and -0.7: 38.25
}

TEST(MapTiles, CoverEveryLevelAndNestInTheNextCoarserOne) {
  const auto pyramid = random_pyramid(600, 255);
  EXPECT_EQ(tile_count(*pyramid, 0), glm::ivec2(3, 2));
  EXPECT_EQ(tile_count(*pyramid, 1), glm::ivec2(2, 1));
  EXPECT_EQ(tile_count(*pyramid, 2), glm::ivec2(1, 1));
  EXPECT_EQ(coarser({0, 2, 1}), (TileKey{1, 1, 0}));
}

TEST(MapTiles, AreMadeOnceAndAreOneTexelLargerAllRound) {
  const GlFunctions gl = counting_gl();
  MapTiles tiles(gl);
  const auto pyramid = random_pyramid(600, 255);
  tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
  const MapTiles::Found whole = tiles.find({0, 0, 0});
  EXPECT_EQ(whole.texture->size(), glm::ivec2(256, 256));
  EXPECT_EQ(tiles.find({0, 2, 1}).texture->size(), glm::ivec2(600 - 508 + 2, 3));
  EXPECT_EQ(tiles.find({0, 0, 0}).texture, whole.texture);
  EXPECT_EQ(tiles.count(), 2U);
  EXPECT_FALSE(tiles.incomplete());
}

TEST(MapTiles, ShowACoarserOneWhereThereIsNoTime) {
  const GlFunctions gl = counting_gl();
  MapTiles tiles(gl);
  const auto pyramid = random_pyramid(600, 600);
  tiles.begin_frame(pyramid, MapColors::normal, k_no_time);
  const MapTiles::Found found = tiles.find({0, 2, 2});
  EXPECT_EQ(found.key, (TileKey{2, 0, 0}));  // the level of a single tile is made at once
  EXPECT_TRUE(tiles.incomplete());
  tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
  EXPECT_EQ(tiles.find({1, 1, 1}).key, (TileKey{1, 1, 1}));
  tiles.begin_frame(pyramid, MapColors::normal, k_no_time);
  EXPECT_EQ(tiles.find({0, 2, 2}).key, (TileKey{1, 1, 1}));  // the finest one there is
}

TEST(MapTiles, StayWithinTheirMemoryAndForgetWhatWasSeenLongestAgo) {
  const GlFunctions gl = counting_gl();
  alive().clear();
  constexpr std::size_t k_tile = std::size_t{256} * 256 * 4;
  MapTiles tiles(gl, 3 * k_tile);
  const auto pyramid = random_pyramid(254 * 4, 254 * 2);
  const auto look = [&](int x, int y) {
    tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
    EXPECT_EQ(tiles.find({0, x, y}).key, (TileKey{0, x, y}));
    EXPECT_LE(tiles.bytes(), 3 * k_tile);
    EXPECT_EQ(tiles.count(), alive().size());
  };
  look(0, 0);
  look(1, 0);
  look(2, 0);
  look(0, 0);
  look(3, 0);  // (1, 0) goes, (0, 0) stays
  EXPECT_EQ(tiles.count(), 3U);
  tiles.begin_frame(pyramid, MapColors::normal, k_no_time);
  EXPECT_EQ(tiles.find({0, 0, 0}).key.level, 0);
  EXPECT_NE(tiles.find({0, 1, 0}).key.level, 0);
}

TEST(MapTiles, OfOneFrameAllStayUntilItIsDrawn) {
  const GlFunctions gl = counting_gl();
  MapTiles tiles(gl, 1);
  const auto pyramid = random_pyramid(600, 600);
  tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
  const Texture* first = tiles.find({0, 0, 0}).texture;
  const Texture* second = tiles.find({0, 1, 0}).texture;
  EXPECT_EQ(tiles.count(), 2U);  // far beyond the limit, but about to be drawn
  EXPECT_FALSE(first->empty());
  EXPECT_FALSE(second->empty());
  tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
  EXPECT_EQ(tiles.bytes(), 0U);
}

TEST(MapTiles, AreDroppedWithTheirMapAndTheirColours) {
  const GlFunctions gl = counting_gl();
  MapTiles tiles(gl);
  const auto pyramid = random_pyramid(20, 20);
  tiles.begin_frame(pyramid, MapColors::normal, k_no_limit);
  tiles.find({0, 0, 0});
  tiles.begin_frame(pyramid, MapColors::slope, k_no_limit);
  EXPECT_EQ(tiles.count(), 0U);
  tiles.find({0, 0, 0});
  tiles.begin_frame(random_pyramid(20, 20), MapColors::slope, k_no_limit);
  EXPECT_EQ(tiles.count(), 0U);
}

}  // namespace
}  // namespace glint::view
