// Exact P-NDF images in single precision, held against double precision.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/pndf_grid.h"
#include "core/study/error_metrics.h"
#include "core/surface/noise.h"
#include "tests/core/pndf/cancelling.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::image_of;

constexpr double k_stated = 1e-4;  // relative L1
constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};

std::string fault_in(const PndfImage& image) {
  for (const double density : image.density) {
    if (!std::isfinite(density)) return "not finite";
    if (density < 0) return "negative";
  }
  return {};
}

void expect_close_to_double(const Surface& surface, double roughness, const Footprint& footprint, const PndfGrid& grid,
                            const std::string& what, const ExactSettings& settings = {}) {
  const PndfImage fast = image_of(FastExactPndf(surface, roughness, settings), footprint, grid);
  const PndfImage exact = image_of(ExactPndf(surface, roughness, settings), footprint, grid);
  EXPECT_EQ(fault_in(fast), "") << what;
  EXPECT_EQ(fast.widening, exact.widening) << what;
  EXPECT_LE(test::relative_l1(fast.density, exact.density), k_stated) << what;
  // What the joint cut leaves out of one cell is a share of the roughness' own peak.
  const double peak = 1 / (2 * std::numbers::pi * std::sqrt(roughness * roughness + exact.widening.x) *
                           std::sqrt(roughness * roughness + exact.widening.y));
  double worst = 0;
  for (std::size_t k = 0; k < fast.density.size(); ++k) {
    worst = std::max(worst, std::abs(fast.density[k] - exact.density[k]) / peak);
  }
  EXPECT_LE(worst, k_stated) << what;
}

TEST(FastExactImage, IsThatOfDoublePrecisionOnEverySurface) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : k_surfaces) {
      const Surface surface(test::rough_map(16, 16, wrap), interpolation);
      for (const Footprint& footprint : {isotropic_footprint({15.7, 3.2}, 0.2), Footprint{{4.2, 15.8}, {4, 1, 2}}}) {
        // Cells that are not square, and a window that cuts the lobe.
        expect_close_to_double(surface, 0.02, footprint, {-0.2, 0.31, -0.3, 0.15, 61, 43},
                               "surface " + std::to_string(static_cast<int>(interpolation)));
      }
    }
  }
}

TEST(FastExactImage, IsThatOfDoublePrecisionForFootprintsOfEveryShape) {
  const Surface surface(test::rough_map(64, 64, Wrap::repeat, 0.1), Interpolation::linear);
  const PndfGrid grid{-0.2, 0.2, -0.2, 0.2, 64, 64};
  const std::vector<std::pair<std::string, Footprint>> footprints = {
      {"a hundredth of a texel", isotropic_footprint({33.3, 20.1}, 0.01)},
      {"one to a thousand at 45 degrees", test::turned_footprint({31.2, 33.4}, 20, 0.02, 0.7853981633974483)},
      {"one to ten thousand at 45 degrees", test::turned_footprint({31.2, 33.4}, 30, 0.003, 0.7853981633974483)},
      {"one to a thousand along u", test::turned_footprint({31.2, 33.4}, 20, 0.02, 0)},
      {"across the border", isotropic_footprint({63.99, 0.01}, 3)},
      {"far outside of the first period", isotropic_footprint({64 * 31 + 63.99, -64 * 7 + 0.2}, 2)},
      {"larger than the map", isotropic_footprint({20, 20}, 9)}};
  for (const auto& [what, footprint] : footprints) expect_close_to_double(surface, 0.01, footprint, grid, what);
}

TEST(FastExactImage, IsThatOfDoublePrecisionForEveryRoughness) {
  const Surface surface(test::rough_map(32, 32, Wrap::repeat), Interpolation::linear);
  const Footprint footprint{{4.2, 15.8}, {4, 1, 2}};
  for (const double roughness : {1e-9, 1e-5, 1e-3, 0.03, 0.3, 1.0}) {
    expect_close_to_double(surface, roughness, footprint, {-1, 1, -1, 1, 96, 80},
                           "sigma_r " + std::to_string(roughness));
  }
}

