// The Gaussian mixture against a plain twin in double precision, closed forms and the exact method.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/mixture_pndf.h"
#include "core/pndf/mixture_query.h"
#include "core/surface/catmull_rom.h"
#include "tests/core/pndf/chi_square.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

// One element, as the paper writes it.
struct SlowElement {
  glm::dvec2 seed;
  glm::dvec2 normal;
  glm::dvec2 du;
  glm::dvec2 dv;
};

SlowElement slow_element(const Surface& surface, const MixtureSettings& settings, double deviation, glm::dvec2 seed) {
  SlowElement e{seed, {0, 0}, {0, 0}, {0, 0}};
  if (surface.interpolation() == Interpolation::constant) {
    e.normal = glm::dvec2(surface.map().texel(static_cast<std::int64_t>(std::floor(seed.x)),
                                              static_cast<std::int64_t>(std::floor(seed.y))));
    return e;
  }
  const double i = std::floor(seed.x - 0.5);
  const double j = std::floor(seed.y - 0.5);
  const double x = seed.x - 0.5 - i;
  const double y = seed.y - 0.5 - j;
  const bool curved = settings.elements != MixtureElements::flat;
  const double half = settings.elements == MixtureElements::corrected ? 0.5 * deviation * deviation : 0;
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a < 4; ++a) {
      const glm::dvec2 n(surface.map().texel(static_cast<std::int64_t>(i) - 1 + static_cast<std::int64_t>(a),
                                             static_cast<std::int64_t>(j) - 1 + static_cast<std::int64_t>(b)));
      const double bend = catmull_rom_second_difference(x)[a] * catmull_rom(y)[b] +
                          catmull_rom(x)[a] * catmull_rom_second_difference(y)[b];
      e.normal += (catmull_rom(x)[a] * catmull_rom(y)[b] + half * bend) * n;
      if (!curved) continue;
      e.du += catmull_rom_derivative(x)[a] * catmull_rom(y)[b] * n;
      e.dv += catmull_rom(x)[a] * catmull_rom_derivative(y)[b] * n;
    }
  }
  return e;
}

double gaussian(glm::dvec2 d, double xx, double xy, double yy) {
  const double determinant = xx * yy - xy * xy;
  const double form = (yy * d.x * d.x - 2 * xy * d.x * d.y + xx * d.y * d.y) / determinant;
  return std::exp(-0.5 * form) / (2 * std::numbers::pi * std::sqrt(determinant));
}

// D_P(s) element by element, without a cut; in closed form or, to test that, as the integral over u of the paper's
// element times the footprint.
double slow_mixture(const Surface& surface, const MixtureSettings& settings, const Footprint& footprint,
                    double roughness, glm::dvec2 s, bool by_quadrature = false) {
  const MixtureLattice lattice(surface.map(), settings);
  const double h = lattice.deviation;
  const SymmetricMatrix2& p = footprint.covariance;
  const double v_xx = p.xx + h * h;
  const double v_yy = p.yy + h * h;
  const double v_det = v_xx * v_yy - p.xy * p.xy;
  const auto first = [&](double center, double reach, double step) { return std::ceil((center - reach) / step - 0.5); };
  const double reach_u = 8.5 * std::sqrt(v_xx);
  const double reach_v = 8.5 * std::sqrt(v_yy);
  double sum = 0;
  for (double l = first(footprint.center.y, reach_v, lattice.step.y);
       (l + 0.5) * lattice.step.y < footprint.center.y + reach_v; ++l) {
    for (double k = first(footprint.center.x, reach_u, lattice.step.x);
         (k + 0.5) * lattice.step.x < footprint.center.x + reach_u; ++k) {
      const SlowElement e =
          slow_element(surface, settings, h, {(k + 0.5) * lattice.step.x, (l + 0.5) * lattice.step.y});
      const glm::dvec2 delta = footprint.center - e.seed;
      if (by_quadrature) {
        constexpr int k_points = 60;
        const double pitch = 14 * h / k_points;
        for (int b = 0; b < k_points; ++b) {
          for (int a = 0; a < k_points; ++a) {
            const glm::dvec2 d{(a + 0.5) * pitch - 7 * h, (b + 0.5) * pitch - 7 * h};
            const glm::dvec2 mean = e.normal + d.x * e.du + d.y * e.dv;
            sum += pitch * pitch * lattice.area() * gaussian(d, h * h, 0, h * h) *
                   gaussian(s - mean, roughness * roughness, 0, roughness * roughness) *
                   gaussian(e.seed + d - footprint.center, p.xx, p.xy, p.yy);
          }
        }
        continue;
      }
      // K = h^2 V^-1 and Sigma_e = h^2 Sigma_p V^-1.
      const double k_xx = h * h * v_yy / v_det;
      const double k_xy = -h * h * p.xy / v_det;
      const double k_yy = h * h * v_xx / v_det;
      const double e_xx = h * h * (1 - k_xx);
      const double e_xy = -h * h * k_xy;
      const double e_yy = h * h * (1 - k_yy);
      const glm::dvec2 moved{k_xx * delta.x + k_xy * delta.y, k_xy * delta.x + k_yy * delta.y};
      const glm::dvec2 mean = e.normal + moved.x * e.du + moved.y * e.dv;
      const auto quadratic = [&](double au, double av, double bu, double bv) {
        return au * (e_xx * bu + e_xy * bv) + av * (e_xy * bu + e_yy * bv);
      };
      const double xx = roughness * roughness + quadratic(e.du.x, e.dv.x, e.du.x, e.dv.x);
      const double xy = quadratic(e.du.x, e.dv.x, e.du.y, e.dv.y);
      const double yy = roughness * roughness + quadratic(e.du.y, e.dv.y, e.du.y, e.dv.y);
      sum += lattice.area() * gaussian(delta, v_xx, p.xy, v_yy) * gaussian(s - mean, xx, xy, yy);
    }
  }
  return sum;
}

