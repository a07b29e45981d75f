#include "core/pndf/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/cell_visit.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};

bool holds(const NormalBox& outer, const NormalBox& inner) {
  constexpr double rounding = 1e-15;
  return outer.lo.x <= inner.lo.x + rounding && outer.lo.y <= inner.lo.y + rounding &&
         outer.hi.x >= inner.hi.x - rounding && outer.hi.y >= inner.hi.y - rounding;
}

TEST(SurfaceCells, BoxesHoldAllVerticesOvershootAndShiftIncluded) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : k_surfaces) {
      for (const int subdivision : {1, 2, 4, 16}) {
        for (const bool shift : {false, true}) {
          const SurfaceCells cells(Surface(test::rough_map(37, 21, wrap), interpolation), subdivision, shift);
          CellVertices vertices;
          const SurfaceCells::Axis u = cells.axis_u();
          const SurfaceCells::Axis v = cells.axis_v();
          for (std::int64_t j = 0; j < v.count; ++j) {
            for (std::int64_t i = 0; i < u.count; ++i) {
              cells.vertices({u.first + i, v.first + j}, {{0, 1}, {0, 1}}, vertices);
              const NormalBox box = vertices.normal_box();
              EXPECT_TRUE(holds(cells.cell_box({u.first + i, v.first + j}), box)) << i << ' ' << j;
              EXPECT_TRUE(holds(cells.tile_box(i / SurfaceCells::k_tile, j / SurfaceCells::k_tile), box));
            }
          }
        }
      }
    }
  }
}

// A worst map: the samples whose weights are negative at the top, the others at the bottom.
TEST(SurfaceCells, BoxesHoldTheLargestOvershootThereIs) {
  const auto map = test::map_of(4, 4, Wrap::repeat, [](int i, int j) {
    const bool inner = (i == 1 || i == 2) == (j == 1 || j == 2);
    return glm::dvec2(inner ? 0.0 : 1.0, 0);
  });
  const SurfaceCells cells(Surface(map, Interpolation::smooth), 4, false);
  CellVertices vertices;
  cells.vertices({1, 1}, {{0, 1}, {0, 1}}, vertices);
  EXPECT_NEAR(vertices.normal_box().lo.x, -0.28125, 1e-15);
  EXPECT_LE(cells.cell_box({1, 1}).lo.x, vertices.normal_box().lo.x);
}

TEST(SurfaceCells, VerticesLieOnTheSurfaceAndNeighboursShareThem) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : k_surfaces) {
      const Surface surface(test::rough_map(9, 7, wrap), interpolation);
      const SurfaceCells cells(surface, 4, false);
      CellVertices vertices;
      for (std::int64_t j = -2; j < 9; ++j) {
        for (std::int64_t i = -2; i < 11; ++i) {
          const glm::dvec2 corner = glm::dvec2(i, j) + cells.border();
          cells.vertices({i, j}, {{corner.x, corner.x + 1}, {corner.y, corner.y + 1}}, vertices);
          vertices.for_each_triangle([&](const SurfaceTriangle& triangle) {
            const glm::dvec2 inward(triangle.du > 0 ? 1e-9 : -1e-9, triangle.dv > 0 ? 1e-9 : -1e-9);
            const glm::dvec2 places[] = {triangle.corner, triangle.corner + glm::dvec2(triangle.du, 0),
                                         triangle.corner + glm::dvec2(0, triangle.dv)};
            for (std::size_t k = 0; k < 3; ++k) {
              glm::dvec2 at = places[k];
              if (interpolation == Interpolation::constant) at = triangle.corner + inward;
              const glm::dvec2 n = surface.normal(at);
              EXPECT_NEAR(triangle.normals[k].x, n.x, 1e-14);
              EXPECT_NEAR(triangle.normals[k].y, n.y, 1e-14);
            }
          });
        }
      }
    }
  }
}

TEST(SurfaceCells, TrianglesTileTheirCellCutFromUpperRightToLowerLeft) {
  const SurfaceCells cells(Surface(test::rough_map(8, 8, Wrap::repeat), Interpolation::smooth), 4, false);
  CellVertices vertices;
  cells.vertices({3, 2}, {{-1, 0}, {5, 6}}, vertices);
  double area = 0;
  std::map<std::pair<long, long>, int> hits;  // of points of a grid: each exactly once
  vertices.for_each_triangle([&](const SurfaceTriangle& t) {
    area += std::abs(t.du * t.dv) / 2;
    for (long b = 0; b < 40; ++b) {
      for (long a = 0; a < 40; ++a) {
        const double x = (-1 + (static_cast<double>(a) + 0.4) / 40 - t.corner.x) / t.du;
        const double y = (5 + (static_cast<double>(b) + 0.3) / 40 - t.corner.y) / t.dv;
        if (x >= 0 && y >= 0 && x + y <= 1) ++hits[{a, b}];
      }
    }
  });
  EXPECT_NEAR(area, 1, 1e-14);
  EXPECT_EQ(hits.size(), 1600U);
  EXPECT_TRUE(std::all_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.second == 1; }));
  const auto [upper, lower] = vertices.triangles(1, 2);
  EXPECT_EQ(upper.normals[1], lower.normals[2]);  // the cut's upper right end
  EXPECT_EQ(upper.normals[2], lower.normals[1]);  // and its lower left end
}

