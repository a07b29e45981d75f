#include "core/image/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {
namespace {

constexpr std::array<DisplayColor, 16> k_viridis = {DisplayColor{0x44, 0x01, 0x54},
                                                    {0x48, 0x1a, 0x6c},
                                                    {0x47, 0x2f, 0x7d},
                                                    {0x41, 0x44, 0x87},
                                                    {0x39, 0x56, 0x8c},
                                                    {0x31, 0x68, 0x8e},
                                                    {0x2a, 0x78, 0x8e},
                                                    {0x23, 0x88, 0x8e},
                                                    {0x1f, 0x98, 0x8b},
                                                    {0x22, 0xa8, 0x84},
                                                    {0x35, 0xb7, 0x79},
                                                    {0x54, 0xc5, 0x68},
                                                    {0x7a, 0xd1, 0x51},
                                                    {0xa5, 0xdb, 0x36},
                                                    {0xd2, 0xe2, 0x1b},
                                                    {0xfd, 0xe7, 0x25}};

struct Stop {
  double position;
  DisplayColor color;
};

constexpr std::array<Stop, 7> k_difference = {
    Stop{-1, {0x9c, 0xd3, 0xff}}, {-0.6, {0x3f, 0x8f, 0xcf}}, {-0.25, {0x1d, 0x45, 0x66}}, {0, {0x0b, 0x0b, 0x0b}},
    {0.25, {0x66, 0x2c, 0x16}},   {0.6, {0xcc, 0x5a, 0x2c}},  {1, {0xff, 0xbb, 0x9c}}};
constexpr DisplayColor k_no_difference{0xff, 0x00, 0x00};  // of a difference that is no number

DisplayColor mixed(DisplayColor a, DisplayColor b, double share) {
  DisplayColor color{};
  for (int channel = 0; channel < 3; ++channel) {
    color[channel] = static_cast<std::uint8_t>(std::lround((1 - share) * a[channel] + share * b[channel]));
  }
  return color;
}

template <class Map>
std::array<DisplayColor, 256> table_of(double lowest, double highest, Map map) {
  std::array<DisplayColor, 256> table{};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(table.size() - 1);
    table[k] = map(lowest + share * (highest - lowest));
  }
  return table;
}

}  // namespace

DisplayColor viridis(double x) {
  if (!(x >= 0)) return k_underflow_color;
  if (x > 1) return k_overflow_color;
  const double scaled = x * (k_viridis.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(scaled), k_viridis.size() - 2);
  return mixed(k_viridis[lower], k_viridis[lower + 1], scaled - static_cast<double>(lower));
}

DisplayColor difference_color(double x) {
  if (std::isnan(x)) return k_no_difference;
  if (x <= k_difference.front().position) return k_difference.front().color;
  for (std::size_t k = 1; k < k_difference.size(); ++k) {
    const Stop& low = k_difference[k - 1];
    const Stop& high = k_difference[k];
    if (x <= high.position) {
      return mixed(low.color, high.color, (x - low.position) / (high.position - low.position));
    }
  }
  return k_difference.back().color;
}

std::array<DisplayColor, 256> viridis_table() {
  return table_of(0, 1, viridis);
}

std::array<DisplayColor, 256> difference_table() {
  return table_of(-1, 1, difference_color);
}

double LogScale::position(double density) const {
  return density > 0 ? std::log(density / lo) / std::log(hi / lo) : -1;
}

DisplayColor LogScale::color(double density) const {
  return viridis(position(density));
}

LogScale fitted_scale(double largest_density) {
  if (!(largest_density > 0) || !std::isfinite(largest_density)) return {1e-4, 1};
  const double power = std::pow(10, std::floor(std::log10(largest_density)));
  const double lead = largest_density / power;
  const double hi = power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
  return {hi * 1e-4, hi};
}

}  // namespace glint
