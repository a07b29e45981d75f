#include "core/image/normal_decoder.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

// The sRGB transfer curve (IEC 61966-2-1) and its inverse, on [0, 1].
double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double srgb_decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// | |v| - 1 | of the vector that three values in [0, 1] hold after `curve`.
template <class Curve>
double length_error(const float* samples, Curve curve) {
  double squares = 0;
  for (int c = 0; c < 3; ++c) {
    const double v = 2 * curve(std::clamp(static_cast<double>(samples[c]), 0.0, 1.0)) - 1;
    squares += v * v;
  }
  return std::abs(std::sqrt(squares) - 1);
}

constexpr double k_leaning = 0.6;

}  // namespace

NormalDecoder::NormalDecoder(const DecodingRules& rules, std::size_t channels_per_texel, int width,
                             std::span<glm::vec2> normals)
    : rules_(rules), stride_(channels_per_texel), width_(width), normals_(normals) {}

void NormalDecoder::decode(const RowBlock& block) {
  const float* samples = block.samples.data();
  std::size_t at = static_cast<std::size_t>(block.first_row) * static_cast<std::size_t>(width_);
  for (int row = block.first_row; row < block.first_row + block.row_count; ++row) {
    for (int column = 0; column < width_; ++column, samples += stride_, ++at) {
      glm::dvec2 normal = texel(samples, {column, row});
      if (rules_.green == GreenDirection::down) normal.y = -normal.y;
      normals_[at] = {static_cast<float>(normal.x), static_cast<float>(normal.y)};
      ++counts_.texels;
    }
  }
}

double NormalDecoder::value(float stored) const {
  const double c = static_cast<double>(stored);
  return rules_.signed_values ? c : 2 * c - 1;
}

glm::dvec2 NormalDecoder::texel(const float* samples, glm::ivec2 at) {
  switch (rules_.layout) {
    case Layout::two_channel:
    case Layout::luminance_alpha:
    case Layout::blue_constant:
      return from_pair(samples[0], samples[1], at);
    case Layout::dxt5nm:
      return from_pair(samples[3], samples[1], at);
    case Layout::vector:
    case Layout::height:
    case Layout::constant_grey:
      break;
  }
  return from_vector(samples, at);
}

glm::dvec2 NormalDecoder::from_vector(const float* samples, glm::ivec2 at) {
  const glm::dvec3 v{value(samples[0]), value(samples[1]), value(samples[2])};
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    counts_.not_finite.add(at);
    return {0, 0};
  }
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  if (length == 0) {
    counts_.zero.add(at);
    return {0, 0};
  }
  const glm::dvec3 unit{v.x / length, v.y / length, v.z / length};
  if (unit.z <= 0) counts_.turned_away.add(at);
  counts_.least_length = counts_.vectors == 0 ? length : std::min(counts_.least_length, length);
  counts_.greatest_length = std::max(counts_.greatest_length, length);
  counts_.length_error += std::abs(length - 1);
  counts_.sum += unit;
  ++counts_.vectors;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(unit[axis]) > k_leaning)
      ++counts_.leaning[2 * static_cast<std::size_t>(axis) + (unit[axis] < 0 ? 1 : 0)];
  }
  if (rules_.measure_transfer) measure_transfer(samples);
  return {unit.x, unit.y};
}

glm::dvec2 NormalDecoder::from_pair(float x, float y, glm::ivec2 at) {
  const glm::dvec2 pair{value(x), value(y)};
  if (!std::isfinite(pair.x) || !std::isfinite(pair.y)) {
    counts_.not_finite.add(at);
    return {0, 0};
  }
  const double length = std::sqrt(pair.x * pair.x + pair.y * pair.y);
  if (length <= 1) return pair;
  counts_.beyond_rim.add(at);
  return pair / length;
}

void NormalDecoder::measure_transfer(const float* samples) {
  counts_.length_error_linearised += length_error(samples, srgb_decoded);
  counts_.length_error_encoded += length_error(samples, srgb_encoded);
}

}  // namespace glint
