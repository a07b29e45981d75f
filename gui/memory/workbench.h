#pragma once
// The document with all that belongs to it and nothing that is drawn: its edits, its jobs, its file, what went wrong,
// and what is remembered from run to run. Main thread.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/document/preset.h"
#include "gui/jobs/document_jobs.h"
#include "gui/jobs/editor.h"
#include "gui/memory/session.h"
#include "gui/memory/settings.h"
#include "gui/window/messages.h"
#include "viewers/edit.h"

namespace glint::gui {

class Workbench {
 public:
  struct Places {
    std::vector<std::filesystem::path> preset_folders;   ///< those that ship, and the user's
    std::optional<std::filesystem::path> user_presets;   ///< where own presets go
    std::optional<std::filesystem::path> config_folder;  ///< none: nothing is remembered (headless runs)
    std::optional<std::filesystem::path> state_folder;   ///< none: no autosave
  };

  /// `wake` is called from background threads when there is something new to see.
  Workbench(Places places, std::function<void()> wake);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  ~Workbench();

  /// Once a frame: hands the document to the jobs and takes what they have done; autosaves at most every 2 seconds.
  void update(double seconds);
  /// The newest edit waits to be autosaved: update() has to be called again within seconds.
  [[nodiscard]] bool autosave_waits() const {
    return session_ && !autosave_failed_ && editor_.revision() != saved_revision_;
  }

  [[nodiscard]] const Document& document() const { return editor_.document(); }
  [[nodiscard]] Editor& editor() { return editor_; }
  [[nodiscard]] const Editor& editor() const { return editor_; }
  [[nodiscard]] DocumentJobs& jobs() { return jobs_; }
  [[nodiscard]] const DocumentJobs& jobs() const { return jobs_; }
  [[nodiscard]] Messages& messages() { return messages_; }
  [[nodiscard]] Settings& settings() { return settings_; }
  [[nodiscard]] const Places& places() const { return places_; }

  /// A message: what was done, or why not.
  void report(const Status& status, const std::string& done);

  /// An edit that a fault refuses becomes a message.
  void apply(view::Edit edit);
  /// One finished edit made by changing a copy of the document.
  void change(const std::string& label, const std::function<void(Document&)>& how, bool finished = true);

  /// Begins to open a preset, an EXR with a recipe or a map. What went wrong becomes a message.
  void open(const std::filesystem::path& file);
  Status open_preset(const std::string& name);
  /// True while the file is on its way; the error if the last one failed.
  [[nodiscard]] Result<bool> opening() const;

  /// The preset file the document was opened from or saved to; empty: none yet.
  [[nodiscard]] const std::filesystem::path& preset_file() const { return preset_file_; }
  /// The shipped presets are not overwritten: saving them means saving under another name.
  [[nodiscard]] bool can_save_in_place() const;
  Status save_to(const std::filesystem::path& file, const std::string& name);
  Status save() { return save_to(preset_file_, document().name); }
  void revert();
  /// Moves the file of a user's preset away, for good.
  Status delete_preset();
  Status rename_preset(const std::string& name, const std::filesystem::path& file);
  [[nodiscard]] bool is_user_preset() const;

  /// "scratched-steel, modified"
  [[nodiscard]] std::string title() const;
  [[nodiscard]] const std::vector<PresetEntry>& presets() const { return presets_; }
  void refresh_presets();

  /// What the last run left: the document of the session, with a message if it had crashed. False: nothing was left.
  bool resume_session();
  /// Writes settings and session; the end of a run that was meant.
  void end();

 private:
  void take_opened();
  void take_errors();
  void take_precision_reading();
  void autosave(double seconds);

  Places places_;
  Editor editor_;
  Messages messages_;
  Settings settings_;
  std::optional<Session> session_;
  std::filesystem::path preset_file_;
  std::filesystem::path opened_file_;  // being opened, or the last one
  bool opening_ = false;
  std::optional<Error> open_error_;
  std::vector<PresetEntry> presets_;
  double saved_at_ = 0;
  std::uint64_t saved_revision_ = 0;
  bool autosave_failed_ = false;
  DocumentJobs jobs_;  // last: its threads may use `wake` until it is gone
};

}  // namespace glint::gui