TEST(FastExactImage, IsThatOfDoublePrecisionWithVerticesShifted) {
  const Surface surface(test::wavy_map(24, 24, Wrap::repeat), Interpolation::smooth);
  expect_close_to_double(surface, 0.01, isotropic_footprint({4.2, 15.8}, 1.3), {-0.4, 0.4, -0.4, 0.4, 64, 64},
                         "shifted", {.subdivision = 4, .vertex_shift = true});
}

// Triangles a thousand deviations long are beyond single precision.
TEST(FastExactImage, HandsTrianglesThatAreTooLongToDoublePrecision) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const Footprint footprint = isotropic_footprint({4.2, 15.8}, 0.7);
  const glm::dvec2 at = surface.normal(footprint.center);
  for (const double roughness : {2e-4, 5e-4}) {
    expect_close_to_double(surface, roughness, footprint,
                           {at.x - 0.002, at.x + 0.002, at.y - 0.002, at.y + 0.002, 40, 40},
                           "sigma_r " + std::to_string(roughness));
  }
}

// Flat but for a few texels hundreds of deviations away: the triangles between flat texels beside them are not theirs.
TEST(FastExactImage, OfAFlatMapWithScratchesIsThatOfDoublePrecision) {
  const Surface surface(
      test::map_of(24, 24, Wrap::repeat,
                   [](int i, int j) { return i * 7 % 11 == j * 3 % 11 ? glm::dvec2(0.3, 0.1) : glm::dvec2(0, 0); }),
      Interpolation::linear);
  for (const double roughness : {0.001, 0.004}) {
    expect_close_to_double(surface, roughness, isotropic_footprint({12.3, 11.1}, 2),
                           {-0.02, 0.02, -0.02, 0.02, 100, 100}, "sigma_r " + std::to_string(roughness));
    expect_close_to_double(surface, roughness, isotropic_footprint({12.3, 11.1}, 2), {-0.5, 0.5, -0.5, 0.5, 700, 700},
                           "wide, sigma_r " + std::to_string(roughness));
  }
}

TEST(FastExactImage, OfAConstantMapIsTheRoughness) {
  const Surface surface(test::constant_map({0.11, -0.07}), Interpolation::linear);
  const PndfGrid grid{-0.1, 0.3, -0.3, 0.1, 64, 64};
  for (const double radius : {0.01, 1.0, 20.0}) {
    const PndfImage image = image_of(FastExactPndf(surface, 0.03), isotropic_footprint({3.1, 4.4}, radius), grid);
    EXPECT_EQ(fault_in(image), "") << radius;
    double worst = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const glm::dvec2 d = grid.center(column, row) - glm::dvec2(0.11, -0.07);
        const double expected = normal_density(d, {9e-4, 0, 9e-4});
        worst = std::max(worst, std::abs(image.density[grid.index(column, row)] - expected));
      }
    }
    EXPECT_LE(worst * 2 * 3.14159265 * 9e-4, k_stated) << radius;
  }
}

TEST(FastExactImage, KeepsItsMassOn128TrianglesPerTexel) {
  for (const double roughness : {0.01, 0.05}) {
    const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::smooth);
    for (const double radius : {1.0, 6.0}) {
      const FastExactPndf model(surface, roughness, {.subdivision = 8});
      const PndfImage image = image_of(model, isotropic_footprint({4.2, 15.8}, radius), {-1, 1, -1, 1, 128, 128});
      EXPECT_NEAR(integral(image), 1, k_stated) << roughness << ' ' << radius;
      EXPECT_EQ(image.error.estimated, 0);
      EXPECT_LE(image.error.bounded, k_stated);
    }
  }
}

TEST(FastExactImage, IsTheSameForEveryInstructionSetToTheStatedError) {
  const test::InstructionSetGuard guard;
  const Surface surface(test::rough_map(32, 32, Wrap::repeat, 0.1), Interpolation::smooth);
  const Footprint footprint{{4.2, 15.8}, {9, 2, 5}};
  const PndfGrid grid{-0.2, 0.2, -0.2, 0.2, 100, 80};
  const PndfImage exact = image_of(ExactPndf(surface, 0.01), footprint, grid);
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    ASSERT_EQ(instruction_set(), set);
    const PndfImage fast = image_of(FastExactPndf(surface, 0.01), footprint, grid);
    EXPECT_LE(test::relative_l1(fast.density, exact.density), k_stated) << instruction_set_name(set);
    EXPECT_EQ(fault_in(fast), "") << instruction_set_name(set);
  }
}

