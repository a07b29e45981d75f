#include "core/surface/engraving.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/surface/slope_field.h"

namespace glint {
namespace {

constexpr double k_profile_reach = 6;  // half widths; what is cut off is below float precision
constexpr double k_kernel_reach = 6;   // deviations, likewise
constexpr double k_taper = 4;          // half widths
constexpr int k_rows_per_band = 16;

struct Interval {
  double low;
  double high;
};

// The x for which |slope * x + offset| <= half.
Interval where_within(double slope, double offset, double half) {
  constexpr Interval k_everywhere{-1e9, 1e9};
  constexpr Interval k_nowhere{1, -1};
  if (std::abs(slope) < 1e-9) return std::abs(offset) <= half ? k_everywhere : k_nowhere;
  const double a = (-half - offset) / slope;
  const double b = (half - offset) / slope;
  return {std::min(a, b), std::max(a, b)};
}

// A scratch with what all its texels share.
struct Groove {
  explicit Groove(const Scratch& scratch)
      : center(scratch.center),
        along(std::cos(scratch.angle), -std::sin(scratch.angle)),  // v runs down
        half_length(scratch.length / 2),
        half_reach(k_profile_reach * scratch.half_width),
        taper(std::min(k_taper * scratch.half_width, half_length)),
        depth(scratch.flank_slope * scratch.half_width * std::sqrt(std::numbers::e)),
        exponent(-0.5 / (scratch.half_width * scratch.half_width)),
        half_height(std::abs(along.y) * half_length + std::abs(along.x) * half_reach) {}

  // The height at a distance along and across the groove's middle.
  [[nodiscard]] double height(double distance_along, double distance_across) const {
    const double from_end = std::clamp((half_length - std::abs(distance_along)) / taper, 0.0, 1.0);
    const double rise = from_end * from_end * (3 - 2 * from_end);
    return -depth * rise * std::exp(exponent * distance_across * distance_across);
  }

  // Lowers one row of the map; `y` is the row's distance below the groove's middle.
  void lower_row(std::span<float> row, double y) const {
    const Interval ends = where_within(along.x, along.y * y, half_length);
    const Interval sides = where_within(-along.y, along.x * y, half_reach);
    // Columns of the unrolled plane; column i has its centre at i + 0.5.
    const double first = std::ceil(center.x + std::max(ends.low, sides.low) - 0.5);
    const double last = std::floor(center.x + std::min(ends.high, sides.high) - 0.5);
    if (!(first <= last)) return;
    const auto n = static_cast<double>(row.size());
    auto column = static_cast<std::size_t>(first - n * std::floor(first / n));
    for (double unrolled = first; unrolled <= last; ++unrolled) {
      const double x = unrolled + 0.5 - center.x;
      const double lowered = height(along.x * x + along.y * y, along.x * y - along.y * x);
      row[column] = std::min(row[column], static_cast<float>(lowered));
      if (++column == row.size()) column = 0;
    }
  }

  glm::dvec2 center;
  glm::dvec2 along;  // unit vector; (-along.y, along.x) runs across
  double half_length;
  double half_reach;
  double taper;
  double depth;
  double exponent;
  double half_height;  // of the box around it
};

// Lowers the rows [first, last) of the map to a groove and to every image of it above and below.
void engrave_band(std::span<float> heights, int size, int first, int last, const Groove& groove) {
  const auto n = static_cast<std::size_t>(size);
  const double top = groove.center.y - groove.half_height;
  const double bottom = groove.center.y + groove.half_height;
  // Images: the map's row j lies at j + 0.5 + k size in the unrolled plane.
  const double first_image = std::ceil((top - last) / size);
  const double last_image = std::floor((bottom - first) / size);
  for (double image = first_image; image <= last_image; ++image) {
    for (int j = first; j < last; ++j) {
      const double y = j + 0.5 + image * size - groove.center.y;
      if (std::abs(y) <= groove.half_height) groove.lower_row(heights.subspan(static_cast<std::size_t>(j) * n, n), y);
    }
  }
}

// Weights of a sampled Gaussian, from the middle outwards; they sum to 1 over both sides.
std::vector<double> gaussian_kernel(double deviation) {
  std::vector<double> kernel(static_cast<std::size_t>(std::ceil(k_kernel_reach * deviation)) + 1);
  double sum = 0;
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const double x = static_cast<double>(k) / deviation;
    kernel[k] = std::exp(-0.5 * x * x);
    sum += k == 0 ? kernel[k] : 2 * kernel[k];
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

}  // namespace

double engraved_area(double length, double half_width) {
  return length * 2 * k_profile_reach * half_width;
}

bool engrave(std::span<float> heights, int size, std::span<const Scratch> scratches, JobControl& control) {
  const std::vector<Groove> grooves(scratches.begin(), scratches.end());
  const int bands = (size + k_rows_per_band - 1) / k_rows_per_band;
  // A band belongs to one thread, and a minimum does not depend on the order of scratches.
  return parallel_blocks(static_cast<std::size_t>(bands), control, [&](std::size_t band) {
    const int first = static_cast<int>(band) * k_rows_per_band;
    const int last = std::min(first + k_rows_per_band, size);
    for (const Groove& groove : grooves) {
      if (control.cancelled()) return;
      engrave_band(heights, size, first, last, groove);
    }
  });
}

bool blur_heights(std::span<float> heights, int size, double deviation, JobControl& control) {
  if (deviation == 0) return true;
  const std::vector<double> kernel = gaussian_kernel(deviation);
  const auto n = static_cast<std::size_t>(size);
  const std::size_t reach = kernel.size() - 1;
  // The row or column of the map that is number k - reach of the unrolled plane.
  std::vector<std::size_t> unrolled(n + 2 * reach);
  const std::size_t turns = n * (reach / n + 1);
  for (std::size_t k = 0; k < unrolled.size(); ++k) unrolled[k] = (k + turns - reach) % n;

  std::vector<float> blurred_rows(heights.size());
  const bool rows_done = for_each_row(size, control, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * n;
    std::vector<double> line(unrolled.size());
    for (std::size_t k = 0; k < line.size(); ++k) line[k] = heights[begin + unrolled[k]];
    for (std::size_t i = 0; i < n; ++i) {
      double sum = kernel[0] * line[i + reach];
      for (std::size_t k = 1; k <= reach; ++k) sum += kernel[k] * (line[i + reach - k] + line[i + reach + k]);
      blurred_rows[begin + i] = static_cast<float>(sum);
    }
  });
  if (!rows_done) return false;
  return for_each_row(size, control, [&](int row) {
    const std::size_t middle = static_cast<std::size_t>(row) + reach;
    std::vector<double> sums(n);
    for (std::size_t i = 0; i < n; ++i)
      sums[i] = kernel[0] * static_cast<double>(blurred_rows[unrolled[middle] * n + i]);
    for (std::size_t k = 1; k <= reach; ++k) {
      const float* above = &blurred_rows[unrolled[middle - k] * n];
      const float* below = &blurred_rows[unrolled[middle + k] * n];
      for (std::size_t i = 0; i < n; ++i) {
        sums[i] += kernel[k] * (static_cast<double>(above[i]) + static_cast<double>(below[i]));
      }
    }
    std::transform(sums.begin(), sums.end(), &heights[static_cast<std::size_t>(row) * n],
                   [](double sum) { return static_cast<float>(sum); });
  });
}

}  // namespace glint
