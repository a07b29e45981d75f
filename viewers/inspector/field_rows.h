#pragma once
// The Inspector's rows: one control for one parameter, made from its declaration by its kind. Names in the widget
// record follow the parameter's path (controls_of()); a row that differs from what is saved ends in the arrow
// "path.reset".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/parameter.h"
#include "viewers/edit.h"
#include "viewers/widgets/ui.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {

/// A column of rows that is being drawn, and what a person changed in it in this frame. Lengths are screen pixels.
struct FieldPage {
  Ui& ui;
  const Document& document;
  const Document& saved;  ///< what "reset" goes back to
  float left = 0;         ///< of the labels
  float controls = 0;     ///< left end of the controls
  float right = 0;        ///< right end of the controls, where the gutter of the reset arrows begins
  float y = 0;            ///< top of the next row
  bool compact = false;   ///< entries are narrower, what only reports moves to tooltips
  std::optional<Edit> edit = {};
};

/// What a section knows better than the declaration.
struct FieldLook {
  std::string_view label = {};               ///< instead of the narrow label
  std::string reason = {};                   ///< why it has no effect now: shown disabled
  std::vector<double> meanwhile = {};        ///< numbers to show where the field is none or `instead`; empty: not known
  std::vector<double> begin_with = {};       ///< what such a field gets when a person takes over and they are not known
  std::vector<std::string_view> units = {};  ///< of the entries of a list
};

/// The next row of the page, from its left to its right end.
Rectangle take_row(FieldPage& page, float height = 24, float pitch = 29);
/// In the label column of `row`.
void row_label(const FieldPage& page, const Rectangle& row, std::string_view label, bool enabled = true);
/// The part of `row` right of the labels.
Rectangle control_area(const FieldPage& page, const Rectangle& row);
/// The k-th of `count` equal parts of `area`, with a gap between them.
Rectangle part_of(const Ui& ui, const Rectangle& area, std::size_t k, std::size_t count);
/// Width of a typed entry beside a slider.
float entry_width(const FieldPage& page);

/// Tooltip of a control of the parameter: what it does, what is allowed, its default and its paper.
Explained explain_parameter(const Parameter& parameter, const std::string& reason = {});

/// Label, controls and reset arrow.
void field_row(FieldPage& page, const Parameter& parameter, const FieldLook& look = {});
/// The controls alone, in `area`: a slider with its entry, or an entry where no slider is declared.
void number_controls(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look = {});
/// A switch or a combo.
void choice_control(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look = {});
/// The box that switches one of several choices on and off; the last one that is on stays.
void choice_box(FieldPage& page, const Parameter& parameter, std::string_view choice, const Rectangle& area,
                std::string_view label);
/// In the gutter of `row`, where the field differs from what is saved.
void reset_control(FieldPage& page, const Parameter& parameter, const Rectangle& row);

/// An entry for one number of the page: what is shown is as long as it fits. Returns what a person typed, if anything.
std::optional<std::string> number_entry(FieldPage& page, std::string_view name, const Rectangle& area, double value,
                                        std::string_view unit, const Explained& explained);
/// Takes the edit over, or keeps the entry open with the reason.
void take_typed(FieldPage& page, std::string_view entry_name, std::string_view text, Result<Edit> edit);

/// Names of the controls that set the parameter: all of them are in the record when its row is drawn.
std::vector<std::string> controls_of(const Parameter& parameter);

}  // namespace glint::view
