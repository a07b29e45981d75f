#pragma once
// Asks what to export and where to. Main thread.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gui/dialogs/dialog_frame.h"

namespace glint::gui {

enum class ExportWhat { window, map_panel, pndf_panel, inspector, pndf_images, pndf_picture, normal_map, values };

struct ExportKind {
  ExportWhat what = ExportWhat::window;
  std::string_view key;                      ///< recorded as export.what.KEY; also the end of the suggested file name
  std::string_view label;                    ///< "Whole window"
  std::string_view text;                     ///< one sentence
  std::vector<std::string_view> extensions;  ///< that the file may have; the first is suggested
};
std::span<const ExportKind> export_kinds();

struct ExportInput {
  std::string document;                                         ///< its name
  std::filesystem::path folder;                                 ///< where exports went last
  std::function<std::string(ExportWhat)> reason_disabled = {};  ///< a sentence, or empty
};

struct ExportChoice {
  ExportWhat what = ExportWhat::window;
  std::filesystem::path file;  ///< absolute, with an extension of its kind; replacing it has been asked for
  /// The person wants to choose the file in the file browser (Purpose::export_file, from `file`): the dialog stays
  /// open, and set_file() takes what comes of it.
  bool browse = false;
};

/// Recorded as export, export.what, export.what.KEY, export.path, export.browse, export.accept, export.cancel.
class ExportDialog {
 public:
  /// With that kind selected: "Export this panel" of a panel's header names its own.
  void open(ExportWhat what = ExportWhat::window);
  [[nodiscard]] bool is_open() const { return frame_.is_open(); }
  void set_file(const std::filesystem::path& file);
  /// Once a frame; a choice without `browse` closes the dialog.
  std::optional<ExportChoice> draw(view::Ui& ui, const ExportInput& input);

 private:
  struct Check {
    std::filesystem::path file;
    bool exists = false;
    std::string reason;
  };

  [[nodiscard]] const ExportKind& kind() const { return export_kinds()[static_cast<std::size_t>(chosen_)]; }
  void suggest(const ExportInput& input);
  [[nodiscard]] Check check(const std::string& text, const ExportInput& input) const;
  void choose(int row, const ExportInput& input);
  /// True if Enter was pressed on the selected kind.
  bool draw_kinds(view::Ui& ui, const view::Rectangle& area, const ExportInput& input);
  void draw_kind(view::Ui& ui, int row, const view::Rectangle& area, const ExportInput& input);
  /// The path entry and Browse…; true if Enter ended it.
  bool draw_path(view::Ui& ui, const view::Rectangle& area, bool& browse);
  void draw_status(const view::Ui& ui, const view::Rectangle& area, const Check& check) const;

  DialogFrame frame_;
  int chosen_ = 0;  // index of export_kinds()
  bool reveal_ = false;
  std::string path_;    // as it stands in the entry
  bool typed_ = false;  // the person gave it: only its extension follows the kind
  std::filesystem::path confirmed_;
};

}  // namespace glint::gui