TEST(SurfaceCells, ShiftMovesVerticesByTheStatedCurvatureOnAParabola) {
  // n = (u^2, u v) / 512: n_uu = (2, 0), n_uv = (0, 1), n_vv = 0, all / 512; Catmull-Rom reproduces it.
  const auto map = test::map_of(16, 16, Wrap::clamp, [](int i, int j) { return glm::dvec2(i * i, i * j) / 512.0; });
  const Surface surface(map, Interpolation::smooth);
  const OffsetBox box{{0, 1}, {0, 1}};
  for (const int subdivision : {1, 2, 4}) {
    CellVertices plain;
    CellVertices shifted;
    SurfaceCells(surface, subdivision, false).vertices({7, 8}, box, plain);
    SurfaceCells(surface, subdivision, true).vertices({7, 8}, box, shifted);
    const double h = 1.0 / subdivision;
    for (std::size_t k = 0; k < plain.normals.size(); ++k) {
      EXPECT_NEAR(shifted.normals[k].x, plain.normals[k].x - h * h / 12 * 2 / 512, 1e-16);
      EXPECT_NEAR(shifted.normals[k].y, plain.normals[k].y + h * h / 12 / 512, 1e-16);
    }
  }
}

TEST(SurfaceCells, StretchesTheOutermostCellsOfAMapThatClampsAsFarAsAsked) {
  const SurfaceCells cells(Surface(test::rough_map(8, 6, Wrap::clamp), Interpolation::linear), 1, false);
  EXPECT_EQ(cells.axis_u().first, -2);
  EXPECT_EQ(cells.axis_u().count, 11);
  EXPECT_EQ(cells.column_span(-2, 3, 100).lo, -100);
  EXPECT_EQ(cells.column_span(-2, 3, 100).hi, -1 + 0.5 - 3);
  EXPECT_EQ(cells.column_span(8, 3, 100).hi, 100);
  EXPECT_EQ(cells.row_span(6, 3, 100).hi, 100);
  EXPECT_EQ(cells.row_span(2, 3, 100).lo, 2.5 - 3);
  // A cell is stretched, never shrunk, where the footprint ends before it.
  EXPECT_EQ(cells.column_span(8, 3, 2).hi, 9.5 - 3);
}

// Every cell that a brute scan finds near enough is visited, exactly once, by exactly one of the shares.
TEST(VisitCells, VisitsEachCellWithinTheCutOnceOverAllShares) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::constant}) {
      for (const Footprint& footprint : {Footprint{{18.2, 3.3}, {9, 2, 5}}, Footprint{{36.9, 20.9}, {200, 150, 130}},
                                         Footprint{{-4, 11}, {3, 0, 90}}}) {
        const SurfaceCells cells(Surface(test::rough_map(37, 21, wrap), interpolation), 1, false);
        const FootprintWindow window(footprint.covariance);
        constexpr double cut = 5;
        std::multiset<std::pair<std::int64_t, std::int64_t>> visited;
        for (std::int64_t share = 0; share < 3; ++share) {
          visit_cells(
              cells, window, footprint.center, cut, {share, 3}, [](const NormalBox&) { return 0.0; },
              [&](CellIndex cell, const OffsetBox&, const NormalBox&) {
                visited.insert({cell.i, cell.j});
              });
        }
        std::multiset<std::pair<std::int64_t, std::int64_t>> expected;
        const double reach_x = window.reach_x(cut);
        const double reach_y = window.reach_y(cut);
        const auto within = [&](std::int64_t k, const SurfaceCells::Axis& axis) {
          return axis.periodic || (k >= axis.first && k < axis.first + axis.count);
        };
        for (std::int64_t j = -150; j < 150; ++j) {
          for (std::int64_t i = -150; i < 150; ++i) {
            if (!within(i, cells.axis_u()) || !within(j, cells.axis_v())) continue;
            const OffsetBox box{cells.column_span(i, footprint.center.x, reach_x),
                                cells.row_span(j, footprint.center.y, reach_y)};
            if (window.squared_distance(box) < cut * cut) expected.insert({i, j});
          }
        }
        EXPECT_GT(expected.size(), 20U);
        EXPECT_EQ(visited, expected);
      }
    }
  }
}

TEST(VisitPeriod, VisitsEachCellOfOnePeriodOnceOverAllShares) {
  const SurfaceCells cells(Surface(test::rough_map(37, 21, Wrap::repeat), Interpolation::linear), 1, false);
  std::multiset<std::pair<std::int64_t, std::int64_t>> visited;
  for (std::int64_t share = 0; share < 3; ++share) {
    visit_period(
        cells, {share, 3}, [](const NormalBox&) { return true; },
        [&](CellIndex cell) {
          visited.insert({cell.i, cell.j});
        });
  }
  EXPECT_EQ(visited.size(), 37U * 21U);
  EXPECT_EQ((std::set(visited.begin(), visited.end()).size()), 37U * 21U);
}

}  // namespace
}  // namespace glint
