#pragma once
// The dialog in which a person finds a file to open, or says where to save one. Main thread.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gui/dialogs/browser_lists.h"
#include "gui/dialogs/browser_path.h"
#include "gui/dialogs/dialog_frame.h"
#include "gui/dialogs/file_listing.h"
#include "gui/dialogs/file_preview.h"
#include "viewers/gl/texture.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

enum class Purpose { open_map, open_preset, save_preset, export_file };

/// Where one can go with one click.
struct Place {
  std::string label;  ///< "Home"
  std::filesystem::path folder;
};

/// Home, Desktop if there is one, the presets that ship, the person's own, and the folder of the current document;
/// those that are not given are left out.
std::vector<Place> usual_places(const std::optional<std::filesystem::path>& shipped_presets,
                                const std::optional<std::filesystem::path>& user_presets,
                                const std::filesystem::path& document_folder);

struct BrowserInput {
  std::span<const std::filesystem::path> recent;  ///< newest first; those that fit the purpose are shown
  std::span<const Place> places;
};

struct FileChoice {
  Purpose purpose = Purpose::open_map;
  std::filesystem::path path;  ///< absolute; when saving it ends in the right extension, and may be there already
};

/// Its textures belong to the context of the Ui it is drawn with, which must outlive it.
class FileBrowser {
 public:
  /// `wake` is called from a background thread when a preview is ready.
  explicit FileBrowser(std::function<void()> wake = {});

  /// `start` is a folder, or a file to be selected; what is not there is looked for above. `name` is the file's name to
  /// begin with when saving: its extension is the one that is written (save_preset always writes .json).
  void open(Purpose purpose, std::filesystem::path start, std::string name = {});
  [[nodiscard]] bool is_open() const { return frame_.is_open(); }
  /// Once a frame. The choice closes the dialog; replacing a file has been asked for.
  std::optional<FileChoice> draw(view::Ui& ui, const BrowserInput& input);
  /// That was shown last, to be remembered.
  [[nodiscard]] std::filesystem::path folder() const { return folder_; }
  /// No preview is on its way.
  [[nodiscard]] bool idle() const { return previews_.idle(); }

 private:
  /// What the accept button would do now.
  struct Intent {
    std::optional<std::filesystem::path> enter;  ///< go to that folder
    std::optional<std::filesystem::path> take;   ///< that file is the answer
    bool replaces = false;                       ///< it exists
    std::string reason;                          ///< why neither
  };
  enum class Bottom { cancel, accept };
  struct Areas {
    view::Rectangle path, places, list, preview, name, status, bottom;
    bool has_places = false, has_preview = false;
  };

  [[nodiscard]] bool saving() const { return purpose_ == Purpose::save_preset || purpose_ == Purpose::export_file; }
  [[nodiscard]] Areas areas(const view::Ui& ui, const view::Rectangle& room) const;
  [[nodiscard]] const FileFilter& filter() const { return filters_[static_cast<std::size_t>(filter_)]; }
  [[nodiscard]] const ListedFile* selected() const;
  [[nodiscard]] Intent intent(const view::Ui& ui) const;
  [[nodiscard]] Intent intent_of_name(const std::string& name) const;

  void go(const std::filesystem::path& folder, const std::filesystem::path& select = {});
  void go_to(const std::filesystem::path& path);
  void go_up();
  void list_again(const std::filesystem::path& select);
  void watch(double seconds);
  void check_places(const BrowserInput& input);

  void draw_left(view::Ui& ui, const view::Rectangle& area);
  bool draw_list(view::Ui& ui, const view::Rectangle& area);
  void draw_preview(view::Ui& ui, const view::Rectangle& area);
  void draw_facts(const view::Ui& ui, const view::Rectangle& area, float top, const FilePreview* preview);
  bool draw_name(view::Ui& ui, const view::Rectangle& area);
  void draw_status(const view::Ui& ui, const view::Rectangle& area, const Intent& intent) const;
  std::optional<Bottom> draw_bottom(view::Ui& ui, const view::Rectangle& area, const Intent& intent);
  std::optional<FileChoice> accept(view::Ui& ui, const Intent& intent);

  DialogFrame frame_;
  Purpose purpose_ = Purpose::open_map;
  std::filesystem::path folder_;
  std::string extension_;     // that a saved file has to have; empty: any
  std::string name_;          // of the file to be saved
  bool name_begins_ = false;  // a person can type it at once
  std::vector<FileFilter> filters_{FileFilter{}};
  int filter_ = 0;
  bool with_hidden_ = false;

  FolderListing listing_;
  std::string listing_fault_;  // a whole sentence; empty: none
  std::filesystem::file_time_type folder_changed_;
  double looked_at_ = 0;  // seconds
  ListState list_;
  std::vector<PlaceRow> places_;
  std::vector<std::filesystem::path> place_paths_;  // of the same indices
  double places_checked_at_ = -1;
  ListState place_;
  PathBar path_bar_;
  std::filesystem::path confirmed_;  // what a second press replaces; empty: nothing

  FilePreviews previews_;
  view::Texture texture_;
  std::shared_ptr<const FilePreview> in_texture_;
};

}  // namespace glint::gui
