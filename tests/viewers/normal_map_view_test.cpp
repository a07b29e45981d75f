#include "viewers/map/normal_map_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/document/parameter.h"
#include "tests/viewers/stage.h"
#include "viewers/map/footprint_shape.h"

namespace glint::view {
namespace {

std::shared_ptr<const SurfaceInUse> surface_of(int width, int height, Wrap wrap) {
  std::vector<glm::vec2> normals;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      normals.emplace_back(0.002F * static_cast<float>(i), -0.001F * static_cast<float>(j));
    }
  }
  JobControl control;
  const auto map = std::make_shared<const NormalMap>(width, height, std::move(normals), wrap);
  auto pyramid = std::make_shared<const NormalPyramid>(*NormalPyramid::build(map, control));
  return std::make_shared<const SurfaceInUse>(
      SurfaceInUse{LoadedSurface{Surface(map, Interpolation::smooth), std::nullopt}, {}, std::move(pyramid)});
}

// The panel as the window drives it: edits become the document of the next frame.
struct MapPanel {
  explicit MapPanel(Wrap wrap = Wrap::repeat, glm::ivec2 size = {346, 404}, float scale = 1)
      : stage(size, scale), surface(surface_of(256, 200, wrap)) {
    document.footprint = {{100.5, 80.5}, covariance_of({{10, 6}, -0.5})};
    stage.io().MousePos = {-1000, -1000};
    frame();
    frame();
  }

  void frame() {
    stage.frame([&](Ui& ui) {
      ui.blocked = blocked;
      const Rectangle area{{0, 0}, {static_cast<float>(stage.size().x), static_cast<float>(stage.size().y)}};
      const NormalMapEvents events = view.draw(ui, area, {document, surface, {}, false, 0, false, false, crosshair});
      if (!events.edit) return;
      edits.push_back(*events.edit);
      document = events.edit->document;
      EXPECT_FALSE(document_fault(document));
    });
  }
  void move_to(ImVec2 at) {
    stage.io().MousePos = at;
    frame();
  }
  void button(bool down, int which = 0) {
    stage.io().MouseDown[which] = down;
    frame();
  }
  void click(ImVec2 at) {
    move_to(at);
    button(true);
    button(false);
    frame();
  }
  ImVec2 screen(glm::dvec2 u) { return *view.screen_of(u); }
  ImVec2 place(const char* name) { return stage.widgets().find(name)->area.center(); }

  test::Stage stage;
  NormalMapView view;
  Document document;
  std::shared_ptr<const SurfaceInUse> surface;
  bool blocked = false;
  std::optional<glm::dvec2> crosshair;
  std::vector<Edit> edits;
};

// The panel with the mixture's elements on it, four a texel and 12 pixels apart.
struct ElementPanel : MapPanel {
  ElementPanel() {
    document.methods = {PndfMethod::exact, PndfMethod::mixture};
    document.view.elements = true;
    document.intrinsic_roughness = 0.005;
    document.footprint = {{100.5, 80.5}, {9, 0, 9}};
    frame();
    view.zoom_by(24 / view.zoom());
    frame();
  }
  // Red, green and blue in the middle of the element of the seed (k, l).
  glm::ivec3 color_of(int k, int l) {
    const ImVec2 at = screen({0.5 * (k + 0.5), 0.5 * (l + 0.5)});
    const std::vector<std::uint8_t> pixels = stage.pixels();
    const auto index = 3 * static_cast<std::size_t>(std::floor(at.y) * static_cast<float>(stage.size().x) + at.x);
    return {pixels[index], pixels[index + 1], pixels[index + 2]};
  }
  std::string said() const {
    const WidgetRecord::Entry* legend = stage.widgets().find("map.elements");
    return legend == nullptr ? "nothing" : legend->reason;
  }
};

TEST(NormalMapView, BeginsWithTheFootprintInItsMiddle) {
  MapPanel panel;
  EXPECT_NEAR(panel.view.zoom(), 2.5, 1e-9);
  EXPECT_NEAR(panel.screen({100.5, 80.5}).x, panel.view.picture().center().x, 1e-3);
  EXPECT_TRUE(panel.edits.empty());
}

TEST(NormalMapView, AClickPlacesTheFootprintWhereItWas) {
  MapPanel panel;
  const ImVec2 at = panel.screen({70, 60});
  panel.click({std::floor(at.x), std::floor(at.y)});
  ASSERT_EQ(panel.edits.size(), 1U);
  EXPECT_TRUE(panel.edits[0].finished);
  EXPECT_NEAR(panel.document.footprint.center.x, 70, 0.4);
  const ImVec2 now = panel.screen(panel.document.footprint.center);
  EXPECT_NEAR(now.x, std::floor(at.x), 1e-3);
  EXPECT_NEAR(now.y, std::floor(at.y), 1e-3);
}

