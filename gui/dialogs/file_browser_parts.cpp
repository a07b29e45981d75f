// The parts of the file browser: places, list, preview, name, and what stands under them.

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "gui/dialogs/file_browser.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using view::Rectangle;
using view::Ui;
namespace color = view::color;
namespace size = view::size;

constexpr float k_thumbnail = 200;

std::string_view text_when_empty(Purpose purpose, bool all_files) {
  if (all_files || purpose == Purpose::export_file) return "This folder is empty.";
  if (purpose == Purpose::open_map) return "This folder holds no pictures that can be read.";
  return "This folder holds no presets.";
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string contents_text(const FolderListing& listing) {
  const auto folders = static_cast<std::size_t>(std::ranges::count_if(listing.entries, &ListedFile::is_folder));
  const std::size_t files = listing.entries.size() - folders;
  if (folders == 0) return counted(files, "file", "files");
  return counted(folders, "folder", "folders") + ", " + counted(files, "file", "files");
}

// The picture in the middle of `box`; small ones grow by a whole factor, so that their pixels stay alike.
void draw_picture(Ui& ui, const view::Texture& texture, const Rectangle& box) {
  const auto side = static_cast<float>(std::max(texture.size().x, texture.size().y));
  const float most = std::min(ui.px(k_thumbnail), box.height() - ui.px(8));
  const float factor = side > most ? most / side : std::max(1.0F, std::floor(most / side));
  const ImVec2 half{std::floor(0.5F * factor * static_cast<float>(texture.size().x)),
                    std::floor(0.5F * factor * static_cast<float>(texture.size().y))};
  const ImVec2 middle{std::floor(box.center().x), std::floor(box.center().y)};
  view::Shading shading;
  shading.nearest = factor >= 4;
  ImGui::GetWindowDrawList()->AddImage(ui.pictures.add(texture, shading), {middle.x - half.x, middle.y - half.y},
                                       {middle.x + half.x, middle.y + half.y});
}

void draw_in_box(const Ui& ui, const Rectangle& box, std::string_view text) {
  const float width = box.width() - 2 * ui.px(12);
  const auto lines = view::wrapped_text(ui.fonts.small, text, width);
  const float pitch = std::ceil(ui.fonts.small->FontSize) + ui.px(3);
  float y = std::floor(box.center().y - 0.5F * pitch * static_cast<float>(lines.size()));
  for (const std::string& line : lines) {
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, {box.min.x + ui.px(12), y}, color::k_hint, line);
    y += pitch;
  }
}

}  // namespace

void FileBrowser::check_places(const BrowserInput& input) {
  places_.clear();
  place_paths_.clear();
  const auto add = [&](PlaceRow row, fs::path path) {
    places_.push_back(std::move(row));
    place_paths_.push_back(std::move(path));
  };
  std::error_code error;
  if (!input.places.empty()) add({.key = {}, .label = "Places", .detail = {}, .reason = {}, .is_heading = true}, {});
  for (const Place& place : input.places) {
    PlaceRow row{.key = "place." + slug(place.label), .label = place.label, .detail = {}, .reason = {}};
    if (!fs::is_directory(place.folder, error)) row.reason = "Not there yet: it comes with the first preset saved.";
    add(std::move(row), typed_path(place.folder.string(), folder_));
  }
  bool has_heading = false;
  for (const fs::path& file : input.recent) {
    if (!filters_.front().matches(file)) continue;
    if (!has_heading) add({.key = {}, .label = "Recent", .detail = {}, .reason = {}, .is_heading = true}, {});
    has_heading = true;
    PlaceRow row{.key = "recent." + shown_path(file.filename()),
                 .label = shown_path(file.filename()),
                 .detail = shown_path(file.parent_path()),
                 .reason = {},
                 .icon = file.extension() == ".json" ? view::Icon::file : view::Icon::picture};
    if (!fs::exists(file, error)) row.reason = "No longer there.";
    add(std::move(row), file);
  }
}

