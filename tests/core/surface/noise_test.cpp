#include "core/surface/noise.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/random.h"
#include "core/surface/spectral.h"
#include "tests/core/surface/map_slopes.h"

namespace glint {
namespace {

using Spectrum = NoiseSettings::Spectrum;

NoiseSettings settings_of(Spectrum spectrum, int size) {
  NoiseSettings settings;
  settings.spectrum = spectrum;
  settings.size = size;
  return settings;
}

NormalMap generated(const NoiseSettings& settings) {
  JobControl control;
  return generate_noise(settings, control).value();
}

class NoiseOf : public testing::TestWithParam<Spectrum> {};
INSTANTIATE_TEST_SUITE_P(Spectra, NoiseOf, testing::Values(Spectrum::gaussian, Spectrum::band),
                         [](const auto& instance) {
                           return instance.param == Spectrum::gaussian ? std::string("gaussian") : std::string("band");
                         });

TEST_P(NoiseOf, HitsItsRmsSlopeExactly) {
  for (const double rms : {0.001, 0.15, 2.0}) {
    NoiseSettings settings = settings_of(GetParam(), 128);
    settings.rms_slope = rms;
    EXPECT_NEAR(test::rms_slope(generated(settings)) / rms, 1, 1e-6) << rms;
  }
}

TEST_P(NoiseOf, IsExactlyFlatWithoutSlope) {
  NoiseSettings settings = settings_of(GetParam(), 64);
  settings.rms_slope = 0;
  const NormalMap map = generated(settings);
  EXPECT_TRUE(test::same_bytes(map, NormalMap(64, 64, std::vector<glm::vec2>(test::texel_count(64)), Wrap::repeat)));
}

TEST_P(NoiseOf, IsIsotropic) {
  double along_u = 0;
  double along_v = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    NoiseSettings settings = settings_of(GetParam(), 128);
    settings.seed = seed;
    const glm::dvec2 rms = test::rms_per_axis(generated(settings));
    along_u += rms.x * rms.x;
    along_v += rms.y * rms.y;
  }
  EXPECT_NEAR(along_u / along_v, 1, 0.06);  // five standard errors of 16 maps
}

TEST_P(NoiseOf, RepeatsWithoutASeam) {
  const NormalMap map = generated(settings_of(GetParam(), 256));
  EXPECT_EQ(map.wrap(), Wrap::repeat);
  const test::Jumps jumps = test::largest_jumps(map);
  EXPECT_LE(jumps.across_border, jumps.inside);
  EXPECT_GT(jumps.across_border, 0);
}

TEST_P(NoiseOf, IsTheSlopeOfAHeightField) {
  NoiseSettings settings = settings_of(GetParam(), 256);
  settings.correlation_length = 16;
  settings.wavelengths = {24, 64};
  EXPECT_LT(test::relative_curl(generated(settings)), 0.02);
}

TEST_P(NoiseOf, GivesTheSameBytesForAnyNumberOfThreads) {
  const NoiseSettings settings = settings_of(GetParam(), 128);
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return generated(settings);
  };
  const NormalMap one = with_threads(1);
  EXPECT_TRUE(test::same_bytes(one, with_threads(2)));
  EXPECT_TRUE(test::same_bytes(one, with_threads(4)));
}

TEST_P(NoiseOf, FollowsItsSeed) {
  NoiseSettings settings = settings_of(GetParam(), 64);
  const NormalMap first = generated(settings);
  settings.seed += 1;
  const NormalMap second = generated(settings);
  EXPECT_FALSE(test::same_bytes(first, second));
  double product = 0;
  for (std::size_t k = 0; k < first.normals().size(); ++k) {
    product += static_cast<double>(first.normals()[k].x) * static_cast<double>(second.normals()[k].x);
  }
  EXPECT_LT(std::abs(product) / static_cast<double>(first.normals().size()) / (0.15 * 0.15), 0.5);
}

TEST_P(NoiseOf, KeepsItsPatternWhenTheSlopeChanges) {
  NoiseSettings settings = settings_of(GetParam(), 64);
  const std::vector<glm::dvec2> gentle = test::slopes_of(generated(settings));
  settings.rms_slope *= 2;
  const std::vector<glm::dvec2> steep = test::slopes_of(generated(settings));
  for (std::size_t k = 0; k < gentle.size(); ++k) {
    ASSERT_NEAR(steep[k].x, 2 * gentle[k].x, 1e-6);
    ASSERT_NEAR(steep[k].y, 2 * gentle[k].y, 1e-6);
  }
}

TEST_P(NoiseOf, SaysThatItWasCancelled) {
  JobControl control;
  control.cancel();
  const auto result = generate_noise(settings_of(GetParam(), 64), control);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::content);
  EXPECT_NE(result.error().sentence.find("cancelled"), std::string::npos);
}

