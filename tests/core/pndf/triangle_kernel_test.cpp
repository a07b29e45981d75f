// The double-precision kernel of one triangle against a slow twin: whitened by Gram-Schmidt in quad precision, then
// integrated adaptively in extended precision. 20 cases in each of ten hard regimes; GLINTSCOPE_KERNEL_CASES sets more
// (RESULTS.md holds a run of 10^4 in each).

#include "core/pndf/triangle_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/math/slow_simplex.h"

namespace glint {
namespace {

__extension__ using Quad = __float128;

Quad root(Quad x) {
  if (x <= 0) return 0;
  Quad r = std::sqrt(static_cast<long double>(x));
  for (int step = 0; step < 2; ++step) r = (r + x / r) / 2;
  return r;
}

using Quad4 = std::array<Quad, 4>;

Quad dot(const Quad4& a, const Quad4& b) {
  Quad sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += a[k] * b[k];
  return sum;
}

// Takes the part along the unit vector q out of x.
Quad take_out(const Quad4& q, Quad4& x) {
  const Quad along = dot(q, x);
  for (std::size_t k = 0; k < 4; ++k) x[k] -= along * q[k];
  return along;
}

Quad normalise(Quad4& x) {
  const Quad length = root(dot(x, x));
  for (Quad& entry : x) entry = length > 0 ? entry / length : 0;
  return length;
}

struct KernelCase {
  SurfaceTriangle triangle;
  SymmetricMatrix2 covariance;
  double roughness;
  glm::dvec2 s;
};

using Point = std::array<long double, 2>;

long double distance_to_segment(Point a, Point b) {
  const Point d{b[0] - a[0], b[1] - a[1]};
  const long double squared = d[0] * d[0] + d[1] * d[1];
  const long double t = squared > 0 ? std::clamp(-(a[0] * d[0] + a[1] * d[1]) / squared, 0.0L, 1.0L) : 0.0L;
  return std::hypot(a[0] + t * d[0], a[1] + t * d[1]);
}

long double distance_to_triangle(const std::array<Point, 3>& w) {
  const auto cross = [&](std::size_t a, std::size_t b) { return w[a][0] * w[b][1] - w[a][1] * w[b][0]; };
  const long double x = cross(0, 1);
  const long double y = cross(1, 2);
  const long double z = cross(2, 0);
  if ((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0)) return 0;
  return std::min({distance_to_segment(w[0], w[1]), distance_to_segment(w[1], w[2]), distance_to_segment(w[2], w[0])});
}

struct SlowValue {
  long double density;
  long double scale;  // the factor of the integral times min(1/2, 2 pi / twice the whitened area)
};

SlowValue slow_kernel(const KernelCase& c) {
  // W^T W = covariance^-1, W upper triangular.
  const Quad xx = c.covariance.xx;
  const Quad xy = c.covariance.xy;
  const Quad yy = c.covariance.yy;
  const Quad determinant = xx * yy - xy * xy;
  const Quad w11 = root(yy / determinant);
  const Quad w12 = -xy / determinant / w11;
  const Quad w22 = root(1 / yy);
  const auto& n = c.triangle.normals;
  const Quad r = c.roughness;
  Quad4 first{w11 * c.triangle.du, 0, (Quad(n[1].x) - n[0].x) / r, (Quad(n[1].y) - n[0].y) / r};
  Quad4 second{w12 * c.triangle.dv, w22 * c.triangle.dv, (Quad(n[2].x) - n[0].x) / r, (Quad(n[2].y) - n[0].y) / r};
  Quad4 offset{w11 * c.triangle.corner.x + w12 * c.triangle.corner.y, w22 * c.triangle.corner.y,
               (Quad(n[0].x) - c.s.x) / r, (Quad(n[0].y) - c.s.y) / r};
  const auto r11 = static_cast<long double>(normalise(first));
  const auto r12 = static_cast<long double>(take_out(first, second));
  const auto r22 = static_cast<long double>(normalise(second));
  const auto wx = static_cast<long double>(take_out(first, offset));
  const auto wy = static_cast<long double>(take_out(second, offset));
  const auto residual = static_cast<long double>(dot(offset, offset));
  const std::array<Point, 3> w{{{wx, wy}, {wx + r11, wy}, {wx + r12, wy + r22}}};
  const long double nearest = distance_to_triangle(w);
  const long double cut = std::sqrt(nearest * nearest + 80);  // beyond it, exp(-40) of what is nearest
  const auto vertex = [&](std::size_t k, long double x, long double y) {
    return test::SlowVertex<long double>{{w[k][0], w[k][1], 0, 0}, {x, y}};
  };
  const long double integral = test::slow_integral<long double>({vertex(0, 0, 0), vertex(1, 1, 0), vertex(2, 0, 1)},
                                                                cut, cut, 1, [](const auto&) { return 1.0L; });
  const auto legs = static_cast<long double>(Quad(c.triangle.du) * c.triangle.dv * w11 * w22 / (r * r));
  const long double factor = std::abs(legs) / (4 * std::numbers::pi_v<long double> * std::numbers::pi_v<long double>);
  const long double twice_area = std::abs(r11 * r22);
  return {factor * std::exp(-residual / 2) * integral,
          factor * std::min(0.5L, 2 * std::numbers::pi_v<long double> / twice_area)};
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_); }
  double log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }
  double normal() { return std::normal_distribution<double>()(random_); }
  glm::dvec2 normals() {
    const double x = normal();
    return {x, normal()};
  }
  struct Ellipse {
    double sigma;
    double ratio;
    double angle;
  };
  static SymmetricMatrix2 ellipse(const Ellipse& e) {
    const auto& [sigma, ratio, angle] = e;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double a = sigma * sigma;
    const double b = a / (ratio * ratio);
    return {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
  }

  // A texel's half under a footprint that sees it and a query near a point of it; `tail` deviations of the roughness
  // away.
  struct Recipe {  // to be written in braces, whose parts are drawn in order
    double roughness;
    SymmetricMatrix2 covariance;
    std::array<glm::dvec2, 3> normals;
    double tail;
  };
  KernelCase make(const Recipe& recipe) {
    const auto& [roughness, covariance, normals, tail] = recipe;
    KernelCase c{};
    const double leg = (random_() % 2 == 0 ? 1 : -1) * (random_() % 2 == 0 ? 1.0 : 0.25);
    const double x = uniform(0, 1);
    const double y = uniform(0, 1 - x);
    const glm::dvec2 seen = cholesky(covariance).apply(normals_or_zero());
    c.triangle = {seen - leg * glm::dvec2(x, y), leg, leg, normals};
    c.covariance = covariance;
    c.roughness = roughness;
    const double turn = uniform(0, 2 * std::numbers::pi);
    c.s = normals[0] + x * (normals[1] - normals[0]) + y * (normals[2] - normals[0]) +
          roughness * tail * glm::dvec2(std::cos(turn), std::sin(turn));
    return c;
  }

  // Of a slope of about `slope` a texel.
  std::array<glm::dvec2, 3> rough(double slope) {
    const glm::dvec2 n = 0.3 * normals();
    return {n, n + slope * normals(), n + slope * normals()};
  }
  double tail() { return std::abs(1.5 * normal()); }
  double angle() { return uniform(0, std::numbers::pi); }

 private:
  glm::dvec2 normals_or_zero() { return random_() % 8 == 0 ? glm::dvec2(0) : normals(); }

  std::mt19937_64 random_;
};

