// The elements one by one against closed forms and against the mixture that they add up to.

#include "core/pndf/mixture_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/mixture_pndf.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

constexpr double k_far = std::numeric_limits<double>::infinity();
constexpr PlaneRectangle k_everywhere{{-k_far, -k_far}, {k_far, k_far}};

struct Case {
  std::string what;
  Surface surface;
  Footprint footprint;
};

std::vector<Case> cases() {
  const auto wavy = test::wavy_map(48, 32, Wrap::repeat);
  return {
      {"inside", Surface(wavy, Interpolation::smooth), isotropic_footprint({20.3, 11.1}, 2)},
      {"many periods away", Surface(wavy, Interpolation::smooth), isotropic_footprint({48 * 90 + 3.3, -32 * 70}, 1)},
      {"turned", Surface(wavy, Interpolation::smooth), test::turned_footprint({20, 11}, 4, 0.5, 0.7)},
      {"much larger than the map", Surface(test::wavy_map(5, 4, Wrap::repeat), Interpolation::smooth),
       isotropic_footprint({2, 2}, 9)},
      {"a map that clamps", Surface(test::wavy_map(20, 20, Wrap::clamp), Interpolation::smooth),
       isotropic_footprint({0.5, 19}, 2)},
      {"flakes", Surface(test::rough_map(24, 24, Wrap::repeat, 0.2), Interpolation::constant),
       isotropic_footprint({7.2, 23.9}, 1.5)}};
}

constexpr double k_roughness = 0.02;

TEST(MixtureElements, AddUpToWhatTheMixtureSaysAtANormal) {
  for (const Case& c : cases()) {
    for (const MixtureElements kind : {MixtureElements::flat, MixtureElements::curved, MixtureElements::corrected}) {
      for (const double step : {1.0, 0.5, 0.3}) {
        const MixtureSettings settings{step, std::nullopt, kind};
        const MixtureFrame frame = element_frame(c.surface, settings, c.footprint, k_roughness);
        ASSERT_TRUE(frame.sums_elements()) << c.what;
        const std::vector<MixtureElement> elements = elements_in(frame, k_everywhere);
        const MixturePndf model(c.surface, k_roughness, settings);
        PndfWorkspace workspace;
        const FootprintPndf& pndf = model.at(c.footprint, workspace);
        RandomStream random(5, 7);
        for (int k = 0; k < 5; ++k) {
          const glm::dvec2 s = pndf.sample(random);
          double expected = 0;
          pndf.evaluate({&s, 1}, {&expected, 1});
          double sum = 0;
          for (const MixtureElement& element : elements) sum += element.density(s);
          EXPECT_NEAR(sum / expected, 1, 2e-5) << c.what << ", step " << step;
        }
      }
    }
  }
}

TEST(MixtureElements, WeighOneTogetherUnderAFootprintWiderThanTheirStep) {
  for (const Case& c : cases()) {
    double sum = 0;
    const MixtureFrame frame = element_frame(c.surface, {}, c.footprint, k_roughness);
    for (const MixtureElement& element : elements_in(frame, k_everywhere)) sum += element.weight;
    EXPECT_NEAR(sum, 1, 2e-5) << c.what;  // of the plane the cut leaves out exp(-12.5) = 4e-6
  }
}

TEST(MixtureElements, OfAFlatMapAreTheFootprintsGaussianAtTheirSeeds) {
  const glm::dvec2 normal(0.1, -0.2);
  const Surface surface(test::constant_map(normal, Wrap::repeat, 16), Interpolation::smooth);
  const Footprint footprint = test::turned_footprint({7.3, 8.1}, 2, 0.7, 0.4);
  const MixtureSettings settings{0.5, 0.6, MixtureElements::corrected};
  const double variance = 0.3 * 0.3;  // (kappa h)^2
  const SymmetricMatrix2 widened{footprint.covariance.xx + variance, footprint.covariance.xy,
                                 footprint.covariance.yy + variance};
  const SymmetricMatrix2 lobe{k_roughness * k_roughness, 0, k_roughness * k_roughness};
  const std::vector<MixtureElement> elements =
      elements_in(element_frame(surface, settings, footprint, k_roughness), k_everywhere);
  ASSERT_GT(elements.size(), 100U);
  for (const MixtureElement& e : elements) {
    const glm::dvec2 place = e.seed / 0.5 - 0.5;
    EXPECT_NEAR(place.x, std::round(place.x), 1e-5);
    EXPECT_NEAR(place.y, std::round(place.y), 1e-12);
    const double weight = 0.25 * normal_density(e.seed - footprint.center, widened);
    EXPECT_NEAR(e.weight / weight, 1, 2e-5);
    for (const glm::dvec2 d : {glm::dvec2(0, 0), glm::dvec2(0.01, -0.02)}) {
      const double expected = weight * normal_density(d, lobe);
      const double squared = (d.x * d.x + d.y * d.y) / (k_roughness * k_roughness);
      if (squared < 0.99 * e.room) {
        EXPECT_NEAR(e.density(normal + d) / expected, 1, 4e-5);
      } else if (squared > 1.01 * e.room) {
        EXPECT_EQ(e.density(normal + d), 0);
      }
    }
  }
}