TEST_P(NoiseOf, ReportsAllItsProgress) {
  JobControl control;
  ASSERT_TRUE(generate_noise(settings_of(GetParam(), 64), control));
  EXPECT_EQ(control.progress(), 1);
}

// Heights with the autocorrelation exp(-x^2 / l^2) have h_u with that of exp(-y^2 / l^2) along v and
// (1 - 2 x^2 / l^2) exp(-x^2 / l^2) along u: 1/e and -1/e at the distance l.
TEST(GaussianNoise, HasItsAutocorrelationAtTheCorrelationLength) {
  double variance = 0;
  double across = 0;
  double along = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    NoiseSettings settings = settings_of(Spectrum::gaussian, 512);
    settings.seed = seed;
    const NormalMap map = generated(settings);
    for (int j = 0; j < map.height(); ++j) {
      for (int i = 0; i < map.width(); ++i) {
        const double here = test::slope_of(map.texel(i, j)).x;
        variance += here * here;
        across += here * test::slope_of(map.texel(i, j + 8)).x;
        along += here * test::slope_of(map.texel(i + 8, j)).x;
      }
    }
  }
  EXPECT_NEAR(across / variance, std::exp(-1), 0.01);
  EXPECT_NEAR(along / variance, -std::exp(-1), 0.01);
}

// A derivative has no sign there; left in, it would leak from one slope component into the other.
TEST(GaussianNoise, HasNothingAtNyquist) {
  NoiseSettings settings = settings_of(Spectrum::gaussian, 64);
  settings.correlation_length = 1.5;
  const NormalMap map = generated(settings);
  for (int line = 0; line < 64; ++line) {
    glm::dvec2 along_row{0, 0};
    glm::dvec2 along_column{0, 0};
    for (int k = 0; k < 64; ++k) {
      const double sign = k % 2 == 0 ? 1 : -1;
      along_row += sign * test::slope_of(map.texel(k, line));
      along_column += sign * test::slope_of(map.texel(line, k));
    }
    for (const double sum : {along_row.x, along_row.y, along_column.x, along_column.y}) ASSERT_NEAR(sum, 0, 1e-5);
  }
}

TEST(GaussianNoise, HasGaussianSlopes) {
  double second = 0;
  double third = 0;
  double fourth = 0;
  const std::vector<glm::dvec2> slopes = test::slopes_of(generated(settings_of(Spectrum::gaussian, 512)));
  for (const glm::dvec2 slope : slopes) {
    second += slope.x * slope.x;
    third += slope.x * slope.x * slope.x;
    fourth += slope.x * slope.x * slope.x * slope.x;
  }
  const auto count = static_cast<double>(slopes.size());
  EXPECT_NEAR(third / count / std::pow(second / count, 1.5), 0, 0.1);
  EXPECT_NEAR(fourth * count / (second * second), 3, 0.15);
}

// On waves of one length the Laplacian multiplies by -k^2; five points see it 1 % smaller at this length.
TEST(BandNoise, HoldsTheWavelengthsItWasAskedFor) {
  for (const double wavelength : {16.0, 32.0}) {
    NoiseSettings settings = settings_of(Spectrum::band, 512);
    settings.wavelengths = {wavelength, wavelength};
    const NormalMap map = generated(settings);
    double projected = 0;
    double variance = 0;
    for (int j = 0; j < map.height(); ++j) {
      for (int i = 0; i < map.width(); ++i) {
        const auto slope = [&](int di, int dj) { return test::slope_of(map.texel(i + di, j + dj)).x; };
        projected -= slope(0, 0) * (slope(1, 0) + slope(-1, 0) + slope(0, 1) + slope(0, -1) - 4 * slope(0, 0));
        variance += slope(0, 0) * slope(0, 0);
      }
    }
    const double k = 2 * std::numbers::pi / wavelength;
    EXPECT_NEAR(projected / variance / (k * k), 1, 0.03) << wavelength;
  }
}

TEST(BandNoise, TakesAnySizeAndEveryWavelengthItHolds) {
  for (const int size : {8, 9, 90, 131}) {
    NoiseSettings settings = settings_of(Spectrum::band, size);
    settings.wavelengths = {2, size};
    const NormalMap map = generated(settings);
    EXPECT_EQ(map.width(), size);
    EXPECT_EQ(map.height(), size);
    EXPECT_NEAR(test::rms_slope(map) / 0.15, 1, 1e-6) << size;
  }
}

struct BadNoise {
  std::string field;
  NoiseSettings settings;
};

