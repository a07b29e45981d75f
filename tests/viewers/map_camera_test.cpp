#include "viewers/map/map_camera.h"

#include <gtest/gtest.h>

namespace glint::view {
namespace {

const MapCamera k_camera{{{10, 70}, {336, 324}}, {250.5, 760.5}, 2.5};

TEST(MapCamera, PutsItsCentreInTheMiddleOfThePicture) {
  EXPECT_EQ(screen_of_texel(k_camera, {250.5, 760.5}).x, 173);
  EXPECT_EQ(screen_of_texel(k_camera, {250.5, 760.5}).y, 197);
}

TEST(MapCamera, CountsTexelsRightAndDown) {
  // 10 texels right and 4 up at 2.5 pixels a texel.
  const ImVec2 pixel = screen_of_texel(k_camera, {260.5, 756.5});
  EXPECT_FLOAT_EQ(pixel.x, 173 + 25);
  EXPECT_FLOAT_EQ(pixel.y, 197 - 10);
  const glm::dvec2 u = texel_of_screen(k_camera, {198, 187});
  EXPECT_DOUBLE_EQ(u.x, 260.5);
  EXPECT_DOUBLE_EQ(u.y, 756.5);
}

TEST(MapCamera, GoesThereAndBack) {
  for (const double zoom : {0.03, 0.7, 2.5, 64.0}) {
    MapCamera camera = k_camera;
    camera.pixels_per_texel = zoom;
    for (const ImVec2 pixel : {ImVec2(10, 70), ImVec2(200.5F, 100.25F), ImVec2(336, 324)}) {
      const ImVec2 back = screen_of_texel(camera, texel_of_screen(camera, pixel));
      EXPECT_NEAR(back.x, pixel.x, 1e-3) << zoom;
      EXPECT_NEAR(back.y, pixel.y, 1e-3) << zoom;
    }
  }
}

TEST(MapCamera, SeesWhatItsPictureCovers) {
  const TexelRange range = visible_texels(k_camera);
  EXPECT_NEAR(range.max.x - range.min.x, 326 / 2.5, 1e-9);
  EXPECT_NEAR(range.max.y - range.min.y, 254 / 2.5, 1e-9);
  EXPECT_DOUBLE_EQ(range.min.x, 250.5 - 65.2);
}

TEST(MapZoom, ReachesFromTheWholeMapToTheNearest) {
  const ZoomRange large = zoom_range({1024, 512}, k_camera.picture, 64);
  EXPECT_DOUBLE_EQ(large.lowest, 0.96 * 326 / 1024);  // the width is the tighter fit
  EXPECT_EQ(large.highest, 64);
  const ZoomRange small = zoom_range({16, 16}, k_camera.picture, 64);
  EXPECT_DOUBLE_EQ(small.lowest, 0.96 * 254 / 16);  // a small map is magnified to fit
  const ZoomRange tiny = zoom_range({2, 2}, k_camera.picture, 64);
  EXPECT_EQ(tiny.lowest, 64);  // and one that does not fill the picture has one zoom
  EXPECT_EQ(tiny.highest, 64);
}

TEST(MapZoom, KeepsTheTexelUnderTheMouse) {
  const ImVec2 mouse{40, 300};
  const glm::dvec2 before = texel_of_screen(k_camera, mouse);
  for (const double factor : {1.25, 0.8, 7.0}) {
    const MapCamera zoomed = zoomed_about(k_camera, mouse, factor, {0.1, 64});
    EXPECT_DOUBLE_EQ(zoomed.pixels_per_texel, 2.5 * factor);
    const glm::dvec2 after = texel_of_screen(zoomed, mouse);
    EXPECT_NEAR(after.x, before.x, 1e-9);
    EXPECT_NEAR(after.y, before.y, 1e-9);
  }
}

TEST(MapZoom, StopsAtItsEndsWithoutMoving) {
  const MapCamera nearest = zoomed_about(k_camera, {40, 300}, 1e6, {0.1, 64});
  EXPECT_EQ(nearest.pixels_per_texel, 64);
  const MapCamera again = zoomed_about(nearest, {300, 100}, 1.25, {0.1, 64});
  EXPECT_EQ(again.center, nearest.center);
}

TEST(MapPan, CarriesTheMapWithTheMouse) {
  const glm::dvec2 grabbed = texel_of_screen(k_camera, {100, 100});
  const MapCamera moved = panned(k_camera, {30, -12});
  const glm::dvec2 now = texel_of_screen(moved, {130, 88});
  EXPECT_NEAR(now.x, grabbed.x, 1e-9);
  EXPECT_NEAR(now.y, grabbed.y, 1e-9);
}

TEST(MapPan, NeverLosesTheMap) {
  MapCamera lost = k_camera;
  lost.center = {-4000, 90};
  lost.pixels_per_texel = 1e-6;
  const MapCamera kept = kept_on_map(lost, {1024, 1024}, {0.24, 64});
  EXPECT_EQ(kept.center, glm::dvec2(0, 90));
  EXPECT_EQ(kept.pixels_per_texel, 0.24);
}

TEST(StoredPosition, IsReducedIntoTheFirstPeriodOfAMapThatRepeats) {
  EXPECT_EQ(stored_position({-1.5, 1030.25}, {1024, 1024}, Wrap::repeat), glm::dvec2(1022.5, 6.25));
  EXPECT_EQ(stored_position({1024, 0}, {1024, 1024}, Wrap::repeat), glm::dvec2(0, 0));
  // A tiny negative number must not become the size itself.
  EXPECT_LT(stored_position({-1e-18, 0}, {1024, 1024}, Wrap::repeat).x, 1024);
  EXPECT_EQ(stored_position({-1.5, 1030.25}, {1024, 1024}, Wrap::clamp), glm::dvec2(0, 1024));
}

TEST(OnMap, EndsOnlyWhereTheMapClamps) {
  EXPECT_TRUE(on_map({-5, 3}, {8, 8}, Wrap::repeat));
  EXPECT_FALSE(on_map({-5, 3}, {8, 8}, Wrap::clamp));
  EXPECT_TRUE(on_map({8, 8}, {8, 8}, Wrap::clamp));
}

TEST(RoundedDownStep, IsOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(rounded_down_step(36), 20);
  EXPECT_DOUBLE_EQ(rounded_down_step(1.4), 1);
  EXPECT_DOUBLE_EQ(rounded_down_step(99), 50);
  EXPECT_DOUBLE_EQ(rounded_down_step(0.7), 0.5);
}

}  // namespace
}  // namespace glint::view
