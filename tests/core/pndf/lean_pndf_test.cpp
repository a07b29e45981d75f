// LEAN: the density over the disk that a Gaussian over slopes is.

#include "core/pndf/lean_pndf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/parallel.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/model_factory.h"
#include "core/pndf/slope_space.h"
#include "core/surface/noise.h"
#include "tests/core/pndf/chi_square.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

Surface wavy(Wrap wrap = Wrap::repeat) {
  return {test::wavy_map(48, 32, wrap), Interpolation::smooth};
}

// N(m; mean, (xx, xy, yy)) / z^4
double slow_density(glm::dvec2 s, glm::dvec2 mean, double xx, double xy, double yy) {
  const double squared = 1 - s.x * s.x - s.y * s.y;
  const double x = -s.x / std::sqrt(squared) - mean.x;
  const double y = -s.y / std::sqrt(squared) - mean.y;
  const double det = xx * yy - xy * xy;
  return std::exp(-0.5 * (yy * x * x - 2 * xy * x * y + xx * y * y) / det) /
         (2 * std::numbers::pi * std::sqrt(det) * squared * squared);
}

TEST(SlopeSpace, GoesThereAndBack) {
  for (const glm::dvec2 s : {glm::dvec2(0), glm::dvec2(0.3, -0.2), glm::dvec2(-0.7, 0.7)}) {
    const glm::dvec2 m = slope_of_normal(s);
    EXPECT_NEAR(m.x * s.x + m.y * s.y, -std::hypot(m.x, m.y) * std::hypot(s.x, s.y), 1e-14) << "opposite";
    EXPECT_NEAR(std::hypot(m.x, m.y), std::tan(std::asin(std::hypot(s.x, s.y))), 1e-12);
    EXPECT_NEAR(normal_of_slope(m).x, s.x, 1e-14);
    EXPECT_NEAR(normal_of_slope(m).y, s.y, 1e-14);
  }
}

TEST(LeanPndf, OfAConstantMapIsTheGaussianOfItsSlope) {
  const glm::dvec2 normal(glm::vec2(0.3F, -0.5F));
  const glm::dvec2 mean = -normal / std::sqrt(1 - normal.x * normal.x - normal.y * normal.y);
  const double roughness = 0.1;
  const LeanPndf model(Surface(test::constant_map(normal), Interpolation::smooth), roughness);
  for (const double radius : {0.1, 2.0, 50.0}) {
    for (const glm::dvec2 s : {normal, normal + glm::dvec2(0.1, 0.05), glm::dvec2(0.2, -0.6), glm::dvec2(0)}) {
      const double expected = slow_density(s, mean, roughness * roughness, 0, roughness * roughness);
      EXPECT_NEAR(test::density_of(model, isotropic_footprint({3, 3}, radius), s) / expected, 1, 2e-5) << radius;
    }
  }
}

TEST(LeanPndf, HasTheMomentsOfItsSlopesAndTheRoughness) {
  const LeanPndf model(wavy(), 0.02);
  const Footprint footprint = test::turned_footprint({20, 11}, 4, 1, 0.7);
  const SlopeMoments moments = model.moments(footprint);
  const SymmetricMatrix2& c = moments.covariance;
  ASSERT_GT(std::abs(c.xy), 1e-4) << "else the test is blind for it";
  for (const glm::dvec2 s : {glm::dvec2(0.1, 0.2), glm::dvec2(-0.1, 0.3), glm::dvec2(0.2, 0)}) {
    const double expected = slow_density(s, moments.mean, c.xx + 4e-4, c.xy, c.yy + 4e-4);
    EXPECT_NEAR(test::density_of(model, footprint, s) / expected, 1, 1e-10);
  }
}

TEST(LeanPndf, IntegratesToOne) {
  for (const double roughness : {0.02, 0.3, 1.0}) {
    const LeanPndf model(wavy(), roughness);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(isotropic_footprint({20, 11}, 3), workspace);
    // In polar coordinates whose radius sin(a) thins out nothing towards the rim.
    constexpr int k_rings = 2000;
    constexpr int k_angles = 2000;
    double sum = 0;
    for (int ring = 0; ring < k_rings; ++ring) {
      const double a = (ring + 0.5) / k_rings * std::numbers::pi / 2;
      for (int k = 0; k < k_angles; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / k_angles;
        const double r = std::sin(a);
        sum += pndf.pdf({r * std::cos(angle), r * std::sin(angle)}) * r * std::cos(a);
      }
    }
    sum *= std::numbers::pi / 2 / k_rings * 2 * std::numbers::pi / k_angles;
    EXPECT_NEAR(sum, 1, 5e-6) << roughness;
  }
}

