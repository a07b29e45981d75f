// Whole P-NDF images of exact evaluation, held against its single normals.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/exact_pndf.h"
#include "core/pndf/folded_footprint.h"
#include "tests/core/pndf/cancelling.h"
#include "tests/core/pndf/reference_quadrature.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::image_of;
using test::MapPointer;

constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};
constexpr double k_bound = 2.9e-7;  // of the mass, by the joint cut at six deviations

double peak_of(const PndfImage& image) {
  return *std::max_element(image.density.begin(), image.density.end());
}

// The largest difference between cells and D at their centres, every `stride`-th of them, in units of the peak.
double largest_difference(const PndfImage& image, const PndfModel& model, const Footprint& footprint, int stride) {
  const double peak = peak_of(image);
  double worst = 0;
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(footprint, workspace);
  for (int row = stride / 2; row < image.grid.rows; row += stride) {
    for (int column = stride / 2; column < image.grid.columns; column += stride) {
      const double expected = pndf.pdf(image.grid.center(column, row));
      worst = std::max(worst, std::abs(image.density[image.grid.index(column, row)] - expected) / peak);
    }
  }
  return worst;
}

TEST(ExactImage, CellsAreTheValuesAtTheirCentresWhereTheRoughnessIsResolved) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : k_surfaces) {
      const ExactPndf model(Surface(test::rough_map(16, 16, wrap), interpolation), 0.02);
      for (const Footprint& footprint : {isotropic_footprint({15.7, 3.2}, 0.2), Footprint{{4.2, 15.8}, {4, 1, 2}}}) {
        // Cells that are not square, and a window that cuts the lobe.
        const PndfImage image = image_of(model, footprint, {-0.2, 0.31, -0.3, 0.15, 30, 15});
        EXPECT_EQ(image.widening, glm::dvec2(0, 0));
        EXPECT_LE(largest_difference(image, model, footprint, 2), 1e-6)
            << "surface " << static_cast<int>(interpolation);
      }
    }
  }
}

TEST(ExactImage, IsWidenedPerAxisWhereCellsAreCoarserThanTheRoughness) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const Footprint footprint{{4.2, 15.8}, {4, 1, 2}};
  constexpr double roughness = 0.004;
  const PndfGrid both{-0.3, 0.3, -0.3, 0.3, 30, 30};
  const PndfGrid along_s{-0.3, 0.3, -0.3, 0.3, 20, 100};
  for (const PndfGrid& grid : {both, along_s}) {
    const ExactPndf model(surface, roughness);
    const PndfImage image = image_of(model, footprint, grid);
    const glm::dvec2 pitch = grid.pitch();
    EXPECT_DOUBLE_EQ(image.widening.x, pitch.x * pitch.x / 12);
    EXPECT_DOUBLE_EQ(image.widening.y, grid.rows == 30 ? pitch.y * pitch.y / 12 : 0);
    const glm::dvec2 widened(std::sqrt(roughness * roughness + image.widening.x),
                             std::sqrt(roughness * roughness + image.widening.y));
    if (widened.x == widened.y) {
      EXPECT_LE(largest_difference(image, ExactPndf(surface, widened.x), footprint, 3), 1e-6);
      continue;
    }
    const test::SlowPndf slow(surface, 1, footprint, widened);
    for (const glm::ivec2 cell : {glm::ivec2(10, 50), glm::ivec2(7, 31), glm::ivec2(14, 66), glm::ivec2(3, 90)}) {
      const double computed = image.density[grid.index(cell.x, cell.y)];
      EXPECT_NEAR(computed, slow.density(grid.center(cell.x, cell.y)), 1e-6 * peak_of(image)) << cell.x;
    }
  }
}

TEST(ExactImage, WideningBeginsBelow06OfThePitch) {
  const PndfGrid grid{0, 1, 0, 0.5, 100, 100};
  EXPECT_EQ(widening_for(grid, 0.0061), glm::dvec2(0, 0));
  EXPECT_EQ(widening_for(grid, 0.0059), glm::dvec2(0.01 * 0.01 / 12, 0));
  EXPECT_EQ(widening_for(grid, 0.0029), glm::dvec2(0.01 * 0.01 / 12, 0.005 * 0.005 / 12));
}

