#include "core/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/random.h"
#include "core/surface/catmull_rom.h"

namespace glint {
namespace {

constexpr Interpolation k_all[] = {Interpolation::linear, Interpolation::smooth, Interpolation::constant};

std::shared_ptr<const NormalMap> map_of(int width, int height, Wrap wrap,
                                        const std::function<glm::dvec2(int, int)>& normal) {
  std::vector<glm::vec2> normals;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) normals.emplace_back(normal(i, j));
  }
  return std::make_shared<NormalMap>(width, height, std::move(normals), wrap);
}

std::shared_ptr<const NormalMap> rough_map(int width, int height, Wrap wrap) {
  RandomStream random(3, 0);
  return map_of(width, height, wrap,
                [&](int, int) { return glm::dvec2(random.next_uniform() - 0.5, random.next_uniform() - 0.5); });
}

void expect_near(glm::dvec2 a, glm::dvec2 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(CatmullRom, WeightsSumToOneAndReproduceQuadratics) {
  for (double x = 0; x <= 1; x += 1.0 / 64) {
    const CubicWeights w = catmull_rom(x);
    const CubicWeights d = catmull_rom_derivative(x);
    const CubicWeights dd = catmull_rom_second_derivative(x);
    const auto moment = [](const CubicWeights& weights, double power) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += weights[static_cast<std::size_t>(k)] * std::pow(k - 1.0, power);
      return sum;
    };
    EXPECT_NEAR(moment(w, 0), 1, 1e-15);
    EXPECT_NEAR(moment(w, 1), x, 1e-15);
    EXPECT_NEAR(moment(w, 2), x * x, 1e-15);
    EXPECT_NEAR(moment(d, 0), 0, 1e-14);
    EXPECT_NEAR(moment(d, 1), 1, 1e-14);
    EXPECT_NEAR(moment(d, 2), 2 * x, 1e-14);
    EXPECT_NEAR(moment(dd, 0), 0, 1e-14);
    EXPECT_NEAR(moment(dd, 1), 0, 1e-14);
    EXPECT_NEAR(moment(dd, 2), 2, 1e-14);
  }
}

TEST(CatmullRom, PassesThroughItsSamplesWithCentralDifferencesAsSlopes) {
  EXPECT_EQ(catmull_rom(0), (CubicWeights{0, 1, 0, 0}));
  EXPECT_EQ(catmull_rom(1), (CubicWeights{0, 0, 1, 0}));
  EXPECT_EQ(catmull_rom_derivative(0), (CubicWeights{-0.5, 0, 0.5, 0}));
  EXPECT_EQ(catmull_rom_derivative(1), (CubicWeights{0, -0.5, 0, 0.5}));
}

TEST(CatmullRom, OvershootsByItsBoundAndNoMore) {
  double worst = 0;
  for (double y = 0; y <= 1; y += 1.0 / 64) {
    for (double x = 0; x <= 1; x += 1.0 / 64) {
      double negative = 0;
      for (const double wx : catmull_rom(x)) {
        for (const double wy : catmull_rom(y)) negative += std::max(0.0, -wx * wy);
      }
      worst = std::max(worst, negative);
    }
  }
  EXPECT_NEAR(worst, k_catmull_rom_overshoot, 1e-15);  // reached in the middle of a cell
}

TEST(Surface, HasTheTexelsNormalAtItsCentre) {
  const auto map = rough_map(6, 5, Wrap::repeat);
  for (const Interpolation interpolation : k_all) {
    const Surface surface(map, interpolation);
    for (int j = 0; j < 5; ++j) {
      for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(surface.normal({i + 0.5, j + 0.5}), glm::dvec2(map->texel(i, j)));
      }
    }
  }
}

TEST(Surface, RepeatsOrStopsAsItsMapDoes) {
  for (const Interpolation interpolation : k_all) {
    const Surface repeats(rough_map(6, 5, Wrap::repeat), interpolation);
    const Surface stops(rough_map(6, 5, Wrap::clamp), interpolation);
    for (double v = -7.3; v < 12; v += 0.77) {
      for (double u = -8.1; u < 14; u += 0.71) {
        expect_near(repeats.normal({u, v}), repeats.normal({u + 18, v - 10}), 1e-13);
        // Beyond the last Catmull-Rom sample nothing changes along the axis.
        if (u < -1.5) expect_near(stops.normal({u, v}), stops.normal({-100, v}), 1e-15);
        if (v > 6.5) expect_near(stops.normal({u, v}), stops.normal({u, 1000}), 1e-15);
      }
    }
  }
}

