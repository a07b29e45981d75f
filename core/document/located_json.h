#pragma once
// JSON text as a flat list of fields, each with the line and column where it stands. Private to document/.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/parameter.h"
#include "core/math/result.h"

namespace glint {

struct TextPosition {
  int line = 1;
  int column = 1;  ///< in characters, not bytes; a tab is one
};

/// One member of an object. Members of inner objects follow their object.
struct LocatedField {
  std::string path;  ///< the names of the objects around it and its own, joined by dots
  TextPosition name_position;
  TextPosition value_position;
  bool is_object = false;
  /// None for an object, and for what no field holds: a list of anything but only numbers or only texts.
  std::optional<ParameterValue> value;
  std::string raw;  ///< the value as the text has it, shortened to fit an error
};

/// "file:line:column", the subject of an error there.
std::string located_subject(const std::string& file, TextPosition position);

/// Reads one object and nothing after it. A content error located in `file` (named so in the error) for what is not
/// UTF-8, not JSON, no object, nested deeper than 8 levels, a field given twice, or a name that is empty or holds a
/// dot.
Result<std::vector<LocatedField>> parse_located_json(std::string_view text, const std::string& file);

}  // namespace glint
