#pragma once
// Everything that lies over the panels: the palette, the list of shortcuts, the file browser and the dialogs, in the
// order in which they can lie over each other. Main thread.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gui/dialogs/about_dialog.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/dialogs/file_browser.h"
#include "gui/dialogs/palette.h"
#include "gui/dialogs/preset_name_dialog.h"
#include "gui/dialogs/question_dialog.h"
#include "gui/dialogs/shortcut_sheet.h"
#include "gui/memory/workbench.h"
#include "gui/window/exporter.h"

namespace glint::gui {

/// What a person chose in one of them.
struct OverlayWishes {
  std::string action;  ///< of the registry, to be run
  std::string field;   ///< to go to in the Inspector
  std::optional<ExportOrder> export_order;
  bool end = false;  ///< the program may end now
};

class Overlays {
 public:
  /// `wake` is called from background threads when a preview is ready.
  Overlays(Workbench& workbench, std::function<void()> wake);

  [[nodiscard]] bool is_open() const;
  /// No preview is on its way.
  [[nodiscard]] bool idle() const { return browser_.idle(); }

  void open_palette() { palette_.open(); }
  void open_shortcuts() { shortcuts_.open(); }
  void open_about() { about_.open(); }
  void open_browser(Purpose purpose);
  void open_export(ExportWhat what) { export_.open(what); }
  void open_save_as();
  void open_rename();
  void ask_delete();
  /// The program is to end and the document is not saved.
  void ask_unsaved();

  OverlayWishes draw(view::Ui& ui, const Actions& actions, const AboutFacts& facts,
                     const std::function<std::string(ExportWhat)>& export_reason);

 private:
  void take_preset_name(const PresetName& chosen, OverlayWishes& wishes);
  void take_answer(const Answer& answer, OverlayWishes& wishes);
  void take_file(const FileChoice& choice, OverlayWishes& wishes);
  void after_saving(const Status& saved, OverlayWishes& wishes);

  Workbench& workbench_;
  Palette palette_;
  ShortcutSheet shortcuts_;
  AboutDialog about_;
  PresetNameDialog preset_name_;
  ExportDialog export_;
  QuestionDialog question_;
  FileBrowser browser_;
  bool browsing_for_export_ = false;
  bool ends_after_saving_ = false;
  std::string name_to_save_;  // while the browser finds a folder for it
  std::filesystem::path export_folder_;
};

}  // namespace glint::gui
