#pragma once
// What the reader of the map reported, in the Inspector: what it took the file for, what it repaired or suspects, and
// the button where it suggests the other green direction.

#include <string>
#include <string_view>

#include "core/image/normal_map_reader.h"
#include "core/surface/normal_map.h"
#include "viewers/inspector/field_rows.h"

namespace glint::view {

/// "1024 × 1024" and "PNG, 8-bit, RGB".
struct FormatText {
  std::string size;
  std::string rest;

  friend bool operator==(const FormatText&, const FormatText&) = default;
};
FormatText format_text(const ReadReport& report, const NormalMap& map);

/// Format and notes as lines, for a tooltip.
std::string report_text(const ReadReport& report, const NormalMap& map);

/// A sentence over the whole width, broken into lines; with the warning's icon where it is one.
void sentence_row(FieldPage& page, std::string_view sentence, bool warning);

/// The rows of a file's report, and of its steps at this roughness. In a compact column only the warnings; the rest
/// stands in report_text().
void read_report_rows(FieldPage& page, const ReadReport& report, const NormalMap& map);

}  // namespace glint::view