void FileBrowser::draw_left(Ui& ui, const Rectangle& area) {
  const ListedFile* file = selected();
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const fs::path& path = place_paths_[k];
    places_[k].is_current = !places_[k].is_heading && (path == folder_ || (file && path == file->path));
  }
  const ListEvents events = gui::draw_places(ui, area, places_, place_);
  if (!events.selected && !events.opened) return;
  go_to(place_paths_[static_cast<std::size_t>(place_.selected)]);
  if (events.opened) ui.state.focus.name = "browser.list";
}

bool FileBrowser::draw_list(Ui& ui, const Rectangle& area) {
  const bool all = filter().extensions.empty();
  const std::string_view empty = listing_fault_.empty() ? text_when_empty(purpose_, all) : listing_fault_;
  const ListEvents events = draw_file_list(ui, area, listing_, empty, list_);
  const ListedFile* file = selected();
  if (events.selected && saving() && file && !file->is_folder) name_ = file->path.filename().string();
  if (events.parent) {
    go_up();
  } else if (events.opened && file && file->is_folder) {
    go(fs::path(file->path));
  } else if (events.opened && file) {
    return true;
  }
  return false;
}

void FileBrowser::draw_preview(Ui& ui, const Rectangle& area) {
  const ListedFile* file = selected();
  if (file && !file->is_folder) {
    previews_.want(file->path, static_cast<int>(ui.px(k_thumbnail)));
  } else {
    previews_.forget();
  }
  const std::shared_ptr<const FilePreview> preview = previews_.current();
  if (preview != in_texture_) {
    in_texture_ = preview;
    texture_ = preview && !preview->rgba.empty()
                   ? view::Texture(ui.gl, view::Texture::Format::rgba8, preview->size, preview->rgba.data())
                   : view::Texture();
  }
  const float height = std::min(area.width(), std::floor(0.5F * area.height()));
  const Rectangle box{area.min, {area.max.x, area.min.y + height}};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ui.widgets.record("browser.preview", {area, {}, false, false});
  list.AddRectFilled(box.min, box.max, color::k_picture);
  list.AddRect(box.min, box.max, color::k_border);
  if (!file) {
    draw_in_box(ui, box, "Select a file to see what it holds.");
  } else if (file->is_folder) {
    draw_in_box(ui, box, "A folder: open it to see what it holds.");
  } else if (!preview) {
    draw_in_box(ui, box, "Reading…");
  } else if (!texture_.empty()) {
    draw_picture(ui, texture_, box);
  } else {
    draw_in_box(ui, box,
                preview->reason.empty() ? "Its surface is generated: there is no picture of it."
                                        : std::string_view(preview->reason));
  }
  if (file) draw_facts(ui, area, box.max.y + ui.px(8), preview.get());
}

void FileBrowser::draw_facts(const Ui& ui, const Rectangle& area, float top, const FilePreview* preview) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ListedFile& file = *selected();
  list.PushClipRect(area.min, area.max, true);
  float y = top;
  const auto lines = view::wrapped_text(ui.fonts.text, file.name, area.width());
  for (std::size_t k = 0; k < std::min<std::size_t>(2, lines.size()); ++k) {
    const bool cut = k == 1 && lines.size() > 2;
    view::draw_text(list, ui.fonts.text, {area.min.x, y}, color::k_text,
                    cut ? view::fitted_text(ui.fonts.text, lines[k] + lines[k + 1], area.width()) : lines[k]);
    y += std::ceil(ui.fonts.text->FontSize) + ui.px(2);
  }
  y += ui.px(4);
  std::vector<FilePreview::Fact> facts;
  if (preview) facts = preview->facts;
  if (!file.size.empty()) facts.push_back({"File", file.size});
  if (!file.date.empty()) facts.push_back({"Changed", file.date});
  const float caption = ui.px(80);
  for (const FilePreview::Fact& fact : facts) {
    view::draw_text(list, ui.fonts.small, {area.min.x, y}, color::k_hint, fact.caption);
    y = draw_sentences(ui, {area.min.x + caption, y}, area.width() - caption, color::k_text_2, fact.value);
  }
  if (preview && !preview->remark.empty()) {
    draw_sentences(ui, {area.min.x, y + ui.px(6)}, area.width(), color::k_text_2, preview->remark);
  }
  list.PopClipRect();
}

