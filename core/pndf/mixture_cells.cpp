#include "core/pndf/mixture_cells.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

// n of h = 1 / n, -n of h = n, or 0. Both are 1 of a whole texel.
std::int64_t commensurate(double step) {
  const double seeds = 1 / step;
  const auto is_whole = [](double x) { return x >= 0.5 && std::abs(x - std::round(x)) < 1e-9 * x; };
  if (is_whole(seeds)) return static_cast<std::int64_t>(std::round(seeds));
  return is_whole(step) ? -static_cast<std::int64_t>(std::round(step)) : 0;
}

std::int64_t floored_remainder(std::int64_t a, std::int64_t b) {
  const std::int64_t remainder = a % b;
  return remainder < 0 ? remainder + b : remainder;
}

}  // namespace

AxisStencil::AxisStencil(double u, bool piecewise_constant)
    : first(static_cast<std::int64_t>(std::floor(u))), value{1, 0, 0, 0} {
  if (piecewise_constant) return;
  const double cell = std::floor(u - 0.5);
  const double x = u - 0.5 - cell;
  first = static_cast<std::int64_t>(cell) - 1;
  value = catmull_rom(x);
  slope = catmull_rom_derivative(x);
  bend = catmull_rom_second_difference(x);
}

std::optional<CellSeeds> CellSeeds::of(const NormalMap& map, bool piecewise_constant, const MixtureSettings& settings) {
  const MixtureLattice lattice(map, settings);
  const std::int64_t n = commensurate(lattice.step.x);
  if (n == 0 || n != commensurate(lattice.step.y)) return std::nullopt;
  const std::int64_t per_axis = std::max<std::int64_t>(n, 1);
  CellSeeds seeds{};
  seeds.count = static_cast<std::size_t>(per_axis * per_axis);
  if (seeds.count > k_most) return std::nullopt;
  seeds.every = std::max<std::int64_t>(-n, 1);
  seeds.taps = piecewise_constant ? 1 : 4;
  seeds.before = piecewise_constant ? 0 : 1;
  seeds.border = piecewise_constant ? 0 : 0.5;
  seeds.curved = !piecewise_constant && settings.elements != MixtureElements::flat;
  seeds.deviation = lattice.deviation;

  // The first seed at or behind the border of some cell, and those that follow within a texel. Of h = n: seed 0.
  const double step = n > 0 ? 1 / static_cast<double>(n) : static_cast<double>(-n);
  const bool on_centers = !piecewise_constant && n > 0 && n % 2 == 1;
  const double first = n > 0 ? (on_centers ? 0.0 : 0.5 * step) : 0.5 * step - seeds.border;
  const double begin = std::floor(first + 1e-9);
  seeds.remainder = floored_remainder(static_cast<std::int64_t>(begin), seeds.every);
  std::vector<double> places;
  for (std::int64_t k = 0; k < per_axis; ++k) places.push_back(first - begin + static_cast<double>(k) * step);

  double sum = 0;
  for (const double place : places) sum += place;
  seeds.centroid = static_cast<float>(sum / static_cast<double>(per_axis));
  seeds.extent = static_cast<float>(0.5 * (places.back() - places.front()));
  const double correction =
      seeds.curved && settings.elements == MixtureElements::corrected ? 0.5 * seeds.deviation * seeds.deviation : 0;
  const auto taps = static_cast<std::size_t>(seeds.taps);
  seeds.stride = ((seeds.curved ? k_quantities : 1) * seeds.count + k_whole - 1) / k_whole * k_whole;
  seeds.weights.assign(taps * taps * seeds.stride, 0.0F);
  seeds.u.assign(seeds.count + k_whole, 0.0F);
  seeds.v.assign(seeds.count + k_whole, 0.0F);
  std::size_t at = 0;
  for (const double v : places) {
    const AxisStencil down(v + seeds.border, piecewise_constant);
    for (const double u : places) {
      const AxisStencil along(u + seeds.border, piecewise_constant);
      seeds.u[at] = static_cast<float>(u);
      seeds.v[at] = static_cast<float>(v);
      for (std::size_t row = 0; row < taps; ++row) {
        for (std::size_t column = 0; column < taps; ++column) {
          float* to = seeds.weights.data() + (row * taps + column) * seeds.stride + at;
          const double bend = along.bend[column] * down.value[row] + along.value[column] * down.bend[row];
          to[0] = static_cast<float>(along.value[column] * down.value[row] + correction * bend);
          if (!seeds.curved) continue;
          to[seeds.count] = static_cast<float>(along.slope[column] * down.value[row]);
          to[2 * seeds.count] = static_cast<float>(along.value[column] * down.slope[row]);
        }
      }
      ++at;
    }
  }
  return seeds;
}

std::uint32_t CellSeeds::cells_with_seeds(std::int64_t i, std::int64_t j, std::int64_t columns,
                                          std::int64_t rows) const {
  if (every == 1 && columns >= 4 && rows >= 4) return 0xFFFF;
  std::uint32_t bits = 0;
  for (int k = 0; k < 16; ++k) {
    const std::int64_t x = k % 4;
    const std::int64_t y = k / 4;
    const bool has = x < columns && y < rows && floored_remainder(i + x - remainder, every) == 0 &&
                     floored_remainder(j + y - remainder, every) == 0;
    bits |= (has ? 1U : 0U) << static_cast<unsigned>(k);
  }
  return bits;
}

}  // namespace glint