struct Case {
  std::string what;
  Surface surface;
  Footprint footprint;
  double roughness;
};

std::vector<Case> cases() {
  const auto wavy = test::wavy_map(48, 32, Wrap::repeat);
  return {{"inside", Surface(wavy, Interpolation::smooth), isotropic_footprint({20.3, 11.1}, 2), 0.02},
          {"across the border", Surface(wavy, Interpolation::smooth), isotropic_footprint({47.9, 31.8}, 1.5), 0.02},
          {"many periods away", Surface(wavy, Interpolation::smooth), isotropic_footprint({48 * 90 + 3.3, -32 * 70}, 1),
           0.02},
          {"turned", Surface(wavy, Interpolation::smooth), test::turned_footprint({20, 11}, 4, 0.5, 0.7), 0.02},
          {"a tiny footprint", Surface(wavy, Interpolation::smooth), isotropic_footprint({20.3, 11.1}, 0.02), 0.02},
          {"larger than the map", Surface(test::wavy_map(5, 4, Wrap::repeat), Interpolation::smooth),
           isotropic_footprint({2, 2}, 4), 0.03},
          {"much larger than the map", Surface(test::wavy_map(5, 4, Wrap::repeat), Interpolation::smooth),
           isotropic_footprint({2, 2}, 9), 0.03},
          {"a map that clamps", Surface(test::wavy_map(20, 20, Wrap::clamp), Interpolation::smooth),
           isotropic_footprint({0.5, 19}, 2), 0.02},
          {"flakes", Surface(test::rough_map(24, 24, Wrap::repeat, 0.2), Interpolation::constant),
           isotropic_footprint({7.2, 23.9}, 1.5), 0.02},
          {"the roughest map", Surface(test::rough_map(24, 24, Wrap::repeat, 0.3), Interpolation::smooth),
           isotropic_footprint({7.2, 23.9}, 1), 0.005}};
}

constexpr double k_steps[] = {2, 1, 0.5, 1.0 / 3, 0.25, 0.3};
constexpr MixtureElements k_kinds[] = {MixtureElements::flat, MixtureElements::curved, MixtureElements::corrected};

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

void expect_twin(const Case& c, const MixtureSettings& settings, int count) {
  const MixturePndf model(c.surface, c.roughness, settings);
  PndfWorkspace workspace;
  const FootprintPndf& pndf = model.at(c.footprint, workspace);
  const double peak = 1 / (2 * std::numbers::pi * c.roughness * c.roughness);
  const std::string what =
      c.what + ", h " + std::to_string(settings.step) + ", kind " + std::to_string(static_cast<int>(settings.elements));
  for (const glm::dvec2 s : normals_for(pndf, c.roughness, count)) {
    double value = 0;
    pndf.evaluate({&s, 1}, {&value, 1});
    const double expected = slow_mixture(c.surface, settings, c.footprint, c.roughness, s);
    ASSERT_TRUE(std::isfinite(value) && value >= 0) << what;
    // Of each element the cut leaves out at most exp(-12.5) = 4e-6 of the roughness' own peak.
    ASSERT_NEAR(value / peak, expected / peak, 8e-6 + 5e-4 * expected / peak) << what;
  }
}

