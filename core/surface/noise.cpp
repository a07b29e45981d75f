#include "core/surface/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/surface/generator_checks.h"
#include "core/surface/slope_field.h"

namespace glint {
namespace {

constexpr int k_smallest_size = 8;
constexpr double k_largest_rms_slope = 10;
constexpr double k_shortest_correlation = 1.5;  // texels; below it the spectrum is cut off at Nyquist
constexpr double k_shortest_wavelength = 2;     // texels: Nyquist

constexpr std::size_t k_waves = 200;
constexpr std::size_t k_rows_per_block = 8;
constexpr std::size_t k_columns_per_tile = 128;

std::optional<Error> check(const NoiseSettings& settings) {
  const bool gaussian = settings.spectrum == NoiseSettings::Spectrum::gaussian;
  if (auto error = check_size(settings.size, k_smallest_size, gaussian)) return error;
  if (auto error = check_number("rms_slope", settings.rms_slope, 0, k_largest_rms_slope)) return error;
  // What the spectrum does not use need only be possible for some map.
  const double longest = gaussian ? settings.size / 4.0 : k_largest_map_side;
  if (auto error = check_number("correlation_length", settings.correlation_length, k_shortest_correlation, longest)) {
    return error;
  }
  return check_interval("wavelengths", settings.wavelengths, k_shortest_wavelength,
                        gaussian ? k_largest_map_side : settings.size);
}

// A plane wave whose slope is (direction) sin(2 pi (periods . u) / size + phase).
struct Wave {
  glm::ivec2 periods;  // whole periods over the map along right and down, never both zero
  glm::dvec2 direction;
  double phase;
};

std::vector<Wave> draw_waves(const NoiseSettings& settings) {
  RandomStream lengths = random_stream(settings.seed, RandomPurpose::wavelengths);
  RandomStream directions = random_stream(settings.seed, RandomPurpose::wave_directions);
  RandomStream phases = random_stream(settings.seed, RandomPurpose::wave_phases);
  const double shortest = settings.wavelengths.x;
  const double ratio = settings.wavelengths.y / shortest;
  std::vector<Wave> waves(k_waves);
  for (Wave& wave : waves) {
    const double periods = settings.size / (shortest * std::pow(ratio, lengths.next_uniform()));
    const double angle = 2 * std::numbers::pi * directions.next_uniform();
    // No wave is longer than the map, so the larger component is at least 1 / sqrt 2 and rounds to 1 or more. On an odd
    // map the shortest could round beyond Nyquist and would come back with another direction than its slope.
    const auto rounded = [&](double component) {
      const int whole = static_cast<int>(std::lround(periods * component));
      return std::clamp(whole, -settings.size / 2, settings.size / 2);
    };
    wave.periods = {rounded(std::cos(angle)), rounded(std::sin(angle))};
    wave.direction = glm::dvec2(wave.periods) / std::hypot(wave.periods.x, wave.periods.y);
    wave.phase = 2 * std::numbers::pi * phases.next_uniform();
  }
  return waves;
}

// The waves along one row of texels: sin(a + b) = sin a cos b + cos a sin b makes all rows from these tables.
struct WaveTables {
  std::size_t size;
  std::vector<Wave> waves;
  std::vector<double> sines;  // [wave][column] of 2 pi periods.x column / size + phase
  std::vector<double> cosines;
};

double turn(int periods, std::size_t texel, std::size_t size) {
  const auto n = static_cast<std::int64_t>(size);
  const std::int64_t whole = periods * static_cast<std::int64_t>(texel) % n;  // exact: the map repeats to the last bit
  return 2 * std::numbers::pi * static_cast<double>(whole) / static_cast<double>(n);
}

bool fill_tables(WaveTables& tables, JobControl& control) {
  tables.sines.resize(k_waves * tables.size);
  tables.cosines.resize(k_waves * tables.size);
  return parallel_blocks(k_waves, control, [&](std::size_t wave) {
    for (std::size_t column = 0; column < tables.size; ++column) {
      const double angle = turn(tables.waves[wave].periods.x, column, tables.size) + tables.waves[wave].phase;
      tables.sines[wave * tables.size + column] = std::sin(angle);
      tables.cosines[wave * tables.size + column] = std::cos(angle);
    }
  });
}

struct RowFactor {
  double sine;
  double cosine;
};
using RowFactors = std::array<std::array<RowFactor, k_waves>, k_rows_per_block>;

// Sums all waves over columns [begin, end) of `rows` rows; a tile's sums and one wave's table stay in the first cache.
void sum_tile(const WaveTables& tables, const RowFactors& factors, std::size_t first_row, std::size_t rows,
              std::size_t begin, std::size_t end, std::vector<glm::vec2>& slopes) {
  using TileSums = std::array<std::array<double, k_columns_per_tile>, k_rows_per_block>;
  TileSums along_u{};
  TileSums along_v{};
  for (std::size_t wave = 0; wave < k_waves; ++wave) {
    const double* sines = &tables.sines[wave * tables.size + begin];
    const double* cosines = &tables.cosines[wave * tables.size + begin];
    const glm::dvec2 direction = tables.waves[wave].direction;
    for (std::size_t row = 0; row < rows; ++row) {
      const RowFactor factor = factors[row][wave];
      for (std::size_t column = 0; column < end - begin; ++column) {
        const double slope = sines[column] * factor.cosine + cosines[column] * factor.sine;
        along_u[row][column] += direction.x * slope;
        along_v[row][column] += direction.y * slope;
      }
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = begin; column < end; ++column) {
      slopes[(first_row + row) * tables.size + column] =
          glm::vec2(glm::dvec2(along_u[row][column - begin], along_v[row][column - begin]));
    }
  }
}

// Models 6.1, "band": equal slope amplitudes; the scale is free, as the RMS slope is set afterwards.
bool fill_band_slopes(SlopeField& field, const NoiseSettings& settings, JobControl& control) {
  WaveTables tables{static_cast<std::size_t>(settings.size), draw_waves(settings), {}, {}};
  if (!fill_tables(tables, control)) return false;
  const std::size_t blocks = (tables.size + k_rows_per_block - 1) / k_rows_per_block;
  const bool finished = parallel_blocks(blocks, control, [&](std::size_t block) {
    const std::size_t first_row = block * k_rows_per_block;
    const std::size_t rows = std::min(k_rows_per_block, tables.size - first_row);
    RowFactors factors;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t wave = 0; wave < k_waves; ++wave) {
        const double angle = turn(tables.waves[wave].periods.y, first_row + row, tables.size);
        factors[row][wave] = {std::sin(angle), std::cos(angle)};
      }
    }
    for (std::size_t begin = 0; begin < tables.size && !control.cancelled(); begin += k_columns_per_tile) {
      const std::size_t end = std::min(begin + k_columns_per_tile, tables.size);
      sum_tile(tables, factors, first_row, rows, begin, end, field.slopes);
    }
  });
  return finished && set_rms_slope(field, settings.rms_slope, control);
}

Result<NormalMap> generate(const NoiseSettings& settings, JobControl& control) {
  SlopeField field(settings.size);
  if (settings.rms_slope > 0) {
    const bool filled =
        settings.spectrum == NoiseSettings::Spectrum::gaussian
            ? fill_gaussian_slopes(field, settings.seed, settings.correlation_length, settings.rms_slope, control)
            : fill_band_slopes(field, settings, control);
    if (!filled || !slopes_to_normals(field, control)) return cancelled_error();
  }
  if (control.cancelled()) return cancelled_error();
  return NormalMap(settings.size, settings.size, std::move(field.slopes), Wrap::repeat);
}

}  // namespace

Result<NormalMap> generate_noise(const NoiseSettings& settings, JobControl& control) {
  if (auto error = check(settings)) return *std::move(error);
  try {
    return generate(settings, control);
  } catch (const std::bad_alloc&) {
    return memory_error(settings.size);
  }
}

}  // namespace glint