const std::string k_tails = "tails of 5 to 30 sigma";

struct Regime {
  std::string name;
  std::function<KernelCase(Draw&)> draw;
};

std::vector<Regime> regimes() {
  const auto plain = [](Draw& d) { return Draw::ellipse({d.log_uniform(0.3, 20), d.uniform(1, 4), d.angle()}); };
  return {
      {"ordinary",
       [=](Draw& d) {
         return d.make({d.log_uniform(0.002, 0.05), plain(d), d.rough(0.05), d.tail()});
       }},
      {"sigma_r 1e-5",
       [=](Draw& d) {
         return d.make({1e-5, plain(d), d.rough(d.log_uniform(1e-6, 0.1)), d.tail()});
       }},
      {"sigma_r 0.3",
       [=](Draw& d) {
         return d.make({0.3, plain(d), d.rough(0.2), d.tail()});
       }},
      {"det J = 0",
       [=](Draw& d) {
         auto n = d.rough(0.05);
         n[2] = n[0] + d.uniform(-1, 1) * (n[1] - n[0]);
         return d.make({d.log_uniform(1e-4, 0.05), plain(d), n, d.tail()});
       }},
      {"constant normals",
       [=](Draw& d) {
         auto n = d.rough(0);
         return d.make({d.log_uniform(1e-5, 0.3), plain(d), n, d.tail()});
       }},
      {"near rank 1",
       [=](Draw& d) {
         auto n = d.rough(0.05);
         n[2] = n[0] + d.uniform(-1, 1) * (n[1] - n[0]) + d.log_uniform(1e-16, 1e-6) * d.normals();
         return d.make({d.log_uniform(1e-4, 0.05), plain(d), n, d.tail()});
       }},
      {k_tails,
       [=](Draw& d) {
         return d.make({d.log_uniform(1e-3, 0.1), plain(d), d.rough(0.05), d.uniform(5, 30)});
       }},
      {"sigma_p 0.01",
       [=](Draw& d) {
         return d.make(
             {d.log_uniform(1e-3, 0.1), Draw::ellipse({0.01, d.uniform(1, 3), d.angle()}), d.rough(0.05), d.tail()});
       }},
      {"sigma_p 1000",
       [=](Draw& d) {
         return d.make(
             {d.log_uniform(1e-3, 0.1), Draw::ellipse({1000, d.uniform(1, 3), d.angle()}), d.rough(0.05), d.tail()});
       }},
      {"1 to 1000",
       [=](Draw& d) {
         const double angle = d.uniform(0, 1) < 0.5 ? std::numbers::pi / 4 : d.angle();
         return d.make(
             {d.log_uniform(1e-3, 0.1), Draw::ellipse({d.log_uniform(1, 30), 1000, angle}), d.rough(0.05), d.tail()});
       }},
  };
}