TEST(Mixture, IsItsTwinForEveryStepAndKind) {
  for (const Case& c : cases()) {
    for (const double step : k_steps) {
      for (const MixtureElements kind : k_kinds) expect_twin(c, {step, std::nullopt, kind}, 2);
    }
  }
}

TEST(Mixture, IsItsTwinForTheFinestAndWidestStepsOnTheSmallestMaps) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 8), std::pair(8, 1), std::pair(3, 7)}) {
    const Case c{"a map of " + std::to_string(width) + " x " + std::to_string(height),
                 Surface(test::rough_map(width, height, Wrap::repeat, 0.1), Interpolation::smooth),
                 isotropic_footprint({0.4, 0.1}, 0.2), 0.02};
    for (const double step : {0.05, 0.7, 8.0}) expect_twin(c, {step, std::nullopt, MixtureElements::corrected}, 2);
  }
}

TEST(Mixture, IsItsTwinWhereRoughnessIsSmallAgainstTheSlope) {
  // |J| h is 100 times sigma_r; elements are needles.
  const Case c{"needles", Surface(test::wavy_map(48, 32, Wrap::repeat), Interpolation::smooth),
               test::turned_footprint({20.3, 11.1}, 8, 0.02, 0.7), 1e-4};
  for (const double step : {1.0, 0.5}) expect_twin(c, {step, std::nullopt, MixtureElements::corrected}, 4);
}

TEST(Mixture, OfARoughnessThatFloatsDoNotHoldIsExact) {
  const Surface surface(test::constant_map({0.1, -0.2}, Wrap::repeat, 8), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({3, 3}, 1);
  const glm::dvec2 s(surface.map().texel(0, 0));
  const double peak = 1 / (2 * std::numbers::pi * 1e-18);
  EXPECT_NEAR(test::density_of(MixturePndf(surface, 1e-9), footprint, s) / peak, 1, 1e-6);
  EXPECT_EQ(test::density_of(MixturePndf(surface, 1e-9), footprint, s + glm::dvec2(1e-7, 0)), 0);
}

TEST(Mixture, IsItsTwinInEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    expect_twin(cases()[0], {}, 6);
    expect_twin(cases()[3], {0.3, 0.6, MixtureElements::corrected}, 6);
  }
}

TEST(Mixture, PictureIsTheSameInEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  const Case c = cases()[3];
  const PndfGrid grid = fitted_window(c.surface, c.footprint, c.roughness, 61);
  std::vector<std::vector<double>> made;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    made.push_back(test::image_of(MixturePndf(c.surface, c.roughness), c.footprint, grid).density);
    // They differ in which cells beyond the cut they visit besides.
    EXPECT_LE(test::relative_l1(made.back(), made.front()), 1.5e-3) << instruction_set_name(set);
  }
}

TEST(Mixture, OfTheTwinIsTheIntegralOfThePapersElements) {
  for (const std::size_t which : {0U, 3U, 8U}) {
    const Case c = cases()[which];
    for (const MixtureElements kind : k_kinds) {
      const MixtureSettings settings{2, 0.5, kind};
      const MixturePndf model(c.surface, c.roughness, settings);
      PndfWorkspace workspace;
      const glm::dvec2 s = normals_for(model.at(c.footprint, workspace), c.roughness, 1)[0];
      const double closed = slow_mixture(c.surface, settings, c.footprint, c.roughness, s);
      const double integrated = slow_mixture(c.surface, settings, c.footprint, c.roughness, s, true);
      EXPECT_NEAR(integrated / closed, 1, 1e-8) << c.what;
    }
  }
}

