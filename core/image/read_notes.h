#pragma once
// What the reader tells the person about a file: sentences made from what the survey, the decoder and the diagnostics
// counted. Suspicions are voiced only where they are clear.

#include "core/image/channel_layout.h"
#include "core/image/normal_decoder.h"
#include "core/image/normal_map_reader.h"
#include "core/surface/map_diagnostics.h"

namespace glint {

/// Everything that is known about a file read as a normal map.
struct NormalReading {
  const ImageInfo& info;
  const ReadOptions& options;
  const ChannelChoice& choice;
  const ImageStatistics& statistics;
  const DecodingRules& rules;
  const DecodingCounts& counts;
};

/// "PNG, 8-bit, RGB, 512 x 512"
std::string format_text(const ImageInfo& info);

/// The file itself: more images than the one that is read, a JPEG cut short, what the decoder remarked.
void note_file(const ImageInfo& info, const std::string& remark, ReadReport& report);

/// Which channels and which range were taken.
void note_assumptions(const NormalReading& reading, ReadReport& report);

/// Texels that were repaired or look odd, with counts and first positions.
void note_repairs(const NormalReading& reading, ReadReport& report);

/// Signs in the values that the file is not a tangent-space normal map as it was read.
void note_suspicions(const NormalReading& reading, ReadReport& report);

/// Signs in the decoded map: a green direction that contradicts the choice, edges that do not meet.
void note_diagnostics(const NormalMap& map, const ReadOptions& options, ReadReport& report);

/// Edges that do not meet; nothing for a map that clamps.
void note_seams(const SeamRatios& seams, Wrap wrap, ReadReport& report);

/// True where the medians look like those of values with a transfer curve too much, so that its effect on the lengths
/// of the vectors is worth measuring.
bool suspects_transfer(const ImageStatistics& statistics);

/// "12 texels", "1 texel"
std::string texels_text(std::size_t count);

}  // namespace glint
