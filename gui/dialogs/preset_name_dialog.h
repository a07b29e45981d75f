#pragma once
// Asks for the name of a preset: to save it as one of the person's own, or to give it another name. Main thread.

#include <filesystem>
#include <optional>
#include <string>

#include "gui/dialogs/dialog_frame.h"

namespace glint::gui {

struct PresetName {
  enum class Wish {
    save,       ///< to `file`, which may be there: replacing it has been asked for
    rename,     ///< to `file`, which is not there unless it is the preset's own
    elsewhere,  ///< save, but the person wants to choose the folder: `file` is a suggestion
  };
  Wish wish = Wish::save;
  std::string name;            ///< free of faults
  std::filesystem::path file;  ///< FOLDER/SLUG.json
};

/// Why a document cannot have that name, as a sentence; empty if it can.
std::string preset_name_fault(const std::string& name);

/// Recorded as preset_name, preset_name.entry, .accept, .cancel, .elsewhere.
class PresetNameDialog {
 public:
  /// Presets go to `folder`, which may not be there yet; none: there is no such folder, only elsewhere is left.
  void open_to_save(std::string name, std::optional<std::filesystem::path> folder);
  /// `file` is the preset's own, and keeps its folder.
  void open_to_rename(std::string name, std::filesystem::path file);
  [[nodiscard]] bool is_open() const { return frame_.is_open(); }
  /// Once a frame; a result closes the dialog.
  std::optional<PresetName> draw(view::Ui& ui);

 private:
  struct Check {
    std::filesystem::path file;
    bool exists = false;
    std::string reason;  ///< why it cannot be accepted
  };
  void open(std::string name);
  [[nodiscard]] Check check(const std::string& name) const;
  void draw_check(const view::Ui& ui, const view::Rectangle& area, const Check& check) const;

  DialogFrame frame_;
  std::string name_;
  bool begins_ = false;
  std::optional<std::filesystem::path> folder_;
  std::filesystem::path own_file_;   // of the preset that is renamed; empty: saving
  std::filesystem::path confirmed_;  // what a second press replaces
};

}  // namespace glint::gui
