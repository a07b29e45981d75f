#pragma once
// The two lists of the file browser: what a folder holds, and the places one can go to. Each is one stop of the Tab
// key; inside, the arrow keys move. Main thread.

#include <string>
#include <string_view>
#include <vector>

#include "gui/dialogs/file_listing.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

struct ListState {
  int selected = -1;
  bool reveal = false;  ///< scroll the selected row into view in the next frame
};

struct ListEvents {
  bool selected = false;  ///< a person moved the selection
  bool opened = false;    ///< double click or Enter on the selected row
  bool parent = false;    ///< Backspace
};

/// Rows are recorded as browser.row.NAME; `empty_text` stands where there is none. Typing a letter goes to the next
/// name that begins with it.
ListEvents draw_file_list(view::Ui& ui, const view::Rectangle& area, const FolderListing& listing,
                          std::string_view empty_text, ListState& state);

struct PlaceRow {
  std::string key;  ///< recorded as browser.KEY
  std::string label;
  std::string detail;  ///< a second line, in hint; its end is shown where room is short
  std::string reason;  ///< why one cannot go there
  view::Icon icon = view::Icon::folder;
  bool is_heading = false;  ///< a caption of what follows; only the label is used
  bool is_current = false;  ///< the folder that is shown
};
/// Clicking a row selects it.
ListEvents draw_places(view::Ui& ui, const view::Rectangle& area, const std::vector<PlaceRow>& rows, ListState& state);

}  // namespace glint::gui