TEST(NormalMapView, ADragOfAHandleIsOneGesture) {
  MapPanel panel;
  const ImVec2 at = panel.place("map.handle.1");
  panel.move_to(at);
  panel.button(true);
  EXPECT_EQ(panel.stage.state().dragging, "map.handle.1");
  panel.move_to({at.x + 10, at.y + 3});
  panel.move_to({at.x + 20, at.y + 6});
  panel.button(false);
  EXPECT_EQ(panel.stage.state().dragging, "");
  ASSERT_EQ(panel.edits.size(), 3U);
  EXPECT_FALSE(panel.edits[1].finished);
  EXPECT_TRUE(panel.edits[2].finished);
  EXPECT_EQ(panel.edits[0].label, panel.edits[2].label);
  const ImVec2 end = panel.place("map.handle.1");
  EXPECT_NEAR(end.x, at.x + 20, 1);
  EXPECT_NEAR(end.y, at.y + 6, 1);
  EXPECT_EQ(panel.document.footprint.center, glm::dvec2(100.5, 80.5));
}

TEST(NormalMapView, WhatClearsTheNameOfTheDragTakesItBack) {
  MapPanel panel;
  panel.move_to(panel.screen({70, 60}));
  panel.button(true);
  panel.move_to(panel.screen({75, 60}));
  panel.edits.clear();
  panel.stage.state().dragging.clear();  // as Escape does
  panel.move_to(panel.screen({80, 60}));
  panel.button(false);
  EXPECT_TRUE(panel.edits.empty());
}

TEST(NormalMapView, PansWithTheMiddleButtonAndWithAlt) {
  for (const bool alt : {false, true}) {
    MapPanel panel;
    const int which = alt ? 0 : 2;
    panel.stage.io().KeyAlt = alt;
    const ImVec2 at = panel.screen({70, 60});
    panel.move_to(at);
    panel.button(true, which);
    panel.move_to({at.x + 25, at.y - 10});
    panel.button(false, which);
    EXPECT_NEAR(panel.screen({70, 60}).x, at.x + 25, 1e-3);
    EXPECT_NEAR(panel.screen({70, 60}).y, at.y - 10, 1e-3);
    EXPECT_TRUE(panel.edits.empty());
  }
}

TEST(NormalMapView, ZoomsAboutTheMouseAndStopsAtWholeMapAndTexels) {
  MapPanel panel;
  const ImVec2 at = panel.screen({70.5, 60.5});  // on a whole pixel, as the mouse is
  ASSERT_EQ(at.x, std::floor(at.x));
  panel.move_to(at);
  panel.stage.io().MouseWheel = 3;
  panel.frame();
  EXPECT_NEAR(panel.view.zoom(), 2.5 * 1.25 * 1.25 * 1.25, 1e-9);
  EXPECT_NEAR(panel.screen({70.5, 60.5}).x, at.x, 1e-2);
  panel.view.zoom_by(1e9);
  EXPECT_EQ(panel.view.zoom(), 64);
  panel.view.show_all();
  panel.frame();
  EXPECT_LE(panel.view.picture().min.x, panel.screen({0, 0}).x);
  EXPECT_LE(panel.screen({256, 200}).y, panel.view.picture().max.y);
  EXPECT_EQ(panel.stage.widgets().find("map.minimap"), nullptr);  // says nothing where all is in view
}

TEST(NormalMapView, DoesNothingBeneathADialog) {
  MapPanel panel;
  panel.blocked = true;
  panel.click(panel.screen({70, 60}));
  panel.stage.io().MouseWheel = 3;
  panel.frame();
  EXPECT_TRUE(panel.edits.empty());
  EXPECT_NEAR(panel.view.zoom(), 2.5, 1e-9);
  EXPECT_EQ(panel.view.values_at_cursor(), "");
}

TEST(NormalMapView, ReadsTheTexelUnderTheMouse) {
  MapPanel panel;
  panel.view.show_texels();
  panel.frame();
  panel.move_to(panel.screen({98.25, 79.75}));
  const std::string text = panel.view.values_at_cursor();
  EXPECT_EQ(text.find("texel 98 79\n"), 0U) << text;
  EXPECT_NE(text.find("decoded s t z 0.196000"), std::string::npos) << text;  // 98 x 0.002
  // The plane is its own interpolation: at u = 98.25 it is 0.002 (98.25 - 0.5).
  EXPECT_NE(text.find("surface s t z 0.1955"), std::string::npos) << text;
}