TEST(Mixture, PictureIsThatOfItsSingleNormals) {
  for (const std::size_t which : {0U, 2U, 3U, 5U, 6U, 7U, 8U}) {
    const Case c = cases()[which];
    const MixturePndf model(c.surface, c.roughness);
    const PndfGrid grid = fitted_window(c.surface, c.footprint, c.roughness, 61);
    const PndfImage image = test::image_of(model, c.footprint, grid);
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(c.footprint, workspace);
    std::vector<double> expected(grid.cells());
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const glm::dvec2 s = grid.center(column, row);
        pndf.evaluate({&s, 1}, {&expected[grid.index(column, row)], 1});
      }
    }
    ASSERT_EQ(image.widening, glm::dvec2(0)) << "else they cannot be compared";
    EXPECT_LE(test::relative_l1(image.density, expected), 3e-3) << c.what;
    const MixtureFrame frame(c.surface, {}, c.footprint, glm::dvec2(c.roughness), 6);
    const PreparedMixture prepared(frame, frame.rows());
    EXPECT_NEAR(integral(image), prepared.mass(), 1e-3) << c.what << ": what is cut is given back";
  }
}

TEST(Mixture, PictureIsTheSameBytesForAnyNumberOfThreads) {
  const Surface surface(test::wavy_map(200, 200, Wrap::repeat), Interpolation::smooth);
  const MixturePndf model(surface, 0.01);
  const Footprint footprint = isotropic_footprint({100, 100}, 12);
  std::vector<std::vector<double>> made;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    made.push_back(test::image_of(model, footprint, PndfGrid{}).density);
  }
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
}

TEST(Mixture, IsNothingOnceCancelled) {
  JobControl control;
  control.cancel();
  EXPECT_FALSE(MixturePndf(cases()[0].surface, 0.02).image(cases()[0].footprint, PndfGrid{}, control).has_value());
}

TEST(Mixture, OfARampIsOneGaussianUpToTheRippleOfItsLattice) {
  // n = a + J u with J along the map's diagonal; where the footprint reaches nothing of the border.
  const glm::dvec2 du{0.004, 0.001};
  const glm::dvec2 dv{-0.002, 0.003};
  const auto ramp = test::map_of(
      64, 64, Wrap::clamp, [&](int i, int j) { return glm::dvec2(-0.1, -0.1) + (i + 0.5) * du + (j + 0.5) * dv; });
  const Footprint footprint{{32.2, 31.7}, {4, 1, 2}};
  const double roughness = 0.01;
  const auto& p = footprint.covariance;
  const auto quadratic = [&](double au, double av, double bu, double bv) {
    return au * (p.xx * bu + p.xy * bv) + av * (p.xy * bu + p.yy * bv);
  };
  const double xx = roughness * roughness + quadratic(du.x, dv.x, du.x, dv.x);
  const double xy = quadratic(du.x, dv.x, du.y, dv.y);
  const double yy = roughness * roughness + quadratic(du.y, dv.y, du.y, dv.y);
  const glm::dvec2 mean = glm::dvec2(-0.1, -0.1) + footprint.center.x * du + footprint.center.y * dv;
  for (const double kappa : {0.4247, 0.5, 0.6}) {
    const double ripple = std::pow(1 + 2 * std::exp(-2 * std::pow(std::numbers::pi * kappa, 2)), 2) - 1;
    for (const MixtureElements kind : {MixtureElements::curved, MixtureElements::corrected}) {
      const MixturePndf model(Surface(ramp, Interpolation::smooth), roughness, {1, kappa, kind});
      PndfWorkspace workspace;
      const FootprintPndf& pndf = model.at(footprint, workspace);
      for (const glm::dvec2 off : {glm::dvec2(0), glm::dvec2(0.01, -0.005), glm::dvec2(-0.02, 0.01)}) {
        const glm::dvec2 s = mean + off;
        double value = 0;
        pndf.evaluate({&s, 1}, {&value, 1});
        EXPECT_NEAR(value / gaussian(off, xx, xy, yy), 1, ripple + 1e-4) << kappa;
      }
    }
  }
}

TEST(Mixture, WeightsSumToOneUpToTheRippleOfItsLattice) {
  const Surface surface(test::wavy_map(48, 32, Wrap::repeat), Interpolation::smooth);
  for (const double sigma : {0.02, 0.3, 1.0, 5.0}) {
    for (const double kappa : {0.4247, 0.6}) {
      const MixtureFrame frame(surface, {1, kappa, MixtureElements::corrected},
                               isotropic_footprint({20.2, 10.9}, sigma), glm::dvec2(0.02), 7);
      const PreparedMixture prepared(frame, frame.rows());
      const double deviation = std::sqrt(kappa * kappa + sigma * sigma);
      const double ripple = std::pow(1 + 2 * std::exp(-2 * std::pow(std::numbers::pi * deviation, 2)), 2) - 1;
      EXPECT_NEAR(prepared.mass(), 1, ripple + 2e-5) << sigma << ' ' << kappa;
    }
  }
}

