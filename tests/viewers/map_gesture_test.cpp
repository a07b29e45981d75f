#include "viewers/map/map_gesture.h"

#include <gtest/gtest.h>

namespace glint::view {
namespace {

// 300 x 200 pixels at 4 pixels a texel; the footprint, 10 x 5 texels, in the middle.
MapScene scene_of(Wrap wrap = Wrap::repeat) {
  MapScene scene;
  scene.camera = {{{0, 0}, {300, 200}}, {100, 100}, 4};
  scene.map_size = {256, 256};
  scene.wrap = wrap;
  scene.zooms = {0.5, 64};
  scene.footprint = {{100, 100}, covariance_of({{10, 5}, 0})};
  scene.handles = handle_positions(ring(shape_of(scene.footprint.covariance), {150, 100}, 4, 1), 15);
  scene.minimap = Rectangle{{230, 10}, {290, 70}};
  return scene;
}

MapMouse mouse(ImVec2 at, bool pressed, bool held) {
  MapMouse mouse;
  mouse.at = at;
  mouse.over = true;
  mouse.pressed = pressed;
  mouse.held = held;
  return mouse;
}

struct Drag {
  MapScene scene = scene_of();
  MapGesture gesture;
  std::vector<FootprintEdit> edits;

  void step(const MapMouse& now) {
    const MapGesture::Step step = gesture.step(scene, now);
    scene.camera = step.camera;
    if (step.edit) {
      edits.push_back(*step.edit);
      scene.footprint = step.edit->footprint;
    }
  }
  void click(ImVec2 at) {
    step(mouse(at, true, true));
    step(mouse(at, false, true));
    step(mouse(at, false, false));
  }
};

TEST(MapGesture, AClickPlacesTheFootprintExactlyThere) {
  Drag drag;
  drag.click({51, 152});
  ASSERT_EQ(drag.edits.size(), 1U);
  EXPECT_EQ(drag.edits[0].footprint.center, glm::dvec2(75.25, 113));
  EXPECT_EQ(drag.edits[0].footprint.covariance, scene_of().footprint.covariance);
  EXPECT_EQ(drag.edits[0].label, "Footprint to 75.2, 113.0");
  EXPECT_TRUE(drag.edits[0].finished);
}

TEST(MapGesture, ShiftSnapsToTheTexelCentre) {
  Drag drag;
  drag.step(mouse({51, 152}, true, true));
  MapMouse up = mouse({51, 152}, false, false);
  up.shift = true;
  drag.step(up);
  ASSERT_EQ(drag.edits.size(), 1U);
  EXPECT_EQ(drag.edits[0].footprint.center, glm::dvec2(75.5, 113.5));
}

TEST(MapGesture, ADragIsManyEditsOfOneLabelOfWhichTheLastIsFinished) {
  Drag drag;
  drag.step(mouse({50, 150}, true, true));
  EXPECT_EQ(drag.gesture.dragged(), "map.picture");
  drag.step(mouse({60, 150}, false, true));
  drag.step(mouse({60, 150}, false, true));  // rests: nothing to say
  drag.step(mouse({70, 160}, false, true));
  drag.step(mouse({70, 160}, false, false));
  ASSERT_EQ(drag.edits.size(), 3U);
  EXPECT_FALSE(drag.edits[0].finished);
  EXPECT_FALSE(drag.edits[1].finished);
  EXPECT_TRUE(drag.edits[2].finished);
  for (const FootprintEdit& edit : drag.edits) EXPECT_EQ(edit.label, "Move the footprint");
  EXPECT_EQ(drag.edits[2].footprint.center, glm::dvec2(80, 115));
  EXPECT_EQ(drag.gesture.dragged(), "");
}

TEST(MapGesture, TheCentreKeepsItsPlaceUnderTheMouse) {
  Drag drag;
  drag.step(mouse({152, 101}, true, true));  // two pixels beside the centre
  EXPECT_EQ(drag.gesture.dragged(), "map.center");
  drag.step(mouse({172, 101}, false, true));
  EXPECT_EQ(drag.scene.footprint.center, glm::dvec2(105, 100));
  drag.edits.clear();
  Drag still;
  still.click({152, 101});
  EXPECT_TRUE(still.edits.empty());
}

TEST(MapGesture, AcrossTheBorderOfAMapThatRepeatsItComesInAgain) {
  Drag drag;
  drag.scene.camera.center = {0, 100};
  drag.scene.handles = {};
  drag.scene.minimap.reset();
  drag.click({110, 100});  // ten texels to the left of the border
  ASSERT_EQ(drag.edits.size(), 1U);
  EXPECT_EQ(drag.edits[0].footprint.center, glm::dvec2(246, 100));
}

TEST(MapGesture, OutsideAMapThatClampsNothingHappensAndADragStopsAtItsBorder) {
  Drag drag;
  drag.scene = scene_of(Wrap::clamp);
  drag.scene.camera.center = {0, 100};
  drag.scene.handles = {};
  drag.click({110, 100});
  EXPECT_TRUE(drag.edits.empty());
  EXPECT_EQ(target_at(drag.scene, {110, 100}).kind, MapTarget::Kind::nothing);
  drag.step(mouse({190, 120}, true, true));
  drag.step(mouse({110, 120}, false, true));
  ASSERT_EQ(drag.edits.size(), 1U);
  EXPECT_EQ(drag.edits[0].footprint.center, glm::dvec2(0, 105));
}

TEST(MapGesture, AHandleShapesTheFootprint) {
  Drag drag;
  drag.step(mouse({192, 101}, true, true));  // the end of the first axis is at (190, 100)
  EXPECT_EQ(drag.gesture.dragged(), "map.handle.1");
  drag.step(mouse({212, 101}, false, true));
  drag.step(mouse({212, 101}, false, false));
  ASSERT_EQ(drag.edits.size(), 2U);
  EXPECT_EQ(drag.edits[1].label, "Shape the footprint");
  EXPECT_TRUE(drag.edits[1].finished);
  EXPECT_NEAR(drag.edits[1].footprint.covariance.xx, 225, 1e-9);  // 15 texels
  EXPECT_NEAR(drag.edits[1].footprint.covariance.yy, 25, 1e-9);
  EXPECT_EQ(drag.edits[1].footprint.center, glm::dvec2(100, 100));
}

TEST(MapGesture, AHandleStaysTheSameOneWhenItsAxisBecomesTheShorter) {
  Drag drag;
  drag.step(mouse({190, 100}, true, true));
  drag.step(mouse({158, 100}, false, true));  // 2 texels: shorter than the other axis
  drag.step(mouse({150, 140}, false, true));  // 10 texels downwards
  const FootprintShape shape = shape_of(drag.scene.footprint.covariance);
  EXPECT_NEAR(shape.widths.x, 10, 1e-9);
  EXPECT_NEAR(shape.widths.y, 5, 1e-9);
  EXPECT_NEAR(axis_direction(shape, 0).y, 1, 1e-9);
}

TEST(MapGesture, TheMiddleButtonPans) {
  Drag drag;
  MapMouse down = mouse({50, 150}, true, true);
  down.pans = true;
  drag.step(down);
  drag.step(mouse({90, 150}, false, true));
  EXPECT_EQ(drag.scene.camera.center, glm::dvec2(90, 100));
  drag.step(mouse({90, 150}, false, false));
  EXPECT_TRUE(drag.edits.empty());
}

TEST(MapGesture, TheWheelZoomsAboutTheMouse) {
  Drag drag;
  const glm::dvec2 under = texel_of_screen(drag.scene.camera, {50, 150});
  MapMouse wheel = mouse({50, 150}, false, false);
  wheel.wheel = 2;
  drag.step(wheel);
  EXPECT_DOUBLE_EQ(drag.scene.camera.pixels_per_texel, 6.25);
  EXPECT_NEAR(texel_of_screen(drag.scene.camera, {50, 150}).x, under.x, 1e-9);
}

TEST(MapGesture, TheOverviewMovesTheView) {
  Drag drag;
  drag.click({245, 25});  // a quarter along both sides
  EXPECT_EQ(drag.scene.camera.center, glm::dvec2(64, 64));
  EXPECT_TRUE(drag.edits.empty());
}

TEST(MapGesture, WhatIsAbandonedLeavesNoEdit) {
  Drag drag;
  drag.step(mouse({50, 150}, true, true));
  drag.step(mouse({70, 150}, false, true));
  drag.edits.clear();
  drag.gesture.abandon();
  drag.step(mouse({90, 150}, false, true));
  drag.step(mouse({90, 150}, false, false));
  EXPECT_TRUE(drag.edits.empty());
}

}  // namespace
}  // namespace glint::view
