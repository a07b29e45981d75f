#include "viewers/widgets/number_text.h"

#include <clocale>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace glint::view {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

TEST(NumberText, HasThreeSignificantDigits) {
  EXPECT_EQ(number_text(0.06482), "0.0648");
  EXPECT_EQ(number_text(1.0749), "1.07");
  EXPECT_EQ(number_text(203.4), "203");
  EXPECT_EQ(number_text(68), "68.0");
  EXPECT_EQ(number_text(12345), "12300");
  EXPECT_EQ(number_text(0.001), "0.00100");
  EXPECT_EQ(number_text(9.999), "10.0") << "a carry takes a digit with it";
  EXPECT_EQ(number_text(0.5, 1), "0.5");
}

TEST(NumberText, WritesPowersOfTenWhereZerosWouldHideTheDigits) {
  EXPECT_EQ(number_text(1.234e-5), "1.23×10⁻⁵");
  EXPECT_EQ(number_text(-4.5e12), "−4.50×10¹²");
  EXPECT_EQ(number_text(99999), "1.00×10⁵");
}

TEST(NumberText, HasARealMinusAndNamesWhatIsNoNumber) {
  EXPECT_EQ(number_text(-0.0034), "−0.00340");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(k_nan), "NaN");
  EXPECT_EQ(number_text(-k_infinity), "−∞");
}

TEST(ShortNumberText, IsAsItWouldBeTyped) {
  EXPECT_EQ(short_number_text(100), "100");
  EXPECT_EQ(short_number_text(0.01), "0.01");
  EXPECT_EQ(short_number_text(0.001), "0.001");
  EXPECT_EQ(short_number_text(1e-4), "1e−4");
  EXPECT_EQ(short_number_text(5000), "5000");
  EXPECT_EQ(short_number_text(2e20), "2e20");
  EXPECT_EQ(short_number_text(-0.9637, 4), "−0.9637");
  EXPECT_EQ(short_number_text(1.25), "1.25");
}

TEST(ShortNumberText, ReadsBackAsTheRoundedNumber) {
  for (const double value : {1.0, -0.25, 1e-4, 2.5e-17, 3e29, 12.0, -5000.0}) {
    EXPECT_EQ(parsed_number(short_number_text(value)), value) << short_number_text(value);
  }
}

TEST(DecimalText, KeepsItsDecimalsAndNeverSaysMinusZero) {
  EXPECT_EQ(decimal_text(-0.5, 2), "−0.50");
  EXPECT_EQ(decimal_text(-0.001, 1), "0.0");
  EXPECT_EQ(decimal_text(3, 0), "3");
}

TEST(TimeText, ChoosesTheUnit) {
  EXPECT_EQ(time_text(203), (Quantity{"203", "ms"}));
  EXPECT_EQ(time_text(1.0712), (Quantity{"1.07", "ms"}));
  EXPECT_EQ(time_text(0.0503), (Quantity{"50.3", "µs"}));
  EXPECT_EQ(time_text(999.7), (Quantity{"1.00", "s"})) << "never 1000 ms in three digits";
  EXPECT_EQ(time_text(12400), (Quantity{"12.4", "s"}));
  EXPECT_EQ(time_text(0), (Quantity{"0", "ms"}));
}

TEST(PercentText, HasOneDecimalUntilThatSaysNothing) {
  EXPECT_EQ(percent_text(0.008), (Quantity{"0.8", "%"}));
  EXPECT_EQ(percent_text(0.04), (Quantity{"4.0", "%"}));
  EXPECT_EQ(percent_text(0.9312), (Quantity{"93.1", "%"}));
  EXPECT_EQ(percent_text(0.00004), (Quantity{"0.004", "%"}));
  EXPECT_EQ(percent_text(2.134), (Quantity{"213", "%"}));
  EXPECT_EQ(percent_text(0), (Quantity{"0", "%"}));
}

TEST(CountText, ShortensThousandsAndMillions) {
  EXPECT_EQ(count_text(100), "100");
  EXPECT_EQ(count_text(100'000), "100 k");
  EXPECT_EQ(count_text(12'500), "12.5 k");
  EXPECT_EQ(count_text(999'999), "1 M");
  EXPECT_EQ(count_text(1'000'000), "1 M");
  EXPECT_EQ(count_text(1'500'000), "1.5 M");
  EXPECT_EQ(count_text(2'000'000'000), "2 G");
}

TEST(CopyText, IsAsciiAndReadsBackExactly) {
  EXPECT_EQ(copy_text(-0.0034), "-0.0034");
  EXPECT_EQ(parsed_number(copy_text(0.1 + 0.2)), 0.1 + 0.2);
}

TEST(ParsedNumber, TakesWhatAPersonTypes) {
  EXPECT_EQ(parsed_number("1e-3"), 1e-3);
  EXPECT_EQ(parsed_number(" −0.5 "), -0.5);
  EXPECT_EQ(parsed_number("+5"), 5);
  EXPECT_EQ(parsed_number("1e−4"), 1e-4);
}

TEST(ParsedNumber, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", " ", "abc", "1,5", "1.5x", "nan", "inf", "1e999", "+-5", "--5", "+"}) {
    EXPECT_FALSE(parsed_number(text)) << text;
  }
}

TEST(NumberText, DoesNotAskTheLocale) {
  const char* const before = std::setlocale(LC_ALL, nullptr);
  const std::string kept = before == nullptr ? "C" : before;
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "de_DE.UTF-8 is not installed";
  EXPECT_EQ(number_text(0.0648), "0.0648");
  EXPECT_EQ(short_number_text(1.25), "1.25");
  EXPECT_EQ(parsed_number("1.5"), 1.5);
  std::setlocale(LC_ALL, kept.c_str());
}

}  // namespace
}  // namespace glint::view
