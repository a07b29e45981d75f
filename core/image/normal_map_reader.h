#pragma once
// Files in: any picture that holds a normal map or a height field, decoded by the tables of the conventions, with a
// report of what was repaired, assumed or suspected on the way.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/surface/normal_map.h"

namespace glint {

class StoredSamples;

enum class ValueRange { automatic, signed_values, unsigned_values };
enum class GreenDirection { up, down };

struct ReadOptions {
  ValueRange range = ValueRange::automatic;   ///< of float files; integers are always 2c - 1
  GreenDirection green = GreenDirection::up;  ///< `down` (DirectX) flips t on reading, and nowhere else
  std::optional<double> height_scale;         ///< set: the file is a height field, value * scale in texels
  Wrap wrap = Wrap::repeat;

  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

/// What the reader did and noticed; each note is one sentence without a full stop.
struct ReadReport {
  enum class Severity {
    info,     ///< what was assumed (range, channels)
    warning,  ///< what was repaired or is suspected
  };
  struct Note {
    Severity severity;
    std::string sentence;
  };

  std::string format;            ///< "PNG, 8-bit, RGB, 512 x 512"
  double quantisation_step = 0;  ///< smallest step between two values of s or t in the file; 0 for float files
  std::optional<GreenDirection> suggested_green;  ///< where the curl of the slope field contradicts the choice made
  std::vector<Note> notes;
};

struct ReadNormalMap {
  NormalMap map;
  ReadReport report;
};

/// Reads `path`. The size is checked from the header before anything of that size is allocated. Not cancellable inside
/// the decoder of a block of rows; `control` is asked between blocks. What the file holds goes to `stored`, if that is
/// given and the file can be read.
Result<ReadNormalMap> read_normal_map(const std::filesystem::path& path, const ReadOptions& options,
                                      JobControl& control, StoredSamples* stored = nullptr);

/// The note for a map whose 8-bit (or coarser) steps show at this intrinsic roughness; none if they do not.
std::optional<std::string> quantisation_note(const ReadReport& report, double intrinsic_roughness);

}  // namespace glint
