#pragma once
// The sections of the Inspector: what each holds, what its header says, and where a control stands.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "viewers/inspector/field_rows.h"
#include "viewers/inspector/inspector.h"

namespace glint::view {

/// What a section draws into.
struct SectionScene {
  FieldPage& page;
  const InspectorInput& input;
  InspectorEvents& events;
  Rectangle header;  ///< of the section, its right end that of the controls
};

struct InspectorSection {
  std::string_view name;  ///< "section.surface"
  std::string_view (*title)(const Document& document);
  std::string (*summary)(const InspectorInput& input, bool open);  ///< right-aligned in the header; may be empty
  float (*height)(const InspectorInput& input, bool compact);      ///< of its rows at scale 1, about
  void (*draw)(const SectionScene& scene);
};

/// In the order in which they stand.
std::span<const InspectorSection> inspector_sections();

/// The name of the section in which the control of that name stands, empty for what stands above all sections; none
/// where this document has no such control.
std::optional<std::string_view> section_of(std::string_view control, const Document& document);

}  // namespace glint::view
