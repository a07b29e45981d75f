#include "core/image/normal_map_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "core/image/channel_layout.h"
#include "core/image/image_file.h"
#include "core/image/normal_decoder.h"
#include "core/image/read_notes.h"
#include "core/image/stored_samples.h"
#include "core/surface/height_field.h"
#include "core/surface/map_diagnostics.h"

namespace glint {
namespace {

using Severity = ReadReport::Severity;

std::optional<Error> options_fault(const ReadOptions& options) {
  if (!options.height_scale) return std::nullopt;
  if (!std::isfinite(*options.height_scale) || *options.height_scale == 0) {
    return request_error("--height", "the scale of heights must be a finite number other than 0");
  }
  if (options.green == GreenDirection::down) {
    return request_error("--green",
                         "a height field has no green channel: --green down and --height exclude each other");
  }
  return std::nullopt;
}

std::size_t texel_count(const ImageInfo& info) {
  return static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height);
}

Error no_normal_map(const ImageInfo& info, Layout layout, bool one_channel) {
  if (layout == Layout::constant_grey) {
    return content_error(info.path.string(), "is one constant grey: not a normal map");
  }
  return content_error(info.path.string(),
                       fmt::format("{}, as in a height field, not a normal map: `--height SCALE` turns heights into "
                                   "normals",
                                   one_channel ? "has one channel" : "has the same value in all channels"));
}

bool takes_values_as_they_stand(const ImageInfo& info, const ImageStatistics& statistics, Layout layout,
                                ValueRange range) {
  if (info.kind == SampleKind::signed_integer) return true;
  if (info.kind == SampleKind::unsigned_integer) return false;
  if (range != ValueRange::automatic) return range == ValueRange::signed_values;
  const std::size_t x = layout == Layout::dxt5nm ? 3 : 0;
  return statistics.channels[x].least < 0 || statistics.channels[1].least < 0;
}

bool is_constant(const ImageStatistics& statistics) {
  return std::ranges::none_of(statistics.channels,
                              [](const ChannelStatistics& c) { return c.varies() || c.not_finite > 0; });
}

Result<ReadNormalMap> decode_normals(const ImageInfo& info, const ReadOptions& options, const ChannelChoice& choice,
                                     const SurveyedImage& survey, JobControl& control, StoredSamples* stored) {
  const ImageStatistics& statistics = survey.statistics;
  DecodingRules rules;
  rules.layout = settle_layout(choice, statistics);
  rules.green = options.green;
  if (rules.layout == Layout::height || rules.layout == Layout::constant_grey) {
    return no_normal_map(info, rules.layout, choice.colors.size() == 1);
  }
  rules.signed_values = takes_values_as_they_stand(info, statistics, rules.layout, options.range);
  rules.measure_transfer = rules.layout == Layout::vector && !rules.signed_values && suspects_transfer(statistics);

  std::vector<glm::vec2> normals(texel_count(info));
  const std::vector<int> channels = choice.all();
  NormalDecoder decoder(rules, channels.size(), info.width, normals);
  if (stored) *stored = StoredSamples(info, channels);
  const Result<std::string> read = read_rows(info, channels, control, [&](const RowBlock& block) {
    decoder.decode(block);
    if (stored) stored->keep(block);
  });
  if (!read) return read.error();

  ReadNormalMap result{NormalMap(info.width, info.height, std::move(normals), options.wrap), {}};
  ReadReport& report = result.report;
  report.format = format_text(info);
  report.quantisation_step = statistics.level_step * (rules.signed_values ? 1 : 2);
  const NormalReading reading{info, options, choice, statistics, rules, decoder.counts()};
  note_file(info, survey.remark, report);
  note_assumptions(reading, report);
  note_repairs(reading, report);
  if (is_constant(statistics)) {
    const glm::vec2 normal = result.map.normals().front();
    report.notes.push_back(
        {Severity::warning,
         fmt::format("the map is constant: every texel holds (s, t) = ({:.4g}, {:.4g})", normal.x, normal.y)});
    return result;
  }
  note_suspicions(reading, report);
  note_diagnostics(result.map, options, report);
  return result;
}

void note_heights(const ReadOptions& options, const ChannelChoice& choice, const ImageStatistics& statistics,
                  const HeightFieldNormals& converted, ReadReport& report) {
  const auto note = [&](Severity severity, std::string sentence) {
    report.notes.push_back({severity, std::move(sentence)});
  };
  note(Severity::info,
       fmt::format("values times {:.6g} were taken as heights in texels and turned into normals by central differences",
                   *options.height_scale));
  if (choice.alpha) note(Severity::info, "the alpha channel is not part of a height and was ignored");
  if (const std::size_t bad = statistics.channels[0].not_finite; bad > 0) {
    note(Severity::warning, fmt::format("{} held no finite height", texels_text(bad)));
  }
  if (converted.bad_slopes > 0) {
    note(Severity::warning,
         fmt::format("{} without a finite slope of at most 1000 became the flat normal; the first at "
                     "column {}, row {}",
                     texels_text(converted.bad_slopes), converted.first_bad.x, converted.first_bad.y));
  }
  if (!statistics.channels[0].varies()) note(Severity::warning, "the height is constant: every texel is flat");
}

Result<ReadNormalMap> decode_heights(const ImageInfo& info, const ReadOptions& options, const ChannelChoice& choice,
                                     const SurveyedImage& survey, JobControl& control, StoredSamples* stored) {
  const ImageStatistics& statistics = survey.statistics;
  if (choice.colors.size() > 1 && !statistics.colors_equal) {
    return content_error(info.path.string(),
                         "its channels differ, so it is not a height field: without --height it is read as a normal "
                         "map");
  }
  std::vector<float> heights(texel_count(info));
  const std::array channel{choice.colors[0]};
  if (stored) *stored = StoredSamples(info, channel);
  const Result<std::string> read = read_rows(info, channel, control, [&](const RowBlock& block) {
    if (stored) stored->keep(block);
    const auto first = static_cast<std::ptrdiff_t>(block.first_row) * info.width;
    std::ranges::copy(block.samples, heights.begin() + first);
  });
  if (!read) return read.error();

  HeightFieldNormals converted =
      normals_from_heights(heights, info.width, info.height, *options.height_scale, options.wrap);
  ReadReport report;
  report.format = format_text(info);
  // Between two neighbours of a texel, which are two texels apart.
  report.quantisation_step = 0.5 * std::abs(*options.height_scale) * statistics.level_step;
  note_file(info, survey.remark, report);
  note_heights(options, choice, statistics, converted, report);
  note_seams(seam_ratios(heights, info.width, info.height), options.wrap, report);
  return ReadNormalMap{std::move(converted.map), std::move(report)};
}

}  // namespace

