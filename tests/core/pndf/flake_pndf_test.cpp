// Flakes placed directly against a plain twin in double precision, and against what they come to.

#include "core/pndf/flake_pndf.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/core/pndf/beckmann.h"
#include "tests/core/pndf/chi_square.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

std::vector<Flake> flakes_of(int size, double radius, double alpha = 0.3, std::uint64_t seed = 7) {
  FlakeSettings settings;
  settings.size = size;
  settings.radius = radius;
  settings.alpha = alpha;
  settings.seed = seed;
  JobControl control;
  return place_flakes(settings, control).value();
}

// Every flake in every period that could count, without a cut.
class SlowFlakes {
 public:
  SlowFlakes(const std::vector<Flake>& flakes, glm::dvec2 domain, const Footprint& footprint, double roughness)
      : flakes_(flakes), variance_(roughness * roughness) {
    const double area = domain.x * domain.y / static_cast<double>(flakes.size());
    const double squared = area / (8 * std::numbers::ln2);
    const SymmetricMatrix2& p = footprint.covariance;
    const SymmetricMatrix2 v{p.xx + squared, p.xy, p.yy + squared};
    const auto periods = [](double deviation, double size) { return std::ceil(9 * deviation / size) + 2; };
    const glm::dvec2 most{periods(std::sqrt(v.xx), domain.x), periods(std::sqrt(v.yy), domain.y)};
    for (const Flake& flake : flakes) {
      glm::dvec2 o = flake.center - footprint.center;
      o -= domain * glm::round(o / domain);
      double weight = 0;
      for (double l = -most.y; l <= most.y; ++l) {
        for (double k = -most.x; k <= most.x; ++k) weight += area * normal_density(o + glm::dvec2(k, l) * domain, v);
      }
      weights_.push_back(weight);
      sum_ += weight;
    }
  }

  [[nodiscard]] double sum() const { return sum_; }
  [[nodiscard]] double density(glm::dvec2 s) const {
    double density = 0;
    for (std::size_t k = 0; k < flakes_.size(); ++k) {
      density += weights_[k] * normal_density(s - flakes_[k].normal, {variance_, 0, variance_});
    }
    return density / sum_;
  }

 private:
  const std::vector<Flake>& flakes_;
  double variance_;
  std::vector<double> weights_;
  double sum_ = 0;
};

struct Case {
  std::string what;
  std::vector<Flake> flakes;
  glm::dvec2 domain;
  Footprint footprint;
  double roughness;
};

std::vector<Case> cases() {
  const std::vector<Flake> paint = flakes_of(96, 5);
  const glm::dvec2 square{96, 96};
  // A strip: the lower half of the same flakes is left out.
  std::vector<Flake> strip;
  std::copy_if(paint.begin(), paint.end(), std::back_inserter(strip), [](const Flake& f) { return f.center.y < 30; });
  const std::vector<Flake> few{{{3, 4}, {0.1, 0.2}}, {{5, 2}, {-0.3, 0.1}}, {{4, 97}, {0.12, 0.18}}};
  return {{"inside", paint, square, isotropic_footprint({40.3, 51.1}, 6), 0.02},
          {"across the corner", paint, square, isotropic_footprint({95.9, 0.2}, 5), 0.02},
          {"many periods away", paint, square, isotropic_footprint({96 * 90 + 3.3, -96 * 70}, 4), 0.02},
          {"turned", paint, square, test::turned_footprint({20, 11}, 15, 1, 0.7), 0.02},
          {"a needle over many periods", paint, square, test::turned_footprint({20, 11}, 400, 0.01, 0.7), 0.02},
          {"tiny", paint, square, isotropic_footprint({40.3, 51.1}, 0.001), 0.02},
          {"nearly as wide as the domain", paint, square, isotropic_footprint({10, 80}, 25), 0.05},
          {"as wide as the domain", paint, square, test::turned_footprint({10, 80}, 110, 40, 1), 0.05},
          {"much wider than the domain", paint, square, isotropic_footprint({10, 80}, 700), 0.05},
          {"long and narrow", paint, square, test::turned_footprint({10, 80}, 500, 12, 0.02), 0.05},
          {"along an axis, far longer than the domain", paint, square, test::turned_footprint({10, 80}, 2000, 1.5, 0),
           0.05},
          {"a strip", strip, {96, 30}, isotropic_footprint({50, 29}, 11), 0.02},
          {"one flake", {{{1, 1}, {0.2, 0.1}}}, {7, 9}, isotropic_footprint({5, 5}, 1), 0.02},
          {"far from few", few, {300, 200}, isotropic_footprint({160, 110}, 1), 0.02},
          {"centres beyond the domain",
           {{{-3, 12}, {0.1, 0}}, {{14, 3}, {0, 0.2}}},
           {9, 9},
           isotropic_footprint({0, 0}, 1),
           0.02},
          {"hardly rough", paint, square, isotropic_footprint({40.3, 51.1}, 6), 1e-8}};
}

