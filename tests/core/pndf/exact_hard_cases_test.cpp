// Exact evaluation against a slow, plain twin (reference_quadrature.h) where it is hard.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/exact_pndf.h"
#include "core/surface/surface.h"
#include "tests/core/pndf/reference_quadrature.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

using test::MapPointer;

constexpr Interpolation k_surfaces[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};

struct HardCase {
  std::string name;
  MapPointer map;
  Footprint footprint;
};

std::vector<HardCase> hard_cases() {
  const MapPointer rough = test::rough_map(24, 20, Wrap::repeat);
  const MapPointer wavy = test::wavy_map(64, 48, Wrap::repeat);
  const double quarter = 0.7853981633974483;
  return {
      {"sigma 0.05 inside a triangle", rough, isotropic_footprint({10.8, 7.7}, 0.05)},
      {"sigma 0.05 on a vertex", rough, isotropic_footprint({10.5, 7.5}, 0.05)},
      {"an oblique ellipse", rough, {{12.3, 9.1}, {1.1, 0.25, 0.6}}},
      {"an oblique ellipse, smooth map", wavy, {{12.3, 9.1}, {9, 2, 5}}},
      {"1 : 200 at 45 degrees", rough, test::turned_footprint({12.3, 9.1}, 8, 0.04, quarter)},
      {"1 : 1000 at 45 degrees", wavy, test::turned_footprint({12.3, 9.1}, 30, 0.03, quarter)},
      {"straddling the wrap", rough, isotropic_footprint({23.99, 0.02}, 0.5)},
      {"many periods away", rough, {{24 * 85 + 7.99, -20 * 40 - 0.01}, {0.5, -0.15, 0.25}}},
      {"several periods wide", test::wavy_map(5, 4, Wrap::repeat), isotropic_footprint({2.2, 1.1}, 2.2)},
      {"a 1 x 1 map", test::rough_map(1, 1, Wrap::repeat), isotropic_footprint({0.3, 0.9}, 0.6)},
      {"a 2 x 2 map", test::rough_map(2, 2, Wrap::repeat), isotropic_footprint({0.3, 0.9}, 0.6)},
      {"a 1 x 7 map", test::rough_map(1, 7, Wrap::repeat), isotropic_footprint({0.3, 3.9}, 0.8)},
      {"a 7 x 1 map", test::rough_map(7, 1, Wrap::repeat), isotropic_footprint({0.3, 3.9}, 0.8)},
      {"8 bits", test::quantised(*test::wavy_map(96, 96, Wrap::repeat, 0.05)), isotropic_footprint({31.7, 12.2}, 2.5)},
      {"clamped, over the corner", test::rough_map(24, 20, Wrap::clamp), isotropic_footprint({23.2, 0.4}, 0.7)},
      {"clamped, far outside", test::rough_map(24, 20, Wrap::clamp), {{-5.3, 8}, {1.5, 0.5, 0.7}}},
      {"clamped, wider than the map", test::rough_map(3, 2, Wrap::clamp), isotropic_footprint({1.5, 1.2}, 1.2)},
      {"a clamped 1 x 1 map", test::rough_map(1, 1, Wrap::clamp), isotropic_footprint({0.3, 0.9}, 0.6)},
      {"a clamped 1 x 7 map", test::rough_map(1, 7, Wrap::clamp), isotropic_footprint({0.3, 3.9}, 0.8)},
  };
}

// Normals drawn from D_P, by the twin.
std::vector<glm::dvec2> queries(const test::SlowPndf& slow, double roughness, int count) {
  RandomStream random(42, 0);
  std::vector<glm::dvec2> s;
  for (int k = 0; k < count; ++k) {
    std::array<double, 2> xi{};
    random.fill_normal(xi);
    s.push_back(slow.draw_normal(random) + roughness * glm::dvec2(xi[0], xi[1]));
  }
  return s;
}

// The largest relative error where D is at least 1e-6 of its largest value.
double largest_error(const ExactPndf& model, const test::SlowPndf& slow, const Footprint& footprint,
                     const std::vector<glm::dvec2>& s) {
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(footprint, workspace);
  std::vector<double> expected;
  for (const glm::dvec2 normal : s) expected.push_back(slow.density(normal));
  const double peak = *std::max_element(expected.begin(), expected.end());
  EXPECT_GT(peak, 0);
  double worst = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (expected[k] > 1e-6 * peak) worst = std::max(worst, std::abs(pndf.pdf(s[k]) / expected[k] - 1));
  }
  return worst;
}

class ExactAgainstTwin : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(SigmaR, ExactAgainstTwin, testing::Values(1e-4, 0.01, 0.3), [](const auto& instance) {
  return instance.param < 1e-3  ? std::string("small")
         : instance.param < 0.1 ? std::string("medium")
                                : std::string("large");
});

TEST_P(ExactAgainstTwin, AgreesInEveryHardCaseOnEverySurface) {
  const double roughness = GetParam();
  for (const HardCase& hard : hard_cases()) {
    double worst = 0;
    for (const Interpolation interpolation : k_surfaces) {
      const Surface surface(hard.map, interpolation);
      const ExactPndf model(surface, roughness);
      const test::SlowPndf slow(surface, 4, hard.footprint, glm::dvec2(roughness));
      std::vector<glm::dvec2> s = queries(slow, roughness, 2);
      if (roughness > 1e-3) s.push_back(s[0] + 2.5 * roughness * glm::dvec2(0.6, -0.8));
      const double error = largest_error(model, slow, hard.footprint, s);
      EXPECT_LE(error, 5e-9) << hard.name << " on surface " << static_cast<int>(interpolation);
      worst = std::max(worst, error);
    }
    RecordProperty(hard.name, std::to_string(worst * 1e10) + "e-10");
  }
}

}  // namespace
}  // namespace glint
