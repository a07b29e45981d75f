#include "core/math/quadrature.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace glint {
namespace {

double integral_of_power(const GaussRule& rule, int degree) {
  double sum = 0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) sum += rule.weights[k] * std::pow(rule.nodes[k], degree);
  return sum;
}

TEST(GaussLegendre, HasDescendingNodesInsideAndWeightsThatSumToOne) {
  for (int n = 1; n <= k_largest_gauss_rule; ++n) {
    const GaussRule rule = gauss_legendre(n);
    ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(rule.weights.size(), static_cast<std::size_t>(n));
    EXPECT_LT(rule.nodes.front(), 1);
    EXPECT_GT(rule.nodes.back(), 0);
    for (std::size_t k = 1; k < rule.nodes.size(); ++k) EXPECT_LT(rule.nodes[k], rule.nodes[k - 1]);
    EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 1, 1e-15 * n);
  }
}

TEST(GaussLegendre, IsExactForPolynomialsOfDegree2nMinus1) {
  for (int n = 1; n <= k_largest_gauss_rule; ++n) {
    const GaussRule rule = gauss_legendre(n);
    for (int degree = 0; degree < 2 * n; ++degree) {
      EXPECT_NEAR(integral_of_power(rule, degree) * (degree + 1), 1, 2e-14) << n << " points, degree " << degree;
    }
  }
}

TEST(GaussLegendre, MissesDegree2nByItsKnownError) {
  for (int n = 1; n <= 8; ++n) {
    // n!^4 / ((2n + 1) (2n)!^2)
    const double error = std::exp(4 * std::lgamma(n + 1.0) - 2 * std::lgamma(2 * n + 1.0)) / (2 * n + 1);
    EXPECT_NEAR((1.0 / (2 * n + 1) - integral_of_power(gauss_legendre(n), 2 * n)) / error, 1, 1e-14 / error + 1e-12)
        << n;
  }
}

TEST(GaussLegendre, HasTheTabulatedRuleOfThreePoints) {
  const GaussRule rule = gauss_legendre(3);
  EXPECT_NEAR(rule.nodes[0], 0.5 + 0.5 * std::sqrt(0.6), 1e-16);
  EXPECT_NEAR(rule.nodes[1], 0.5, 1e-16);
  EXPECT_NEAR(rule.weights[0], 5.0 / 18, 1e-16);
  EXPECT_NEAR(rule.weights[1], 8.0 / 18, 1e-16);
}

}  // namespace
}  // namespace glint