// Normals drawn, and some beside them.
std::vector<glm::dvec2> normals_for(const FootprintPndf& pndf, double roughness, int count) {
  RandomStream random(5, 7);
  std::vector<glm::dvec2> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(pndf.sample(random));
    if (k % 3 == 1) all.back().x += 3 * roughness;
  }
  return all;
}

TEST(FlakePndf, AreTheirTwin) {
  for (const Case& c : cases()) {
    const FlakePndf model(c.flakes, c.domain, c.roughness);
    const SlowFlakes twin(c.flakes, c.domain, c.footprint, c.roughness);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(c.footprint, workspace);
    const double peak = 1 / (2 * std::numbers::pi * c.roughness * c.roughness);
    for (const glm::dvec2 s : normals_for(pndf, c.roughness, 60)) {
      double value = 0;
      pndf.evaluate({&s, 1}, {&value, 1});
      const double expected = twin.density(s);
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << c.what;
      // Of each flake the cut leaves out at most exp(-12.5) = 4e-6 of its own peak.
      ASSERT_NEAR(value / peak, expected / peak, 8e-6 + 2e-4 * expected / peak) << c.what;
      ASSERT_EQ(value, pndf.pdf(s));
    }
  }
}

TEST(FlakePndf, AreZeroWhereNoneIsNear) {
  const Case c = cases()[0];
  const FlakePndf model(c.flakes, c.domain, c.roughness);
  for (const glm::dvec2 s : {glm::dvec2(30, 0), glm::dvec2(-1e9, 1e9), glm::dvec2(0, -1e300)}) {
    EXPECT_EQ(test::density_of(model, c.footprint, s), 0);
  }
}

PndfGrid window_around(const Case& c, int cells) {
  glm::dvec2 lo(std::numeric_limits<double>::infinity());
  glm::dvec2 hi = -lo;
  for (const Flake& flake : c.flakes) {
    lo = {std::min(lo.x, flake.normal.x), std::min(lo.y, flake.normal.y)};
    hi = {std::max(hi.x, flake.normal.x), std::max(hi.y, flake.normal.y)};
  }
  const double margin = 5.1 * c.roughness;
  return {lo.x - margin, hi.x + margin, lo.y - margin, hi.y + margin, cells, cells};
}

PndfImage pointwise(const FootprintPndf& pndf, const PndfGrid& grid) {
  PndfImage image;
  image.grid = grid;
  image.density.resize(grid.cells());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      image.density[grid.index(column, row)] = pndf.pdf(grid.center(column, row));
    }
  }
  return image;
}

TEST(FlakePndf, HaveUnitEnergyUnderEveryFootprint) {
  for (const Case& c : cases()) {
    if (c.roughness < 1e-6) continue;  // no grid is as fine
    const FlakePndf model(c.flakes, c.domain, c.roughness);
    PndfWorkspace workspace;
    EXPECT_NEAR(integral(pointwise(model.at(c.footprint, workspace), window_around(c, 320))), 1, 2e-5) << c.what;
  }
}