TEST(ExactImage, KeepsItsMassWithinTheStatedBound) {
  for (const Interpolation interpolation : k_surfaces) {
    for (const double radius : {0.01, 1.0, 6.0}) {
      const ExactPndf model(Surface(test::rough_map(16, 16, Wrap::repeat), interpolation), 0.02);
      const PndfImage image = image_of(model, isotropic_footprint({4.2, 15.8}, radius), {-0.6, 0.6, -0.6, 0.6, 96, 96});
      EXPECT_EQ(image.error.estimated, 0);
      EXPECT_LE(image.error.bounded, k_bound);
      EXPECT_NEAR(integral(image), 1, k_bound) << radius << " surface " << static_cast<int>(interpolation);
    }
  }
}

TEST(ExactImage, DiffersFromSingleNormalsByNoMoreThanTheStatedRelativeL1) {
  const ExactPndf model(Surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::smooth), 0.02);
  const Footprint footprint{{4.2, 15.8}, {1, 0.3, 0.5}};
  const PndfImage image = image_of(model, footprint, {-0.5, 0.5, -0.5, 0.5, 30, 30});
  std::vector<glm::dvec2> s;
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 30; ++column) s.push_back(image.grid.center(column, row));
  }
  std::vector<double> exact(s.size());
  JobControl control;
  ASSERT_TRUE(evaluate_all(model, footprint, s, exact, control));
  EXPECT_LE(test::relative_l1(image.density, exact), image.error.bounded);
}

// Triangles a thousand deviations long: cell by cell where the grid is coarse, point by point where it is fine.
TEST(ExactImage, LargeTrianglesAgreeWithSingleNormals) {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
    const ExactPndf model(Surface(test::rough_map(16, 16, Wrap::repeat), interpolation), 2e-4);
    const Footprint footprint = isotropic_footprint({4.2, 15.8}, 0.7);
    const glm::dvec2 at = model.cells().surface().normal(footprint.center);
    for (const int cells : {8, 40}) {  // a window of 24 deviations, 8 or 40 cells a side: coarse enough not to widen
      const double half = cells == 8 ? 0.0012 : 0.002;
      const PndfGrid grid{at.x - half, at.x + half, at.y - half, at.y + half, cells, cells};
      const PndfImage image = image_of(model, footprint, grid);
      ASSERT_EQ(image.widening, glm::dvec2(0, 0));
      EXPECT_LE(largest_difference(image, model, footprint, cells / 8), 1e-6) << cells;
    }
  }
}

TEST(ExactImage, WithTheSmallestRoughnessIsWidenedAndKeepsItsMassOnARoughMap) {
  const ExactPndf model(Surface(test::rough_map(32, 32, Wrap::repeat), Interpolation::linear), 1e-5);
  const PndfImage image = image_of(model, isotropic_footprint({4.2, 15.8}, 4), {-0.5, 0.5, -0.5, 0.5, 128, 128});
  EXPECT_GT(image.widening.x, 0);
  // The sum over cells is not an integral to the last digit where the lobe has creases as sharp as a cell.
  EXPECT_NEAR(integral(image), 1, 1e-3);
}

TEST(ExactImage, LargerThanOneBandHasNoSeam) {
  const ExactPndf model(Surface(test::rough_map(8, 8, Wrap::repeat), Interpolation::linear), 0.02);
  const Footprint footprint = isotropic_footprint({4.2, 5.8}, 0.6);
  const PndfGrid grid{-0.5, 0.5, -0.5, 0.5, 1200, 1000};  // bands of 873 rows
  const PndfImage image = image_of(model, footprint, grid);
  const double peak = peak_of(image);
  for (const int row : {0, 500, 871, 872, 873, 874, 999}) {
    for (int column = 100; column < 1200; column += 250) {
      EXPECT_NEAR(image.density[grid.index(column, row)] / peak,
                  test::density_of(model, footprint, grid.center(column, row)) / peak, 1e-6)
          << column << ' ' << row;
    }
  }
  EXPECT_NEAR(integral(image), 1, k_bound);
}

TEST(ExactImage, OfAWideFootprintIsThatOfTheTiledMapUnfolded) {
  const MapPointer map = test::wavy_map(50, 52, Wrap::repeat);
  const MapPointer many = test::tiled(*map, 12, 12);
  const Footprint footprint{{13.7, 11.2}, {2100, 450, 1800}};
  ASSERT_TRUE(FoldedFootprint::pays(*map, footprint.covariance, 6));
  ASSERT_FALSE(FoldedFootprint::pays(*many, footprint.covariance, 6));
  for (const double roughness : {1e-3, 0.03}) {  // widened; resolved
    const PndfGrid grid{-0.4, 0.4, -0.4, 0.4, 20, 20};
    const PndfImage folded = image_of(ExactPndf(Surface(map, Interpolation::linear), roughness), footprint, grid);
    const PndfImage unfolded = image_of(ExactPndf(Surface(many, Interpolation::linear), roughness), footprint, grid);
    EXPECT_LE(test::relative_l1(folded.density, unfolded.density), k_bound) << roughness;
  }
}

