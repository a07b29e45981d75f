#include "core/math/gaussian.h"

#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace glint {
namespace {

// An ellipse with deviations `large` and `small`, turned by `angle`.
SymmetricMatrix2 ellipse(double large, double small, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double a = large * large;
  const double b = small * small;
  return {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
}

TEST(Determinant, KeepsItsDigitsWhereTheProductsCancel) {
  // (2^27 + 1)(2^27 - 1) - 2^54 = -1, while the products themselves round to the same number.
  EXPECT_EQ(determinant({0x1p27 + 1, 0x1p27, 0x1p27 - 1}), -1);
  std::mt19937_64 random(1);
  for (int k = 0; k < 1000; ++k) {
    const auto x = static_cast<std::int64_t>(random() >> 12U) + 1;
    const auto y = x + static_cast<std::int64_t>(random() % 1000);
    const auto z = x + static_cast<std::int64_t>(random() % 1000);
    const auto exact = static_cast<double>(__int128{x} * y - __int128{z} * z);
    const double computed = determinant({static_cast<double>(x), static_cast<double>(z), static_cast<double>(y)});
    EXPECT_NEAR(computed, exact, 4e-16 * std::abs(exact)) << x << ' ' << y << ' ' << z;
  }
}

TEST(Eigenvalues, AreTheSquaredDeviationsOfAnEllipseLargestFirst) {
  for (const double angle : {0.0, 0.3, 0.7853981633974483, 1.5, 2.4}) {
    const glm::dvec2 values = eigenvalues(ellipse(20, 0.5, angle));
    EXPECT_NEAR(values.x, 400, 1e-10) << angle;
    EXPECT_NEAR(values.y, 0.25, 1e-10) << angle;
  }
  EXPECT_EQ(eigenvalues({3, 0, 3}), glm::dvec2(3, 3));
  EXPECT_EQ(eigenvalues({0, 0, 0}), glm::dvec2(0, 0));
  EXPECT_NEAR(eigenvalues({1, 2, 1}).y, -1, 1e-14);  // indefinite
}

TEST(Eigenvalues, KeepTheDigitsOfTheSmallerOne) {
  // Determinant 2^40, trace 2^41 + 1: 1/2 (1 - 2^-43) to first order. Half of trace minus root loses eleven digits
  // here.
  const SymmetricMatrix2 thin{0x1p40, 0x1p40, 0x1p40 + 1};
  EXPECT_NEAR(eigenvalues(thin).y, 0.5, 1e-12);
}

TEST(Whitening, SquaresToTheInverseCovariance) {
  for (const double ratio : {1.0, 3.0, 200.0, 1000.0}) {
    for (const double angle : {0.0, 0.2, 0.7853981633974483, 2.0}) {
      const SymmetricMatrix2 c = ellipse(50, 50 / ratio, angle);
      const Whitening w = whitening(c);
      // W^T W c = I; entries of the inverse are up to 1 / small^2, so an error of one ulp in c grows by ratio^2.
      const double xx = w.w11 * w.w11;
      const double xy = w.w11 * w.w12;
      const double yy = w.w12 * w.w12 + w.w22 * w.w22;
      const double tolerance = 1e-15 * ratio * ratio * 4;
      EXPECT_NEAR(xx * c.xx + xy * c.xy, 1, tolerance) << ratio << ' ' << angle;
      EXPECT_NEAR(xx * c.xy + xy * c.yy, 0, tolerance) << ratio << ' ' << angle;
      EXPECT_NEAR(xy * c.xx + yy * c.xy, 0, tolerance) << ratio << ' ' << angle;
      EXPECT_NEAR(xy * c.xy + yy * c.yy, 1, tolerance) << ratio << ' ' << angle;
      EXPECT_NEAR(w.determinant() * w.determinant() * determinant(c), 1, 1e-14) << ratio << ' ' << angle;
    }
  }
}

TEST(Whitening, OfAnOffsetIsItsDistanceInDeviations) {
  const double angle = 0.4;
  const Whitening w = whitening(ellipse(8, 0.5, angle));
  const auto length = [&](glm::dvec2 d) { return std::hypot(w.apply(d).x, w.apply(d).y); };
  EXPECT_NEAR(length({16 * std::cos(angle), 16 * std::sin(angle)}), 2, 1e-12);
  EXPECT_NEAR(length({-1.5 * std::sin(angle), 1.5 * std::cos(angle)}), 3, 1e-12);
}

TEST(Cholesky, TimesItsTransposeIsTheCovariance) {
  for (const double ratio : {1.0, 3.0, 1000.0}) {
    for (const double angle : {0.0, 0.2, 0.7853981633974483, 2.0}) {
      const SymmetricMatrix2 c = ellipse(50, 50 / ratio, angle);
      const CholeskyFactor l = cholesky(c);
      EXPECT_NEAR(l.l11 * l.l11, c.xx, 1e-12 * c.xx);
      EXPECT_NEAR(l.l11 * l.l21, c.xy, 1e-12 * c.xx);
      EXPECT_NEAR(l.l21 * l.l21 + l.l22 * l.l22, c.yy, 1e-12 * c.yy);
      EXPECT_EQ(l.apply({1, 0}), glm::dvec2(l.l11, l.l21));
      EXPECT_EQ(l.apply({0, 1}), glm::dvec2(0, l.l22));
    }
  }
}

TEST(NormalDensity, HasPinnedValues) {
  // d^T C^-1 d = (3 + 2 + 4) / 11 for d = (1, -1), worked by hand.
  EXPECT_NEAR(normal_density({1, -1}, {4, 1, 3}), std::exp(-0.5 * 9 / 11) / (6.283185307179586 * std::sqrt(11.0)),
              1e-16);
  EXPECT_NEAR(normal_density({0, 0}, {1, 0, 1}), 0.15915494309189535, 1e-16);
  EXPECT_EQ(normal_density({100, 0}, {1, 0, 1}), 0);
}

TEST(NormalCdf, KeepsItsRelativeAccuracyInTheLowerTail) {
  struct Value {
    double x;
    double phi;
  };
  for (const Value& value : {Value{0, 0.5}, Value{-1, 0.15865525393145705142}, Value{-5, 2.8665157187919391167e-7},
                             Value{-10, 7.6198530241605260660e-24}, Value{-20, 2.7536241186062336951e-89},
                             Value{-37, 5.7255712225245768e-300}}) {
    EXPECT_NEAR(normal_cdf(value.x) / value.phi, 1, 1e-13) << value.x;
    EXPECT_NEAR(normal_cdf(-value.x), 1 - value.phi, 1e-15) << value.x;
  }
  EXPECT_EQ(normal_cdf(-40), 0);
  EXPECT_EQ(normal_cdf(40), 1);
}

}  // namespace
}  // namespace glint