TEST(FlakePndf, LeaveAGapOfWeightsThatRenormalisingMends) {
  const std::vector<Flake> flakes = flakes_of(96, 5);
  // Where the nearest flake is farthest.
  glm::dvec2 gap{0, 0};
  double widest = 0;
  for (int j = 0; j < 192; ++j) {
    for (int i = 0; i < 192; ++i) {
      const glm::dvec2 place = 0.5 * glm::dvec2(i, j);
      double nearest = 96;
      for (const Flake& flake : flakes) {
        const glm::dvec2 o = place - flake.center;
        nearest = std::min(nearest, glm::length(o - 96.0 * glm::round(o / 96.0)));
      }
      if (nearest > widest) gap = place;
      widest = std::max(widest, nearest);
    }
  }
  ASSERT_GT(widest, 4);
  const Case c{"a gap", flakes, {96, 96}, isotropic_footprint(gap, 0.01), 0.02};
  EXPECT_LT(SlowFlakes(c.flakes, c.domain, c.footprint, c.roughness).sum(), 0.85);
  const FlakePndf model(c.flakes, c.domain, c.roughness);
  PndfWorkspace workspace;
  EXPECT_NEAR(integral(pointwise(model.at(c.footprint, workspace), window_around(c, 320))), 1, 1e-5);
  EXPECT_NEAR(integral(test::image_of(model, c.footprint, window_around(c, 100))), 1, 2e-3);
}

TEST(FlakePndf, PictureIsThatOfTheirSingleNormals) {
  for (const Case& c : cases()) {
    const FlakePndf model(c.flakes, c.domain, c.roughness);
    const double pitch = 0.8 * c.roughness;
    PndfGrid grid = window_around(c, 61);
    if (c.roughness < 1e-6) {  // about the nearest flake
      const auto nearer = [&](const Flake& a, const Flake& b) {
        return glm::distance(a.center, c.footprint.center) < glm::distance(b.center, c.footprint.center);
      };
      const glm::dvec2 n = std::min_element(c.flakes.begin(), c.flakes.end(), nearer)->normal;
      grid = {n.x - 20 * pitch, n.x + 20 * pitch, n.y - 20 * pitch, n.y + 20 * pitch, 40, 40};
    }
    const PndfImage image = test::image_of(model, c.footprint, grid);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(c.footprint, workspace);
    const PndfImage expected = pointwise(pndf, grid);
    ASSERT_EQ(image.widening, glm::dvec2(0)) << "else they cannot be compared";
    EXPECT_GT(integral(image), 0.01) << c.what;
    EXPECT_LE(test::relative_l1(image.density, expected.density), 4e-3) << c.what;
    EXPECT_TRUE(image.error.total() && *image.error.total() <= 4e-3);
  }
}

TEST(FlakePndf, PictureOfCoarseCellsIsWidened) {
  const Case c = cases()[0];
  const FlakePndf model(c.flakes, c.domain, c.roughness);
  const PndfGrid grid{-1, 1, -1, 1, 20, 30};
  const PndfImage image = test::image_of(model, c.footprint, grid);
  EXPECT_EQ(image.widening, mean_widening(grid));
  EXPECT_NEAR(integral(image), 1, 0.05);  // 0.29 cells wide, flakes still ripple with the grid
}

TEST(FlakePndf, PictureIsTheSameBytesForAnyNumberOfThreads) {
  const FlakePndf model(flakes_of(512, 3), {512, 512}, 0.01);
  for (const double sigma : {60.0, 5000.0}) {
    std::vector<std::vector<double>> made;
    for (const int threads : {1, 2, 3}) {
      const ThreadLimit limit(threads);
      made.push_back(test::image_of(model, isotropic_footprint({100, 100}, sigma), PndfGrid{}).density);
    }
    EXPECT_EQ(made[0], made[1]);
    EXPECT_EQ(made[0], made[2]);
  }
}

TEST(FlakePndf, PictureIsTheSameInEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  const FlakePndf model(flakes_of(96, 5), {96, 96}, 0.03);
  std::vector<std::vector<double>> made;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    made.push_back(test::image_of(model, isotropic_footprint({30, 40}, 8), PndfGrid{}).density);
    EXPECT_LE(test::relative_l1(made.back(), made.front()), 1.5e-3) << instruction_set_name(set);
  }
}

TEST(FlakePndf, PictureIsNothingOnceCancelled) {
  JobControl control;
  control.cancel();
  for (const double roughness : {0.02, 1e-8}) {
    const FlakePndf model(flakes_of(96, 5), {96, 96}, roughness);
    PndfGrid grid;
    if (roughness < 1e-6) grid = {0, 1e-7, 0, 1e-7, 16, 16};
    EXPECT_FALSE(model.image(isotropic_footprint({30, 40}, 8), grid, control).has_value());
  }
}

