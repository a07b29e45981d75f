#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/gaussian.h"
#include "core/pndf/binned_pndf.h"
#include "core/pndf/exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/model_factory.h"
#include "core/pndf/surface_sampling.h"
#include "tests/core/pndf/cell_means.h"
#include "tests/core/pndf/reference_quadrature.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::image_of;

constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};

BinnedSettings draws(std::uint64_t samples, std::uint64_t seed = 1) {
  return {samples, seed, 64};
}

// Chi-square of an image's counts against cell means, cells of fewer than ten expected hits merged; as a deviate that
// is standard normal for good counts (Wilson and Hilferty).
double chi_square_deviate(const PndfImage& image, const std::vector<double>& means, std::uint64_t samples) {
  const double scale = static_cast<double>(samples) * image.grid.cell_area();
  double chi_square = 0;
  int cells = 0;
  double expected = 0;
  double counted = 0;
  double in_cells = 0;
  const auto close = [&] {
    chi_square += (counted - expected) * (counted - expected) / expected;
    in_cells += expected;
    ++cells;
    expected = counted = 0;
  };
  for (std::size_t k = 0; k < means.size(); ++k) {
    expected += means[k] * scale;
    counted += image.density[k] * scale;
    if (expected >= 10) close();
  }
  // What is left over, with all that fell outside the grid.
  const double outside = static_cast<double>(samples) - in_cells;
  counted += static_cast<double>(image.outside_samples);
  expected = outside;
  if (outside >= 10) close();
  const double degrees = cells - 1;
  return (std::cbrt(chi_square / degrees) - (1 - 2 / (9 * degrees))) / std::sqrt(2 / (9 * degrees));
}

TEST(BinnedPndf, CountsPassAChiSquareTestAgainstTheExactCellMeans) {
  constexpr std::uint64_t samples = 400'000;
  const PndfGrid grid{-0.35, 0.4, -0.4, 0.3, 40, 32};
  for (const Interpolation interpolation : k_surfaces) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
      const Surface surface(test::rough_map(16, 16, wrap), interpolation);
      const Footprint footprint{{14.2, 1.8}, {4, 1, 2}};
      const std::vector<double> means = test::cell_means(ExactPndf(surface, 0.03, {8, true}), footprint, grid);
      const PndfImage image = image_of(BinnedPndf(surface, 0.03, draws(samples, 3)), footprint, grid);
      // p > 0.001 on either side: too good a fit is as wrong.
      EXPECT_LT(std::abs(chi_square_deviate(image, means, samples)), 3.1) << static_cast<int>(interpolation);
    }
  }
}

TEST(BinnedPndf, ChiSquareTestWouldSeeOnePercentOfRoughness) {
  constexpr std::uint64_t samples = 400'000;
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const Footprint footprint{{14.2, 1.8}, {0.01, 0, 0.01}};
  const PndfGrid grid{-0.35, 0.4, -0.4, 0.3, 40, 32};
  const std::vector<double> means = test::cell_means(ExactPndf(surface, 0.0303), footprint, grid);
  const PndfImage image = image_of(BinnedPndf(surface, 0.03, draws(samples, 3)), footprint, grid);
  EXPECT_GT(chi_square_deviate(image, means, samples), 3.1);
}

TEST(BinnedPndf, ErrorFallsAsOneOverTheRootOfTheDrawsAndIsTheOwnNoiseItStates) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const Footprint footprint{{14.2, 1.8}, {4, 1, 2}};
  const PndfGrid grid{-0.4, 0.4, -0.4, 0.4, 64, 64};
  const std::vector<double> means = test::cell_means(ExactPndf(surface, 0.02), footprint, grid);
  std::vector<double> errors;
  for (const std::uint64_t samples : {250'000U, 1'000'000U, 4'000'000U}) {
    const PndfImage image = image_of(BinnedPndf(surface, 0.02, draws(samples)), footprint, grid);
    errors.push_back(test::relative_l1(image.density, means));
    ASSERT_TRUE(image.error.estimated);
    EXPECT_NEAR(errors.back() / *image.error.estimated, 1, 0.1) << samples;
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.15);
  EXPECT_NEAR(errors[1] / errors[2], 2, 0.15);
}

