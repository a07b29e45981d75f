#pragma once
// Every field of a document, declared once: name, unit, range, default, help and paper. The Inspector, presets, command
// line, recipe, undo and help all follow from these declarations; a new field is one entry in one of the
// *_parameters.cpp.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/document/document.h"
#include "core/math/result.h"

namespace glint {

/// The value of a field on its way in or out. `std::monostate` is "none".
using ParameterValue = std::variant<std::monostate, bool, double, std::uint64_t, std::string, std::vector<double>,
                                    std::vector<std::string>>;

enum class ParameterKind {
  number,   ///< double; or none, where may_be_none
  integer,  ///< std::uint64_t
  flag,     ///< bool
  text,     ///< std::string: UTF-8 without control characters
  path,     ///< like text, may be empty
  choice,   ///< std::string, one of `choices`
  numbers,  ///< std::vector<double>, one for each of `components`; or std::string `instead`, where that is not empty
  choices,  ///< std::vector<std::string>: one or more of `choices`, none twice
};

struct NumberRange {
  double lowest = 0;
  double highest = 0;
  bool open_lowest = false;   ///< `lowest` itself is not allowed
  bool without_zero = false;  ///< 0 lies between them and is not allowed
};

struct IntegerRange {
  std::uint64_t lowest = 0;
  std::uint64_t highest = 0;
};

/// The part of a field's range that a slider spans; typed entries reach the whole range. Empty (0, 0): no slider.
struct SliderRange {
  double lowest = 0;
  double highest = 0;
  bool logarithmic = false;

  [[nodiscard]] constexpr bool empty() const { return lowest == highest; }
};

/// How a field stands in a document; `set` expects a value that has been checked.
struct ParameterAccess {
  ParameterValue (*get)(const Document&);
  void (*set)(Document&, const ParameterValue&);
};

struct Parameter {
  std::string_view path;              ///< "surface.generator.rms_slope": the name in presets, scripts and recipes
  std::string_view label;             ///< "RMS slope": the name in a window
  std::string_view short_label = {};  ///< "Roughness σ": for narrow columns, at most 12 characters; empty: the label
  std::string_view symbol = {};       ///< "sigma_r": the name in formulas, or empty
  std::string_view unit = {};         ///< "texels", "degrees" …; empty: dimensionless
  ParameterKind kind;
  NumberRange range = {};  ///< of a number, or of each of the numbers
  IntegerRange integer_range = {};
  SliderRange slider = {};
  std::span<const std::string_view> choices = {};
  std::span<const std::string_view> components = {};  ///< names of the numbers of a list
  bool ascending = false;                             ///< each pair of the list is a shortest and a longest
  bool strictly = false;                              ///< and they must differ
  bool may_be_none = false;
  std::string_view instead = {};  ///< the word that may stand instead of the numbers ("fit")
  std::string_view help;          ///< one sentence: what it does
  std::string_view source;        ///< where it is defined: paper and equation, or the part of this tool
  ParameterAccess access;
  /// Whether its value has any effect on what this document computes (a seed of the noise has none on a file).
  bool (*matters)(const Document&);

  [[nodiscard]] ParameterValue get(const Document& document) const { return access.get(document); }
  /// That of a default document.
  [[nodiscard]] ParameterValue default_value() const { return access.get(Document()); }
  /// What is allowed, as a phrase: "a number above 0 and at most 1".
  [[nodiscard]] std::string allowed() const;
  /// `value` as this field holds it (a whole double becomes an integer, …), or a request error with the field as
  /// subject: "is 2; allowed: a number above 0 and at most 1".
  [[nodiscard]] Result<ParameterValue> checked(const ParameterValue& value) const;
  /// Checks and sets; an error leaves the document as it was.
  Status set(Document& document, const ParameterValue& value) const;
};

/// All of them, those of one object side by side, in the order in which they are written.
std::span<const Parameter> parameters();

/// The parameter of exactly that path, or null.
const Parameter* find_parameter(std::string_view path);

/// The one a person most likely meant: by spelling of its path, the end of its path, its symbol or its label.
const Parameter& nearest_parameter(std::string_view path);

/// The first fault of a document: a field outside its range, or fields that do not fit each other. A request error
/// whose subject is the field's path. A document without one can be computed, if the machine and its file allow it.
std::optional<Error> document_fault(const Document& document);

/// A value as it stands in an error: numbers in their shortest form, text in quotes, long text shortened.
std::string value_text(const ParameterValue& value);

}  // namespace glint
