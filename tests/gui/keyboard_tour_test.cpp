// The tour of the window by keyboard alone: not one event of a mouse.

#include <gtest/gtest.h>

#include "tests/gui/application_stage.h"

namespace glint::test {
namespace {

// Tab until the control has the focus.
void tab_to(const ApplicationStage& stage, const std::string& name) {
  const std::size_t controls = stage.app().widgets().order().size();
  for (std::size_t k = 0; k <= controls; ++k) {
    if (stage.app().screen().state().focus.name == name) return;
    stage.play("key Tab");
  }
  FAIL() << name << " was not reached by Tab";
}

TEST(KeyboardTour, OpensAPresetFromThePalette) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key Ctrl+P\nwait 2\ntype flat-oracle\nwait 2\nkey Enter\nwait jobs");
  EXPECT_EQ(stage.document().name, "flat-oracle");
}

TEST(KeyboardTour, MovesShapesAndTurnsTheFootprint) {
  const ApplicationStage stage;
  stage.open_small();
  const glm::dvec2 at = stage.document().footprint.center;
  stage.play("key Right\nkey Right\nkey Down\nkey Shift+Left");
  EXPECT_EQ(stage.document().footprint.center, at + glm::dvec2(2 - 10, 1));
  const SymmetricMatrix2 before = stage.document().footprint.covariance;
  stage.play("key ]");
  EXPECT_NEAR(stage.document().footprint.covariance.xx, 1.5625 * before.xx, 1e-12);
  stage.play("key [");
  EXPECT_NEAR(stage.document().footprint.covariance.xx, before.xx, 1e-12);
  stage.play("key .");
  EXPECT_NEAR(determinant(stage.document().footprint.covariance), determinant(before), 1e-9);
  EXPECT_GT(std::abs(stage.document().footprint.covariance.xx - before.xx), 0.05);
}

TEST(KeyboardTour, ReachesControlsByTabAndUsesThem) {
  const ApplicationStage stage;
  stage.open_small();
  tab_to(stage, "view.map_colors.slope");
  stage.play("key Enter\nwait 2");
  EXPECT_EQ(stage.document().view.map_colors, MapColors::slope);
  tab_to(stage, "intrinsic_roughness.slider");
  const double before = stage.document().intrinsic_roughness;
  stage.play("key Right\nwait 2");
  EXPECT_GT(stage.document().intrinsic_roughness, before);
  tab_to(stage, "intrinsic_roughness");
  stage.play("key Enter\nwait 2\nkey Ctrl+A\ntype 0.06\nkey Enter\nexpect intrinsic_roughness 0.06");
}

TEST(KeyboardTour, ChoosesFromAListWithArrowsAndEnter) {
  const ApplicationStage stage;
  stage.open_small();
  tab_to(stage, "grid.size");
  stage.play("key Enter\nwait 3\nkey Down\nkey Enter\nwait jobs");
  EXPECT_NE(stage.document().grid.size, 96);
}

TEST(KeyboardTour, OpensAMenuAndRunsWhatIsInIt) {
  const ApplicationStage stage;
  stage.open_small();
  tab_to(stage, "menu.View");
  ASSERT_NE(stage.document().view.map_colors, MapColors::slope);
  stage.play("key Enter\nwait 3");
  EXPECT_FALSE(stage.app().screen().state().open_popup.empty());
  for (int down = 0; down < 6; ++down) stage.play("key Down\nwait 1");  // from "Whole map" to "Map as slope"
  stage.play("key Enter\nwait 3");
  EXPECT_EQ(stage.document().view.map_colors, MapColors::slope);
  EXPECT_TRUE(stage.app().screen().state().open_popup.empty());
}

TEST(KeyboardTour, GoesFromPanelToPanel) {
  const ApplicationStage stage;
  stage.open_small();
  const gui::Panel first = stage.app().panels().focused();
  stage.play("key F6");
  EXPECT_NE(stage.app().panels().focused(), first);
  stage.play("key F6\nkey F6");
  EXPECT_EQ(stage.app().panels().focused(), first);
}

TEST(KeyboardTour, SavesThroughTheDialog) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key Ctrl+Shift+S\nwait 3\nkey Ctrl+A\ntype keyboard steel\nwait 2\nkey Enter\nwait 5");
  EXPECT_EQ(stage.document().name, "keyboard steel");
  EXPECT_TRUE(stage.app().workbench().editor().is_saved());
}

TEST(KeyboardTour, ZoomsTheMap) {
  const ApplicationStage stage;
  stage.open_small();
  const double before = stage.app().panels().map().zoom();
  stage.play("key =\nwait 2");
  EXPECT_GT(stage.app().panels().map().zoom(), before);
  stage.play("key -\nkey -\nwait 2");
  EXPECT_LT(stage.app().panels().map().zoom(), before);
}

TEST(KeyboardTour, ExportsThroughTheDialog) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key Ctrl+E\nwait 3");
  tab_to(stage, "export.path");
  const std::filesystem::path file = stage.folder / "images.exr";
  stage.play("key Enter\nwait 2\nkey Ctrl+A\ntype " + file.string() + "\nwait 2\nkey Enter\nwait 5");
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(KeyboardTour, OpensAFileThroughTheBrowser) {
  const ApplicationStage stage;
  stage.open_small();
  write_text(stage.folder / "other.json",
             std::string(k_small_preset).replace(k_small_preset.find("small"), 5, "other"));
  stage.play("key Ctrl+Shift+O\nwait 5");
  tab_to(stage, "browser.path");
  stage.play("key Enter\nwait 2\nkey Ctrl+A\ntype " + (stage.folder / "other.json").string() +
             "\nwait 3\nkey Enter\nwait 5");
  if (stage.app().overlays().is_open()) {
    tab_to(stage, "browser.accept");
    stage.play("key Enter\nwait 5");
  }
  stage.play("wait jobs");
  EXPECT_EQ(stage.document().name, "other");
}

TEST(KeyboardTour, ListsEveryKeyAndLeavesTheList) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("key F1\nwait 3");
  EXPECT_TRUE(stage.app().overlays().is_open());
  stage.play("key Esc\nwait 3");
  EXPECT_FALSE(stage.app().overlays().is_open());
}

}  // namespace
}  // namespace glint::test