Result<ReadNormalMap> read_normal_map(const std::filesystem::path& path, const ReadOptions& options,
                                      JobControl& control, StoredSamples* stored) {
  if (const std::optional<Error> fault = options_fault(options)) return *fault;
  try {
    const Result<ImageInfo> info = inspect_image(path);
    if (!info) return info.error();
    control.expect_steps(2 * row_block_count(*info));
    const ChannelChoice choice = choose_channels(*info);
    const Result<SurveyedImage> survey = survey_image(*info, choice, control);
    if (!survey) return survey.error();
    return options.height_scale ? decode_heights(*info, options, choice, *survey, control, stored)
                                : decode_normals(*info, options, choice, *survey, control, stored);
  } catch (const std::bad_alloc&) {
    return content_error(path.string(), "not enough memory to read it");
  } catch (const std::exception& failure) {
    return content_error(path.string(), fmt::format("cannot be read: {}", failure.what()));
  }
}

std::optional<std::string> quantisation_note(const ReadReport& report, double intrinsic_roughness) {
  if (!(intrinsic_roughness < report.quantisation_step)) return std::nullopt;
  return fmt::format(
      "the file's values step by {:.2g}, which is more than the intrinsic roughness of {:.4g}: single steps show in "
      "D(s), and more bits or a larger roughness would hide them",
      report.quantisation_step, intrinsic_roughness);
}

}  // namespace glint
