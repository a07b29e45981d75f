// Single normals of a mixture without preparing their footprint, against the prepared one.

#include "core/pndf/mixture_query.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/mixture_pndf.h"
#include "core/pndf/mixture_sampler.h"
#include "core/pndf/mixture_search.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

constexpr MixtureElements k_kinds[] = {MixtureElements::flat, MixtureElements::curved, MixtureElements::corrected};
constexpr double k_steps[] = {2, 1, 0.5, 1.0 / 3, 0.25};

struct Case {
  std::string what;
  Surface surface;
  Footprint footprint;
  double roughness;
  double least_step = 0.25;
  double most_step = 2;
};

test::MapPointer spiky_map(int size) {
  RandomStream random(4, 4);
  return test::map_of(size, size, Wrap::repeat, [&](int, int) {
    const double xi = random.next_uniform();
    return xi < 0.03 ? glm::dvec2(0.9 - 60 * xi, 0.3) : glm::dvec2(0.002 * xi, -0.1);
  });
}

std::vector<Case> cases() {
  const auto smooth = [](test::MapPointer map) { return Surface(std::move(map), Interpolation::smooth); };
  const auto wavy = test::wavy_map(96, 64, Wrap::repeat);
  const auto clamped = test::wavy_map(96, 64, Wrap::clamp);
  return {
      {"inside", smooth(wavy), isotropic_footprint({40.3, 31.1}, 2), 0.005},
      {"a point", smooth(wavy), isotropic_footprint({40.3, 31.1}, 0.05), 0.005},
      {"a point on a texel", smooth(wavy), isotropic_footprint({40.5, 31.5}, 0.2), 0.02},
      {"a point on a slope", smooth(test::rough_map(64, 64, Wrap::repeat, 0.3)), isotropic_footprint({9.8, 31.3}, 0.3),
       0.001},
      {"across the border", smooth(wavy), isotropic_footprint({95.9, 0.2}, 3), 0.005},
      {"many periods", smooth(test::wavy_map(20, 12, Wrap::repeat)), isotropic_footprint({3, 8}, 11), 0.01},
      {"two texels a side", smooth(test::constant_map({0.1, 0.2}, Wrap::repeat, 2)), isotropic_footprint({0.4, 1.1}, 1),
       0.02},
      {"one texel", smooth(test::constant_map({0.1, 0.2}, Wrap::repeat, 1)), isotropic_footprint({0.4, 1.1}, 0.4), 0.02,
       0.25, 1},
      {"one column", smooth(test::wavy_map(1, 37, Wrap::repeat)), isotropic_footprint({0.4, 36.1}, 2), 0.02, 0.25, 1},
      {"one row", smooth(test::wavy_map(37, 1, Wrap::repeat)), isotropic_footprint({0.4, 0.1}, 2), 0.02, 0.25, 1},
      {"long and turned", smooth(wavy), test::turned_footprint({40, 31}, 30, 0.3, 0.7), 0.01},
      {"long, across", smooth(wavy), test::turned_footprint({40, 31}, 0.2, 12, 0.1), 0.01},
      {"wide", smooth(test::wavy_map(320, 288, Wrap::repeat)), isotropic_footprint({40, 31}, 60), 0.005, 1},
      {"steps of 8 bits", smooth(test::quantised(*test::wavy_map(200, 200, Wrap::repeat, 0.05))),
       isotropic_footprint({77, 50}, 4), 0.002},
      {"spikes", smooth(spiky_map(48)), isotropic_footprint({20, 47}, 3), 0.005},
      {"the roughest", smooth(test::rough_map(64, 64, Wrap::repeat, 0.5)), isotropic_footprint({7.2, 63.9}, 2), 0.002},
      {"needles", smooth(test::rough_map(64, 64, Wrap::repeat, 0.3)), isotropic_footprint({30, 30}, 1), 1e-4},
      {"blunt", smooth(test::rough_map(64, 64, Wrap::repeat, 0.3)), isotropic_footprint({30, 30}, 1), 0.3},
      {"flakes", Surface(test::rough_map(64, 64, Wrap::repeat, 0.2), Interpolation::constant),
       isotropic_footprint({7.2, 63.9}, 2.5), 0.01},
      {"a map that clamps", smooth(clamped), isotropic_footprint({20.3, 40}, 2), 0.01},
      {"the edge of a map that clamps", smooth(clamped), isotropic_footprint({6.5, 57}, 0.5), 0.01},
      {"flakes on a map that clamps", Surface(clamped, Interpolation::constant), isotropic_footprint({20, 40}, 2),
       0.01},
  };
}

// Both ways to one footprint's densities.
struct Both {
  MixtureFrame frame;
  std::unique_ptr<const MixtureBounds> bounds;
  std::unique_ptr<const MixtureSearch> search;
  PreparedMixture prepared;