bool FileBrowser::draw_name(Ui& ui, const Rectangle& area) {
  constexpr std::string_view k_entry = "browser.name";
  if (name_begins_) view::refuse_entry(ui, k_entry, name_, {});
  name_begins_ = false;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float label = ui.px(52);
  view::draw_text(list, ui.fonts.text, {area.min.x, area.center().y - 0.5F * ui.fonts.text->FontSize}, color::k_text_2,
                  "Name");
  const std::optional<std::string> typed =
      view::entry(ui, k_entry, {{area.min.x + label, area.min.y}, area.max}, name_, {},
                  {"Name of the file", "A name for this folder, or a path. Enter saves.", {}}, {}, true);
  if (!typed) return false;
  name_ = *typed;
  return enter_pressed();
}

void FileBrowser::draw_status(const Ui& ui, const Rectangle& area, const Intent& intent) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = area.center().y - 0.5F * ui.fonts.small->FontSize;
  std::string text = contents_text(listing_);
  ImU32 ink = color::k_hint;
  float x = area.min.x;
  if (!confirmed_.empty()) {
    text = fmt::format("“{}” exists: Save again to replace it.", shown_path(confirmed_.filename()));
    ink = color::k_text;
    view::draw_icon(ui, list, view::Icon::warning, {x + ui.px(7), area.center().y}, color::k_text);
    x += ui.px(20);
  } else if (saving() && !intent.reason.empty()) {
    text = intent.reason;
  } else if (saving() && intent.take) {
    text = "Goes to " + shown_path(*intent.take) + (intent.replaces ? ", which exists." : ".");
  } else if (!listing_fault_.empty()) {
    text = listing_fault_;
  } else if (!intent.reason.empty()) {
    text += ". " + intent.reason;
  }
  view::draw_text(list, ui.fonts.small, {x, top}, ink, view::fitted_text(ui.fonts.small, text, area.max.x - x));
}

std::optional<FileBrowser::Bottom> FileBrowser::draw_bottom(Ui& ui, const Rectangle& area, const Intent& intent) {
  std::vector<std::string_view> labels;
  labels.reserve(filters_.size());
  for (const FileFilter& one : filters_) labels.push_back(one.label);
  const float filter_width = ui.px(164);
  const Rectangle filter_area{area.min, {area.min.x + filter_width, area.max.y}};
  const std::optional<int> picked = view::combo(ui, "browser.filter", filter_area, labels, filter_,
                                                {"Which files are shown", "Folders are always shown.", {}});
  const ListedFile* file = selected();
  const fs::path kept = file ? file->path : fs::path();
  if (picked) filter_ = *picked;
  const float x = filter_area.max.x + ui.px(12);
  const Rectangle hidden{{x, area.min.y}, {x + ui.px(112), area.max.y}};
  const bool toggled = view::checkbox(ui, "browser.hidden", hidden, "Hidden files", with_hidden_,
                                      {"Hidden files", "Also shows what has a name that begins with a dot.", {}});
  if (toggled) with_hidden_ = !with_hidden_;
  if (picked || toggled) list_again(kept);
  const std::string verb = !confirmed_.empty() ? "Replace" : saving() && !intent.enter ? "Save" : "Open";
  const std::array buttons{
      DialogButton{"cancel", "Cancel", {"Cancel", "Leaves everything as it is.", {}}},
      DialogButton{"accept", verb, {verb, {}, intent.reason}, true},
  };
  const std::optional<int> pressed = dialog_buttons(ui, "browser", area, buttons);
  if (!pressed) return std::nullopt;
  return *pressed == 0 ? Bottom::cancel : Bottom::accept;
}

}  // namespace glint::gui
