#pragma once
// Text that people or files hand in: is it UTF-8, and how does it fit into one line of an error.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// The byte at which `text` stops being UTF-8 (overlong forms and surrogates are not), or nothing.
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

/// Text of unknown origin as part of one line: control characters and broken UTF-8 become '?', and what is longer than
/// `most_bytes` is cut with an ellipsis, between characters.
std::string one_line(std::string_view text, std::size_t most_bytes = 60);

}  // namespace glint
