#pragma once
// Changes of one field, as the controls of the Inspector propose them: checked, explained where they are refused, and
// brought to round values where a slider gives them. Pure functions.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/parameter.h"
#include "core/math/result.h"
#include "viewers/edit.h"

namespace glint::view {

/// "Roughness σ": the name of a field in a narrow column.
std::string_view narrow_label(const Parameter& parameter);
/// "Intrinsic roughness σ_r": the name of a field where there is room.
std::string full_label(const Parameter& parameter);
/// "σ_r" for "sigma_r".
std::string symbol_text(std::string_view symbol);

/// With a capital letter and a full stop; options of the command line, which notes name as `--green down`, as “green
/// down”.
std::string sentence_text(std::string_view note);

/// A value as it stands in the label of an edit: "0.02", "clamp", "8, 32", "none".
std::string edit_text(const ParameterValue& value);

/// The document with that value, as a finished edit "Roughness σ to 0.02". An error of Parameter::checked() or
/// document_fault(), as a sentence that begins with the field's name.
Result<Edit> proposed(const Document& document, const Parameter& parameter, const ParameterValue& value);

/// A choice that other fields stand against (scratches on a map of 1000 texels) takes them along to the nearest value
/// that fits; the error is left where that is not enough.
Result<Edit> proposed_choice(const Document& document, const Parameter& parameter, const std::string& choice);

/// What a person typed for the component of a list whose numbers are `shown`, or for all of a field ("8, 32", "fit").
/// Units and signs as they are shown are understood: "−35°", "12 texels", "1.5 M".
Result<Edit> typed_edit(const Document& document, const Parameter& parameter, const std::vector<double>& shown,
                        std::size_t component, std::string_view text);

/// Where a slider came to rest, as a round number that the document allows: three significant digits, those of its span
/// where it is linear; whole numbers, two digits of large counts, powers of two and their halfway points for sizes.
/// None if nothing near is allowed. `by_key`: a step of the keyboard, which reaches the next round number at least.
std::optional<ParameterValue> slid_value(const Document& document, const Parameter& parameter, double wanted,
                                         bool by_key);

/// A number of the field, for a slider: none where it has no single number now.
std::optional<double> slider_number(const ParameterValue& value);

}  // namespace glint::view
