#include "core/image/stored_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

namespace glint {
namespace {

// The integer that was delivered as `sample`, so that it can be made signed again.
template <class Integer>
Integer integer_of(float sample, double largest, double least) {
  const double whole = std::round(static_cast<double>(sample) * largest);
  return static_cast<Integer>(static_cast<std::int32_t>(std::clamp(whole, least, largest)));
}

}  // namespace

StoredSamples::StoredSamples(const ImageInfo& info, std::span<const int> channels)
    : width_(info.width), bits_(info.bits), signed_(info.kind == SampleKind::signed_integer) {
  for (const int channel : channels) channels_.push_back(info.channels[static_cast<std::size_t>(channel)]);
  const std::size_t count =
      static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height) * channels.size();
  const bool integers = info.kind != SampleKind::floating && bits_ <= 16;
  const std::size_t sample_bytes = !integers ? sizeof(float) : bits_ <= 8 ? 1 : 2;
  too_large_ = count > k_most_bytes / sample_bytes;
  if (integers) largest_ = std::exp2(signed_ ? bits_ - 1 : bits_) - 1;
  const std::size_t kept = too_large_ ? 0 : count;
  if (!integers) {
    values_ = std::vector<float>(kept);
  } else if (bits_ <= 8) {
    values_ = std::vector<std::uint8_t>(kept);
  } else {
    values_ = std::vector<std::uint16_t>(kept);
  }
}

void StoredSamples::keep(const RowBlock& block) {
  if (empty()) return;
  const double least = signed_ ? -largest_ - 1 : 0;
  std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(index(0, block.first_row));
        if constexpr (std::is_same_v<Value, float>) {
          std::ranges::copy(block.samples, first);
        } else {
          std::ranges::transform(block.samples, first,
                                 [&](float sample) { return integer_of<Value>(sample, largest_, least); });
        }
      },
      values_);
}

std::size_t StoredSamples::bytes() const {
  return std::visit([](const auto& values) { return values.size() * sizeof(values[0]); }, values_);
}

double StoredSamples::value(int i, int j, std::size_t channel) const {
  assert(!empty() && channel < channels_.size());
  const std::size_t at = index(i, j) + channel;
  return std::visit(
      [&](const auto& values) -> double {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (!std::is_same_v<Value, float>) {
          if (signed_) return static_cast<std::make_signed_t<Value>>(values[at]);
        }
        return static_cast<double>(values[at]);
      },
      values_);
}

std::string StoredSamples::text(int i, int j) const {
  if (too_large_) return "not kept: the file is too large";
  std::string line;
  if (empty()) return line;
  const bool integers = !std::holds_alternative<std::vector<float>>(values_);
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    const double number = value(i, j, channel);
    if (channel > 0) line += ' ';
    line += integers ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number);
  }
  return line;
}

}  // namespace glint