int cases_each() {
  const char* wanted = std::getenv("GLINTSCOPE_KERNEL_CASES");
  return wanted == nullptr ? 20 : std::atoi(wanted);
}

TEST(TriangleKernel, IsExactTo1e9InTenHardRegimes) {
  Draw draw(2016);
  for (const Regime& regime : regimes()) {
    double worst = 0;
    double worst_of_scale = 0;
    int counted = 0;
    for (int k = 0; k < cases_each(); ++k) {
      const KernelCase c = regime.draw(draw);
      const TriangleKernel kernel(c.triangle, whitening(c.covariance), glm::dvec2(c.roughness));
      const double value = kernel.density(c.s, 40);
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << regime.name;
      const SlowValue expected = slow_kernel(c);
      worst_of_scale =
          std::max(worst_of_scale, static_cast<double>(std::abs(value - expected.density) / expected.scale));
      // Where tails are meant, the whole of them: positive and right as far as a double can say.
      const bool tails = regime.name == k_tails;
      if (tails && expected.density > 1e-290L) {
        ASSERT_GT(value, 0) << regime.name << " case " << k;
        ASSERT_LE(std::abs(static_cast<double>(value / expected.density - 1)), 1e-8) << regime.name << " case " << k;
      }
      if (expected.density <= 1e-8L * expected.scale) continue;
      ++counted;
      const double error = std::abs(static_cast<double>(value / expected.density - 1));
      worst = std::max(worst, error);
      ASSERT_LE(error, 1e-9) << regime.name << " case " << k;
    }
    EXPECT_LE(worst_of_scale, 1e-9) << regime.name;
    if (regime.name != k_tails) {
      EXPECT_GT(counted, cases_each() / 3) << regime.name;
    }
    RecordProperty(regime.name, std::to_string(worst * 1e12) + "e-12 of " + std::to_string(counted));
    if (std::getenv("GLINTSCOPE_KERNEL_CASES") != nullptr) {
      std::printf("%-24s %8d cases, %8d with D > 1e-8 of the scale, largest relative error %.1e, of the scale %.1e\n",
                  regime.name.c_str(), cases_each(), counted, worst, worst_of_scale);
    }
  }
}

}  // namespace
}  // namespace glint
