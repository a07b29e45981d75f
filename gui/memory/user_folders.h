#pragma once
// Where a person's own files live: settings and presets under the config folder, sessions under the state folder, as
// the XDG base directory specification says. Asking for a folder creates nothing; what writes calls make_folder first.
// Any thread, as long as none changes the environment.

#include <filesystem>
#include <optional>
#include <string>

#include "core/math/result.h"

namespace glint::gui {

/// $XDG_CONFIG_HOME/glintscope, else ~/.config/glintscope. Nothing where neither it nor HOME is set to an absolute
/// path.
std::optional<std::filesystem::path> config_folder();

/// $XDG_STATE_HOME/glintscope, else ~/.local/state/glintscope; nothing as above.
std::optional<std::filesystem::path> state_folder();

/// Where the person's own presets are: `presets` in the config folder.
std::optional<std::filesystem::path> user_presets_folder();

/// Creates the folder and those around it where they are missing; the new folder is readable by its owner only.
Status make_folder(const std::filesystem::path& folder);

/// The text of a file of at most 1 MiB; the error's subject is the file.
Result<std::string> read_small_file(const std::filesystem::path& file);

}  // namespace glint::gui
