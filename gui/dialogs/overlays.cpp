#include "gui/dialogs/overlays.h"

#include <system_error>
#include <utility>

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Workbench& workbench) {
  const SurfaceDescription& surface = workbench.document().surface;
  if (surface.source == SurfaceSource::file && !surface.path.empty()) return surface.path;
  return workbench.preset_file();
}

constexpr std::string_view k_field = "field:";

}  // namespace

Overlays::Overlays(Workbench& workbench, std::function<void()> wake)
    : workbench_(workbench), browser_(std::move(wake)) {}

bool Overlays::is_open() const {
  return palette_.is_open() || shortcuts_.is_open() || about_.is_open() || preset_name_.is_open() ||
         export_.is_open() || question_.is_open() || browser_.is_open();
}

void Overlays::open_browser(Purpose purpose) {
  const Settings& settings = workbench_.settings();
  fs::path start = settings.last_folder.empty() ? folder_of(workbench_) : settings.last_folder;
  if (purpose == Purpose::open_preset && settings.last_folder.empty() && workbench_.places().user_presets) {
    start = *workbench_.places().user_presets;
  }
  if (start.empty()) {
    std::error_code error;
    start = fs::current_path(error);
  }
  browser_.open(purpose, start);
}

void Overlays::open_save_as() {
  preset_name_.open_to_save(workbench_.document().name, workbench_.places().user_presets);
}

void Overlays::open_rename() {
  preset_name_.open_to_rename(workbench_.document().name, workbench_.preset_file());
}

void Overlays::ask_delete() {
  question_.open(delete_preset_question(workbench_.document().name, workbench_.preset_file()));
}

void Overlays::ask_unsaved() {
  question_.open(unsaved_changes_question(workbench_.document().name, "closing"));
}

OverlayWishes Overlays::draw(view::Ui& ui, const Actions& actions, const AboutFacts& facts,
                             const std::function<std::string(ExportWhat)>& export_reason) {
  OverlayWishes wishes;
  if (palette_.is_open()) {
    const std::string key = palette_.draw(ui, actions);
    if (key.starts_with(k_field)) {
      wishes.field = key.substr(k_field.size());
    } else {
      wishes.action = key;
    }
  }
  if (shortcuts_.is_open()) shortcuts_.draw(ui, actions);
  about_.draw(ui, facts);
  if (const auto chosen = preset_name_.draw(ui)) take_preset_name(*chosen, wishes);
  if (export_folder_.empty()) export_folder_ = workbench_.settings().last_folder;
  if (const auto chosen = export_.draw(ui, {workbench_.document().name, export_folder_, export_reason})) {
    export_folder_ = chosen->file.parent_path();
    if (chosen->browse) {
      browsing_for_export_ = true;
      browser_.open(Purpose::export_file, chosen->file.parent_path(), chosen->file.filename().string());
    } else {
      wishes.export_order = ExportOrder{chosen->what, chosen->file};
    }
  }
  if (const auto answer = question_.draw(ui)) take_answer(*answer, wishes);
  if (browser_.is_open()) {
    const auto& shipped = workbench_.places().preset_folders;
    const std::vector<Place> places =
        usual_places(shipped.empty() ? std::nullopt : std::optional(shipped.front()), workbench_.places().user_presets,
                     folder_of(workbench_).parent_path());
    if (const auto choice = browser_.draw(ui, {workbench_.settings().recent, places})) take_file(*choice, wishes);
  }
  return wishes;
}

void Overlays::take_preset_name(const PresetName& chosen, OverlayWishes& wishes) {
  switch (chosen.wish) {
    case PresetName::Wish::save:
      after_saving(workbench_.save_to(chosen.file, chosen.name), wishes);
      break;
    case PresetName::Wish::rename:
      workbench_.report(workbench_.rename_preset(chosen.name, chosen.file), "Renamed to " + chosen.name + ".");
      break;
    case PresetName::Wish::elsewhere:
      name_to_save_ = chosen.name;
      browser_.open(Purpose::save_preset, chosen.file.parent_path(), chosen.file.filename().string());
      break;
  }
}

void Overlays::after_saving(const Status& saved, OverlayWishes& wishes) {
  workbench_.report(saved, "Saved " + workbench_.preset_file().string() + ".");
  wishes.end = saved && std::exchange(ends_after_saving_, false);
}

void Overlays::take_answer(const Answer& answer, OverlayWishes& wishes) {
  if (answer.question == "delete_preset" && answer.key == "delete") {
    workbench_.report(workbench_.delete_preset(), "Deleted. The document itself is still open.");
  }
  if (answer.question != "unsaved") return;
  if (answer.key == "discard") wishes.end = true;
  if (answer.key != "save") return;
  ends_after_saving_ = true;
  if (workbench_.can_save_in_place()) {
    after_saving(workbench_.save(), wishes);
  } else {
    open_save_as();
  }
}

void Overlays::take_file(const FileChoice& choice, OverlayWishes& wishes) {
  workbench_.settings().last_folder = browser_.folder();
  switch (choice.purpose) {
    case Purpose::open_map:
    case Purpose::open_preset:
      workbench_.open(choice.path);
      break;
    case Purpose::save_preset:
      after_saving(workbench_.save_to(choice.path, name_to_save_), wishes);
      break;
    case Purpose::export_file:
      if (std::exchange(browsing_for_export_, false)) export_.set_file(choice.path);
      break;
  }
}

}  // namespace glint::gui
