#pragma once
// What keys do when no text is typed: the stops of the Tab key, and Space, Enter and arrows for the control that has
// the focus. Pure functions on the record of the last frame.

#include <cstddef>
#include <optional>
#include <string>

#include "gui/input/chord.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

/// The control after (or before) `name` among those drawn from the `first`-th on; the first or last of them where
/// `name` is none of them. Empty where there is none at all.
std::string next_stop(const view::WidgetRecord& widgets, std::size_t first, const std::string& name, bool backwards);

/// Hands a chord to the control that has the focus; false if it is not one that controls use.
bool feed_focus(view::KeyboardFocus& focus, const Chord& chord);

}  // namespace glint::gui