TEST(Mixture, OfAFootprintOfMillionsOfTexelsIsThatOfTheWholeMap) {
  const Surface surface(test::wavy_map(32, 24, Wrap::repeat), Interpolation::smooth);
  const MixturePndf model(surface, 0.03);
  const Footprint wide = isotropic_footprint({3, 5}, 5000);
  const Footprint wider = isotropic_footprint({20, 11}, 50000);
  for (const glm::dvec2 s : {glm::dvec2(0.1, 0.05), glm::dvec2(-0.2, 0.15)}) {
    EXPECT_NEAR(test::density_of(model, wide, s) / test::density_of(model, wider, s), 1, 1e-6);
    const double exact = test::density_of(ExactPndf(surface, 0.03), wide, s);
    EXPECT_NEAR(test::density_of(model, wide, s) / exact, 1, 0.02);
  }
  EXPECT_NEAR(integral(test::image_of(model, wide, PndfGrid{})), 1, 1e-3);
}

TEST(Mixture, OfAFootprintMuchWiderThanAMapThatClampsIsExact) {
  const Surface surface(test::wavy_map(8, 8, Wrap::clamp), Interpolation::smooth);
  const Footprint wide = isotropic_footprint({4, 4}, 3000);
  const FastExactPndf exact(surface, 0.03);
  const glm::dvec2 s{0.1, 0.05};
  EXPECT_EQ(test::density_of(MixturePndf(surface, 0.03), wide, s), test::density_of(exact, wide, s));
  EXPECT_EQ(test::image_of(MixturePndf(surface, 0.03), wide, PndfGrid{}).density,
            test::image_of(exact, wide, PndfGrid{}).density);
}