TEST(ExactImage, FoldedWithLargeTrianglesAgreesWithSingleNormals) {
  const ExactPndf model(Surface(test::wavy_map(30, 32, Wrap::repeat), Interpolation::linear), 2e-4);
  const Footprint footprint{{13.7, 11.2}, {2100, 450, 1800}};
  const glm::dvec2 at = model.cells().surface().normal(footprint.center);
  const PndfGrid grid{at.x - 0.0012, at.x + 0.0012, at.y - 0.0012, at.y + 0.0012, 8, 8};
  const PndfImage image = image_of(model, footprint, grid);
  EXPECT_LE(largest_difference(image, model, footprint, 1), 1e-6);
}

TEST(ExactImage, IsTheSameBytesForAnyNumberOfThreads) {
  const ExactPndf model(Surface(test::rough_map(40, 40, Wrap::repeat, 0.05), Interpolation::smooth), 0.01);
  const PndfGrid grid{-0.5, 0.5, -0.5, 0.5, 100, 80};
  for (const Footprint& footprint : {Footprint{{4.2, 15.8}, {9, 2, 5}}, isotropic_footprint({3, 4}, 40)}) {
    std::vector<std::vector<double>> images;
    for (const int threads : {1, 2, 1}) {
      const ThreadLimit limit(threads);
      images.push_back(image_of(model, footprint, grid).density);
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
  }
}

TEST(ExactImage, IsNothingOnceCancelled) {
  const ExactPndf model(Surface(test::rough_map(64, 64, Wrap::repeat), Interpolation::smooth), 0.01);
  const PndfGrid grid{-0.5, 0.5, -0.5, 0.5, 400, 400};
  const Footprint footprint = isotropic_footprint({3, 4}, 10);
  test::expect_no_image_once_cancelled(model, footprint, grid);
}

TEST(PndfGrid, RowsRunFromTheLargestTDownwards) {
  const PndfGrid grid{-1, 1, -0.5, 0.5, 4, 2};
  EXPECT_EQ(grid.center(0, 0), glm::dvec2(-0.75, 0.25));
  EXPECT_EQ(grid.center(3, 1), glm::dvec2(0.75, -0.25));
  EXPECT_EQ(grid.index(3, 1), 7U);
  EXPECT_EQ(grid.cells(), 8U);
  EXPECT_EQ(grid.cell_area(), 0.25);
}

TEST(PndfGrid, IsRefusedWithTheReasonWhenItCannotBe) {
  const auto fault = [](const PndfGrid& grid) { return grid_fault(grid).value_or("none"); };
  EXPECT_EQ(fault({}), "none");
  EXPECT_NE(fault({-1, 1, 0.5, 0.5, 4, 4}).find("TMIN < TMAX"), std::string::npos);
  EXPECT_NE(fault({1, -1, -1, 1, 4, 4}).find("SMIN < SMAX"), std::string::npos);
  EXPECT_NE(fault({-1, 1, -1, 1, 0, 4}).find("1 to 16384"), std::string::npos);
  EXPECT_NE(fault({-1, 1, -1, 1, 4, 16385}).find("1 to 16384"), std::string::npos);
  EXPECT_NE(fault({-1, std::nan(""), -1, 1, 4, 4}).find("four numbers"), std::string::npos);
  EXPECT_NE(fault({-1, 1e9, -1, 1, 4, 4}).find("four numbers"), std::string::npos);
  EXPECT_NE(fault({0, 1e-12, -1, 1, 4, 4}).find("too narrow"), std::string::npos);
}

TEST(PndfImage, KnowsItsMassAndMeanNormal) {
  PndfImage image;
  image.grid = {0, 1, 0, 1, 2, 2};
  image.density = {0, 3, 1, 0};  // 3 at (0.75, 0.75), 1 at (0.25, 0.25)
  EXPECT_EQ(integral(image), 1);
  EXPECT_EQ(mean_normal(image), glm::dvec2(0.625, 0.625));
  image.density = {0, 0, 0, 0};
  EXPECT_EQ(mean_normal(image), glm::dvec2(0, 0));
}

}  // namespace
}  // namespace glint
