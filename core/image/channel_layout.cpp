#include "core/image/channel_layout.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace glint {
namespace {

std::string lower_case(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return lower;
}

using NameSet = std::array<std::string_view, 3>;
constexpr std::array k_name_sets{NameSet{"n.x", "n.y", "n.z"}, NameSet{"nx", "ny", "nz"}, NameSet{"x", "y", "z"},
                                 NameSet{"r", "g", "b"}};

std::optional<std::vector<int>> find_names(const std::vector<std::string>& lower_names, const NameSet& names,
                                           std::size_t count) {
  std::vector<int> found;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = std::ranges::find(lower_names, names[k]);
    if (at == lower_names.end()) return std::nullopt;
    found.push_back(static_cast<int>(at - lower_names.begin()));
  }
  return found;
}

std::optional<std::vector<int>> find_known_names(const std::vector<std::string>& lower_names) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{2}}) {
    for (const NameSet& names : k_name_sets) {
      if (auto found = find_names(lower_names, names, count)) return found;
    }
  }
  return std::nullopt;
}

// The values that occur in a channel of integers of at most 16 bits, and how often values fall into 1024 bins.
class ChannelSurvey {
 public:
  explicit ChannelSurvey(bool with_levels) : seen_(with_levels ? k_levels : 0, false) {}

  void add(float value) {
    if (!std::isfinite(value)) {
      ++statistics_.not_finite;
      return;
    }
    const double v = static_cast<double>(value);
    statistics_.least = statistics_.finite == 0 ? v : std::min(statistics_.least, v);
    statistics_.greatest = statistics_.finite == 0 ? v : std::max(statistics_.greatest, v);
    ++statistics_.finite;
    const double unit = std::clamp(v, 0.0, 1.0);
    ++histogram_[static_cast<std::size_t>(std::lround(unit * (k_bins - 1)))];
    if (!seen_.empty()) seen_[static_cast<std::size_t>(std::lround(unit * (k_levels - 1)))] = true;
  }

  [[nodiscard]] const ChannelStatistics& statistics() const { return statistics_; }

  [[nodiscard]] double median() const {
    std::size_t below = 0;
    for (std::size_t bin = 0; bin < k_bins; ++bin) {
      below += histogram_[bin];
      if (2 * below >= statistics_.finite) return static_cast<double>(bin) / (k_bins - 1);
    }
    return 0;
  }

  // The smallest difference between two values that occur; none if fewer than two do.
  [[nodiscard]] std::optional<double> level_step() const {
    std::optional<std::size_t> last;
    std::optional<std::size_t> least;
    for (std::size_t level = 0; level < seen_.size(); ++level) {
      if (!seen_[level]) continue;
      if (last) least = std::min(least.value_or(k_levels), level - *last);
      last = level;
    }
    if (!least) return std::nullopt;
    return static_cast<double>(*least) / (k_levels - 1);
  }

 private:
  static constexpr std::size_t k_levels = 65536;
  static constexpr std::size_t k_bins = 1024;

  ChannelStatistics statistics_;
  std::array<std::size_t, k_bins> histogram_{};
  std::vector<bool> seen_;
};

// The step of the file's integers by themselves, for those whose occurring values are not followed.
double nominal_step(const ImageInfo& info) {
  const int bits = std::clamp(info.bits, 1, 32) - (info.kind == SampleKind::signed_integer ? 1 : 0);
  return 1.0 / std::max(1.0, std::exp2(bits) - 1);
}

class ImageSurvey {
 public:
  ImageSurvey(const ImageInfo& info, const ChannelChoice& choice)
      : color_count_(choice.colors.size()),
        integers_(info.kind != SampleKind::floating),
        nominal_step_(nominal_step(info)),
        channels_(choice.all().size(), ChannelSurvey(info.kind == SampleKind::unsigned_integer && info.bits <= 16)) {}

  void add(const RowBlock& block) {
    const std::size_t stride = channels_.size();
    for (std::size_t at = 0; at + stride <= block.samples.size(); at += stride) add_texel(&block.samples[at]);
  }

  [[nodiscard]] ImageStatistics result() const {
    ImageStatistics statistics;
    for (const ChannelSurvey& channel : channels_) statistics.channels.push_back(channel.statistics());
    statistics.colors_equal = colors_equal_;
    statistics.median = {channels_[0].median(), color_count_ > 1 ? channels_[1].median() : 0.0};
    if (integers_) statistics.level_step = level_step();
    if (lengths_ > 0) {
      statistics.signed_length_error = signed_error_ / static_cast<double>(lengths_);
      statistics.unsigned_length_error = unsigned_error_ / static_cast<double>(lengths_);
    }
    return statistics;
  }

