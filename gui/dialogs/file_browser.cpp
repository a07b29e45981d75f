#include "gui/dialogs/file_browser.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using view::Rectangle;
using view::Ui;

const ImVec2 k_size{860, 560};               // at scale 1
constexpr double k_look_every = 1;           // seconds between looks at what changed on the disk
constexpr std::size_t k_longest_name = 255;  // bytes, of the usual file systems

const std::vector<std::string>& picture_extensions() {
  static const std::vector<std::string> extensions{".png", ".jpg", ".jpeg", ".exr", ".tif", ".tiff", ".hdr", ".pnm",
                                                   ".ppm", ".pgm", ".pfm",  ".bmp", ".dds", ".webp", ".tga", ".tpic"};
  return extensions;
}

std::vector<FileFilter> filters_for(Purpose purpose, const std::string& extension) {
  std::vector<FileFilter> filters;
  switch (purpose) {
    case Purpose::open_map:
      filters = {{"Pictures", picture_extensions()}};
      break;
    case Purpose::open_preset:
      filters = {{"Presets", {".json"}}, {"Presets and results", {".json", ".exr"}}};
      break;
    case Purpose::save_preset:
      filters = {{"Presets", {".json"}}};
      break;
    case Purpose::export_file:
      if (!extension.empty()) filters = {{extension.substr(1) + " files", {extension}}};
      break;
  }
  filters.push_back({"All files", {}});
  return filters;
}

std::string_view title_for(Purpose purpose) {
  switch (purpose) {
    case Purpose::open_map:
      return "Open a normal map";
    case Purpose::open_preset:
      return "Open a preset";
    case Purpose::save_preset:
      return "Save the preset as";
    case Purpose::export_file:
      break;
  }
  return "Export to a file";
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

fs::path working_folder() {
  std::error_code error;
  fs::path path = fs::current_path(error);
  return error ? fs::path("/") : path;
}

fs::path folder_at_or_above(fs::path path) {
  while (!is_folder(path)) {
    const std::optional<fs::path> parent = parent_of(path);
    if (!parent) return path;
    path = *parent;
  }
  return path;
}

}  // namespace

std::vector<Place> usual_places(const std::optional<fs::path>& shipped_presets,
                                const std::optional<fs::path>& user_presets, const fs::path& document_folder) {
  std::vector<Place> places;
  if (const char* home = std::getenv("HOME"); home && *home != '\0') {
    places.push_back({"Home", home});
    if (is_folder(fs::path(home) / "Desktop")) places.push_back({"Desktop", fs::path(home) / "Desktop"});
  }
  if (shipped_presets) places.push_back({"Shipped presets", *shipped_presets});
  if (user_presets) places.push_back({"Your presets", *user_presets});
  if (!document_folder.empty()) places.push_back({"This document", document_folder});
  return places;
}

FileBrowser::FileBrowser(std::function<void()> wake) : previews_(std::move(wake)) {}

void FileBrowser::open(Purpose purpose, fs::path start, std::string name) {
  purpose_ = purpose;
  name_ = std::move(name);
  extension_ = purpose == Purpose::save_preset ? ".json" : fs::path(name_).extension().string();
  filters_ = filters_for(purpose, extension_);
  filter_ = 0;
  confirmed_.clear();
  places_checked_at_ = -1;
  place_ = {};
  name_begins_ = saving();
  start = typed_path(start.string(), working_folder());
  const fs::path folder = folder_at_or_above(start);
  go(folder, folder == start ? fs::path() : start);
  frame_.open();
}

const ListedFile* FileBrowser::selected() const {
  const auto row = static_cast<std::size_t>(list_.selected);
  return list_.selected >= 0 && row < listing_.entries.size() ? &listing_.entries[row] : nullptr;
}

void FileBrowser::go(const fs::path& folder, const fs::path& select) {
  folder_ = folder;
  list_again(select);
}

void FileBrowser::go_to(const fs::path& path) {
  if (is_folder(path)) {
    go(path);
    return;
  }
  if (!filter().matches(path)) filter_ = static_cast<int>(filters_.size()) - 1;
  if (saving()) name_ = path.filename().string();
  go(path.parent_path(), path);
}

void FileBrowser::go_up() {
  if (const std::optional<fs::path> parent = parent_of(folder_)) go(*parent, fs::path(folder_));
}

void FileBrowser::list_again(const fs::path& select) {
  std::error_code error;
  folder_changed_ = fs::last_write_time(folder_, error);
  Result<FolderListing> listing = list_folder(folder_, filter(), with_hidden_);
  listing_fault_.clear();
  if (listing) {
    listing_ = std::move(*listing);
  } else {
    listing_fault_ = "This folder " + listing.error().sentence + ".";
    listing_ = {folder_, {}, false};
  }
  const auto at = std::ranges::find(listing_.entries, select, &ListedFile::path);
  list_.selected = at == listing_.entries.end() ? -1 : static_cast<int>(at - listing_.entries.begin());
  list_.reveal = true;
}

// What other programs did to the folder.
void FileBrowser::watch(double seconds) {
  if (seconds < looked_at_ + k_look_every && seconds >= looked_at_) return;
  looked_at_ = seconds;
  std::error_code error;
  const fs::file_time_type changed = fs::last_write_time(folder_, error);
  if (!error == listing_fault_.empty() && (error || changed == folder_changed_)) return;
  const ListedFile* file = selected();
  list_again(file ? file->path : fs::path());
}