TEST(NormalMapView, OffersOnlyTheMapWhereItClamps) {
  MapPanel panel(Wrap::clamp);
  panel.view.show_all();
  panel.frame();
  const ImVec2 corner = panel.view.picture().min;
  panel.click({corner.x + 3, corner.y + 3});
  EXPECT_TRUE(panel.edits.empty());
}

TEST(NormalMapView, FollowsAFootprintThatWentElsewhere) {
  MapPanel panel;
  panel.document.footprint.center = {240, 190};
  panel.frame();
  EXPECT_TRUE(panel.view.picture().contains(panel.screen({240, 190})));
}

TEST(NormalMapView, TakesHoldOfAFootprintOfAnotherPeriodInTheFirst) {
  MapPanel panel;
  panel.document.footprint.center = {100.5 + 3 * 256, 80.5 - 200};
  panel.frame();
  const ImVec2 at = panel.place("map.handle.1");
  EXPECT_TRUE(panel.view.picture().contains(at));
  panel.move_to(at);
  panel.button(true);
  panel.move_to({at.x + 10, at.y});
  panel.button(false);
  ASSERT_EQ(panel.edits.size(), 2U);
  EXPECT_EQ(panel.document.footprint.center, glm::dvec2(868.5, -119.5));  // shaping does not move it
}

TEST(NormalMapView, ChangesItsColoursThroughTheDocument) {
  MapPanel panel;
  panel.click(panel.place("view.map_colors.slope"));
  ASSERT_EQ(panel.edits.size(), 1U);
  EXPECT_EQ(panel.document.view.map_colors, MapColors::slope);
}

bool is_yellow(glm::ivec3 c) {  // the end of viridis
  return c.x > 180 && c.y > 180 && c.z < 110;
}

TEST(NormalMapView, ShowsTheElementsUnderTheFootprintWhereAskedTo) {
  ElementPanel panel;
  EXPECT_EQ(panel.said(), "");
  EXPECT_TRUE(is_yellow(panel.color_of(202, 159)));   // half a texel from the centre
  EXPECT_FALSE(is_yellow(panel.color_of(208, 164)));  // 3.6 texels from it: a share of a half
  const glm::ivec3 far = panel.color_of(211, 158);
  panel.document.view.elements = false;
  panel.frame();
  EXPECT_EQ(panel.said(), "nothing");
  EXPECT_FALSE(is_yellow(panel.color_of(202, 159)));
  EXPECT_NE(panel.color_of(211, 158), far);
  panel.document.view.elements = true;
  panel.document.methods = {PndfMethod::exact};
  panel.frame();
  EXPECT_EQ(panel.said(), "nothing");
  EXPECT_FALSE(is_yellow(panel.color_of(202, 159)));
}

TEST(NormalMapView, ColoursTheElementsByWhatTheyAddAtTheCrosshair) {
  ElementPanel panel;
  // The map is a plane: its normal is that of one place, here the seed (206, 162), and turns by 0.4 sigma_r a texel
  // along u and 0.2 along v.
  panel.crosshair = panel.surface->loaded.surface.normal({103.25, 81.25});
  panel.frame();
  EXPECT_EQ(panel.said(), "");
  EXPECT_TRUE(is_yellow(panel.color_of(204, 162)));
  EXPECT_FALSE(is_yellow(panel.color_of(196, 159)));  // as near to the centre, on its other side
  panel.crosshair = glm::dvec2(-0.9, 0);
  panel.frame();
  EXPECT_EQ(panel.said(), "no element reaches the crosshair");
  EXPECT_FALSE(is_yellow(panel.color_of(204, 162)));
}

TEST(NormalMapView, SaysWhenToZoomInToSeeTheElements) {
  ElementPanel panel;
  panel.view.zoom_by(5.0 / panel.view.zoom());
  panel.frame();
  EXPECT_EQ(panel.said(), "zoom in to see the elements");
  EXPECT_FALSE(is_yellow(panel.color_of(202, 159)));
}

TEST(NormalMapView, WithoutAMapOffersToOpenOne) {
  test::Stage stage({276, 308});
  NormalMapView view;
  const Document document;
  bool opened = false;
  const auto body = [&](Ui& ui) {
    opened |= view.draw(ui, {{0, 0}, {276, 308}}, {document, nullptr, {}, false, 0, false, false}).open_pressed;
  };
  stage.frame(body);
  stage.frame(body);
  EXPECT_FALSE(view.screen_of({1, 1}));
  stage.click("map.open", body);
  EXPECT_TRUE(opened);
}

}  // namespace
}  // namespace glint::view
