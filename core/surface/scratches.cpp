#include "core/surface/scratches.h"

#include <cmath>
#include <cstddef>
#include <new>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/surface/engraving.h"
#include "core/surface/generator_checks.h"
#include "core/surface/slope_field.h"

namespace glint {
namespace {

constexpr int k_smallest_size = 32;  // a quarter of it still holds the dents' correlation length
constexpr int k_most_scratches = 100'000;
constexpr double k_dent_correlation = 6;  // texels
constexpr double k_most_engraved = 2e9;   // texels visited: about ten seconds
constexpr glm::dvec2 k_lengths{1, k_largest_map_side};
constexpr glm::dvec2 k_half_widths{0.25, 64};
constexpr glm::dvec2 k_flank_slopes{0.001, 10};

std::optional<Error> check(const ScratchSettings& settings) {
  if (auto error = check_size(settings.size, k_smallest_size, true)) return error;
  if (auto error = check_number("count", settings.count, 0, k_most_scratches)) return error;
  if (auto error = check_interval("length", settings.length, k_lengths.x, k_lengths.y)) return error;
  if (auto error = check_interval("half_width", settings.half_width, k_half_widths.x, k_half_widths.y)) return error;
  if (auto error = check_interval("flank_slope", settings.flank_slope, k_flank_slopes.x, k_flank_slopes.y)) {
    return error;
  }
  if (auto error = check_number("direction", settings.direction, -360, 360)) return error;
  if (auto error = check_number("spread", settings.spread, 0, 90)) return error;
  if (auto error = check_number("blur", settings.blur, 0, 16)) return error;
  if (auto error = check_number("dent_rms_slope", settings.dent_rms_slope, 0, 10)) return error;
  const double most = std::floor(k_most_engraved / engraved_area(settings.length.y, settings.half_width.y));
  if (settings.count > most) {
    return generator_error("count", "must be at most " + number_text(most) +
                                        " for scratches as long and wide as these, not " + number_text(settings.count));
  }
  return std::nullopt;
}

double between(glm::dvec2 interval, double share) {
  return interval.x + (interval.y - interval.x) * share;
}

// Scratch k takes the k-th number of every stream, so more scratches leave the first ones where they are.
std::vector<Scratch> draw_scratches(const ScratchSettings& settings) {
  const auto stream = [&](RandomPurpose purpose) { return random_stream(settings.seed, purpose); };
  RandomStream centers = stream(RandomPurpose::scratch_centers);
  RandomStream lengths = stream(RandomPurpose::scratch_lengths);
  RandomStream half_widths = stream(RandomPurpose::scratch_half_widths);
  RandomStream flank_slopes = stream(RandomPurpose::scratch_flank_slopes);
  RandomStream directions = stream(RandomPurpose::scratch_directions);
  std::vector<Scratch> scratches(static_cast<std::size_t>(settings.count));
  for (Scratch& scratch : scratches) {
    scratch.center.x = settings.size * centers.next_uniform();
    scratch.center.y = settings.size * centers.next_uniform();
    scratch.length = settings.length.x * std::pow(settings.length.y / settings.length.x, lengths.next_uniform());
    scratch.half_width = between(settings.half_width, half_widths.next_uniform());
    scratch.flank_slope = between(settings.flank_slope, flank_slopes.next_uniform());
    const double degrees = settings.direction + settings.spread * (2 * directions.next_uniform() - 1);
    scratch.angle = degrees * std::numbers::pi / 180;
  }
  return scratches;
}

// Adds the slopes of the heights, by central differences over the border.
bool add_slopes(SlopeField& field, const std::vector<float>& heights, JobControl& control) {
  const auto n = static_cast<std::size_t>(field.size);
  return for_each_row(field.size, control, [&](int row) {
    const auto j = static_cast<std::size_t>(row);
    const float* here = &heights[j * n];
    const float* above = &heights[(j + n - 1) % n * n];
    const float* below = &heights[(j + 1) % n * n];
    for (std::size_t i = 0; i < n; ++i) {
      field.slopes[j * n + i] += 0.5F * glm::vec2(here[(i + 1) % n] - here[(i + n - 1) % n], below[i] - above[i]);
    }
  });
}

Result<NormalMap> generate(const ScratchSettings& settings, JobControl& control) {
  SlopeField field(settings.size);
  if (settings.dent_rms_slope > 0 &&
      !fill_gaussian_slopes(field, settings.seed, k_dent_correlation, settings.dent_rms_slope, control)) {
    return cancelled_error();
  }
  std::vector<float> heights(field.slopes.size());
  const bool finished = engrave(heights, settings.size, draw_scratches(settings), control) &&
                        blur_heights(heights, settings.size, settings.blur, control) &&
                        add_slopes(field, heights, control) && slopes_to_normals(field, control);
  if (!finished) return cancelled_error();
  return NormalMap(settings.size, settings.size, std::move(field.slopes), Wrap::repeat);
}

}  // namespace

Result<NormalMap> generate_scratches(const ScratchSettings& settings, JobControl& control) {
  if (auto error = check(settings)) return *std::move(error);
  try {
    return generate(settings, control);
  } catch (const std::bad_alloc&) {
    return memory_error(settings.size);
  }
}

}  // namespace glint
