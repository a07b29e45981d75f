#include "gui/memory/workbench.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/document/parameter.h"
#include "viewers/widgets/number_text.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

constexpr double k_autosave_seconds = 2;

bool lies_below(const fs::path& file, const std::optional<fs::path>& folder) {
  if (!folder || file.empty()) return false;
  std::error_code error;
  return fs::equivalent(file.parent_path(), *folder, error) && !error;
}

}  // namespace

Workbench::Workbench(Places places, std::function<void()> wake) : places_(std::move(places)), jobs_(std::move(wake)) {
  refresh_presets();
  if (places_.config_folder) {
    LoadedSettings loaded = load_settings(*places_.config_folder);
    settings_ = std::move(loaded.settings);
    if (loaded.fault) messages_.post_error(*loaded.fault);
  }
  if (places_.state_folder) {
    Result<Session> session = Session::begin(*places_.state_folder);
    if (session) {
      session_.emplace(std::move(*session));
      if (session_->fault()) messages_.post_error(*session_->fault());
    } else {
      messages_.post_error(session.error());
    }
  }
}

Workbench::~Workbench() = default;

void Workbench::update(double seconds) {
  take_opened();
  take_errors();
  jobs_.update(document(), editor_.revision());
  take_precision_reading();
  autosave(seconds);
}

void Workbench::report(const Status& status, const std::string& done) {
  if (status) {
    messages_.post({Message::Kind::info, done, {}});
  } else {
    messages_.post_error(status.error());
  }
}

void Workbench::apply(view::Edit edit) {
  if (const Status applied = editor_.apply(std::move(edit)); !applied) messages_.post_error(applied.error());
}

void Workbench::change(const std::string& label, const std::function<void(Document&)>& how, bool finished) {
  Document changed = document();
  how(changed);
  apply({std::move(changed), label, finished});
}

void Workbench::open(const fs::path& file) {
  opened_file_ = file;
  opening_ = true;
  open_error_.reset();
  jobs_.update(document(), editor_.revision());
  jobs_.open(file);
}

Status Workbench::open_preset(const std::string& name) {
  std::vector<fs::path> folders = places_.preset_folders;
  const Result<fs::path> file = find_preset(name, folders);
  if (!file) return file.error();
  open(*file);
  return success();
}

Result<bool> Workbench::opening() const {
  if (opening_) return true;
  if (open_error_) return *open_error_;
  return false;
}

void Workbench::take_opened() {
  std::optional<Opened> opened = jobs_.take_opened();
  if (!opened) return;
  opening_ = false;
  if (const Status done = editor_.open(std::move(opened->document), std::move(opened->label)); !done) {
    open_error_ = done.error();
    messages_.post_error(done.error());
    return;
  }
  preset_file_ = opened_file_.extension() == ".json" ? fs::absolute(opened_file_) : fs::path();
  remember_recent(settings_, opened_file_);
}

void Workbench::take_errors() {
  for (Error& error : jobs_.take_errors()) {
    if (opening_ && !jobs_.opening()) {
      opening_ = false;
      open_error_ = error;
      error.sentence += ". What was open is unchanged";
    }
    messages_.post_error(error);
  }
}

void Workbench::take_precision_reading() {
  const std::optional<PrecisionReading> reading = jobs_.take_precision_reading();
  if (!reading) return;
  const double difference = reading->single_precision - reading->double_precision;
  messages_.post(
      {Message::Kind::info,
       fmt::format("Exact at s {}, t {}: {:.8g} in single and {:.8g} in double precision; they differ by {:.1e} of the "
                   "largest density.",
                   view::number_text(reading->s.x), view::number_text(reading->s.y), reading->single_precision,
                   reading->double_precision, reading->largest > 0 ? std::abs(difference) / reading->largest : 0.0),
       {}});
}

bool Workbench::can_save_in_place() const {
  if (preset_file_.empty()) return false;
  return std::none_of(places_.preset_folders.begin(), places_.preset_folders.end(), [&](const fs::path& folder) {
    return lies_below(preset_file_, folder) && folder != places_.user_presets;
  });
}

Status Workbench::save_to(const fs::path& file, const std::string& name) {
  editor_.finish_gesture();
  Document named = document();
  named.name = name;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);  // what fails here is told by the writing
  if (Status saved = save_preset(file, named); !saved) return saved;
  if (!(named == document())) apply({named, "Name to " + name});
  editor_.mark_saved();
  preset_file_ = fs::absolute(file);
  remember_recent(settings_, preset_file_);
  refresh_presets();
  return success();
}

void Workbench::revert() {
  Document saved = editor_.saved();
  apply({std::move(saved), "Revert"});
}

bool Workbench::is_user_preset() const {
  return lies_below(preset_file_, places_.user_presets);
}

Status Workbench::delete_preset() {
  std::error_code error;
  if (!fs::remove(preset_file_, error)) {
    return content_error(preset_file_.string(), "cannot be deleted: " + (error ? error.message() : "it is not there"));
  }
  preset_file_.clear();
  refresh_presets();
  return success();
}

Status Workbench::rename_preset(const std::string& name, const fs::path& file) {
  const fs::path old = preset_file_;
  if (Status saved = save_to(file, name); !saved) return saved;
  std::error_code error;
  if (old != preset_file_) fs::remove(old, error);
  refresh_presets();
  return success();
}

std::string Workbench::title() const {
  return document().name + (editor_.is_saved() ? "" : ", modified");
}

void Workbench::refresh_presets() {
  presets_ = list_presets(places_.preset_folders);
}

bool Workbench::resume_session() {
  if (!session_ || !session_->recovered()) return false;
  const RecoveredSession& left = *session_->recovered();
  // A document that was saved is opened as such; one that was not is an edit on what was saved, so that it can be told.
  Document saved = left.document;
  if (!left.was_saved && !left.preset_file.empty()) {
    if (Result<Document> stored = load_preset(left.preset_file)) saved = std::move(*stored);
  }
  if (const Status opened = editor_.open(saved, "Open the last session"); !opened) return false;
  if (!(saved == left.document)) apply({left.document, "What was not saved"});
  preset_file_ = left.preset_file;
  if (left.crashed && !left.was_saved) {
    messages_.post({Messages::Kind::info,
                    fmt::format("Recovered: \"{}\" as it was when the program ended unexpectedly.", left.document.name),
                    {}});
  }
  return true;
}

void Workbench::autosave(double seconds) {
  if (!autosave_waits()) return;
  if (seconds - saved_at_ < k_autosave_seconds) return;
  saved_at_ = seconds;
  saved_revision_ = editor_.revision();
  if (const Status saved = session_->save(document(), preset_file_, editor_.is_saved()); !saved) {
    autosave_failed_ = true;  // once is enough
    messages_.post_error(saved.error());
  }
}

void Workbench::end() {
  if (session_ && session_->save(document(), preset_file_, editor_.is_saved())) {
    if (const Status ended = session_->end(); !ended) messages_.post_error(ended.error());
  }
  if (places_.config_folder) {
    if (const Status saved = save_settings(*places_.config_folder, settings_); !saved) {
      messages_.post_error(saved.error());
    }
  }
}

}  // namespace glint::gui
