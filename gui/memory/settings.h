#pragma once
// What the window remembers from one run to the next and no document holds: its size and layout, and recent files. One
// JSON file, settings.json in the config folder. Main thread.

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/result.h"

namespace glint::gui {

inline constexpr std::size_t k_most_recent = 12;

struct Settings {
  double ui_scale = 0;  ///< 0: automatic; else 0.5 to 4
  glm::ivec2 window_size{1600, 1000};
  bool maximised = false;
  std::map<std::string, double> splitters;    ///< ratio by name, 0 to 1
  std::map<std::string, bool> open_sections;  ///< by name
  std::vector<std::filesystem::path> recent;  ///< newest first, at most k_most_recent, none twice
  std::filesystem::path last_folder;          ///< of the file browser; empty: none yet
  std::string maximised_panel;                ///< the panel that fills the window; empty: none

  friend bool operator==(const Settings&, const Settings&) = default;
};

struct LoadedSettings {
  Settings settings;
  std::optional<Error> fault;  ///< to be shown: what could not be read and has its default instead
};

/// The settings in `folder`. A missing file gives defaults; what is wrong in a file is left at its default and named
/// in one error; what is unknown is passed over.
LoadedSettings load_settings(const std::filesystem::path& folder);

/// Writes them, all or nothing; creates the folder. Paths that are not UTF-8 cannot stand in JSON and are left out.
Status save_settings(const std::filesystem::path& folder, const Settings& settings);

/// Puts the file, made absolute, at the head of the recent ones.
void remember_recent(Settings& settings, const std::filesystem::path& file);

}  // namespace glint::gui