TEST(LeanPndf, IsFiniteUpToTheRimAndNothingBeyond) {
  const auto steep = test::map_of(8, 8, Wrap::repeat, [](int i, int) { return glm::dvec2(i % 2 == 0 ? 0.9 : 1.0, 0); });
  for (const double roughness : {1e-9, 0.01, 1.0}) {
    for (const auto& map : {steep, test::wavy_map(48, 32, Wrap::repeat), test::constant_map({0.1, 0.1})}) {
      const LeanPndf model(Surface(map, Interpolation::smooth), roughness);
      for (const double radius : {1e-6, 2.0, 100.0}) {
        PndfWorkspace workspace;
        const FootprintPndf& pndf = model.at(isotropic_footprint({3, 3}, radius), workspace);
        for (const double r : {0.0, 0.9, 1 - 1e-3, 1 - 1e-8, 1 - 1e-15, std::nextafter(1.0, 0.0)}) {
          const double density = pndf.pdf({r, 0});
          EXPECT_TRUE(std::isfinite(density) && density >= 0) << roughness << ' ' << radius << ' ' << r;
        }
        EXPECT_EQ(pndf.pdf({1, 0}), 0);
        EXPECT_EQ(pndf.pdf({-0.8, 0.7}), 0);
        EXPECT_EQ(pndf.pdf({30, 1}), 0);
        RandomStream random(1, 2);
        for (int k = 0; k < 100; ++k) {
          const glm::dvec2 s = pndf.sample(random);
          EXPECT_LE(s.x * s.x + s.y * s.y, 1 + 1e-15);
        }
      }
    }
  }
}

TEST(SlopeGaussian, KeepsASmallRoughnessBesideLargeSlopesOfOneDirection) {
  // C is of rank one, and adding 1e-18 to its elements changes none of their digits.
  const SlopeGaussian gaussian({{0, 0}, {0.25, 0.125, 0.0625}}, {1e-18, 1e-18});
  EXPECT_NEAR(gaussian.density({0, 0}) * 2 * std::numbers::pi * 1e-9 * std::sqrt(0.3125), 1, 1e-9);
  // Half a deviation along the only direction there is.
  EXPECT_NEAR(gaussian.density(normal_of_slope({0.25, 0.125})) *
                  std::pow(squared_height(normal_of_slope({0.25, 0.125})), 2) / gaussian.density({0, 0}),
              std::exp(-0.125), 1e-6);
}

TEST(LeanPndf, DrawsNormalsOfItsDensity) {
  const LeanPndf model(wavy(), 0.05);
  const Footprint footprint = test::turned_footprint({20, 11}, 4, 1, 0.7);
  const PndfGrid grid = fitted_window(wavy(), footprint, 0.05, test::k_chi_square_cells);
  const PndfImage fine = test::image_of(model, footprint, test::finer(grid));
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(footprint, workspace);
  EXPECT_LE(std::abs(test::chi_square_deviate(pndf, grid, fine)), 4);
  // The statistic sees a roughness that is off by a tenth.
  const LeanPndf other(wavy(), 0.055);
  PndfWorkspace others;
  EXPECT_GE(test::chi_square_deviate(other.at(footprint, others), grid, fine), 4);
}

TEST(LeanPndf, PictureIsThatOfItsSingleNormals) {
  const test::InstructionSetGuard guard;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    for (const double roughness : {0.005, 0.1, 1.0}) {  // the first is widened
      const LeanPndf model(wavy(), roughness);
      const Footprint footprint = test::turned_footprint({20, 11}, 4, 1, 0.7);
      // A window that reaches beyond the disk, and one inside it; no multiples of any vector's length.
      for (const PndfGrid& grid : {PndfGrid{-1.1, 1.2, -1.05, 1.1, 203, 181}, PndfGrid{0.05, 0.3, -0.2, 0.2, 61, 45}}) {
        const PndfImage image = test::image_of(model, footprint, grid);
        const glm::dvec2 widening = widening_for(grid, roughness);
        EXPECT_EQ(image.widening, widening);
        const SlopeMoments moments = model.moments(footprint);
        const SlopeGaussian gaussian(moments, roughness * roughness + widening);
        for (int row = 0; row < grid.rows; ++row) {
          for (int column = 0; column < grid.columns; ++column) {
            const glm::dvec2 s = grid.center(column, row);
            const double expected = gaussian.density(s);
            const double density = image.density[grid.index(column, row)];
            if (expected == 0) {
              ASSERT_EQ(density, 0);
              continue;
            }
            const glm::dvec2 w = gaussian.whitening().apply(slope_of_normal(s) - moments.mean);
            const double deviations = std::hypot(w.x, w.y);
            if (deviations < 6.499) {
              ASSERT_NEAR(density / expected, 1, 1e-9) << instruction_set_name(set);
            } else if (deviations > 6.501) {
              ASSERT_EQ(density, 0) << instruction_set_name(set);
            }
          }
        }
      }
    }
  }
}