  Both(const Case& c, const MixtureSettings& settings)
      : frame(c.surface, settings, c.footprint, glm::dvec2(c.roughness), MixturePndf::k_query_cut),
        prepared(frame, frame.rows()) {
    const bool constant = c.surface.interpolation() == Interpolation::constant;
    std::optional<CellSeeds> seeds = CellSeeds::of(c.surface.map(), constant, settings);
    if (!seeds || !MixtureSearch::can_search(frame)) return;
    bounds = std::make_unique<const MixtureBounds>(c.surface.shared_map(), *std::move(seeds), c.roughness);
    search = std::make_unique<const MixtureSearch>(frame, *bounds);
  }

  // The largest density that one element can have.
  [[nodiscard]] double scale() const { return frame.weight / (frame.roughness.x * frame.roughness.y); }
};

// Drawn, beside those, and anywhere.
glm::dvec2 some_normal(const MixtureFrame& frame, int k, RandomStream& random) {
  const glm::dvec2 drawn = sample_mixture(frame, random);
  const glm::dvec2 xi{random.next_uniform() - 0.5, random.next_uniform() - 0.5};
  if (k % 4 == 1) return drawn + 12 * frame.roughness.x * xi;
  if (k % 4 == 2) return drawn + 0.2 * xi;
  return k % 4 == 3 && k % 3 == 0 ? 2.0 * xi : drawn;
}

// As far as float rounding tells: of means, in deviations, and in tails; and elements that only one way takes as within
// the cut, exp(-12.5) = 4e-6 of their peak.
void expect_same(const Both& both, double density, glm::dvec2 s, const std::string& what) {
  const double expected = both.prepared.density(s);
  const double share = 5e-5 + 3e-6 / both.frame.roughness.x;
  ASSERT_TRUE(std::isfinite(density) && density >= 0) << what;
  ASSERT_NEAR(density, expected, share * expected + 6e-6 * both.scale()) << what << " at " << s.x << ", " << s.y;
}

TEST(MixtureQuery, WithoutPreparingIsThePreparedOne) {
  RandomStream random(11, 3);
  int asked = 0;
  for (const Case& c : cases()) {
    for (const double step : k_steps) {
      if (step < c.least_step || step > c.most_step) continue;
      for (const MixtureElements kind : k_kinds) {
        const Both both(c, {step, std::nullopt, kind});
        const std::string what = c.what + ", h " + std::to_string(step) + ", kind " + std::to_string(int(kind));
        ASSERT_NE(both.search, nullptr) << what;
        const int count = 48;
        for (int k = 0; k < count; ++k, ++asked) {
          const glm::dvec2 s = some_normal(both.frame, k, random);
          double spent = 0;
          ASSERT_NO_FATAL_FAILURE(expect_same(both, both.search->density(s, spent), s, what));
        }
      }
    }
  }
  EXPECT_GE(asked, 10'000);
}

TEST(MixtureQuery, WithoutPreparingIsThePreparedOneForTheFinestAndWidestSteps) {
  RandomStream random(12, 3);
  const Case c{"", Surface(test::wavy_map(96, 64, Wrap::repeat), Interpolation::smooth),
               isotropic_footprint({40.3, 0.1}, 1.5), 0.01};
  for (const double step : {0.05, 0.1, 1.0 / 7, 4.0, 8.0}) {
    for (const double kappa : {0.3, 1.0}) {
      const Both both(c, {step, kappa, MixtureElements::corrected});
      ASSERT_NE(both.search, nullptr) << step;
      for (int k = 0; k < 100; ++k) {
        const glm::dvec2 s = some_normal(both.frame, k, random);
        double spent = 0;
        ASSERT_NO_FATAL_FAILURE(expect_same(both, both.search->density(s, spent), s, std::to_string(step)));
      }
    }
  }
}

TEST(MixtureQuery, IsTheSameInEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    for (const Case& c : cases()) {
      if (c.least_step > 0.5) continue;
      RandomStream random(5, 5);
      const Both both(c, {0.5, std::nullopt, MixtureElements::corrected});
      for (int k = 0; k < 12; ++k) {
        const glm::dvec2 s = some_normal(both.frame, k, random);
        double spent = 0;
        ASSERT_NO_FATAL_FAILURE(expect_same(both, both.search->density(s, spent), s, c.what));
      }
    }
  }
}

