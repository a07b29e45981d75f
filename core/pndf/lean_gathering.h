#pragma once
// Private to footprint_moments: a MomentSum of many parts, some at a time, since two passes over those cost less than a
// division for each.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/pndf/lean_moments.h"
#include "core/pndf/slope_space.h"

namespace glint {

class LeanGathering {
 public:
  /// A run of texels stands between these two; they become slopes many at a time.
  void begin_texels() { merge(); }
  void end_texels() { merge_texels(); }
  void add_texel(double weight, glm::vec2 normal) {
    weight_[count_] = weight;
    x_[count_] = static_cast<double>(normal.x);
    y_[count_] = static_cast<double>(normal.y);
    if (++count_ == k_room) merge_texels();
  }

  void add(double weight, const SlopeMoments& part) {
    weight_[count_] = weight;
    x_[count_] = part.mean.x;
    y_[count_] = part.mean.y;
    inner_.xx += weight * part.covariance.xx;
    inner_.xy += weight * part.covariance.xy;
    inner_.yy += weight * part.covariance.yy;
    if (++count_ == k_room) merge();
  }

  /// Parts merged so far, and those still gathered.
  SlopeMoments moments() {
    merge();
    return sum_.moments();
  }

 private:
  static constexpr std::size_t k_room = 64;
  static constexpr std::size_t k_ways = 4;  // sums side by side, which need not wait for each other
  using Values = std::array<double, k_room>;
  using Sums = std::array<double, k_ways>;

  static double total(const Sums& sums) { return (sums[0] + sums[1]) + (sums[2] + sums[3]); }

  void merge_texels() {
    to_slopes();
    merge();
  }

  void to_slopes() {
    constexpr double k_least = k_least_height * k_least_height;
    double least = 1;
    for (std::size_t k = 0; k < count_; ++k) least = std::min(least, squared_height({x_[k], y_[k]}));
    if (least < k_least) {
      for (std::size_t k = 0; k < count_; ++k) {
        const glm::dvec2 slope = texel_slope({x_[k], y_[k]}).slope;
        x_[k] = slope.x;
        y_[k] = slope.y;
      }
      return;
    }
    for (std::size_t k = 0; k < count_; ++k) {
      const double steep = -1 / std::sqrt(1 - x_[k] * x_[k] - y_[k] * y_[k]);
      x_[k] *= steep;
      y_[k] *= steep;
    }
  }

  void merge() {
    const std::size_t rounded = (count_ + k_ways - 1) / k_ways * k_ways;
    std::fill(weight_.begin() + static_cast<std::ptrdiff_t>(count_),
              weight_.begin() + static_cast<std::ptrdiff_t>(rounded), 0.0);
    Sums weight{};
    Sums mean_x{};
    Sums mean_y{};
    for (std::size_t k = 0; k < rounded; k += k_ways) {
      for (std::size_t way = 0; way < k_ways; ++way) {
        weight[way] += weight_[k + way];
        mean_x[way] += weight_[k + way] * x_[k + way];
        mean_y[way] += weight_[k + way] * y_[k + way];
      }
    }
    count_ = 0;
    if (!(total(weight) > 0)) return;
    const double share = 1 / total(weight);
    const glm::dvec2 mean{share * total(mean_x), share * total(mean_y)};
    Sums xx{};
    Sums xy{};
    Sums yy{};
    for (std::size_t k = 0; k < rounded; k += k_ways) {
      for (std::size_t way = 0; way < k_ways; ++way) {
        const double x = x_[k + way] - mean.x;
        const double y = y_[k + way] - mean.y;
        xx[way] += weight_[k + way] * x * x;
        xy[way] += weight_[k + way] * x * y;
        yy[way] += weight_[k + way] * y * y;
      }
    }
    sum_.add(
        total(weight),
        {mean, {share * (inner_.xx + total(xx)), share * (inner_.xy + total(xy)), share * (inner_.yy + total(yy))}});
    inner_ = {0, 0, 0};
  }

  Values weight_{};
  Values x_{};
  Values y_{};
  std::size_t count_ = 0;
  SymmetricMatrix2 inner_{0, 0, 0};
  MomentSum sum_;
};

}  // namespace glint
