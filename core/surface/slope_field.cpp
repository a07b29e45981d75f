#include "core/surface/slope_field.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/surface/generator_checks.h"
#include "core/surface/height_field.h"
#include "core/surface/spectral.h"

namespace glint {
namespace {

constexpr int k_rows_per_block = 8;

std::span<glm::vec2> row_of(SlopeField& field, int row) {
  const auto n = static_cast<std::size_t>(field.size);
  return std::span(field.slopes).subspan(static_cast<std::size_t>(row) * n, n);
}

// Every row has a random stream of its own, so that rows can be filled in any order.
bool fill_white_noise(SlopeField& field, std::uint64_t seed, JobControl& control) {
  return for_each_row(field.size, control, [&](int row) {
    std::vector<double> noise(static_cast<std::size_t>(field.size));
    random_stream(seed, RandomPurpose::white_noise, static_cast<std::uint64_t>(row)).fill_normal(noise);
    std::transform(noise.begin(), noise.end(), row_of(field, row).begin(),
                   [](double value) { return glm::vec2(static_cast<float>(value), 0.0F); });
  });
}

// Heights to slopes and the amplitude exp(-k^2 l^2 / 8), at once: h_u + i h_v has the spectrum (i k_u - k_v) H.
bool filter_to_slopes(SlopeField& spectrum, double correlation_length, JobControl& control) {
  const int n = spectrum.size;
  return for_each_row(n, control, [&](int row) {
    const double k_v = wave_number(row, n);
    const std::span<glm::vec2> line = row_of(spectrum, row);
    for (int column = 0; column < n; ++column) {
      const double k_u = wave_number(column, n);
      const double amplitude = std::exp(-(k_u * k_u + k_v * k_v) * correlation_length * correlation_length / 8);
      // A derivative at the Nyquist line has no sign: it would leave one field's residue in the other.
      const bool nyquist = row == n / 2 || column == n / 2;
      const double factor = nyquist ? 0 : amplitude;
      glm::vec2& value = line[static_cast<std::size_t>(column)];
      const glm::dvec2 noise(value);
      value = glm::vec2(factor * glm::dvec2(-k_v * noise.x - k_u * noise.y, k_u * noise.x - k_v * noise.y));
    }
  });
}

}  // namespace

bool for_each_row(int size, JobControl& control, const std::function<void(int)>& body) {
  const int blocks = (size + k_rows_per_block - 1) / k_rows_per_block;
  return parallel_blocks(static_cast<std::size_t>(blocks), control, [&](std::size_t block) {
    const int first = static_cast<int>(block) * k_rows_per_block;
    for (int row = first; row < std::min(first + k_rows_per_block, size); ++row) body(row);
  });
}

bool set_rms_slope(SlopeField& field, double rms_slope, JobControl& control) {
  std::vector<double> row_sums(static_cast<std::size_t>(field.size));  // added in order below, whatever the threads
  const bool measured = for_each_row(field.size, control, [&](int row) {
    double sum = 0;
    for (const glm::dvec2 slope : row_of(field, row)) sum += slope.x * slope.x + slope.y * slope.y;
    row_sums[static_cast<std::size_t>(row)] = sum;
  });
  if (!measured) return false;
  double sum = 0;
  for (const double row_sum : row_sums) sum += row_sum;
  const double present = std::sqrt(sum / (2 * static_cast<double>(field.slopes.size())));
  const double scale = present > 0 ? rms_slope / present : 0;
  return for_each_row(field.size, control, [&](int row) {
    for (glm::vec2& slope : row_of(field, row)) slope = glm::vec2(scale * glm::dvec2(slope));
  });
}

bool fill_gaussian_slopes(SlopeField& field, std::uint64_t seed, double correlation_length, double rms_slope,
                          JobControl& control) {
  return fill_white_noise(field, seed, control) &&
         transform_in_place(field.slopes, field.size, TransformDirection::forward, control) &&
         filter_to_slopes(field, correlation_length, control) &&
         transform_in_place(field.slopes, field.size, TransformDirection::inverse, control) &&
         set_rms_slope(field, rms_slope, control);
}

bool slopes_to_normals(SlopeField& field, JobControl& control) {
  return for_each_row(field.size, control, [&](int row) {
    for (glm::vec2& value : row_of(field, row)) value = glm::vec2(normal_from_slopes(value.x, value.y));
  });
}

}  // namespace glint