TEST(MixtureQuery, WithoutPreparingMakesFewElementsOfASmoothMap) {
  const Case c{"", Surface(test::wavy_map(512, 512, Wrap::repeat), Interpolation::smooth),
               isotropic_footprint({200, 300}, 50.0 / 6), 0.001};
  const Both both(c, {});
  RandomStream random(6, 6);
  double spent = 0;
  for (int k = 0; k < 100; ++k) both.search->density(sample_mixture(both.frame, random), spent);
  EXPECT_LT(spent / 100, 0.2 * static_cast<double>(both.prepared.elements()));
  spent = 0;
  EXPECT_EQ(both.search->density({0.9, 0.9}, spent), 0);
  EXPECT_LT(spent, 0.01 * static_cast<double>(both.prepared.elements()));
}

TEST(MixtureQuery, SeedsOfCellsAreThoseOfTheLattice) {
  const auto map = test::wavy_map(24, 12, Wrap::repeat);
  for (const double step : {8.0, 3.0, 2.0, 1.0, 0.5, 1.0 / 3, 0.25, 0.05}) {
    for (const bool constant : {false, true}) {
      const MixtureSettings settings{step, std::nullopt, MixtureElements::corrected};
      if (12 / step != std::round(12 / step)) continue;
      const std::optional<CellSeeds> seeds = CellSeeds::of(*map, constant, settings);
      ASSERT_TRUE(seeds.has_value()) << step;
      double total = 0;
      for (std::int64_t j = 0; j < 12; j += 4) {
        for (std::int64_t i = 0; i < 24; i += 4) {
          for (std::uint32_t bits = seeds->cells_with_seeds(i, j, 24 - i, 12 - j); bits != 0; bits &= bits - 1) {
            const int cell = __builtin_ctz(bits);
            for (std::size_t k = 0; k < seeds->count; ++k, ++total) {
              const double u = static_cast<double>(i + cell % 4) + seeds->border + static_cast<double>(seeds->u[k]);
              const double v = static_cast<double>(j + cell / 4) + seeds->border + static_cast<double>(seeds->v[k]);
              EXPECT_NEAR(u / step - 0.5, std::round(u / step - 0.5), 1e-5) << step;
              EXPECT_NEAR(v / step - 0.5, std::round(v / step - 0.5), 1e-5) << step;
            }
          }
        }
      }
      EXPECT_NEAR(total, 24 * 12 / (step * step), 1e-6) << step;
    }
  }
}

TEST(MixtureQuery, PreparesWhereLatticeAndTexelsAreNotCommensurate) {
  const auto map = test::wavy_map(48, 33, Wrap::repeat);
  for (const double step : {0.3, 0.4, 0.7, 1.5, 2.0}) {  // 2 does not divide 33
    EXPECT_FALSE(CellSeeds::of(*map, false, {step, std::nullopt, MixtureElements::corrected}).has_value()) << step;
  }
  const Case c{"", Surface(map, Interpolation::smooth), isotropic_footprint({20, 11}, 2), 0.01};
  const MixtureSettings settings{0.3, std::nullopt, MixtureElements::corrected};
  const Both both(c, settings);
  const MixturePndf model(c.surface, c.roughness, settings);
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(c.footprint, workspace);
  const glm::dvec2 s(c.surface.normal({20, 11}));
  double density = 0;
  pndf.evaluate({&s, 1}, {&density, 1});
  EXPECT_EQ(density, both.prepared.density(s));
}

TEST(MixtureQuery, OfMapsOneTexelWideAreThoseOfTheSameMapManyTimes) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 37), glm::ivec2(37, 1)}) {
      const glm::ivec2 times{size.x == 1 ? 64 : 1, size.y == 1 ? 64 : 1};
      const auto thin = test::wavy_map(size.x, size.y, wrap);
      const Surface wide(test::tiled(*thin, times.x, times.y), Interpolation::smooth);
      const glm::dvec2 center{0.4, 0.8};
      const glm::dvec2 inside = center + glm::dvec2((times - 1) / 2);
      const MixturePndf model(Surface(thin, Interpolation::smooth), 0.02);
      const MixturePndf expected(wide, 0.02);
      PndfWorkspace workspace;
      RandomStream random(3, 3);
      const FootprintPndf& pndf = expected.at(isotropic_footprint(inside, 2), workspace);
      for (int k = 0; k < 40; ++k) {
        const glm::dvec2 s = pndf.sample(random);
        const double density = pndf.pdf(s);
        const std::string what = std::to_string(size.x) + " x " + std::to_string(size.y);
        EXPECT_NEAR(test::density_of(model, isotropic_footprint(center, 2), s) / density, 1, 1e-3) << what;
      }
    }
  }
}

TEST(MixtureQuery, PreparesWhereAFootprintLeavesAMapThatClamps) {
  const Case c{"", Surface(test::wavy_map(96, 64, Wrap::clamp), Interpolation::smooth), isotropic_footprint({4, 40}, 2),
               0.01};
  EXPECT_EQ(Both(c, {}).search, nullptr);
}