TEST(BinnedPndf, StandardErrorOfACellIsThatOfItsCount) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const PndfGrid grid{-0.4, 0.4, -0.4, 0.4, 16, 16};
  const PndfImage image = image_of(BinnedPndf(surface, 0.02, draws(10'000)), isotropic_footprint({3, 4}, 2), grid);
  const double one_hit = 1 / (10'000 * grid.cell_area());
  ASSERT_EQ(image.standard_error.size(), image.density.size());
  for (std::size_t k = 0; k < image.density.size(); ++k) {
    const double hits = image.density[k] / one_hit;
    EXPECT_NEAR(hits, std::round(hits), 1e-9);
    EXPECT_NEAR(image.standard_error[k], std::sqrt(std::max(1.0, hits)) * one_hit, 1e-9 * one_hit);
  }
}

TEST(BinnedPndf, CountsInvalidNormalsAndThoseOutsideTheWindow) {
  // The lobe stands on the rim of the disk, far enough out for the rim to be straight: half of it is invalid but for
  // the rim's curvature, sigma / (2 sqrt(2 pi)) of a lobe of that deviation.
  constexpr std::uint64_t samples = 200'000;
  constexpr double roughness = 0.05;
  const Surface surface(test::constant_map({1, 0}), Interpolation::linear);
  const PndfGrid window{0, 2, -1, 1, 100, 100};
  const PndfImage image =
      image_of(BinnedPndf(surface, roughness, draws(samples)), isotropic_footprint({3, 4}, 2), window);
  const double expected = 0.5 + roughness / (2 * std::sqrt(2 * std::numbers::pi));
  EXPECT_NEAR(static_cast<double>(image.invalid_samples) / samples, expected, 5 * std::sqrt(0.25 / samples));
  EXPECT_EQ(image.outside_samples, 0U);
  // A window that ends one deviation off on one side.
  const PndfImage cut = image_of(BinnedPndf(surface, roughness, draws(samples)), isotropic_footprint({3, 4}, 2),
                                 {0.5, 1 - roughness, -1, 1, 100, 100});
  const double inside = normal_cdf(-1);
  EXPECT_NEAR(static_cast<double>(cut.outside_samples) / samples, 1 - inside, 5 * std::sqrt(0.14 / samples));
  EXPECT_EQ(cut.invalid_samples, image.invalid_samples);
  EXPECT_NEAR(integral(cut), 1 - static_cast<double>(cut.outside_samples) / samples, 1e-12);
}

TEST(BinnedPndf, SamplesWhatItEvaluates) {
  const BinnedPndf model(Surface(test::wavy_map(16, 16, Wrap::repeat), Interpolation::smooth), 0.02, {20'000, 3, 8});
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(isotropic_footprint({3, 4}, 2), workspace);
  RandomStream random(5, 0);
  // The mean of 1 / pdf over samples is the area of the bins that are not empty; no sample has density 0.
  const PndfGrid window = fitted_window(model.surface(), isotropic_footprint({3, 4}, 2), 0.02, 8);
  double area = 0;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column)
      area += pndf.pdf(window.center(column, row)) > 0 ? window.cell_area() : 0;
  }
  constexpr int draws = 40'000;
  double mean = 0;
  double squares = 0;
  for (int k = 0; k < draws; ++k) {
    const double density = pndf.pdf(pndf.sample(random));
    ASSERT_GT(density, 0);
    mean += 1 / density / draws;
    squares += 1 / (density * density) / draws;
  }
  EXPECT_NEAR(mean, area, 5 * std::sqrt((squares - mean * mean) / draws));
}

TEST(BinnedPndf, IsTheSameBytesForAnyNumberOfThreadsAndOthersForOtherSeeds) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({3, 4}, 2);
  const PndfGrid grid{-0.4, 0.4, -0.4, 0.4, 32, 32};
  const auto density = [&](int threads, std::uint64_t seed) {
    const ThreadLimit limit(threads);
    return image_of(BinnedPndf(surface, 0.02, draws(150'000, seed)), footprint, grid).density;
  };
  const std::vector<double> one = density(1, 1);
  EXPECT_EQ(one, density(2, 1));
  EXPECT_NE(one, density(1, 2));
}

TEST(BinnedPndf, IsNothingOnceCancelled) {
  const BinnedPndf model(Surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::smooth), 0.02,
                         draws(1'000'000'000'000));
  JobControl control;
  std::thread other([&] {
    while (control.progress() == 0) std::this_thread::yield();
    control.cancel();
  });
  EXPECT_FALSE(model.image(isotropic_footprint({3, 4}, 2), {}, control));
  other.join();
}

TEST(BinnedPndf, AnswersWithTheBinOfItsFittedWindow) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::linear);
  const Footprint footprint = isotropic_footprint({3, 4}, 2);
  const BinnedPndf model(surface, 0.02, draws(100'000));
  const PndfGrid grid = fitted_window(surface, footprint, 0.02, 64);
  const PndfImage image = image_of(model, footprint, grid);
  for (const int k : {0, 700, 2000, 3333}) {
    const int column = k % 64;
    const int row = k / 64;
    const glm::dvec2 s = grid.center(column, row) + 0.3 * grid.pitch();
    EXPECT_EQ(test::density_of(model, footprint, s), image.density[grid.index(column, row)]);
  }
  EXPECT_EQ(test::density_of(model, footprint, {grid.s_max + 1e-6, 0}), 0);
  EXPECT_EQ(test::density_of(model, footprint, {0, grid.t_min - 1e-6}), 0);
  PndfWorkspace workspace;
  EXPECT_EQ(model.at(footprint, workspace).error().estimated, image.error.estimated);
}

TEST(SurfaceSampler, DrawsHaveTheMomentsOfTheNormalsAndTheRoughness) {
  constexpr int samples = 200'000;
  for (const Interpolation interpolation : k_surfaces) {
    const Surface surface(test::rough_map(16, 16, Wrap::repeat), interpolation);
    const Footprint footprint{{14.2, -31.8}, {4, 1, 2}};
    constexpr double roughness = 0.05;
    const test::NormalMoments moments = test::SlowPndf(surface, 8, footprint, glm::dvec2(1)).moments();
    const ExactPndf model(surface, roughness);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(footprint, workspace);
    RandomStream random(21, 0);
    glm::dvec2 sum{0, 0};
    SymmetricMatrix2 squares{0, 0, 0};
    for (int k = 0; k < samples; ++k) {
      const glm::dvec2 d = pndf.sample(random) - moments.mean;
      sum += d;
      squares = {squares.xx + d.x * d.x, squares.xy + d.x * d.y, squares.yy + d.y * d.y};
    }
    const SymmetricMatrix2 lobe{moments.covariance.xx + roughness * roughness, moments.covariance.xy,
                                moments.covariance.yy + roughness * roughness};
    const double of_mean = 5 * std::sqrt(lobe.xx / samples);
    const double of_square = 5 * std::sqrt(2.0 / samples) * std::max(lobe.xx, lobe.yy);
    EXPECT_NEAR(sum.x / samples, 0, of_mean);
    EXPECT_NEAR(sum.y / samples, 0, of_mean);
    EXPECT_NEAR(squares.xx / samples, lobe.xx, of_square) << static_cast<int>(interpolation);
    EXPECT_NEAR(squares.xy / samples, lobe.xy, of_square) << static_cast<int>(interpolation);
    EXPECT_NEAR(squares.yy / samples, lobe.yy, of_square) << static_cast<int>(interpolation);
  }
}

TEST(SurfaceSampler, TurnsItsDeviatesIntoAPositionAndARoughness) {
  const Surface surface(test::rough_map(16, 16, Wrap::repeat), Interpolation::smooth);
  const SurfaceSampler sampler(surface, {{3.2, 4.1}, {4, 2, 5}}, 0.1);
  // L = [[2, 0], [1, 2]].
  const glm::dvec2 expected = surface.normal({3.2 + 2 * 0.5, 4.1 + 0.5 - 2 * 0.25}) + 0.1 * glm::dvec2(1.5, -2);
  const glm::dvec2 drawn = sampler.normal({0.5, -0.25, 1.5, -2});
  EXPECT_NEAR(drawn.x, expected.x, 1e-15);
  EXPECT_NEAR(drawn.y, expected.y, 1e-15);
}

TEST(ModelFactory, MakesTheMethodAskedForOnTheSurfaceAsked) {
  const Surface surface(test::rough_map(8, 8, Wrap::repeat), Interpolation::constant);
  const auto exact = make_model(PndfMethod::exact, surface, 0.1, {});
  const auto binning = make_model(PndfMethod::binning, surface, 0.1, {});
  ASSERT_TRUE(exact && binning);
  EXPECT_EQ(exact->info().name, "exact");
  EXPECT_EQ(binning->info().name, "binning");
  EXPECT_EQ(exact->info().surface, Interpolation::constant);
  EXPECT_EQ(binning->info().surface, Interpolation::constant);
}

}  // namespace
}  // namespace glint
