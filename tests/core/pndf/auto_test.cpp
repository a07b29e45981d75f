// Auto: who answers, whether its error is what it says, and that it counts.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/image/normal_map_reader.h"
#include "core/pndf/auto_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/study/error_metrics.h"
#include "core/surface/noise.h"
#include "core/surface/scratches.h"
#include "tests/core/pndf/test_maps.h"
#include "tests/test_data.h"

namespace glint {
namespace {

Surface smooth(test::MapPointer map) {
  return {std::move(map), Interpolation::smooth};
}

// Against the exact image with shifted vertices, which is some 1e-3 off at most.
double measured_error(const AutoPndf& model, const Surface& surface, double roughness, const Footprint& footprint) {
  const PndfGrid grid = fitted_window(surface, footprint, roughness, 64);
  ExactSettings fine;
  fine.vertex_shift = surface.interpolation() == Interpolation::smooth;
  const PndfImage reference = test::image_of(FastExactPndf(surface, roughness, fine), footprint, grid);
  return compare(test::image_of(model, footprint, grid), reference).relative_l1;
}

Footprint random_footprint(RandomStream& random, const NormalMap& map, double least, double most) {
  const double narrow = least * std::pow(most / least, random.next_uniform());
  const double wide = std::min(most, narrow * (1 + 2 * random.next_uniform()));
  const glm::dvec2 center{map.width() * random.next_uniform(), map.height() * random.next_uniform()};
  return test::turned_footprint(center, wide, narrow, 3.1 * random.next_uniform());
}

TEST(Auto, TakesLeanWhereOneGaussianDoes) {
  const Surface flat = smooth(test::constant_map({0, 0}));
  const AutoChoice choice = AutoPndf(flat, 0.01).choose(isotropic_footprint({3, 3}, 2));
  EXPECT_EQ(choice.answer, AutoChoice::Answer::lean);
  EXPECT_TRUE(choice.known);
  EXPECT_EQ(choice.text(), "LEAN");
}

TEST(Auto, TakesFinerMethodsForSmallerTolerances) {
  const Surface surface = smooth(test::wavy_map(32, 32, Wrap::repeat));
  const auto rank = [&](double tolerance) {
    const AutoChoice choice = AutoPndf(surface, 0.01, {tolerance}).choose(isotropic_footprint({11.3, 17.8}, 3));
    return choice.answer == AutoChoice::Answer::lean ? 10.0 : choice.step;  // 0 for exact
  };
  EXPECT_GE(rank(0.3), rank(0.03));
  EXPECT_GE(rank(0.03), rank(0.003));
  EXPECT_GT(rank(0.3), rank(1e-4));
}

TEST(Auto, SaysSoWhereNothingMeetsTheTolerance) {
  // Nothing is rougher, nor the roughness smaller against it: triangles of an eighth of a texel do not do.
  const Surface surface = smooth(test::rough_map(32, 32, Wrap::repeat, 0.5));
  const AutoPndf model(surface, 5e-4, {1e-3});
  const Footprint footprint = isotropic_footprint({11.3, 17.8}, 1);
  const AutoChoice choice = model.choose(footprint);
  EXPECT_EQ(choice.answer, AutoChoice::Answer::exact);
  EXPECT_FALSE(choice.known);
  EXPECT_GT(choice.estimated, 1e-3);
  const PndfImage image = test::image_of(model, footprint, {-1, 1, -1, 1, 32, 32});
  EXPECT_FALSE(image.answer.known);
  EXPECT_EQ(image.answer.text, "exact");
  EXPECT_EQ(model.statistics().exact, 1U);
  EXPECT_EQ(model.statistics().unknown, 1U);
}

TEST(Auto, CountsWhoAnswers) {
  const Surface surface = smooth(test::wavy_map(32, 32, Wrap::repeat));
  const AutoPndf model(surface, 0.02);
  const Footprint footprint = isotropic_footprint({11.3, 17.8}, 3);
  const AutoChoice choice = model.choose(footprint);
  ASSERT_EQ(choice.answer, AutoChoice::Answer::mixture);
  PndfWorkspace workspace;
  EXPECT_EQ(model.at(footprint, workspace).error().estimated, choice.estimated);
  const PndfImage image = test::image_of(model, footprint, fitted_window(surface, footprint, 0.02, 32));
  EXPECT_EQ(image.answer.text, choice.text());
  EXPECT_EQ(image.answer.step, choice.step);
  EXPECT_EQ(image.error.estimated, choice.estimated);
  const AutoPndf::Statistics counts = model.statistics();
  EXPECT_EQ(counts.lean + counts.exact + counts.unknown, 0U);
  std::size_t mixtures = 0;
  for (const std::size_t count : counts.mixture) mixtures += count;
  EXPECT_EQ(mixtures, 2U);
}

TEST(Auto, AnswersAsTheMethodThatItChose) {
  const Surface surface = smooth(test::wavy_map(32, 32, Wrap::repeat));
  const Footprint footprint = isotropic_footprint({11.3, 17.8}, 3);
  const AutoPndf model(surface, 0.02);
  const AutoChoice choice = model.choose(footprint);
  ASSERT_EQ(choice.answer, AutoChoice::Answer::mixture);
  const MixturePndf chosen(surface, 0.02, mixture_of_step(choice.step));
  PndfWorkspace ours;
  PndfWorkspace its;
  const FootprintPndf& a = model.at(footprint, ours);
  const FootprintPndf& b = chosen.at(footprint, its);
  RandomStream of_a(5, 0);
  RandomStream of_b(5, 0);
  for (int k = 0; k < 50; ++k) {
    const glm::dvec2 s = a.sample(of_a);
    EXPECT_EQ(s, b.sample(of_b));
    EXPECT_EQ(a.pdf(s), b.pdf(s));
  }
  const PndfGrid grid = fitted_window(surface, footprint, 0.02, 32);
  EXPECT_EQ(test::image_of(model, footprint, grid).density, test::image_of(chosen, footprint, grid).density);
}

TEST(Auto, SaysThatItsToleranceIsNotMetByWhatItBoundsEither) {
  // A mixture's images are cut by more than this.
  const Surface surface = smooth(test::wavy_map(32, 32, Wrap::repeat));
  const AutoPndf model(surface, 0.05, {1e-3});
  const Footprint footprint = isotropic_footprint({11.3, 17.8}, 3);
  const PndfImage image = test::image_of(model, footprint, fitted_window(surface, footprint, 0.05, 64));
  EXPECT_EQ(image.answer.text, "exact");
  EXPECT_EQ(image.answer.known, *image.error.total() <= 1e-3);
}

TEST(Auto, ValuesDoNotDependOnThreads) {
  const Surface surface = smooth(test::wavy_map(32, 32, Wrap::repeat));
  const Footprint footprint = isotropic_footprint({11.3, 17.8}, 4);
  const auto values = [&] {
    const AutoPndf model(surface, 0.02);
    std::vector<glm::dvec2> s;
    RandomStream random(4, 0);
    for (int k = 0; k < 400; ++k) s.push_back(0.3 * glm::dvec2(random.next_uniform(), random.next_uniform()));
    std::vector<double> density(s.size());
    JobControl control;
    EXPECT_TRUE(evaluate_all(model, footprint, s, density, control));
    return density;
  };
  const std::vector<double> two = values();
  const ThreadLimit one(1);
  EXPECT_EQ(values(), two);
}

TEST(Auto, LooksWideFootprintsUpWhereTheAtlasIsOfItsStep) {
  const Surface surface = smooth(test::wavy_map(64, 64, Wrap::repeat));
  const Footprint footprint = isotropic_footprint({11, 40}, 20);
  const PndfGrid grid = fitted_window(surface, footprint, 0.05, 48);
  const AutoChoice choice = AutoPndf(surface, 0.05, {0.03}).choose(footprint);
  ASSERT_EQ(choice.answer, AutoChoice::Answer::mixture);
  const auto atlas = std::make_shared<MixtureAtlas>(surface, 0.05, mixture_of_step(choice.step), grid);
  JobControl control;
  ASSERT_TRUE(atlas->build(footprint, control));
  const PndfImage image = test::image_of(AutoPndf(surface, 0.05, {0.03}, atlas), footprint, grid);
  EXPECT_EQ(image.answer.text, choice.text() + ", atlas");
  EXPECT_EQ(image.error.bounded, atlas->image(footprint)->error.bounded);
  EXPECT_EQ(image.error.estimated, choice.estimated);
}

// --- what it says against what is measured, on footprints of sigma 1 to 30 texels

void expect_within_tolerance(const Surface& surface, double roughness, const std::string& name) {
  constexpr double k_tolerance = 0.01;
  const AutoPndf model(surface, roughness, {k_tolerance});
  RandomStream random(21, 0);
  int unknown = 0;
  for (int k = 0; k < 10; ++k) {
    const Footprint footprint = random_footprint(random, surface.map(), 1, 30);
    const AutoChoice choice = model.choose(footprint);
    if (!choice.known) {
      ++unknown;
      continue;
    }
    EXPECT_LE(choice.estimated, k_tolerance) << name;
    const double error = measured_error(model, surface, roughness, footprint);
    EXPECT_LE(error, k_tolerance) << name << ", footprint " << k << ", " << choice.text() << ", estimated "
                                  << choice.estimated;
  }
  EXPECT_LE(unknown, 1) << name;
}

TEST(Auto, MeetsItsToleranceOnGeneratedMaps) {
  JobControl control;
  NoiseSettings noise;
  noise.size = 256;
  const Surface isotropic = smooth(std::make_shared<const NormalMap>(*generate_noise(noise, control)));
  expect_within_tolerance(isotropic, 0.01, "noise");
  ScratchSettings scratches;
  scratches.size = 256;
  scratches.count = 50;
  const Surface scratched = smooth(std::make_shared<const NormalMap>(*generate_scratches(scratches, control)));
  expect_within_tolerance(scratched, 0.02, "scratches");
}

TEST(Auto, MeetsItsToleranceOnRealMaps) {
  GLINT_NEEDS_DATA();
  for (const char* const name :
       {"dielectric_wavy_f16_512.exr", "gaussian_beckmann_f32_512.exr", "leather_fine_512.png"}) {
    JobControl control;
    const Result<ReadNormalMap> read = read_normal_map(test::data_directory() / "normals" / name, {}, control);
    ASSERT_TRUE(read) << read.error().message();
    expect_within_tolerance(smooth(std::make_shared<const NormalMap>(read->map)), 0.02, name);
  }
}

}  // namespace
}  // namespace glint
