#pragma once
// The row of controls above the pictures of the P-NDF panel.

#include <optional>
#include <span>
#include <string>

#include "viewers/edit.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// Something that holds of all pictures: said at the right of the row, in the longer form where there is room.
struct PndfNote {
  std::string full;
  std::string brief;
};

/// `notes` come before the hint about the key that flips, whose name is `flip_chord`.
std::optional<Edit> draw_pndf_toolbar(Ui& ui, const Rectangle& row, const Document& document,
                                      std::span<const PndfNote> notes, const std::string& flip_chord);

}  // namespace glint::view
