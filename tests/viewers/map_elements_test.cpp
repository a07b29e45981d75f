#include "viewers/map/map_elements.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/pndf/mixture_pndf.h"
#include "core/surface/normal_pyramid.h"
#include "tests/core/pndf/test_maps.h"

namespace glint::view {
namespace {

ElementRequest request_on(const test::MapPointer& map) {
  JobControl control;
  auto pyramid = std::make_shared<const NormalPyramid>(*NormalPyramid::build(map, control));
  ElementRequest request;
  request.surface = std::make_shared<const SurfaceInUse>(
      SurfaceInUse{LoadedSurface{Surface(map, Interpolation::smooth), std::nullopt}, {}, std::move(pyramid)});
  request.intrinsic_roughness = 0.02;
  request.footprint = isotropic_footprint({100.3, 80.2}, 4);
  request.part = {{80, 60}, {120, 100}};
  request.pixels_per_texel = 8;
  return request;
}

ElementRequest wavy_request() {
  return request_on(test::wavy_map(256, 200, Wrap::repeat));
}

bool ascends(const std::vector<ShownElement>& elements) {
  return std::is_sorted(elements.begin(), elements.end(),
                        [](const auto& a, const auto& b) { return a.share < b.share; });
}

TEST(MapElements, AreThoseUnderTheFootprintByTheirWeight) {
  MapElements elements;
  const ShownElements& shown = elements.at(wavy_request());
  EXPECT_EQ(shown.instead, "");
  EXPECT_FALSE(shown.by_density);
  EXPECT_TRUE(ascends(shown.elements));
  EXPECT_NEAR(shown.radius, 0.5 * 0.42466, 1e-5);
  // Shares are exp(-d^2 / 2) up to the nearest seed's own distance, and a thousandth is 3.7 sigma away.
  const double variance = 16 + shown.radius * shown.radius;
  for (const ShownElement& e : shown.elements) {
    const glm::dvec2 d = e.seed - glm::dvec2(100.3, 80.2);
    EXPECT_NEAR(e.share, std::exp(-0.5 * (d.x * d.x + d.y * d.y) / variance), 3e-3);
  }
  const double expected = 2 * std::log(1000) * std::numbers::pi * variance / 0.25;  // elements in that circle
  EXPECT_NEAR(static_cast<double>(shown.elements.size()) / expected, 1, 0.02);
  EXPECT_EQ(shown.elements.back().share, 1);
}

TEST(MapElements, AtACrosshairAreSharesOfWhatAddsUpToTheDensityThere) {
  const ElementRequest weights = wavy_request();
  ElementRequest request = weights;
  const Surface& surface = request.surface->loaded.surface;
  request.crosshair = surface.normal({103, 82});
  MapElements elements;
  const ShownElements shown = elements.at(request);
  EXPECT_TRUE(shown.by_density);
  EXPECT_TRUE(ascends(shown.elements));
  double sum = 0;
  for (const ShownElement& e : shown.elements) sum += static_cast<double>(e.share) * shown.largest;
  const MixturePndf model(surface, request.intrinsic_roughness, request.mixture);
  PndfWorkspace workspace;
  const double density = model.at(request.footprint, workspace).pdf(*request.crosshair);
  EXPECT_NEAR(sum / density, 1, 2e-3);  // those below a thousandth of the largest are left out
  // What lights up has the crosshair's normal.
  const glm::dvec2 brightest = shown.elements.back().seed;
  const glm::dvec2 off = surface.normal(brightest) - *request.crosshair;
  EXPECT_LT(std::hypot(off.x, off.y), 0.02);
  // Those under the footprint that do not stay, dark.
  EXPECT_GE(shown.elements.size(), MapElements().at(weights).elements.size());
  EXPECT_LT(shown.elements.front().share, 1e-3F);
}

TEST(MapElements, AtANormalThatNoneReachesAreDark) {
  ElementRequest request = wavy_request();
  request.crosshair = glm::dvec2(-0.9, 0.1);
  MapElements elements;
  const ShownElements& shown = elements.at(request);
  EXPECT_EQ(shown.largest, 0);
  ASSERT_FALSE(shown.elements.empty());
  EXPECT_EQ(shown.elements.back().share, 0);
}

TEST(MapElements, AreNotShownWhereTheyCannotBeToldApart) {
  ElementRequest request = wavy_request();
  request.pixels_per_texel = 5.9;  // two a texel
  MapElements elements;
  EXPECT_EQ(elements.at(request).instead, "zoom in to see the elements");
  EXPECT_TRUE(elements.at(request).elements.empty());
  request.pixels_per_texel = 6.1;
  EXPECT_EQ(elements.at(request).instead, "");
  request.mixture.step = 0.25;
  EXPECT_EQ(elements.at(request).instead, "zoom in to see the elements");
  request.mixture.step = 1;
  EXPECT_FALSE(elements.at(request).elements.empty());
  request.pixels_per_texel = 1;
  EXPECT_EQ(elements.at(request).instead, "zoom in to see the elements");  // though they are known
}

TEST(MapElements, FollowTheView) {
  MapElements elements;
  ElementRequest request = wavy_request();
  const ShownElements all = elements.at(request);
  request.part = {{98, 78}, {101, 82}};
  const ShownElements part = elements.at(request);
  EXPECT_EQ(part.largest, all.largest);  // colours stay while one pans
  ASSERT_FALSE(part.elements.empty());
  for (const ShownElement& e : part.elements) {
    EXPECT_TRUE(e.seed.x > 97.7 && e.seed.x < 101.3 && e.seed.y > 77.7 && e.seed.y < 82.3);
  }
  request.part = {{0, 0}, {20, 20}};
  EXPECT_EQ(elements.at(request).instead, "no elements in view");
}

TEST(MapElements, OfAWideFootprintAreThoseInViewAndTheBrightestOfThem) {
  ElementRequest request = request_on(test::wavy_map(2048, 2048, Wrap::repeat));
  request.footprint = isotropic_footprint({1000, 1000}, 60);
  request.part = {{900, 900}, {1100, 1080}};
  request.pixels_per_texel = 6;
  MapElements elements;
  const ShownElements& shown = elements.at(request);
  EXPECT_EQ(shown.elements.size(), ShownElements::k_most);
  EXPECT_NEAR(static_cast<double>(shown.left_out + ShownElements::k_most), 4 * 200.4 * 180.4, 1000);
  for (const ShownElement& e : shown.elements) {
    EXPECT_LT(std::hypot(e.seed.x - 1000, e.seed.y - 1000), std::sqrt(20'000 / 4 / std::numbers::pi) + 2);
  }
}

TEST(MapElements, OfALongFootprintAcrossTheAxesAreThoseInView) {
  ElementRequest request = request_on(test::wavy_map(2048, 2048, Wrap::repeat));
  request.footprint = test::turned_footprint({1000, 1000}, 130, 1, 0.7);
  const MixtureFrame frame =
      element_frame(request.surface->loaded.surface, request.mixture, request.footprint, request.intrinsic_roughness);
  ASSERT_LT(frame.elements_within(), MapElements::k_most_kept);  // in a box of many more seeds
  MapElements elements;
  request.part = {{990, 990}, {1010, 1010}};
  EXPECT_FALSE(elements.at(request).elements.empty());
  request.part = {{1060, 1050}, {1080, 1070}};
  EXPECT_FALSE(elements.at(request).elements.empty());  // gathered anew
  request.part = {{0, 0}, {2000, 2000}};
  EXPECT_EQ(elements.at(request).instead, "zoom in to see the elements");
}

TEST(MapElements, AreNoneWhereTheMixtureIsEvaluatedExactly) {
  ElementRequest request = wavy_request();
  request.intrinsic_roughness = 1e-8;
  MapElements elements;
  EXPECT_EQ(elements.at(request).instead, "evaluated exactly here: no elements");
}

TEST(MapElements, NeedTheMixtureAmongTheMethods) {
  Document document;
  EXPECT_EQ(reason_without_elements(document), "The mixture is not among the methods");
  document.methods = {PndfMethod::exact, PndfMethod::mixture};
  EXPECT_EQ(reason_without_elements(document), "");
}

}  // namespace
}  // namespace glint::view