TEST(MixtureQuery, IsPreparedOnceManyNormalsAreAsked) {
  const Case c = cases()[0];
  const Both both(c, {});
  const MixturePndf model(c.surface, c.roughness);
  RandomStream random(8, 8);
  std::vector<glm::dvec2> s(5000);
  for (glm::dvec2& normal : s) normal = sample_mixture(both.frame, random);
  std::vector<double> together(s.size());
  PndfWorkspace workspace;
  model.at(c.footprint, workspace).evaluate(s, together);
  const FootprintPndf& one_by_one = model.at(c.footprint, workspace);
  for (std::size_t k = 0; k < s.size(); ++k) {
    double density = 0;
    one_by_one.evaluate({&s[k], 1}, {&density, 1});
    EXPECT_EQ(together[k], both.prepared.density(s[k]));
    ASSERT_NO_FATAL_FAILURE(expect_same(both, density, s[k], std::to_string(k)));
    if (k > 1000) {
      EXPECT_EQ(density, together[k]);
    }
  }
}

TEST(MixtureQuery, DoesNotDependOnTheirOrderOnceTheirNumberIsExpected) {
  const Case c = cases()[3];
  const MixturePndf model(c.surface, c.roughness);
  PndfWorkspace workspace;
  RandomStream random(9, 9);
  for (const std::size_t count : {4U, 3000U}) {
    const FootprintPndf& pndf = model.at(c.footprint, workspace);
    pndf.expect_queries(count);
    std::vector<glm::dvec2> s(count);
    for (glm::dvec2& normal : s) normal = pndf.sample(random);
    std::vector<double> forward(count);
    std::vector<double> backward(count);
    for (std::size_t k = 0; k < count; ++k) pndf.evaluate({&s[k], 1}, {&forward[k], 1});
    for (std::size_t k = count; k-- > 0;) pndf.evaluate({&s[k], 1}, {&backward[k], 1});
    EXPECT_EQ(forward, backward);
  }
}

TEST(MixtureQuery, MayBeAskedFromSeveralThreads) {
  const Case c{"", Surface(test::wavy_map(300, 200, Wrap::repeat), Interpolation::smooth),
               isotropic_footprint({100, 90}, 6), 0.005};
  const Both both(c, {});
  const MixturePndf model(c.surface, c.roughness);
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(c.footprint, workspace);
  std::vector<glm::dvec2> s(400);
  RandomStream random(10, 10);
  for (glm::dvec2& normal : s) normal = sample_mixture(both.frame, random);
  std::vector<std::vector<double>> densities(4, std::vector<double>(s.size()));
  std::vector<std::thread> threads;
  for (std::vector<double>& of_thread : densities) {
    threads.emplace_back([&] {
      for (std::size_t k = 0; k < s.size(); ++k) {
        pndf.evaluate({&s[k], 1}, {&of_thread[k], 1});
        of_thread[k] += 0 * pndf.pdf(s[k]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& of_thread : densities) {
    for (std::size_t k = 0; k < s.size(); ++k) {
      ASSERT_NO_FATAL_FAILURE(expect_same(both, of_thread[k], s[k], std::to_string(k)));
    }
  }
}

TEST(MixtureQuery, MassIsTheSumOfTheWeightsOfAllElements) {
  const Surface surface(test::wavy_map(48, 36, Wrap::repeat), Interpolation::smooth);
  for (const double step : {2.0, 0.5, 0.3}) {
    for (const double kappa : {0.3, 0.4247, 1.0}) {
      for (const Footprint& footprint :
           {isotropic_footprint({20.2, 10.9}, 0.001), isotropic_footprint({20.2, 10.9}, 0.3),
            isotropic_footprint({20, 11}, 5), test::turned_footprint({1.3, 7.7}, 9, 0.05, 0.7),
            test::turned_footprint({1.3, 7.7}, 0.5, 0.1, -0.9)}) {
        const MixtureFrame frame(surface, {step, kappa, MixtureElements::corrected}, footprint, glm::dvec2(0.02), 8);
        const auto [first_row, last_row] = frame.rows();
        const auto [first, last] = frame.columns();
        double sum = 0;
        for (std::int64_t l = first_row; l <= last_row; ++l) {
          for (std::int64_t k = first; k <= last; ++k) {
            const glm::dvec2 seed{(static_cast<double>(k) + 0.5) * frame.lattice.step.x,
                                  (static_cast<double>(l) + 0.5) * frame.lattice.step.y};
            sum += frame.lattice.area() * normal_density(seed - frame.center, frame.widened);
          }
        }
        EXPECT_NEAR(sum_of_weights(frame), sum, 1e-11) << step << ' ' << kappa << ' ' << footprint.covariance.xx;
      }
    }
  }
}

}  // namespace
}  // namespace glint
