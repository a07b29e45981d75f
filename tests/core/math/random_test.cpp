#include "core/math/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace glint {
namespace {

constexpr std::size_t k_draws = 1U << 16U;

std::vector<double> uniforms(const std::function<double(std::size_t)>& draw) {
  std::vector<double> values(k_draws);
  for (std::size_t k = 0; k < k_draws; ++k) values[k] = draw(k);
  return values;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, std::size_t lag) {
  double sum = 0;
  for (std::size_t k = 0; k + lag < a.size(); ++k) sum += (a[k] - 0.5) * (b[k + lag] - 0.5);
  return 12 * sum / static_cast<double>(a.size() - lag);
}

/// As even as chance makes it, and no more: a lattice is far too even. 255 degrees of freedom, five deviations.
void expect_uniform_and_uncorrelated(const std::vector<double>& values) {
  std::array<double, 256> bins{};
  for (const double value : values) bins[static_cast<std::size_t>(value * 256)] += 1;
  const double expected = static_cast<double>(values.size()) / 256;
  double chi_square = 0;
  for (const double bin : bins) chi_square += (bin - expected) * (bin - expected) / expected;
  EXPECT_NEAR(chi_square, 255, 5 * std::sqrt(2 * 255.0));
  for (const std::size_t lag : {1U, 2U, 16U, 256U}) {
    EXPECT_NEAR(correlation(values, values, lag), 0, 5 / std::sqrt(static_cast<double>(values.size()))) << lag;
  }
}

TEST(RandomStream, IsUniformInTheOpenUnitInterval) {
  RandomStream random(7, 0);
  const std::vector<double> values = uniforms([&](std::size_t) { return random.next_uniform(); });
  EXPECT_GT(*std::min_element(values.begin(), values.end()), 0);
  EXPECT_LT(*std::max_element(values.begin(), values.end()), 1);
  double sum = 0;
  double second = 0;
  for (const double value : values) {
    sum += value;
    second += (value - 0.5) * (value - 0.5);
  }
  EXPECT_NEAR(sum / k_draws, 0.5, 5 * std::sqrt(1.0 / 12 / k_draws));
  EXPECT_NEAR(second / k_draws, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / k_draws));
  expect_uniform_and_uncorrelated(values);
}

TEST(RandomStream, StreamsAndSeedsThatFollowEachOtherAreIndependent) {
  expect_uniform_and_uncorrelated(uniforms([](std::size_t k) { return RandomStream(7, k).next_uniform(); }));
  expect_uniform_and_uncorrelated(uniforms([](std::size_t k) { return RandomStream(k, 7).next_uniform(); }));
}

TEST(RandomStream, StreamsAndSeedsThatDifferInHighBitsOnlyAreIndependent) {
  expect_uniform_and_uncorrelated(uniforms([](std::size_t k) { return RandomStream(7, k << 44U).next_uniform(); }));
  expect_uniform_and_uncorrelated(uniforms([](std::size_t k) { return RandomStream(k << 44U, 7).next_uniform(); }));
}

TEST(RandomStream, TwoStreamsOfOneSeedAreUncorrelated) {
  RandomStream first(7, 1);
  RandomStream second(7, 2);
  RandomStream other_seed(8, 1);
  const std::vector<double> a = uniforms([&](std::size_t) { return first.next_uniform(); });
  const std::vector<double> b = uniforms([&](std::size_t) { return second.next_uniform(); });
  const std::vector<double> c = uniforms([&](std::size_t) { return other_seed.next_uniform(); });
  const double tolerance = 5 / std::sqrt(static_cast<double>(k_draws));
  for (const std::size_t lag : {0U, 1U, 2U}) {
    EXPECT_NEAR(correlation(a, b, lag), 0, tolerance);
    EXPECT_NEAR(correlation(a, c, lag), 0, tolerance);
  }
}

TEST(RandomStream, RepeatsAndGoesOnFromWhereItIs) {
  RandomStream a(11, 5);
  RandomStream b(11, 5);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(a.next_bits(), b.next_bits());
  RandomStream copy = a;
  EXPECT_EQ(copy.next_uniform(), a.next_uniform());
  EXPECT_NE(a.next_uniform(), a.next_uniform());
}

// Saved seeds must go on giving the same maps and pictures. (The numbers are those of PCG32 written anew in Python.)
TEST(RandomStream, GivesTheNumbersItAlwaysGave) {
  RandomStream random(7, 3);
  EXPECT_EQ(random.next_bits(), 738043282U);
  EXPECT_EQ(random.next_bits(), 4285658917U);
}

TEST(RandomStream, NormalDeviatesHaveTheMomentsOfANormal) {
  RandomStream random(7, 0);
  std::vector<double> values(k_draws + 1);  // odd: the last pair gives one number
  random.fill_normal(values);
  std::array<double, 5> moments{};
  double neighbours = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (std::size_t power = 1; power < 5; ++power) {
      moments[power] += std::pow(values[k], static_cast<double>(power)) / static_cast<double>(values.size());
    }
    if (k > 0) neighbours += values[k] * values[k - 1] / static_cast<double>(values.size());
  }
  const double deviation = 1 / std::sqrt(static_cast<double>(values.size()));
  EXPECT_NEAR(moments[1], 0, 5 * deviation);
  EXPECT_NEAR(moments[2], 1, 5 * deviation * std::sqrt(2.0));
  EXPECT_NEAR(moments[3], 0, 5 * deviation * std::sqrt(15.0));
  EXPECT_NEAR(moments[4], 3, 5 * deviation * std::sqrt(96.0));
  EXPECT_NEAR(neighbours, 0, 5 * deviation);
  EXPECT_NE(values.back(), 0);
}

TEST(RandomStream, FillsNothingWithNothing) {
  RandomStream filled(7, 0);
  filled.fill_normal({});
  EXPECT_EQ(filled.next_bits(), RandomStream(7, 0).next_bits());
}

}  // namespace
}  // namespace glint