 private:
  void add_texel(const float* texel) {
    for (std::size_t c = 0; c < channels_.size(); ++c) channels_[c].add(texel[c]);
    for (std::size_t c = 1; c < color_count_; ++c) {
      const bool both_nan = std::isnan(texel[c]) && std::isnan(texel[0]);
      colors_equal_ = colors_equal_ && (texel[c] == texel[0] || both_nan);
    }
    if (integers_ || color_count_ < 3) return;
    double as_stored = 0;
    double as_unsigned = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = static_cast<double>(texel[c]);
      as_stored += v * v;
      as_unsigned += (2 * v - 1) * (2 * v - 1);
    }
    if (!std::isfinite(as_stored)) return;
    signed_error_ += std::abs(std::sqrt(as_stored) - 1);
    unsigned_error_ += std::abs(std::sqrt(as_unsigned) - 1);
    ++lengths_;
  }

  [[nodiscard]] double level_step() const {
    std::optional<double> least;
    for (std::size_t c = 0; c < std::min<std::size_t>(2, channels_.size()); ++c) {
      const std::optional<double> step = channels_[c].level_step();
      if (step && (!least || *step < *least)) least = step;
    }
    return least.value_or(nominal_step_);
  }

  std::size_t color_count_;
  bool integers_;
  double nominal_step_;
  std::vector<ChannelSurvey> channels_;
  bool colors_equal_ = true;
  double signed_error_ = 0;
  double unsigned_error_ = 0;
  std::size_t lengths_ = 0;
};

}  // namespace

std::vector<int> ChannelChoice::all() const {
  std::vector<int> channels = colors;
  if (alpha) channels.push_back(*alpha);
  return channels;
}

ChannelChoice choose_channels(const ImageInfo& info) {
  std::vector<std::string> lower_names;
  lower_names.reserve(info.channels.size());
  for (const std::string& name : info.channels) lower_names.push_back(lower_case(name));
  ChannelChoice choice;
  if (info.alpha_channel >= 0) {
    choice.alpha = info.alpha_channel;
  } else if (const auto at = std::ranges::find(lower_names, "a"); at != lower_names.end()) {
    choice.alpha = static_cast<int>(at - lower_names.begin());
  }
  if (auto known = find_known_names(lower_names)) {
    choice.colors = std::move(*known);
    choice.by_name = true;
    return choice;
  }
  for (int c = 0; c < static_cast<int>(info.channels.size()); ++c) {
    if (c == choice.alpha) continue;
    if (choice.colors.size() < 3) {
      choice.colors.push_back(c);
    } else if (!choice.alpha) {
      choice.alpha = c;
    }
  }
  if (choice.colors.empty()) {  // a file of nothing but alpha
    choice.colors.push_back(*choice.alpha);
    choice.alpha.reset();
  }
  return choice;
}

Result<SurveyedImage> survey_image(const ImageInfo& info, const ChannelChoice& choice, JobControl& control) {
  ImageSurvey survey(info, choice);
  const std::vector<int> channels = choice.all();
  const Result<std::string> remark =
      read_rows(info, channels, control, [&](const RowBlock& block) { survey.add(block); });
  if (!remark) return remark.error();
  return SurveyedImage{survey.result(), *remark};
}

Layout settle_layout(const ChannelChoice& choice, const ImageStatistics& statistics) {
  const auto varies = [&](std::size_t channel) { return statistics.channels[channel].varies(); };
  const std::size_t colors = choice.colors.size();
  const bool alpha_varies = choice.alpha && varies(colors);
  if (colors == 1) {
    if (alpha_varies) return Layout::luminance_alpha;
    return varies(0) ? Layout::height : Layout::constant_grey;
  }
  if (colors == 3 && alpha_varies && !varies(0) && varies(1) && !varies(2)) return Layout::dxt5nm;
  if (statistics.colors_equal) return varies(0) ? Layout::height : Layout::constant_grey;
  if (colors == 2) return Layout::two_channel;
  return !varies(2) && (varies(0) || varies(1)) ? Layout::blue_constant : Layout::vector;
}

}  // namespace glint