TEST(FlakePndf, UnderAHugeFootprintAreBeckmannsDistributionConvolvedWithTheRoughness) {
  const FlakePndf model(flakes_of(512, 3), {512, 512}, 0.1);
  const PndfGrid grid{-1, 1, -1, 1, 40, 40};
  const PndfImage image = test::image_of(model, isotropic_footprint({20, 300}, 3000), grid);
  EXPECT_LE(test::relative_l1(image.density, test::beckmann_image(grid, 0.3, 0.1)), 0.03);
  // Without the widening of coarse cells, and as the mean over all flakes exactly.
  const std::vector<Flake> few = flakes_of(96, 5);
  const FlakePndf small(few, {96, 96}, 0.02);
  for (const glm::dvec2 s : {glm::dvec2(0, 0), glm::dvec2(0.1, -0.2)}) {
    double mean = 0;
    for (const Flake& flake : few) mean += normal_density(s - flake.normal, {4e-4, 0, 4e-4});
    mean /= static_cast<double>(few.size());
    EXPECT_NEAR(test::density_of(small, isotropic_footprint({1, 2}, 1e5), s) / mean, 1, 1e-4);
  }
}

TEST(FlakePndf, SeeNoStepWhereTheirPeriodsBeginToBeAddedUpInFrequencies) {
  const std::vector<Flake> flakes = flakes_of(96, 5);
  const FlakePndf model(flakes, {96, 96}, 0.05);
  for (const double sigma : {20.0, 40.0, 47.0, 50.0, 53.0, 60.0, 100.0, 125.0, 130.0, 140.0}) {
    const Footprint footprint = isotropic_footprint({10, 80}, sigma);
    const SlowFlakes twin(flakes, {96, 96}, footprint, 0.05);
    for (const glm::dvec2 s : {glm::dvec2(0.05, 0), glm::dvec2(-0.1, 0.2)}) {
      EXPECT_NEAR(test::density_of(model, footprint, s) / twin.density(s), 1, 3e-4) << sigma;
    }
  }
}

TEST(FlakePndf, AreDrawnWithTheirDensity) {
  for (const Case& c : cases()) {
    if (c.roughness < 1e-6) continue;
    const FlakePndf model(c.flakes, c.domain, c.roughness);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(c.footprint, workspace);
    const PndfGrid grid = window_around(c, test::k_chi_square_cells);
    const PndfImage fine = pointwise(pndf, test::finer(grid));
    EXPECT_LE(test::chi_square_deviate(pndf, grid, fine), 3.5) << c.what;
  }
}

TEST(FlakePndf, AnswerAlikeOnEveryThreadAtOnce) {
  const FlakePndf model(flakes_of(96, 5), {96, 96}, 0.02);
  std::vector<double> densities(64);
  JobControl control;
  ASSERT_TRUE(parallel_blocks(densities.size(), control, [&](std::size_t block) {
    const double sigma = block % 2 == 0 ? 900 : 6;  // the first prepares what all footprints that wide share
    densities[block] = test::density_of(model, isotropic_footprint({3, 4}, sigma), {0.05, 0.02});
  }));
  for (std::size_t k = 2; k < densities.size(); ++k) EXPECT_EQ(densities[k], densities[k - 2]);
}

TEST(FlakePndf, SayWhatTheyAre) {
  const FlakePndf model(flakes_of(96, 5), {96, 96}, 0.02);
  const PndfModelInfo info = model.info();
  EXPECT_EQ(info.name, "flakes");
  EXPECT_EQ(info.surface, Interpolation::constant);
  EXPECT_NE(info.guarantee.find("energy 1"), std::string::npos);
  EXPECT_GT(info.bytes, 0U);
  const double count = static_cast<double>(flakes_of(96, 5).size());
  EXPECT_NEAR(model.deviation(), std::sqrt(96.0 * 96.0 / count / (8 * std::numbers::ln2)), 1e-12);
}

}  // namespace
}  // namespace glint