TEST(Mixture, OfMoreElementsThanAreKeptIsTheSame) {
  const Surface surface(test::wavy_map(900, 700, Wrap::repeat), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({444, 321}, 90);  // 2.5 million elements with h = 0.3
  const double step = 0.3;
  const MixturePndf model(surface, 0.02, {step, {}, MixtureElements::corrected});
  const MixtureFrame frame(surface, {step, {}, MixtureElements::corrected}, footprint, glm::dvec2(0.02), 5);
  const PreparedMixture kept(frame, frame.rows());
  ASSERT_GT(kept.elements(), 2'000'000U);
  for (const glm::dvec2 s : {glm::dvec2(0.05, 0.1), glm::dvec2(-0.1, -0.05)}) {
    EXPECT_NEAR(test::density_of(model, footprint, s) / kept.density(s), 1, 1e-5);
    EXPECT_GT(kept.density(s), 0);
  }
}

TEST(Mixture, OfAConstantMapIsTheSameForEveryKind) {
  const Surface surface(test::constant_map({0.1, -0.2}, Wrap::repeat, 16), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({7.1, 3.2}, 2);
  const glm::dvec2 s{0.11, -0.195};
  const double flat = test::density_of(MixturePndf(surface, 0.01, {1, {}, MixtureElements::flat}), footprint, s);
  for (const MixtureElements kind : {MixtureElements::curved, MixtureElements::corrected}) {
    EXPECT_NEAR(test::density_of(MixturePndf(surface, 0.01, {1, {}, kind}), footprint, s) / flat, 1, 1e-5);
  }
  EXPECT_NEAR(flat / gaussian({0.01, 0.005}, 1e-4, 0, 1e-4), 1, 1e-5);
}

// Relative L1 against the smooth surface.
double error_of(const Surface& surface, const Footprint& footprint, double roughness, const MixtureSettings& settings,
                const PndfImage& reference) {
  const PndfImage image = test::image_of(MixturePndf(surface, roughness, settings), footprint, reference.grid);
  return test::relative_l1(image.density, reference.density);
}

TEST(Mixture, ErrorFallsWithTheSquareOfTheStepAndWithItsFourthPowerWhereCorrected) {
  const Surface surface(test::wavy_map(24, 24, Wrap::repeat, 0.15), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({11.3, 9.1}, 1.5);
  const double roughness = 0.02;
  // Without a cut that would be seen: single normals.
  const PndfGrid grid = fitted_window(surface, footprint, roughness, 24);
  PndfImage exact =
      test::image_of(ExactPndf(surface, roughness, {.subdivision = 16, .vertex_shift = true}), footprint, grid);
  const auto error = [&](double step, MixtureElements kind) {
    const MixturePndf model(surface, roughness, {step, 0.6, kind});
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(footprint, workspace);
    std::vector<double> values(grid.cells());
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const glm::dvec2 s = grid.center(column, row);
        pndf.evaluate({&s, 1}, {&values[grid.index(column, row)], 1});
      }
    }
    return test::relative_l1(values, exact.density);
  };
  for (const MixtureElements kind : {MixtureElements::flat, MixtureElements::curved}) {
    const double order = std::log2(error(1, kind) / error(0.5, kind));
    EXPECT_NEAR(order, 2, 0.35) << static_cast<int>(kind);
  }
  const double order = std::log2(error(1, MixtureElements::corrected) / error(0.5, MixtureElements::corrected));
  EXPECT_NEAR(order, 4, 0.6);
  RecordProperty("order where corrected", std::to_string(order));
}

TEST(Mixture, DrawsNormalsWithTheirDensityOnTenFootprints) {
  const Surface surface(test::wavy_map(64, 64, Wrap::repeat, 0.1), Interpolation::smooth);
  RandomStream random(3, 3);
  for (int k = 0; k < 10; ++k) {
    const glm::dvec2 center{64 * random.next_uniform(), 64 * random.next_uniform()};
    const double large = 0.2 + 6 * random.next_uniform();
    const double small = large * (0.1 + 0.9 * random.next_uniform());
    const Footprint footprint = test::turned_footprint(center, large, small, 3 * random.next_uniform());
    const MixturePndf model(surface, 0.02, {k % 2 == 0 ? 1.0 : 0.5, std::nullopt, k_kinds[k % 3]});
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(footprint, workspace);
    const PndfGrid grid = fitted_window(surface, footprint, 0.02, test::k_chi_square_cells);
    PndfImage fine;
    fine.grid = test::finer(grid);
    fine.density.resize(fine.grid.cells());
    for (int row = 0; row < fine.grid.rows; ++row) {
      for (int column = 0; column < fine.grid.columns; ++column) {
        fine.density[fine.grid.index(column, row)] = pndf.pdf(fine.grid.center(column, row));
      }
    }
    EXPECT_NEAR(integral(fine), 1, 2e-3) << "the density of what is drawn";
    EXPECT_LE(test::chi_square_deviate(pndf, grid, fine), 3.5) << k;
  }
}

TEST(Mixture, IsFourTimesCloserThanThePapersAtHalfATexel) {
  const Surface surface(test::wavy_map(32, 32, Wrap::repeat, 0.2), Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({15, 15}, 2);
  const PndfGrid grid = fitted_window(surface, footprint, 0.02, 64);
  const PndfImage exact =
      test::image_of(ExactPndf(surface, 0.02, {.subdivision = 8, .vertex_shift = true}), footprint, grid);
  const double plain = error_of(surface, footprint, 0.02, {0.5, {}, MixtureElements::curved}, exact);
  const double corrected = error_of(surface, footprint, 0.02, {0.5, {}, MixtureElements::corrected}, exact);
  EXPECT_LT(4 * corrected, plain) << corrected;
}

TEST(Mixture, TakesALinearSurfaceAsTheSmoothOne) {
  const auto map = test::wavy_map(32, 32, Wrap::repeat);
  EXPECT_EQ(MixturePndf(Surface(map, Interpolation::linear), 0.02).info().surface, Interpolation::smooth);
  EXPECT_EQ(MixturePndf(Surface(map, Interpolation::constant), 0.02).info().surface, Interpolation::constant);
}

TEST(MixtureLattice, HoldsAWholeNumberOfStepsInTheMap) {
  const auto map = test::wavy_map(10, 7, Wrap::repeat);
  const MixtureLattice lattice(*map, {0.3, 0.5, MixtureElements::curved});
  EXPECT_DOUBLE_EQ(lattice.step.x, 10.0 / 33);
  EXPECT_DOUBLE_EQ(lattice.step.y, 7.0 / 23);
  EXPECT_NEAR(lattice.deviation, 0.5 * 0.3, 0.005);
  EXPECT_DOUBLE_EQ(MixtureLattice(*test::wavy_map(1, 1, Wrap::repeat), {8, {}, MixtureElements::flat}).step.x, 1);
}

}  // namespace
}  // namespace glint
