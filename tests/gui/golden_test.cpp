// Screens held against pictures: every size, and the states a person meets.

#include "tests/gui/golden.h"

#include <ostream>

#include <gtest/gtest.h>

#include "tests/gui/application_stage.h"

namespace glint::test {
namespace {

struct Screen {
  const char* name;
  glm::ivec2 size;
  float scale;
};

void PrintTo(const Screen& screen, std::ostream* out) {
  *out << screen.name;
}

class Golden : public ::testing::TestWithParam<Screen> {};

TEST_P(Golden, TheWindowAtRest) {
  const ApplicationStage stage(GetParam().size, GetParam().scale);
  stage.open_small();
  stage.play("click pndf.picture.exact\nwait 3");
  stage.app().input().push(gui::MouseMove{{-1, -1}});
  stage.settle();
  expect_golden(std::string("rest-") + GetParam().name, stage.picture());
}

INSTANTIATE_TEST_SUITE_P(Sizes, Golden,
                         ::testing::Values(Screen{"1280x720", {1280, 720}, 1}, Screen{"1600x1000", {1600, 1000}, 1},
                                           Screen{"3200x2000-at-2", {3200, 2000}, 2}),
                         [](const auto& screen) { return "At" + std::to_string(screen.param.size.x); });

TEST(GoldenStates, Error) {
  const ApplicationStage stage;
  stage.open_small();
  stage.app().workbench().messages().post_error(
      content_error("bracket_v2.dds", "BC7 compression is not supported. What was open is unchanged"), {"file.open"});
  stage.settle();
  expect_golden("error-1280x720", stage.picture());
}

TEST(GoldenStates, Menu) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("click menu.View\nwait 3");
  expect_golden("menu-1280x720", stage.picture());
}

TEST(GoldenStates, Palette) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key Ctrl+P\nwait 2\ntype foot\nwait 3");
  expect_golden("palette-1280x720", stage.picture());
}

TEST(GoldenStates, Shortcuts) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key F1\nwait 3");
  expect_golden("shortcuts-1280x720", stage.picture());
}

TEST(GoldenStates, TexelsAndNormals) {
  const ApplicationStage stage({1600, 1000});
  stage.open_small();
  stage.play("action view.texels\nwait 3");
  expect_golden("texels-1600x1000", stage.picture());
}

TEST(GoldenStates, Elements) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("set methods exact,mixture\nkey E\naction view.footprint\nwait jobs\nclick pndf.picture.exact\nwait 3");
  stage.app().input().push(gui::MouseMove{{-1, -1}});
  stage.settle();
  expect_golden("elements-1280x720", stage.picture());
}

TEST(GoldenStates, Empty) {
  const ApplicationStage stage;
  stage.app().workbench().jobs().cancel();
  stage.frames(1);
  stage.app().workbench().jobs().cancel();
  stage.frames(3);
  expect_golden("empty-1280x720", stage.picture());
}

TEST(GoldenPictures, ADifferenceThatAnEyeSeesIsFoundAndAShiftOfAFractionOfAPixelIsNot) {
  Picture a{{200, 100}, std::vector<std::uint8_t>(60000, 30)};
  Picture same = a;
  same.rgb[3 * 5050] = 60;  // one channel of one pixel, a little
  EXPECT_EQ(compare_pictures(a, same).differing, 0);
  Picture other = a;
  for (std::size_t y = 40; y < 50; ++y) {
    for (std::size_t x = 40; x < 46; ++x) other.rgb[3 * (200 * y + x)] = 230;
  }
  const PictureDifference difference = compare_pictures(a, other);
  EXPECT_GT(difference.differing, 2e-4);
  EXPECT_EQ(difference.map.rgb[3 * (200 * 45 + 43)], 255);  // magenta where they differ
}

}  // namespace
}  // namespace glint::test
