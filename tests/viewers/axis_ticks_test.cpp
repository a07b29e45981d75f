#include "viewers/pndf/axis_ticks.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::view {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pointwise;

MATCHER(Close, "") {
  const auto [a, b] = arg;
  return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b));
}

TEST(RoundedUpStep, IsOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(rounded_up_step(1), 1);
  EXPECT_DOUBLE_EQ(rounded_up_step(1.01), 2);
  EXPECT_DOUBLE_EQ(rounded_up_step(2.1), 5);
  EXPECT_DOUBLE_EQ(rounded_up_step(5.1), 10);
  EXPECT_NEAR(rounded_up_step(0.03), 0.05, 1e-15);
}

TEST(LinearTicks, StandAtMultiplesOfTheStep) {
  EXPECT_THAT(linear_ticks(-1, 1, 5), Pointwise(Close(), {-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_THAT(linear_ticks(0.13, 0.41, 4), Pointwise(Close(), {0.2, 0.3, 0.4}));
}

TEST(LinearTicks, AreNeverMoreThanAsked) {
  for (const double width : {1e-9, 0.37, 1.0, 2.0, 9.99, 1e7}) {
    for (int most = 2; most < 12; ++most) {
      EXPECT_LE(linear_ticks(0.3, 0.3 + width, most).size(), static_cast<std::size_t>(most)) << width;
    }
  }
}

TEST(LinearTicks, AreNoneInAnEmptyRange) {
  EXPECT_THAT(linear_ticks(1, 1, 5), IsEmpty());
  EXPECT_THAT(linear_ticks(2, 1, 5), IsEmpty());
  EXPECT_THAT(linear_ticks(0, std::numeric_limits<double>::infinity(), 5), IsEmpty());
  EXPECT_THAT(linear_ticks(0, std::numeric_limits<double>::quiet_NaN(), 5), IsEmpty());
}

TEST(LogTicks, AreDecades) {
  EXPECT_THAT(log_ticks(0.01, 100, 9), Pointwise(Close(), {0.01, 0.1, 1.0, 10.0, 100.0}));
  EXPECT_THAT(log_ticks(0.02, 200, 9), Pointwise(Close(), {0.1, 1.0, 10.0, 100.0}));
}

TEST(LogTicks, AreThinnedEvenly) {
  EXPECT_THAT(log_ticks(1e-8, 1, 3), Pointwise(Close(), {1e-8, 1e-5, 1e-2}));
}

TEST(LogTicks, AreOneTwoFiveWithinADecade) {
  EXPECT_THAT(log_ticks(1.5, 8, 5), Pointwise(Close(), {2.0, 5.0}));
  EXPECT_THAT(log_ticks(0.9, 3, 5), Pointwise(Close(), {1.0, 2.0}));
}

TEST(LogTicks, AreNoneWhereThereIsNoLogarithm) {
  EXPECT_THAT(log_ticks(0, 1, 5), IsEmpty());
  EXPECT_THAT(log_ticks(-1, 1, 5), IsEmpty());
}

TEST(TickTexts, AgreeInTheirDecimals) {
  EXPECT_THAT(tick_texts({-0.5, 0, 0.5}), ElementsAre("−0.5", "0.0", "0.5"));
  EXPECT_THAT(tick_texts({0, 5, 10}), ElementsAre("0", "5", "10"));
  EXPECT_THAT(tick_texts(linear_ticks(0, 0.3, 4)), ElementsAre("0.0", "0.1", "0.2", "0.3"));
}

}  // namespace
}  // namespace glint::view