TEST(MixtureElements, OfAPartAreThoseOfAllWhoseSeedsLieInIt) {
  const Case c = cases()[2];
  const MixtureFrame frame = element_frame(c.surface, {}, c.footprint, k_roughness);
  const PlaneRectangle part{{18.9, 9.1}, {22.6, 12.3}};
  std::vector<MixtureElement> expected;
  for (const MixtureElement& e : elements_in(frame, k_everywhere)) {
    if (e.seed.x >= 18.9 && e.seed.x <= 22.6 && e.seed.y >= 9.1 && e.seed.y <= 12.3) expected.push_back(e);
  }
  const std::vector<MixtureElement> found = elements_in(frame, part);
  ASSERT_GT(found.size(), 20U);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].seed, expected[k].seed);
    EXPECT_EQ(found[k].weight, expected[k].weight);
  }
  EXPECT_GE(seeds_visited(frame, part), static_cast<double>(found.size()));
  EXPECT_TRUE(elements_in(frame, {{0, 300}, {48, 310}}).empty());
  EXPECT_EQ(seeds_visited(frame, {{0, 300}, {48, 310}}), 0);
}

// What an element adds to the density at s, and how that lies in the plane, by quadrature of the paper's product: the
// footprint times the element's Gaussian round its seed times the roughness' round its linear normal.
TEST(MixtureElements, ShineFromWhereTheirNormalIsTheOneAsked) {
  const auto wavy = test::wavy_map(48, 32, Wrap::repeat, 0.4);
  const Footprint footprint = test::turned_footprint({20.3, 11.1}, 1.2, 0.3, 0.7);
  for (const Surface& surface : {Surface(wavy, Interpolation::smooth), Surface(wavy, Interpolation::constant)}) {
    for (const MixtureElements kind : {MixtureElements::flat, MixtureElements::corrected}) {
      const MixtureFrame frame = element_frame(surface, {1.5, std::nullopt, kind}, footprint, k_roughness);
      const double variance = frame.lattice.deviation * frame.lattice.deviation;
      const bool is_curved = kind != MixtureElements::flat && surface.interpolation() == Interpolation::smooth;
      const CholeskyFactor& whole = frame.spread;
      for (const MixtureElement& e : elements_in(frame, {{18.8, 9.6}, {21.8, 12.6}})) {
        const glm::dmat2 j = element_jacobian(frame, surface, e.seed);
        const glm::dvec2 o = e.seed - footprint.center;
        const SymmetricMatrix2 v{footprint.covariance.xx + variance, footprint.covariance.xy,
                                 footprint.covariance.yy + variance};
        const glm::dvec2 k_o = variance / determinant(v) * glm::dvec2(v.yy * o.x - v.xy * o.y, v.xx * o.y - v.xy * o.x);
        const glm::dvec2 normal = e.mean + j * k_o;  // at the seed
        const glm::dvec2 s = e.mean + glm::dvec2(0.02, -0.01);
        double sum = 0;
        glm::dvec2 first(0, 0);
        SymmetricMatrix2 second{0, 0, 0};
        constexpr double k_pitch = 0.02;
        for (double y = -4; y < 4; y += k_pitch) {
          for (double x = -4; x < 4; x += k_pitch) {
            const glm::dvec2 d(x, y);  // from the seed
            const double density =
                normal_density(d + o, footprint.covariance) * normal_density(d, {variance, 0, variance}) *
                normal_density(s - normal - j * d, {k_roughness * k_roughness, 0, k_roughness * k_roughness});
            sum += density;
            first += density * d;
            second.xx += density * d.x * d.x;
            second.xy += density * d.x * d.y;
            second.yy += density * d.y * d.y;
          }
        }
        EXPECT_NEAR(sum * k_pitch * k_pitch * frame.lattice.area() / e.density(s), 1, 1e-4);
        first /= sum;
        const ElementPart part = part_towards(frame, e, j, s);
        EXPECT_NEAR(part.center.x, e.seed.x + first.x, 1e-5);
        EXPECT_NEAR(part.center.y, e.seed.y + first.y, 1e-5);
        EXPECT_NEAR(part.covariance.xx, second.xx / sum - first.x * first.x, 1e-6);
        EXPECT_NEAR(part.covariance.xy, second.xy / sum - first.x * first.y, 1e-6);
        EXPECT_NEAR(part.covariance.yy, second.yy / sum - first.y * first.y, 1e-6);
        const double share = std::sqrt(determinant(part.covariance)) / (whole.l11 * whole.l22);
        EXPECT_EQ(share < 0.99, is_curved);
      }
    }
  }
}

// MixturePndf decides by itself what it hands to the exact method: its values tell.
TEST(MixtureElements, AreSaidToBeThereWhereTheMixtureIsNotTheExactMethod) {
  const Surface surface(test::wavy_map(48, 32, Wrap::repeat), Interpolation::smooth);
  const auto is_exact = [&](const Footprint& footprint, double roughness, const MixtureSettings& settings) {
    PndfWorkspace of_mixture;
    PndfWorkspace of_exact;
    const MixturePndf mixture(surface, roughness, settings);
    const FastExactPndf exact(surface, roughness);
    RandomStream random(5, 7);
    const glm::dvec2 s = exact.at(footprint, of_exact).sample(random);
    return mixture.at(footprint, of_mixture).pdf(s) == exact.at(footprint, of_exact).pdf(s);
  };
  const MixtureSettings coarse{2, std::nullopt, MixtureElements::flat};
  for (const auto& [footprint, roughness] :
       {std::pair(isotropic_footprint({20, 11}, 2), 0.02), std::pair(isotropic_footprint({20, 11}, 60), 0.02),
        std::pair(isotropic_footprint({20, 11}, 2), 1e-7),
        std::pair(test::turned_footprint({20, 11}, 300, 0.01, 0.7), 0.02)}) {
    EXPECT_EQ(element_frame(surface, coarse, footprint, roughness).sums_elements(),
              !is_exact(footprint, roughness, coarse))
        << footprint.covariance.xx << ' ' << roughness;
  }
}

}  // namespace
}  // namespace glint
