// What was found of a method's input, under its rows in the Inspector.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/viewers/inspector_scene.h"

namespace glint {
namespace {

using test::InspectorScene;

std::shared_ptr<const view::PndfResults> results_with(std::vector<std::string> findings) {
  auto results = std::make_shared<view::PndfResults>();
  view::MethodPicture picture;
  picture.method = PndfMethod::mixture;
  picture.findings = std::move(findings);
  results->methods = {picture};
  return results;
}

TEST(MethodFindings, StandUnderTheRowsOfTheMixtureAndPushTheRestDown) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document.methods = {PndfMethod::exact, PndfMethod::mixture};
  scene.frame(2);
  EXPECT_EQ(scene.widget("mixture.finding.0"), nullptr);
  const float below = scene.widget("auto.tolerance")->area.min.y;
  scene.results = results_with(
      {"sigma_r 0.002 is below the 8-bit step of the map, 0.0078: the P-NDF shows its steps", "elements ripple"});
  scene.frame(2);
  ASSERT_NE(scene.widget("mixture.finding.0"), nullptr);
  ASSERT_NE(scene.widget("mixture.finding.1"), nullptr);
  const view::Rectangle first = scene.widget("mixture.finding.0")->area;
  const view::Rectangle second = scene.widget("mixture.finding.1")->area;
  EXPECT_GT(first.min.y, scene.widget("mixture.elements")->area.max.y);
  EXPECT_GT(first.height(), 2 * 17.0F);  // in more than one line
  EXPECT_LT(second.height(), 2 * 17.0F);
  EXPECT_GE(second.min.y, first.max.y);
  EXPECT_NEAR(scene.widget("auto.tolerance")->area.min.y - below, first.height() + second.height(), 1);
}

TEST(MethodFindings, AreGoneWithTheMethod) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.results = results_with({"elements ripple"});
  scene.document.methods = {PndfMethod::exact};
  scene.frame(2);
  EXPECT_EQ(scene.widget("mixture.finding.0"), nullptr);
}

}  // namespace
}  // namespace glint