TEST(LeanPndf, PictureHoldsAllOfALobeInItsWindow) {
  for (const double roughness : {0.0045, 0.01, 0.05}) {  // the first is widened
    const LeanPndf model(wavy(), roughness);
    for (const double radius : {0.1, 3.0, 40.0}) {
      const PndfImage image = test::image_of(model, isotropic_footprint({20, 11}, radius), PndfGrid{});
      EXPECT_NEAR(integral(image), 1, 2e-3) << roughness << ' ' << radius;
    }
  }
}

TEST(LeanPndf, PictureBesideTheLobeIsEmpty) {
  const LeanPndf model(Surface(test::constant_map({0.1, 0.1}), Interpolation::smooth), 0.01);
  for (const PndfGrid& grid : {PndfGrid{0.5, 0.7, -0.1, 0.3, 64, 64}, PndfGrid{-0.1, 0.3, -3, -2, 64, 64}}) {
    const PndfImage image = test::image_of(model, isotropic_footprint({3, 3}, 2), grid);
    ASSERT_EQ(image.density.size(), grid.cells());
    EXPECT_EQ(integral(image), 0);
  }
}

TEST(LeanPndf, IsTheSameBytesForAnyNumberOfThreads) {
  const Surface surface(test::wavy_map(300, 200, Wrap::repeat), Interpolation::smooth);
  std::vector<std::vector<double>> made;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const LeanPndf model(surface, 0.02);  // which builds its chain
    made.push_back(test::image_of(model, isotropic_footprint({100, 100}, 30), {-1, 1, -1, 1, 700, 700}).density);
  }
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
}

TEST(LeanPndf, BuildsItsChainUnderLoopsThatAllAskForIt) {
  const LeanPndf model(Surface(test::wavy_map(512, 512, Wrap::repeat), Interpolation::smooth), 0.02);
  std::vector<double> values(64);
  JobControl control;
  parallel_blocks(values.size(), control, [&](std::size_t k) {
    values[k] = test::density_of(model, isotropic_footprint({100, 100}, 30), {0.05, 0.1});
  });
  for (const double value : values) EXPECT_EQ(value, values[0]);
  EXPECT_GT(values[0], 0);
}

TEST(LeanPndf, IsNothingOnceCancelled) {
  JobControl control;
  control.cancel();
  EXPECT_FALSE(LeanPndf(wavy(), 0.02).image(isotropic_footprint({3, 3}, 2), PndfGrid{}, control).has_value());
}

TEST(LeanPndf, ComesFromTheFactoryAndNamesItsSurface) {
  const auto of = [](Interpolation interpolation) {
    return make_model(PndfMethod::lean, Surface(test::wavy_map(8, 8, Wrap::repeat), interpolation), 0.1, {})->info();
  };
  EXPECT_EQ(of(Interpolation::smooth).name, "lean");
  EXPECT_EQ(of(Interpolation::smooth).surface, Interpolation::smooth);
  EXPECT_EQ(of(Interpolation::linear).surface, Interpolation::smooth);
  EXPECT_EQ(of(Interpolation::constant).surface, Interpolation::constant);
  EXPECT_FALSE(of(Interpolation::smooth).guarantee.empty());
}

TEST(LeanPndf, ComesNearerTheExactOneAsFootprintsGrow) {
  NoiseSettings settings;
  settings.size = 256;
  settings.spectrum = NoiseSettings::Spectrum::gaussian;
  settings.correlation_length = 4;
  settings.rms_slope = 0.1;
  JobControl control;
  const Surface surface(std::make_shared<const NormalMap>(generate_noise(settings, control).value()),
                        Interpolation::smooth);
  const double roughness = 0.03;
  const LeanPndf lean(surface, roughness);
  const FastExactPndf exact(surface, roughness);
  const PndfGrid grid{-0.5, 0.5, -0.5, 0.5, 24, 24};
  std::vector<double> errors;
  for (const double radius : {2.5, 10.0, 30.0}) {
    double sum = 0;
    for (const glm::dvec2 center : {glm::dvec2(50, 70), glm::dvec2(180, 90)}) {
      const Footprint footprint = isotropic_footprint(center, radius);
      sum += 0.5 * test::relative_l1(test::image_of(lean, footprint, grid).density,
                                     test::image_of(exact, footprint, grid).density);
    }
    errors.push_back(sum);
  }
  // About as 1 / radius.
  EXPECT_LE(errors[1], 0.6 * errors[0]) << errors[0];
  EXPECT_LE(errors[2], 0.6 * errors[1]) << errors[1];
  EXPECT_GE(errors[2], 0.01 * errors[0]) << "it is no second exact method";
  RecordProperty("errors",
                 std::to_string(errors[0]) + " " + std::to_string(errors[1]) + " " + std::to_string(errors[2]));
}

}  // namespace
}  // namespace glint
