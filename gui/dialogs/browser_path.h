#pragma once
// The path bar of the file browser: the button to the folder above, the folder as an entry, and how what a person
// types there can go on. Main thread.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gui/dialogs/file_listing.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

class PathBar {
 public:
  struct Event {
    bool parent = false;
    std::optional<std::filesystem::path> go;  ///< to a folder, to the folder of a file
  };

  /// `may_be_new`: a file that is not there yet will do, if its folder is.
  Event draw(view::Ui& ui, const view::Rectangle& area, const std::filesystem::path& folder, const FileFilter& filter,
             bool may_be_new);
  /// Over what stands below the bar: to be called after that was drawn.
  void draw_suggestions(view::Ui& ui);

 private:
  void suggest(view::Ui& ui, const std::filesystem::path& folder, const FileFilter& filter);
  [[nodiscard]] std::optional<std::filesystem::path> destination(view::Ui& ui, const std::string& text,
                                                                 const std::filesystem::path& folder,
                                                                 bool may_be_new) const;
  [[nodiscard]] view::Rectangle suggestions_area(const view::Ui& ui) const;

  view::Rectangle entry_;
  std::string began_with_;  // the text when a person began to type
  std::string suggested_for_;
  std::vector<std::string> suggestions_;
  int highlighted_ = -1;
};

}  // namespace glint::gui
