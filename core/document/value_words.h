#pragma once
// Values of fields as a person types them: in an entry of the window, on the command line, in a script.

#include <string_view>

#include "core/document/parameter.h"
#include "core/math/result.h"

namespace glint {

/// The value that `words` name: "1e-3", "1000000" or "1e6" for whole numbers, "8, 32", "fit", "exact, binning", "true",
/// "none" where a field may be none. The decimal point is a point in every locale. A request error whose subject is the
/// field's path and whose sentence is that of Parameter::checked().
Result<ParameterValue> value_from_words(const Parameter& parameter, std::string_view words);

}  // namespace glint
