#include "viewers/inspector/footprint_fields.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewers/inspector_scene.h"
#include "viewers/map/footprint_shape.h"

namespace glint {
namespace {

using test::InspectorScene;
using testing::HasSubstr;
using testing::IsEmpty;

Document with_covariance(SymmetricMatrix2 covariance) {
  Document document;
  document.footprint.covariance = covariance;
  return document;
}

TEST(FootprintAngle, GrowsTowardsTheTopOfThePicture) {
  // v points down, so what leans right and up has a negative covariance of u and v.
  EXPECT_NEAR(view::footprint_angle({{0, 0}, {2, -1, 2}}), 45, 1e-9);
  EXPECT_NEAR(view::footprint_angle({{0, 0}, {2, 1, 2}}), -45, 1e-9);
  EXPECT_NEAR(view::footprint_angle({{0, 0}, {4, 0, 1}}), 0, 1e-9);
  EXPECT_NEAR(view::footprint_angle({{0, 0}, {1, 0, 4}}), 90, 1e-9);
  EXPECT_EQ(view::footprint_angle({{0, 0}, {3, 0, 3}}), 0);
}

TEST(FootprintFields, GiveBackTheAngleThatWasSet) {
  for (double angle = -89; angle <= 90; angle += 0.5) {
    const auto edit = view::turned_footprint(with_covariance({144, 0, 49}), angle);
    ASSERT_TRUE(edit) << edit.error().sentence;
    EXPECT_NEAR(view::footprint_angle(edit->document.footprint), angle, 1e-9);
    const view::FootprintShape shape = view::shape_of(edit->document.footprint.covariance);
    EXPECT_NEAR(shape.widths.x, 12, 1e-12);
    EXPECT_NEAR(shape.widths.y, 7, 1e-12);
  }
}

TEST(FootprintFields, KeepTheOtherWidthAndTheAngle) {
  const auto turned = view::turned_footprint(with_covariance({144, 0, 49}), -35);
  ASSERT_TRUE(turned);
  const auto edit = view::widened_footprint(turned->document, 1, 3);
  ASSERT_TRUE(edit) << edit.error().sentence;
  const view::FootprintShape shape = view::shape_of(edit->document.footprint.covariance);
  EXPECT_NEAR(shape.widths.x, 12, 1e-12);
  EXPECT_NEAR(shape.widths.y, 3, 1e-12);
  EXPECT_NEAR(view::footprint_angle(edit->document.footprint), -35, 1e-9);
  EXPECT_EQ(edit->label, "Width σ2 to 3");
}

TEST(FootprintFields, RefuseWhatIsNoFootprint) {
  for (const double width : {0.0, -1.0, 1e6, 1e-7, std::nan("")}) {
    EXPECT_FALSE(view::widened_footprint(with_covariance({25, 0, 25}), 0, width)) << width;
  }
  const auto circle = view::turned_footprint(with_covariance({25, 0, 25}), 10);
  ASSERT_FALSE(circle);
  EXPECT_THAT(circle.error().sentence, HasSubstr("round"));
}

TEST(FootprintFields, RefuseACentreOutsideAMapThatClamps) {
  const NormalMap clamps(4, 4, std::vector<glm::vec2>(16), Wrap::clamp);
  const NormalMap repeats(4, 4, std::vector<glm::vec2>(16), Wrap::repeat);
  view::Edit edit;
  edit.document.footprint.center = {5, 1};
  EXPECT_FALSE(view::placed_on(&clamps, edit));
  EXPECT_TRUE(view::placed_on(&repeats, edit));
  EXPECT_TRUE(view::placed_on(nullptr, edit)) << "the map is not known yet";
}

TEST(FootprintFields, AreTypedAsWidthsAndAngle) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document = with_covariance({100, 0, 100});
  scene.frame(2);
  EXPECT_THAT(scene.widget("footprint.angle")->reason, HasSubstr("no direction"));
  scene.type("footprint.width.1", "20");
  scene.frame();
  EXPECT_THAT(scene.widget("footprint.angle")->reason, IsEmpty());
  scene.type("footprint.angle", "−30°");
  scene.type("footprint.center.y", "12.5");
  EXPECT_EQ(scene.edits.size(), 3U);
  EXPECT_NEAR(view::footprint_angle(scene.document.footprint), -30, 1e-9);
  EXPECT_NEAR(view::shape_of(scene.document.footprint.covariance).widths.x, 20, 1e-12);
  EXPECT_EQ(scene.document.footprint.center.y, 12.5);
}

TEST(FootprintFields, LeftAsTheyWereChangeNothing) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document = with_covariance({100, 20, 70});
  scene.frame(2);
  for (const char* name : {"footprint.width.1", "footprint.angle", "footprint.width.2", "footprint.covariance.sxy"}) {
    scene.click(name);
    scene.frame(2);
  }
  scene.click("footprint.center.x");
  EXPECT_THAT(scene.edits, IsEmpty());
}

TEST(FootprintFields, TurnInStepsOfADegree) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document = with_covariance({144, 0, 49});
  scene.frame(2);
  scene.step("footprint.angle.slider", 10);
  EXPECT_NEAR(view::footprint_angle(scene.document.footprint), 18, 1e-9);
  ASSERT_EQ(scene.edits.size(), 1U);
  EXPECT_EQ(scene.edits[0].label, "Footprint angle");
}

}  // namespace
}  // namespace glint
