#include "viewers/pndf/axis_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "viewers/widgets/number_text.h"

namespace glint::view {
namespace {

constexpr double k_slack = 1e-9;  // of a step: a tick at the very end of a range counts as inside

bool positive_range(double lowest, double highest) {
  return lowest > 0 && highest > lowest && std::isfinite(highest);
}

}  // namespace

double rounded_up_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double lead : {1.0, 2.0, 5.0}) {
    if (step <= lead * power * (1 + k_slack)) return lead * power;
  }
  return 10 * power;
}

std::vector<double> linear_ticks(double lowest, double highest, int most) {
  if (!(lowest < highest) || !std::isfinite(highest - lowest)) return {};
  // n ticks span n - 1 steps, so a step of range / most can leave one tick too many.
  double step = rounded_up_step((highest - lowest) / std::max(2, most));
  std::vector<double> ticks;
  for (;; step = rounded_up_step(step * 1.5)) {
    const double first = std::ceil(lowest / step - k_slack);
    const double last = std::floor(highest / step + k_slack);
    if (last - first + 1 > std::max(2, most)) continue;
    for (double k = first; k <= last; ++k) ticks.push_back(k == 0 ? 0 : k * step);
    return ticks;
  }
}

std::vector<double> log_ticks(double lowest, double highest, int most) {
  if (!positive_range(lowest, highest)) return {};
  const int first = static_cast<int>(std::ceil(std::log10(lowest) - k_slack));
  const int last = static_cast<int>(std::floor(std::log10(highest) + k_slack));
  std::vector<double> ticks;
  if (last > first) {
    const int count = last - first + 1;
    const int stride = (count + std::max(2, most) - 1) / std::max(2, most);
    for (int k = first; k <= last; k += stride) ticks.push_back(std::pow(10, k));
    return ticks;
  }
  for (int k = first - 1; k <= last; ++k) {
    for (const double lead : {1.0, 2.0, 5.0}) {
      const double tick = lead * std::pow(10, k);
      if (tick >= lowest * (1 - k_slack) && tick <= highest * (1 + k_slack)) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::vector<std::string> tick_texts(const std::vector<double>& ticks) {
  int decimals = 0;
  if (ticks.size() > 1) {
    const double step = ticks[1] - ticks[0];
    decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + k_slack)));
  }
  std::vector<std::string> texts;
  texts.reserve(ticks.size());
  for (const double tick : ticks) {
    texts.push_back(decimals <= 6 && std::abs(tick) < 1e6 ? decimal_text(tick, decimals) : short_number_text(tick));
  }
  return texts;
}

}  // namespace glint::view