FileBrowser::Intent FileBrowser::intent(const Ui& ui) const {
  if (saving()) return intent_of_name(ui.state.editing == "browser.name" ? ui.state.text : name_);
  const ListedFile* file = selected();
  Intent intent;
  if (!file) {
    intent.reason = "Select a file first.";
  } else if (file->is_folder) {
    intent.enter = file->path;
  } else {
    intent.take = file->path;
  }
  return intent;
}

FileBrowser::Intent FileBrowser::intent_of_name(const std::string& name) const {
  Intent intent;
  if (name.find_first_not_of(' ') == std::string::npos) {
    intent.reason = "Type a name first.";
    return intent;
  }
  fs::path path = typed_path(name, folder_);
  if (is_folder(path)) {
    intent.enter = path;
    return intent;
  }
  if (!extension_.empty() && path.extension() != extension_) path += extension_;
  const fs::path folder = path.parent_path();
  if (name.ends_with('/') || !is_folder(folder)) {
    intent.reason = fmt::format("There is no folder “{}”.", shown_path(name.ends_with('/') ? fs::path(name) : folder));
  } else if (path.filename().string().size() > k_longest_name) {
    intent.reason = "This name is too long for a file.";
  } else if (is_folder(path)) {
    intent.reason = fmt::format("“{}” is a folder.", shown_path(path.filename()));
  } else if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    intent.reason = "You have no permission to write into this folder.";
  } else {
    intent.replaces = is_there(path);
    intent.take = std::move(path);
  }
  return intent;
}

std::optional<FileChoice> FileBrowser::accept(Ui& ui, const Intent& intent) {
  if (intent.enter) go_to(*intent.enter);
  if (!intent.take) return std::nullopt;
  if (intent.replaces && saving() && confirmed_ != *intent.take) {
    confirmed_ = *intent.take;
    ui.state.editing.clear();
    ui.state.focus.name = "browser.accept";
    return std::nullopt;
  }
  frame_.close(ui);
  return FileChoice{purpose_, *intent.take};
}

FileBrowser::Areas FileBrowser::areas(const Ui& ui, const Rectangle& room) const {
  const float gap = ui.px(8);
  const float pad = ui.px(view::size::k_padding);
  const float row = ui.px(view::size::k_row);
  const Rectangle in{{room.min.x + pad, room.min.y + gap}, {room.max.x - pad, room.max.y - pad}};
  Areas areas;
  areas.path = {in.min, {in.max.x, in.min.y + row}};
  areas.bottom = {{in.min.x, in.max.y - row}, in.max};
  areas.status = {{in.min.x, areas.bottom.min.y - ui.px(26)}, {in.max.x, areas.bottom.min.y - ui.px(4)}};
  areas.name = {{in.min.x, areas.status.min.y - row}, {in.max.x, areas.status.min.y}};
  const float top = areas.path.max.y + gap;
  const float bottom = (saving() ? areas.name.min.y - gap : areas.status.min.y) - ui.px(2);
  areas.has_places = in.width() >= ui.px(520);
  areas.has_preview = in.width() >= ui.px(700);
  areas.list = {{in.min.x, top}, {in.max.x, bottom}};
  if (areas.has_places) {
    areas.places = {{in.min.x, top}, {in.min.x + ui.px(184), bottom}};
    areas.list.min.x = areas.places.max.x + gap;
  }
  if (areas.has_preview) {
    areas.preview = {{in.max.x - ui.px(216), top}, {in.max.x, bottom}};
    areas.list.max.x = areas.preview.min.x - gap;
  }
  return areas;
}

std::optional<FileChoice> FileBrowser::draw(Ui& ui, const BrowserInput& input) {
  if (!is_open()) {
    texture_ = {};
    in_texture_.reset();
    return std::nullopt;
  }
  watch(ui.seconds);
  if (places_checked_at_ < 0 || ui.seconds > places_checked_at_ + k_look_every) {
    check_places(input);
    places_checked_at_ = ui.seconds;
  }
  const Rectangle room =
      frame_.begin(ui, {"browser", title_for(purpose_), k_size, saving() ? "browser.name" : "browser.list"});
  if (frame_.escaped() && !confirmed_.empty()) {
    confirmed_.clear();
    frame_.keep_open();
  }
  const Areas at = areas(ui, room);
  const PathBar::Event moved = path_bar_.draw(ui, at.path, folder_, filter(), saving());
  if (at.has_places) draw_left(ui, at.places);
  bool accepted = draw_list(ui, at.list);
  if (at.has_preview) draw_preview(ui, at.preview);
  if (saving() && draw_name(ui, at.name)) accepted = true;
  const Intent now = intent(ui);
  if (now.take != confirmed_) confirmed_.clear();
  draw_status(ui, at.status, now);
  const std::optional<Bottom> pressed = draw_bottom(ui, at.bottom, now);
  path_bar_.draw_suggestions(ui);
  if (moved.parent) go_up();
  if (moved.go) {
    go_to(*moved.go);
    ui.state.focus.name = "browser.list";
  }
  std::optional<FileChoice> choice;
  if (accepted || pressed == Bottom::accept) choice = accept(ui, now);
  if (pressed == Bottom::cancel) frame_.close(ui);
  frame_.end(ui);
  if (!is_open()) previews_.forget();
  return choice;
}

}  // namespace glint::gui
