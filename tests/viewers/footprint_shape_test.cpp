#include "viewers/map/footprint_shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/document/parameter.h"
#include "core/pndf/footprint.h"

namespace glint::view {
namespace {

constexpr double k_degree = std::numbers::pi / 180;
constexpr AxisEnd k_first_end{0, 1};

void expect_shape(const FootprintShape& shape, double first, double second, double degrees) {
  EXPECT_NEAR(shape.widths.x, first, 1e-9 * first);
  EXPECT_NEAR(shape.widths.y, second, 1e-9 * second);
  EXPECT_NEAR(shape.angle / k_degree, degrees, 1e-9);
}

TEST(FootprintShape, HasPinnedCovariances) {
  const SymmetricMatrix2 along = covariance_of({{3, 2}, 0});
  EXPECT_EQ(along, (SymmetricMatrix2{9, 0, 4}));
  // Turned by 45 degrees: ((9 + 4) / 2, (9 - 4) / 2, (9 + 4) / 2). v runs down, so axis 0 points to the lower right.
  const SymmetricMatrix2 turned = covariance_of({{3, 2}, 45 * k_degree});
  EXPECT_NEAR(turned.xx, 6.5, 1e-14);
  EXPECT_NEAR(turned.xy, 2.5, 1e-14);
  EXPECT_NEAR(turned.yy, 6.5, 1e-14);
}

TEST(FootprintShape, IsReadFromPinnedCovariances) {
  expect_shape(shape_of({9, 0, 4}), 3, 2, 0);
  expect_shape(shape_of({4, 0, 9}), 3, 2, 90);
  expect_shape(shape_of({6.5, -2.5, 6.5}), 3, 2, -45);
  expect_shape(shape_of({25, 0, 25}), 5, 5, 0);  // a circle has no direction: 0
}

TEST(FootprintShape, GoesToACovarianceAndBack) {
  for (const double degrees : {-89.0, -35.0, 0.0, 12.5, 90.0}) {
    for (const double ratio : {1.01, 1.7, 50.0, 3000.0}) {
      const FootprintShape shape = shape_of(covariance_of({{12, 12 / ratio}, degrees * k_degree}));
      EXPECT_NEAR(shape.widths.x, 12, 1e-12);
      // Of a thin ellipse only the determinant holds the smaller width: rounding grows by the ratio squared.
      EXPECT_NEAR(shape.widths.y * ratio / 12, 1, 1e-15 * ratio * ratio);
      EXPECT_NEAR(shape.angle / k_degree, degrees, 1e-9 / (ratio - 1)) << ratio;
    }
  }
}

TEST(AxisEnd, FollowsTheMouseAndLeavesTheOtherWidth) {
  const FootprintShape start{{12, 7}, -35 * k_degree};
  const FootprintShape dragged = with_axis_end(start, k_first_end, {3, 4}, {});
  expect_shape(dragged, 5, 7, std::atan2(4, 3) / k_degree);
  const glm::dvec2 end = dragged.widths.x * axis_direction(dragged, 0);
  EXPECT_NEAR(end.x, 3, 1e-12);
  EXPECT_NEAR(end.y, 4, 1e-12);
}

TEST(AxisEnd, OfTheOtherAxisAndTheOtherSideTurnTheSameEllipse) {
  const FootprintShape start{{12, 7}, 0};
  expect_shape(with_axis_end(start, {0, -1}, {-10, 0}, {}), 10, 7, 0);
  expect_shape(with_axis_end(start, {1, 1}, {0, 9}, {}), 12, 9, 0);
  expect_shape(with_axis_end(start, {1, -1}, {0, -9}, {}), 12, 9, 0);
  expect_shape(with_axis_end(start, {1, 1}, {-9, 9}, {}), 12, 9 * std::numbers::sqrt2, 45);
}

TEST(AxisEnd, KeepsTheAngleOnDemand) {
  const FootprintShape start{{12, 7}, 0};
  expect_shape(with_axis_end(start, k_first_end, {8, 100}, {.keep_angle = true}), 8, 7, 0);
  // Beyond the centre the width ends at its least.
  expect_shape(with_axis_end(start, k_first_end, {-8, 0}, {.keep_angle = true}), 0.05, 7, 0);
}

TEST(AxisEnd, KeepsTheRatioOnDemandAndAtTheLimits) {
  const FootprintShape start{{12, 6}, 0};
  expect_shape(with_axis_end(start, k_first_end, {24, 0}, {.keep_ratio = true}), 24, 12, 0);
  expect_shape(with_axis_end(start, {1, 1}, {0, 3}, {.keep_ratio = true}), 6, 3, 0);
  expect_shape(with_axis_end(start, k_first_end, {1e-3, 0}, {.keep_ratio = true}), 0.1, 0.05, 0);
  expect_shape(with_axis_end(start, {1, 1}, {0, 1e7}, {.keep_ratio = true}), 1e4, 5e3, 0);
}

TEST(AxisEnd, NeverMakesADocumentWithAFault) {
  for (const double width : {1e-5, 0.05, 7.0, 1e4, 9e4}) {
    for (const double reach : {0.0, 1e-12, 0.05, 3.0, 1e4, 1e12}) {
      for (const double degrees : {0.0, 33.3, 90.0, 179.0, 271.0}) {
        const glm::dvec2 offset(reach * std::cos(degrees * k_degree), reach * std::sin(degrees * k_degree));
        for (const AxisEnd end : k_axis_ends) {
          for (const DragRule rule : {DragRule{}, {true, false}, {false, true}, {true, true}}) {
            Document document;
            document.footprint.covariance = covariance_of(with_axis_end({{width, 2}, 0.3}, end, offset, rule));
            EXPECT_FALSE(document_fault(document)) << width << ' ' << reach << ' ' << degrees;
          }
        }
      }
    }
  }
}

TEST(Ring, IsAsManyDeviationsFromTheCentre) {
  const SymmetricMatrix2 covariance{6.5, 2.5, 6.5};
  const ScreenEllipse ellipse = ring(shape_of(covariance), {100, 50}, 2, 3);
  const Whitening white = whitening(covariance);
  const std::vector<Arc> arcs = visible_arcs(ellipse, {{0, 0}, {200, 100}});
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_TRUE(arcs[0].closed);
  for (const ImVec2 p : arcs[0].points) {
    const glm::dvec2 w = white.apply(glm::dvec2(p.x - 100, p.y - 50) / 2.0);
    EXPECT_NEAR(std::hypot(w.x, w.y), 3, 1e-4);
  }
  // The extent along u is the deviation of u: sqrt(6.5), 3 of them, 2 pixels a texel.
  EXPECT_NEAR(half_extent(ellipse).x, 6 * std::sqrt(6.5), 1e-12);
}

TEST(Ring, ShowsOnlyItsPartsInsideAndOnThemAllPoints) {
  const Rectangle area{{0, 0}, {100, 100}};
  // A circle of radius 60 about the middle leaves four arcs in the corners.
  const std::vector<Arc> arcs = visible_arcs({{50, 50}, {60, 0}, {0, 60}}, area);
  EXPECT_EQ(arcs.size(), 4U);
  for (const Arc& arc : arcs) {
    EXPECT_FALSE(arc.closed);
    for (const ImVec2 p : arc.points) EXPECT_NEAR(std::hypot(p.x - 50, p.y - 50), 60, 1e-3);
  }
  EXPECT_TRUE(visible_arcs({{50, 50}, {200, 0}, {0, 200}}, area).empty());  // all around the picture
  EXPECT_TRUE(visible_arcs({{900, 50}, {20, 0}, {0, 20}}, area).empty());   // beside it
}

TEST(Ring, HoweverLargeStaysALineOfFewPoints) {
  // Radius 3 million pixels, passing through the middle of the picture.
  const std::vector<Arc> arcs = visible_arcs({{50 - 3e6, 50}, {3e6, 0}, {0, 3e6}}, {{0, 0}, {100, 100}});
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_LT(arcs[0].points.size(), 10U);
  for (const ImVec2 p : arcs[0].points) EXPECT_NEAR(p.x, 50, 0.01);
}

TEST(Handles, StandAtTheEndsOfTheAxes) {
  const std::array<ImVec2, 4> handles = handle_positions({{100, 100}, {30, 0}, {0, 20}}, 15);
  EXPECT_EQ(handles[0].x, 130);
  EXPECT_EQ(handles[1].y, 120);
  EXPECT_EQ(handles[2].x, 70);
  EXPECT_EQ(handles[3].y, 80);
}

TEST(Handles, OfASmallEllipseStandApart) {
  const std::array<ImVec2, 4> handles = handle_positions({{100, 100}, {3, 0}, {0, 0.001}}, 15);
  EXPECT_EQ(handles[0].x, 115);
  EXPECT_EQ(handles[1].y, 115);
}

TEST(Handles, AreHitByTheNearest) {
  const std::array<ImVec2, 4> handles{ImVec2(10, 10), {18, 10}, {100, 100}, {200, 200}};
  EXPECT_EQ(handle_at(handles, {15, 11}, 7), 1);
  EXPECT_EQ(handle_at(handles, {12, 11}, 7), 0);
  EXPECT_EQ(handle_at(handles, {106, 106}, 7), 2);  // squares: the corner counts
  EXPECT_FALSE(handle_at(handles, {60, 60}, 7));
}

}  // namespace
}  // namespace glint::view