// Among its millions of rays are some that end exactly where a cell is.
TEST(FastExactImage, OfTheMapOfTheSpeedTablesHasNoCellThatIsOff) {
  const test::InstructionSetGuard guard;
  JobControl control;
  Result<NormalMap> noise = generate_noise({}, control);
  ASSERT_TRUE(noise);
  const Surface surface(std::make_shared<const NormalMap>(std::move(*noise)), Interpolation::linear);
  const Footprint footprint = isotropic_footprint({512.5, 512.5}, 50.0 / 6);
  const PndfImage exact = image_of(ExactPndf(surface, 0.005), footprint, {});
  for (const InstructionSet set : supported_instruction_sets()) {
    if (set == InstructionSet::scalar) continue;  // ten times slower, the same code
    force_instruction_set(set);
    const PndfErrors errors = compare(image_of(FastExactPndf(surface, 0.005), footprint, {}), exact);
    EXPECT_LE(errors.relative_l1, 1e-5) << instruction_set_name(set);
    EXPECT_LE(errors.peak_error, 1e-5) << instruction_set_name(set);
  }
}

TEST(FastExactImage, IsTheSameBytesForAnyNumberOfThreads) {
  const Surface surface(test::rough_map(90, 90, Wrap::repeat, 0.05), Interpolation::linear);
  const PndfGrid grid{-0.2, 0.2, -0.2, 0.2, 100, 80};
  for (const double radius : {2.0, 8.0}) {  // one group of cells, and several
    std::vector<std::vector<double>> images;
    for (const int threads : {1, 2, 1}) {
      const ThreadLimit limit(threads);
      images.push_back(image_of(FastExactPndf(surface, 0.01), isotropic_footprint({4.2, 15.8}, radius), grid).density);
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
  }
}

TEST(FastExactImage, IsNothingOnceCancelled) {
  const FastExactPndf model(Surface(test::rough_map(64, 64, Wrap::repeat), Interpolation::smooth), 0.01);
  const PndfGrid grid{-0.5, 0.5, -0.5, 0.5, 2000, 2000};
  const Footprint footprint = isotropic_footprint({3, 4}, 9);
  test::expect_no_image_once_cancelled(model, footprint, grid);
}

// Its cells are listed slab by slab.
TEST(FastExactImage, OfMoreThanAMillionCellsKeepsItsMassForAnyNumberOfThreads) {
  const Surface surface(test::rough_map(1400, 1400, Wrap::clamp, 0.1), Interpolation::linear);
  const FastExactPndf model(surface, 0.1);
  std::vector<std::vector<double>> images;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const PndfImage image = image_of(model, isotropic_footprint({700, 700}, 130), {-1, 1, -1, 1, 24, 24});
    EXPECT_NEAR(integral(image), 1, k_stated);
    images.push_back(image.density);
  }
  EXPECT_EQ(images[0], images[1]);
}

TEST(FastExactPndf, FoldsWideFootprintsInDoublePrecision) {
  const Surface surface(test::wavy_map(50, 52, Wrap::repeat), Interpolation::linear);
  const Footprint footprint{{13.7, 11.2}, {2100, 450, 1800}};
  ASSERT_TRUE(FoldedFootprint::pays(surface.map(), footprint.covariance, FastExactPndf::k_image_cut));
  expect_close_to_double(surface, 0.03, footprint, {-0.4, 0.4, -0.4, 0.4, 40, 40}, "folded");
}

TEST(InstructionSets, CanBeForcedByNameAndGivenBack) {
  const test::InstructionSetGuard guard;
  const std::vector<InstructionSet> sets = supported_instruction_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front(), InstructionSet::scalar);
  EXPECT_TRUE(std::is_sorted(sets.begin(), sets.end()));
  for (const InstructionSet set : sets) {
    force_instruction_set(set);
    EXPECT_EQ(instruction_set(), set);
    EXPECT_EQ(supported_instruction_sets(), sets) << "forcing one must not lose the others";
  }
  EXPECT_EQ(instruction_set_name(InstructionSet::avx512), "avx512");
}

}  // namespace
}  // namespace glint
