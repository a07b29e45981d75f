#include "viewers/pndf/disk_picture.h"

#include <gtest/gtest.h>

namespace glint::view {
namespace {

const Rectangle k_square{{100, 50}, {300, 250}};

TEST(DiskPlace, PutsTheLargestTOnTop) {
  const DiskPlace place = disk_place(k_square, k_whole_disk);
  EXPECT_EQ(place.screen_of({-1, 1}).x, 100);
  EXPECT_EQ(place.screen_of({-1, 1}).y, 50);
  EXPECT_EQ(place.screen_of({1, -1}).y, 250);
  EXPECT_EQ(place.normal_at({200, 150}), glm::dvec2(0, 0));
}

TEST(DiskPlace, KeepsTheProportionsOfAWindowThatIsNotSquare) {
  const DiskPlace place = disk_place(k_square, {-1, 1, -0.5, 0.5});
  EXPECT_EQ(place.shown.width(), 200);
  EXPECT_EQ(place.shown.height(), 100);
  EXPECT_EQ(place.shown.center().y, k_square.center().y);
}

TEST(DiskPlace, HasNoNormalBeyondTheRim) {
  const DiskPlace place = disk_place(k_square, k_whole_disk);
  EXPECT_TRUE(place.normal_under({200, 150}));
  EXPECT_FALSE(place.normal_under({103, 53})) << "a corner of the square";
  EXPECT_FALSE(place.normal_under({350, 150}));
}

TEST(ZoomedWindow, KeepsWhatIsUnderTheCursor) {
  const glm::dvec2 s{0.2, -0.3};
  const glm::dvec4 window = zoomed_window(k_whole_disk, s, 1);
  EXPECT_NEAR(window.y - window.x, 1.6, 1e-3);
  EXPECT_NEAR((s.x - window.x) / (window.y - window.x), (s.x + 1) / 2, 1e-3);
  EXPECT_NEAR((s.y - window.z) / (window.w - window.z), (s.y + 1) / 2, 1e-3);
}

TEST(ZoomedWindow, StaysInsideTheSquareOfTheDisk) {
  const glm::dvec4 out = zoomed_window({0.5, 0.9, 0.5, 0.9}, {0.9, 0.9}, -2);
  EXPECT_LE(out.y, 1);
  EXPECT_LE(out.w, 1);
  EXPECT_EQ(zoomed_window({0.5, 0.9, 0.5, 0.9}, {0.9, 0.9}, -20), k_whole_disk);
}

TEST(ZoomedWindow, IsAlwaysAGrid) {
  glm::dvec4 window = k_whole_disk;
  for (int k = 0; k < 200; ++k) window = zoomed_window(window, {0.123456789, -0.4}, 1);
  EXPECT_FALSE(grid_fault({window.x, window.y, window.z, window.w, 1024, 1024}));
  EXPECT_LE(window.x, 0.123456789);
  EXPECT_GE(window.y, 0.123456789);
}

TEST(PannedWindow, MovesAgainstTheDragAndStopsAtTheEdge) {
  const glm::dvec4 window = panned_window({-0.2, 0.2, -0.2, 0.2}, {0.1, -0.1});
  EXPECT_NEAR(window.x, -0.3, 1e-12);
  EXPECT_NEAR(window.w, 0.3, 1e-12);
  EXPECT_EQ(panned_window({0.7, 0.9, 0, 0.2}, {-5, 0}), glm::dvec4(0.8, 1, 0, 0.2));
  EXPECT_EQ(panned_window(k_whole_disk, {0.3, 0.3}), k_whole_disk);
}

}  // namespace
}  // namespace glint::view
