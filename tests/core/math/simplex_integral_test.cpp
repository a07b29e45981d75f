#include "core/math/simplex_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/math/slow_simplex.h"

namespace glint {
namespace {

std::array<glm::dvec2, 3> corners(const WhitenedTriangle& t) {
  return {t.w0, t.w0 + glm::dvec2(t.r11, 0), t.w0 + glm::dvec2(t.r12, t.r22)};
}

// The distance of the origin from a filled triangle, by ternary search along its rays: plain rather than fast.
double nearest_distance(const WhitenedTriangle& t) {
  const auto at = [&](double x, double y) { return std::hypot(t.w0.x + x * t.r11 + y * t.r12, t.w0.y + y * t.r22); };
  const auto smallest = [](const std::function<double(double)>& f, double lo, double hi) {
    for (int step = 0; step < 60; ++step) {
      const double a = lo + (hi - lo) / 3;
      const double b = hi - (hi - lo) / 3;
      (f(a) < f(b) ? hi : lo) = f(a) < f(b) ? b : a;
    }
    return f((lo + hi) / 2);
  };
  return smallest([&](double y) { return smallest([&](double x) { return at(x, y); }, 0, 1 - y); }, 0, 1);
}

template <class Real, class Weight>
Real slow_weighted(const WhitenedTriangle& t, int least_points, const Weight& weight) {
  const auto w = corners(t);
  const auto vertex = [](glm::dvec2 q, Real x, Real y) {
    return test::SlowVertex<Real>{{static_cast<Real>(q.x), static_cast<Real>(q.y), 0, 0}, {x, y}};
  };
  const double nearest = nearest_distance(t);
  // Nothing beyond matters: exp(-40) of the value at the nearest point.
  const auto cut = static_cast<Real>(std::sqrt(nearest * nearest + 80) + 1e-6);
  return test::slow_integral<Real>({vertex(w[0], 0, 0), vertex(w[1], 1, 0), vertex(w[2], 0, 1)}, cut, cut, least_points,
                                   weight);
}

// In long double for the figures of accuracy, in double for the long sweeps.
template <class Real = double>
Real slow(const WhitenedTriangle& t) {
  return slow_weighted<Real>(t, 1, [](const auto&) { return Real(1); });
}

struct Regime {
  std::string name;
  std::function<WhitenedTriangle(std::mt19937_64&)> draw;
};

double uniform(std::mt19937_64& random, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(random);
}
double log_uniform(std::mt19937_64& random, double lo, double hi) {
  return std::exp(uniform(random, std::log(lo), std::log(hi)));
}
double either_sign(std::mt19937_64& random, double value) {
  return random() % 2 == 0 ? value : -value;
}
glm::dvec2 around(std::mt19937_64& random, double reach) {
  return {uniform(random, -reach, reach), uniform(random, -reach, reach)};
}
// A triangle of about `size`, whose edge lengths differ by up to `thinness`, near `where`.
WhitenedTriangle triangle(std::mt19937_64& random, double size, double thinness, glm::dvec2 where) {
  WhitenedTriangle t{where, either_sign(random, size), uniform(random, -size, size),
                     either_sign(random, size * thinness)};
  // Somewhere on the triangle lies on `where`.
  const double x = uniform(random, 0, 1);
  const double y = uniform(random, 0, 1 - x);
  t.w0 = t.w0 - glm::dvec2(x * t.r11 + y * t.r12, y * t.r22);
  return t;
}

std::vector<Regime> regimes() {
  return {
      {"tiny", [](auto& r) { return triangle(r, log_uniform(r, 1e-4, 1e-2), 1, around(r, 3)); }},
      {"small", [](auto& r) { return triangle(r, log_uniform(r, 0.01, 0.5), 1, around(r, 4)); }},
      {"medium", [](auto& r) { return triangle(r, log_uniform(r, 0.5, 4), 1, around(r, 4)); }},
      {"large", [](auto& r) { return triangle(r, log_uniform(r, 4, 30), 1, around(r, 6)); }},
      {"huge", [](auto& r) { return triangle(r, log_uniform(r, 30, 300), 1, around(r, 8)); }},
      {"thin", [](auto& r) { return triangle(r, log_uniform(r, 0.5, 100), log_uniform(r, 1e-6, 0.05), around(r, 4)); }},
      {"far and small",
       [](auto& r) {
         return triangle(r, log_uniform(r, 1e-3, 1), 1, {uniform(r, 5, 21), uniform(r, -21, -5)});
       }},
      {"far and large",
       [](auto& r) {
         return triangle(r, log_uniform(r, 1, 20), 1, {uniform(r, -19, -5), uniform(r, 5, 19)});
       }},
      {"a line (r22 = 0)", [](auto& r) { return triangle(r, log_uniform(r, 1e-3, 100), 0, around(r, 4)); }},
      {"a line (r11 = 0)",
       [](auto& r) {
         WhitenedTriangle t = triangle(r, log_uniform(r, 1e-3, 50), 1, around(r, 3));
         t.r11 = 0;
         return t;
       }},
      {"a point",
       [](auto& r) {
         return WhitenedTriangle{around(r, 20), 0, 0, 0};
       }},
  };
}

TEST(SimplexIntegral, AgreesWithSubdivisionInEveryRegime) {
  std::mt19937_64 random(11);
  for (const Regime& regime : regimes()) {
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      const WhitenedTriangle t = regime.draw(random);
      if (nearest_distance(t) > 35) continue;
      const auto expected = slow<long double>(t);
      const auto error = static_cast<double>(std::abs(gaussian_over_simplex(t) / expected - 1));
      worst = std::max(worst, error);
      EXPECT_LE(error, 1e-10) << regime.name << ": w0 " << t.w0.x << ' ' << t.w0.y << " R " << t.r11 << ' ' << t.r12
                              << ' ' << t.r22;
    }
    RecordProperty("largest relative error, " + regime.name, std::to_string(worst * 1e12) + "e-12");
  }
}

TEST(SimplexIntegral, OfTheWholePlaneOrHalfOfItIsKnown) {
  // 2 pi over twice the area, for a triangle that holds all; half of that where the origin is on an edge.
  EXPECT_NEAR(gaussian_over_simplex({{-100, -100}, 1000, 0, 1000}) * 1e6, 2 * std::numbers::pi, 1e-14);
  EXPECT_NEAR(gaussian_over_simplex({{-100, 0}, 1000, 0, 1000}) * 1e6, std::numbers::pi, 1e-14);
  EXPECT_NEAR(gaussian_over_simplex({{0, 0}, 1000, 0, 1000}) * 1e6, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(gaussian_over_simplex({{3, 4}, 0, 0, 0}), 0.5 * std::exp(-12.5), 1e-17);
}

TEST(SimplexIntegral, DoesNotDependOnTheOrderOfTheVertices) {
  std::mt19937_64 random(5);
  for (const Regime& regime : regimes()) {
    for (int k = 0; k < 50; ++k) {
      const WhitenedTriangle t = regime.draw(random);
      const auto w = corners(t);
      // The same triangle with its last vertex first and turned so that the new first leg lies along the x axis.
      const glm::dvec2 leg = w[0] - w[2];
      const double length = std::hypot(leg.x, leg.y);
      if (length == 0 || nearest_distance(t) > 30) continue;
      const glm::dvec2 axis = leg / length;
      const auto turned = [&](glm::dvec2 v) {
        return glm::dvec2{axis.x * v.x + axis.y * v.y, axis.x * v.y - axis.y * v.x};
      };
      const glm::dvec2 second = turned(w[1] - w[2]);
      const double other = gaussian_over_simplex({turned(w[2]), length, second.x, second.y});
      // Turning moves the vertices by a rounding error of their coordinates: 1e-13 where they are 300 away.
      EXPECT_NEAR(other / gaussian_over_simplex(t), 1, 3e-10) << regime.name;
    }
  }
}

// Of a fixed shape, as large as `length`, whose farthest vertex lies about `reach` from the origin.
WhitenedTriangle with_length(double length, double reach, double shape) {
  return {{reach * std::cos(0.7) - length, reach * std::sin(0.7)}, length, shape * length, 0.4 * length};
}

// The points of the rule that the longest edge asks for.
int points_for(const WhitenedTriangle& t) {
  const auto w = corners(t);
  double longest = 0;
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 edge = w[k] - w[(k + 1) % 3];
    longest = std::max(longest, std::hypot(edge.x, edge.y));
    reach = std::max(reach, std::hypot(w[k].x, w[k].y));
  }
  return gauss_points(longest, reach);
}

TEST(SimplexIntegral, DoesNotJumpWhereTheRuleChanges) {
  double largest = 0;
  int changes = 0;
  for (const double reach : {0.5, 1.0, 3.0, 5.0, 8.0, 15.0, 30.0}) {
    for (const double shape : {0.1, 0.5, 0.9}) {
      double before = 1e-3;
      for (double length = before; length < 4; length *= 1.01) {
        double lo = before;
        double hi = length;
        before = length;
        if (points_for(with_length(lo, reach, shape)) == points_for(with_length(hi, reach, shape))) continue;
        const int points = points_for(with_length(lo, reach, shape));
        for (int halving = 0; halving < 60; ++halving) {
          const double middle = 0.5 * (lo + hi);
          (points_for(with_length(middle, reach, shape)) == points ? lo : hi) = middle;
        }
        const double jump =
            gaussian_over_simplex(with_length(hi, reach, shape)) / gaussian_over_simplex(with_length(lo, reach, shape));
        largest = std::max(largest, std::abs(jump - 1));
        ++changes;
      }
    }
  }
  EXPECT_GT(changes, 100);
  EXPECT_LE(largest, 2e-11);
  RecordProperty("largest relative jump", std::to_string(largest * 1e12) + "e-12");
}

TEST(SimplexIntegral, DoesNotJumpWhereItTurnsToClosedFormsOrCutsItsWindow) {
  // A large triangle whose second nearest edge moves through the distance from which the half plane takes over, and
  // through the window's end; then one whose fibres pass from Gauss's rule to erfc.
  for (double second = 8.5; second < 10.6; second += 0.05) {
    for (const double first : {-8.0, -0.9, 0.0, 2.0}) {
      const WhitenedTriangle t{{-second, -first}, 60, 0, 60};
      EXPECT_NEAR(gaussian_over_simplex(t) / slow(t), 1, 1e-10) << second << ' ' << first;
    }
  }
  for (double height = 0.3; height < 0.7; height += 0.02) {
    for (const double eta : {-4.5, -2.0, -0.2, 0.5, 3.7, 7.0}) {
      const WhitenedTriangle t{{-3, eta}, 10, 4, height};
      EXPECT_NEAR(gaussian_over_simplex(t) / slow(t), 1, 1e-10) << height << ' ' << eta;
    }
  }
}

TEST(SimplexIntegral, ShrinksAsTheTriangleMovesAway) {
  for (const double size : {0.01, 0.4, 1.7, 3.2, 20.0}) {
    double before = 1;
    for (double distance = 0; distance < 45; distance += 0.01) {
      const double value = gaussian_over_simplex({{distance, 0.3}, size, 0.2 * size, size});
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << size << ' ' << distance;
      ASSERT_LE(value, before) << size << ' ' << distance;
      before = value;
    }
    EXPECT_EQ(before, 0) << size;
  }
}

TEST(SimplexIntegral, LeavesOutNoMoreThanWhatLiesBeyondTheCut) {
  std::mt19937_64 random(3);
  int cut_away = 0;
  for (const Regime& regime : regimes()) {
    for (int k = 0; k < 200; ++k) {
      const WhitenedTriangle t = regime.draw(random);
      const double cut = uniform(random, 0.5, 8);
      const double all = gaussian_over_simplex(t);
      const double part = gaussian_over_simplex(t, cut);
      EXPECT_GE(part, 0);
      EXPECT_LE(part, all * (1 + 1e-10)) << regime.name;
      if (part == 0) {
        EXPECT_GE(nearest_distance(t), cut * (1 - 1e-9)) << regime.name;
        ++cut_away;
      }
      // Every point beyond has exp(-cut^2 / 2) at most, over an area of 1/2.
      EXPECT_LE(all - part, 0.5 * std::exp(-0.5 * cut * cut) * (1 + 1e-9) + 1e-10 * all) << regime.name << ' ' << cut;
    }
  }
  EXPECT_GT(cut_away, 100);
}

TEST(WeightedSimplexIntegral, WithWeightOneIsThePlainIntegral) {
  std::mt19937_64 random(17);
  for (const Regime& regime : regimes()) {
    for (int k = 0; k < 60; ++k) {
      const WhitenedTriangle t = regime.draw(random);
      if (nearest_distance(t) > 35) continue;
      const double weighted = weighted_gaussian_over_simplex(t, 40, [](glm::dvec2) { return 1.0; });
      EXPECT_NEAR(weighted / gaussian_over_simplex(t), 1, 1e-10)
          << regime.name << ": w0 " << t.w0.x << ' ' << t.w0.y << " R " << t.r11 << ' ' << t.r12 << ' ' << t.r22;
    }
  }
}

// The folded footprint over one cell, where its narrowest deviation is 32 texels; and a plane, far steeper.
TEST(WeightedSimplexIntegral, OfASmoothWeightAgreesWithSubdivision) {
  const auto footprint = [](auto x, auto y) { return std::exp(-((x + 85) * (x + 85) + (y - 40) * (y - 40)) / 2048); };
  const auto plane = [](auto x, auto y) { return 1 + x - y / 2; };
  std::mt19937_64 random(23);
  for (const Regime& regime : regimes()) {
    double worst = 0;
    const auto compare = [&](const WhitenedTriangle& t, const auto& weight) {
      const double weighted = weighted_gaussian_over_simplex(t, 40, [&](glm::dvec2 x) { return weight(x.x, x.y); });
      const long double expected = slow_weighted<long double>(t, 12, [&](const auto& x) { return weight(x[0], x[1]); });
      const auto error = static_cast<double>(std::abs(weighted / expected - 1));
      worst = std::max(worst, error);
      EXPECT_LE(error, 1e-10) << regime.name << ": w0 " << t.w0.x << ' ' << t.w0.y << " R " << t.r11 << ' ' << t.r12
                              << ' ' << t.r22;
    };
    for (int k = 0; k < 15; ++k) {
      const WhitenedTriangle t = regime.draw(random);
      if (nearest_distance(t) > 30) continue;
      compare(t, footprint);
      compare(t, plane);
    }
    RecordProperty("largest relative error, " + regime.name, std::to_string(worst * 1e12) + "e-12");
  }
}

TEST(WeightedSimplexIntegral, FindsTheCentroidOfTinyAndHugeTriangles) {
  const auto x_of = [](glm::dvec2 x) { return x.x; };
  // Tiny: the integral of x over the simplex is 1/6. Huge with the origin inside at x = 0.2: x there times 2 pi / area.
  EXPECT_NEAR(weighted_gaussian_over_simplex({{0, 0}, 1e-6, 0, 1e-6}, 40, x_of), 1.0 / 6, 1e-12);
  EXPECT_NEAR(weighted_gaussian_over_simplex({{-60, -90}, 300, 0, 300}, 40, x_of) * 9e4 / (2 * std::numbers::pi), 0.2,
              1e-11);
}

}  // namespace
}  // namespace glint
