#include "core/image/read_notes.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/image/jpeg_check.h"

namespace glint {
namespace {

using Severity = ReadReport::Severity;

void inform(ReadReport& report, std::string sentence) {
  report.notes.push_back({Severity::info, std::move(sentence)});
}
void warn(ReadReport& report, std::string sentence) {
  report.notes.push_back({Severity::warning, std::move(sentence)});
}

std::string join(const std::vector<std::string>& names, std::string_view between) {
  std::string text;
  for (const std::string& name : names) text += text.empty() ? name : fmt::format("{}{}", between, name);
  return text;
}

std::vector<std::string> names_of(const ImageInfo& info, const std::vector<int>& channels) {
  std::vector<std::string> names;
  names.reserve(channels.size());
  for (const int channel : channels) names.push_back(info.channels[static_cast<std::size_t>(channel)]);
  return names;
}

std::string times_text(double factor) {
  if (factor >= 1000) return "over 1000 times";
  return factor >= 10 ? fmt::format("{:.0f} times", factor) : fmt::format("{:.1f} times", factor);
}

std::string at(const TexelCount& texels) {
  return fmt::format("column {}, row {}", texels.first.x, texels.first.y);
}

std::string count_and_place(const TexelCount& texels, std::string_view what) {
  return fmt::format("{} {}; the first at {}", texels_text(texels.count), what, at(texels));
}

// Medians of red and green where 0.5 was encoded to 0.735 or linearised to 0.214, with room for a map that leans.
bool both_within(const ImageStatistics& statistics, double least, double greatest) {
  return std::ranges::all_of(statistics.median, [&](double m) { return m > least && m < greatest; });
}
bool looks_encoded(const ImageStatistics& statistics) {
  return both_within(statistics, 0.66, 0.80);
}
bool looks_linearised(const ImageStatistics& statistics) {
  return both_within(statistics, 0.13, 0.30);
}

// Real maps differ from unit length by up to 0.15 on average, so only a clear gain speaks for a curve.
constexpr double k_clear_gain = 0.8;
constexpr double k_least_length_error = 0.04;

void note_transfer(const NormalReading& reading, ReadReport& report) {
  const DecodingCounts& counts = reading.counts;
  if (!reading.rules.measure_transfer || counts.vectors == 0) return;
  const double bound = k_clear_gain * counts.length_error;
  if (counts.length_error < k_least_length_error * static_cast<double>(counts.vectors)) return;
  if (looks_encoded(reading.statistics) && counts.length_error_linearised < bound) {
    warn(report,
         "the values look as if the sRGB curve had been applied to them by mistake; a normal map must be stored as "
         "linear data");
  }
  if (looks_linearised(reading.statistics) && counts.length_error_encoded < bound) {
    warn(report,
         "the values look as if they had been converted from sRGB to linear by mistake; a normal map must be stored as "
         "it is, without colour conversion");
  }
}

void note_orientation(const NormalReading& reading, ReadReport& report) {
  const DecodingCounts& counts = reading.counts;
  if (reading.rules.layout != Layout::vector || counts.vectors < 64) return;
  const auto vectors = static_cast<double>(counts.vectors);
  const auto share = [&](std::size_t direction) { return static_cast<double>(counts.leaning[direction]) / vectors; };
  const glm::dvec3 mean = counts.sum / vectors;
  const double turned_away = static_cast<double>(counts.turned_away.count) / vectors;
  if (mean.x > 0.5 && mean.z < 0.3 && turned_away > 0.2) {
    warn(report,
         "red points where blue should: the channels look swapped (BGR); swap red and blue in the program that wrote "
         "the file");
    return;
  }
  constexpr double k_present = 0.02;
  const auto sideways = std::ranges::count_if(std::array<std::size_t, 4>{0, 1, 2, 3},
                                              [&](std::size_t direction) { return share(direction) > k_present; });
  if (share(5) > k_present && sideways >= 3 && glm::length(mean) < 0.4) {
    warn(report,
         "normals point all round: this looks like an object-space or world-space map, but tangent space is needed");
  }
}

void note_range(const NormalReading& reading, ReadReport& report) {
  if (reading.info.kind != SampleKind::floating || reading.options.range != ValueRange::automatic) return;
  const ImageStatistics& statistics = reading.statistics;
  const double taken = reading.rules.signed_values ? statistics.signed_length_error : statistics.unsigned_length_error;
  const double other = reading.rules.signed_values ? statistics.unsigned_length_error : statistics.signed_length_error;
  const char* option = reading.rules.signed_values ? "unsigned" : "signed";
  if (reading.rules.layout == Layout::vector && taken > 0.1 && other < 0.25 * taken) {
    warn(report, fmt::format("the vectors would be nearly of unit length with the other range: `--range {}` may be "
                             "right",
                             option));
    return;
  }
  const double greatest = std::max(statistics.channels[0].greatest, statistics.channels[1].greatest);
  if (!reading.rules.signed_values && greatest > 1.01) {
    warn(report, fmt::format("values up to {:.4g} were read as 2c - 1 although that takes them for at most 1: `--range "
                             "signed` takes them as they stand",
                             greatest));
  }
}

void note_lengths(const DecodingCounts& counts, ReadReport& report) {
  if (counts.vectors == 0) return;
  const double mean = counts.length_error / static_cast<double>(counts.vectors);
  const std::string sentence =
      fmt::format("vectors between {:.3g} and {:.3g} long were normalised (they differ from 1 by {:.2g} on average)",
                  counts.least_length, counts.greatest_length, mean);
  if (mean > 0.25) {
    warn(report, sentence);
  } else if (mean > 0.05 || counts.least_length < 0.5 || counts.greatest_length > 1.5) {
    inform(report, sentence);
  }
}

const char* layout_sentence(Layout layout) {
  switch (layout) {
    case Layout::two_channel:
      return "two channels were taken as x and y, and z was rebuilt from them";
    case Layout::luminance_alpha:
      return "luminance and alpha were taken as x and y because alpha varies, and z was rebuilt from them";
    case Layout::blue_constant:
      return "blue is constant, so z was rebuilt from red and green";
    case Layout::dxt5nm:
      return "red and blue are constant and alpha varies (DXT5nm): x was taken from alpha, y from green, and z was "
             "rebuilt from them";
    case Layout::vector:
    case Layout::height:
    case Layout::constant_grey:
      break;
  }
  return nullptr;
}

}  // namespace

std::string format_text(const ImageInfo& info) {
  const bool single_letters = std::ranges::all_of(info.channels, [](const auto& name) { return name.size() == 1; });
  const std::string channels = info.channels.size() > 8 ? fmt::format("{} channels", info.channels.size())
                                                        : join(info.channels, single_letters ? "" : " ");
  return fmt::format("{}, {}-bit{}, {}, {} x {}", format_title(info.format), info.bits,
                     info.kind == SampleKind::floating ? " float" : "", channels, info.width, info.height);
}

std::string texels_text(std::size_t count) {
  return count == 1 ? "1 texel" : fmt::format("{} texels", count);
}

void note_file(const ImageInfo& info, const std::string& remark, ReadReport& report) {
  if (info.images > 1) inform(report, fmt::format("the file holds {} images; the first was read", info.images));
  if (info.format == ImageFormat::jpeg && !jpeg_reaches_its_end(info.path)) {
    warn(report, "the file is cut short: the JPEG data end before the end of the image, and what is missing is grey");
  } else if (!remark.empty()) {
    warn(report, fmt::format("the decoder went on after a fault: {}", remark));
  }
}

void note_assumptions(const NormalReading& reading, ReadReport& report) {
  const auto& [info, options, choice, statistics, rules, counts] = reading;
  if (choice.all().size() < info.channels.size()) {
    inform(report, fmt::format("of {} channels, {} were read", info.channels.size(),
                               join(names_of(info, choice.colors), ", ")));
  }
  if (rules.layout == Layout::vector && choice.alpha) {
    inform(report, "the alpha channel is not part of a normal and was ignored");
  }
  if (const char* sentence = layout_sentence(rules.layout)) inform(report, sentence);
  if (info.kind == SampleKind::signed_integer) inform(report, "signed integers were taken as they stand, in [-1, 1]");
  if (info.kind == SampleKind::floating && options.range == ValueRange::automatic) {
    inform(report, rules.signed_values
                       ? "float values were taken as they stand, because x or y is negative somewhere"
                       : "float values were read as 2c - 1, because x and y are nowhere negative; `--range signed` "
                         "takes them as they stand");
  }
}

void note_repairs(const NormalReading& reading, ReadReport& report) {
  const DecodingCounts& counts = reading.counts;
  if (counts.not_finite.count > 0) {
    warn(report, count_and_place(counts.not_finite, "held NaN or infinity and became the flat normal"));
  }
  if (counts.zero.count > 0) {
    warn(report, count_and_place(counts.zero, "held a zero vector and became the flat normal"));
  }
  if (counts.beyond_rim.count > 0) {
    warn(report, count_and_place(counts.beyond_rim, "had (s, t) longer than 1, scaled onto the rim of the disk"));
  }
  if (counts.turned_away.count > 0) {
    warn(report, count_and_place(counts.turned_away, "had z <= 0 (facing away from the surface); (s, t) were kept"));
  }
  note_lengths(counts, report);
}

bool suspects_transfer(const ImageStatistics& statistics) {
  return looks_encoded(statistics) || looks_linearised(statistics);
}

void note_suspicions(const NormalReading& reading, ReadReport& report) {
  note_transfer(reading, report);
  note_orientation(reading, report);
  note_range(reading, report);
}

void note_diagnostics(const NormalMap& map, const ReadOptions& options, ReadReport& report) {
  const std::optional<double> curl = curl_ratio(map);
  if (curl && *curl < 1 / k_clear_curl_ratio) {
    const bool up = options.green == GreenDirection::up;
    report.suggested_green = up ? GreenDirection::down : GreenDirection::up;
    warn(report, fmt::format("the curl of the slopes is {} smaller with green pointing {}: `--green {}` is "
                             "probably right",
                             times_text(1 / *curl), up ? "down (DirectX)" : "up (OpenGL)", up ? "down" : "up"));
  }
  note_seams(seam_ratios(map), map.wrap(), report);
}

void note_seams(const SeamRatios& seams, Wrap wrap, ReadReport& report) {
  const double worst = std::max(seams.left_right, seams.top_bottom);
  if (wrap == Wrap::clamp || worst <= k_clear_seam_ratio) return;
  const char* edges = seams.left_right > k_clear_seam_ratio
                          ? (seams.top_bottom > k_clear_seam_ratio ? "opposite edges" : "the left and right edges")
                          : "the top and bottom edges";
  warn(report, fmt::format("the map repeats, but {} do not meet (a jump {} that between neighbours); `--wrap "
                           "clamp` does not repeat it",
                           edges, times_text(worst)));
}

}  // namespace glint