TEST(LinearSurface, IsCutFromTheUpperRightToTheLowerLeftCorner) {
  // One corner of a cell is lifted: the half of the cell beyond the diagonal must not see it.
  const auto with_peak = [](int pi, int pj) {
    return Surface(
        map_of(8, 8, Wrap::repeat, [=](int i, int j) { return glm::dvec2(i == pi && j == pj ? 0.5 : 0.0, 0); }),
        Interpolation::linear);
  };
  const Surface upper_left = with_peak(3, 3);
  EXPECT_EQ(upper_left.normal({3.5 + 0.7, 3.5 + 0.7}).x, 0);
  EXPECT_DOUBLE_EQ(upper_left.normal({3.5 + 0.25, 3.5 + 0.25}).x, 0.25);
  const Surface upper_right = with_peak(4, 3);
  EXPECT_DOUBLE_EQ(upper_right.normal({4.0, 4.0}).x, 0.25);  // the middle of the diagonal
  const Surface lower_right = with_peak(4, 4);
  EXPECT_EQ(lower_right.normal({3.5 + 0.3, 3.5 + 0.3}).x, 0);
  EXPECT_DOUBLE_EQ(lower_right.normal({3.5 + 0.75, 3.5 + 0.75}).x, 0.25);
}

TEST(ConstantSurface, KeepsOneNormalAllOverATexelSquare) {
  const auto map = rough_map(4, 4, Wrap::repeat);
  const Surface surface(map, Interpolation::constant);
  for (const glm::dvec2 inside : {glm::dvec2(0, 0), glm::dvec2(0.999, 0), glm::dvec2(0.3, 0.999)}) {
    EXPECT_EQ(surface.normal(glm::dvec2(2, 1) + inside), glm::dvec2(map->texel(2, 1)));
  }
}

TEST(Surface, ReproducesAffineNormalsAwayFromTheBorder) {
  const auto affine = [](double u, double v) {
    return glm::dvec2(0.125 + u / 512 - v / 1024, -0.25 + u / 256 + v / 512);
  };
  const auto map = map_of(32, 32, Wrap::clamp, [&](int i, int j) { return affine(i + 0.5, j + 0.5); });
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
    const Surface surface(map, interpolation);
    for (double v = 3; v < 29; v += 0.83) {
      for (double u = 3; u < 29; u += 0.79) {
        expect_near(surface.normal({u, v}), affine(u, v), 1e-15);
        const glm::dmat2 jacobian = surface.jacobian({u, v});
        expect_near(jacobian[0], {1.0 / 512, 1.0 / 256}, 1e-15);
        expect_near(jacobian[1], {-1.0 / 1024, 1.0 / 512}, 1e-15);
      }
    }
  }
}

TEST(Surface, JacobianIsTheDerivativeOfTheNormal) {
  constexpr double h = 1e-5;
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const auto map = rough_map(7, 6, wrap);
    for (const Interpolation interpolation : k_all) {
      const Surface surface(map, interpolation);
      RandomStream random(9, 0);
      for (int k = 0; k < 400; ++k) {
        const glm::dvec2 u{20 * random.next_uniform() - 7, 20 * random.next_uniform() - 7};
        if (interpolation != Interpolation::smooth) {
          // Differences across an edge say nothing.
          const double x = u.x - 0.5 - std::floor(u.x - 0.5);
          const double y = u.y - 0.5 - std::floor(u.y - 0.5);
          const double edge = std::min({x, 1 - x, y, 1 - y, std::abs(x + y - 1), std::abs(x - 0.5), std::abs(y - 0.5)});
          if (edge < 2 * h) continue;
        }
        const glm::dmat2 jacobian = surface.jacobian(u);
        expect_near(jacobian[0],
                    (surface.normal(u + glm::dvec2(h, 0)) - surface.normal(u - glm::dvec2(h, 0))) / (2 * h), 1e-8);
        expect_near(jacobian[1],
                    (surface.normal(u + glm::dvec2(0, h)) - surface.normal(u - glm::dvec2(0, h))) / (2 * h), 1e-8);
      }
    }
  }
}

TEST(LinearSurface, TakesTheLowerRightTriangleOnAnEdge) {
  const auto map = rough_map(8, 8, Wrap::repeat);
  const Surface surface(map, Interpolation::linear);
  EXPECT_EQ(surface.jacobian({3.5, 3.75}), surface.jacobian({3.625, 3.75}));  // a vertical edge
  EXPECT_EQ(surface.jacobian({3.75, 3.5}), surface.jacobian({3.75, 3.625}));  // a horizontal edge
  EXPECT_EQ(surface.jacobian({4.0, 4.0}), surface.jacobian({4.25, 4.25}));    // the diagonal
  EXPECT_NE(surface.jacobian({4.0, 4.0}), surface.jacobian({3.75, 3.75}));
}

TEST(Surface, WorksOnTheSmallestMaps) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    for (const Interpolation interpolation : k_all) {
      const Surface one(map_of(1, 1, wrap, [](int, int) { return glm::dvec2(0.25, -0.5); }), interpolation);
      expect_near(one.normal({12.3, -7.9}), {0.25, -0.5}, 1e-15);
      expect_near(one.jacobian({12.3, -7.9})[0], {0, 0}, 1e-15);
      const Surface row(map_of(4, 1, wrap, [](int i, int) { return glm::dvec2(0.125 * i, 0); }), interpolation);
      expect_near(row.normal({1.7, 0.1}), row.normal({1.7, 55.6}), 1e-15);
    }
  }
}

}  // namespace
}  // namespace glint