std::vector<BadNoise> bad_noise() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<BadNoise> bad;
  const auto add = [&](const char* field, Spectrum spectrum, auto change) {
    bad.push_back({field, settings_of(spectrum, 64)});
    change(bad.back().settings);
  };
  for (const int size : {-1, 0, 7, 16385}) {
    add("size", Spectrum::band, [&](NoiseSettings& s) { s.size = size; });
  }
  for (const int size : {std::numeric_limits<int>::min(), 0, 4, 100, 32768}) {
    add("size", Spectrum::gaussian, [&](NoiseSettings& s) { s.size = size; });
  }
  for (const auto spectrum : {Spectrum::band, Spectrum::gaussian}) {
    for (const double rms : {-0.1, 10.1, nan, infinity, -infinity}) {
      add("rms_slope", spectrum, [&](NoiseSettings& s) { s.rms_slope = rms; });
    }
    for (const double length : {1.4, -8.0, nan, infinity}) {
      add("correlation_length", spectrum, [&](NoiseSettings& s) { s.correlation_length = length; });
    }
    for (const glm::dvec2 lengths : {glm::dvec2(1.9, 32), glm::dvec2(32, 8), glm::dvec2(nan, 32), glm::dvec2(8, nan),
                                     glm::dvec2(8, infinity), glm::dvec2(-8, 8)}) {
      add("wavelengths", spectrum, [&](NoiseSettings& s) { s.wavelengths = lengths; });
    }
  }
  add("correlation_length", Spectrum::gaussian, [](NoiseSettings& s) { s.correlation_length = 16.1; });
  add("wavelengths", Spectrum::band, [](NoiseSettings& s) { s.wavelengths.y = 65; });
  return bad;
}

TEST(NoiseSettingsCheck, NamesTheFieldOfEveryBadNumber) {
  for (const BadNoise& bad : bad_noise()) {
    JobControl control;
    const auto result = generate_noise(bad.settings, control);
    ASSERT_FALSE(result) << bad.field;
    EXPECT_EQ(result.error().kind, ErrorKind::request);
    EXPECT_EQ(result.error().subject, "surface.generator." + bad.field) << result.error().sentence;
    EXPECT_EQ(result.error().sentence.rfind("must be ", 0), 0U) << result.error().sentence;
  }
}

TEST(NoiseSettingsCheck, SaysWhatIsAllowedAndWhatWasGiven) {
  JobControl control;
  NoiseSettings settings = settings_of(Spectrum::gaussian, 1000);
  EXPECT_EQ(generate_noise(settings, control).error().message(),
            "surface.generator.size: must be a power of two from 8 to 16384, not 1000");
  settings = settings_of(Spectrum::band, 64);
  settings.wavelengths = {40, 12.5};
  EXPECT_EQ(generate_noise(settings, control).error().message(),
            "surface.generator.wavelengths: must be two numbers from 2 to 64, the smaller first, not 40 and 12.5");
}

std::vector<glm::vec2> random_field(int size) {
  RandomStream random(3, 1);
  std::vector<glm::vec2> field(test::texel_count(size));
  for (glm::vec2& value : field) value = glm::vec2(random.next_uniform() - 0.5, random.next_uniform() - 0.5);
  return field;
}

TEST(Transform, EqualsTheDefinition) {
  for (const int size : {8, 12}) {
    const std::vector<glm::vec2> field = random_field(size);
    std::vector<glm::vec2> spectrum = field;
    JobControl control;
    ASSERT_TRUE(transform_in_place(spectrum, size, TransformDirection::forward, control));
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        std::complex<double> sum = 0;
        for (int j = 0; j < size; ++j) {
          for (int i = 0; i < size; ++i) {
            const glm::dvec2 value(field[test::index_of(i, j, size)]);
            const double angle = -2 * std::numbers::pi * (row * j + column * i) / size;
            sum += std::complex<double>(value.x, value.y) * std::polar(1.0, angle);
          }
        }
        const glm::vec2 value = spectrum[test::index_of(column, row, size)];
        ASSERT_NEAR(static_cast<double>(value.x), sum.real(), 1e-5);
        ASSERT_NEAR(static_cast<double>(value.y), sum.imag(), 1e-5);
      }
    }
  }
}

TEST(Transform, ThereAndBackMultipliesByTheNumberOfTexels) {
  const std::vector<glm::vec2> field = random_field(64);
  std::vector<glm::vec2> there_and_back = field;
  JobControl control;
  ASSERT_TRUE(transform_in_place(there_and_back, 64, TransformDirection::forward, control));
  ASSERT_TRUE(transform_in_place(there_and_back, 64, TransformDirection::inverse, control));
  for (std::size_t k = 0; k < field.size(); ++k) {
    ASSERT_NEAR(there_and_back[k].x / (64 * 64), field[k].x, 1e-6F);
    ASSERT_NEAR(there_and_back[k].y / (64 * 64), field[k].y, 1e-6F);
  }
}

TEST(WaveNumber, IsSignedAboutTheNyquistLine) {
  EXPECT_EQ(wave_number(0, 16), 0);
  EXPECT_DOUBLE_EQ(wave_number(1, 16), std::numbers::pi / 8);
  EXPECT_DOUBLE_EQ(wave_number(8, 16), std::numbers::pi);
  EXPECT_DOUBLE_EQ(wave_number(15, 16), -std::numbers::pi / 8);
}

}  // namespace
}  // namespace glint
