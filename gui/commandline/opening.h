#pragma once
// What a person names on the command line to look at: a preset by name or file, an EXR with a recipe, or a map.

#include <filesystem>
#include <string>

#include "core/math/result.h"
#include "gui/window/application.h"

namespace glint::gui {

/// Its file; a request error, which lists the presets, where there is none of that name.
Result<std::filesystem::path> named_document(const std::string& words);

/// Begins to open it.
Status open_document(Application& application, const std::string& words);

}  // namespace glint::gui
