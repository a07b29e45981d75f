#pragma once
// Presets and recipes: a document as JSON, in and out.
//
//   {"glintscope": "preset", "version": 1, "name": "…", "surface": {"source": "noise", …}, …}
//
// Objects follow the dots of the parameters' paths. What is missing has its default; what is unknown, twice, of the
// wrong type or out of range is one content error whose subject is "file:line:column" and whose sentence is
// "field 'x.y': what is wrong; allowed: …". The language of the locale has no effect on numbers.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/math/result.h"

namespace glint {

/// The preset versions that are read are 1 to this one, which is written.
inline constexpr int k_preset_version = 1;

/// A preset with two spaces of indentation and fields in the order of parameters(): the name, every field that matters
/// to the document (see Parameter::matters), and any other that differs from its default. parse_preset gives the same
/// document back, to the last bit.
std::string preset_text(const Document& document);

/// A document from the text of a preset; `subject` stands for the file in errors. surface.path is kept as it stands.
Result<Document> parse_preset(std::string_view text, const std::string& subject);

/// Reads a preset file of at most 1 MiB. A relative surface.path is taken from the preset's folder.
Result<Document> load_preset(const std::filesystem::path& file);

/// Reads a preset file, or an EXR with a recipe (by its extension). A recipe keeps surface.path as it was typed: a
/// relative one is taken from the working directory, else, where it is only there, from the folder of the EXR.
Result<Document> load_document(const std::filesystem::path& file);

/// Writes a preset file, all or nothing. surface.path is written relative to the preset's folder where it lies below
/// it, else absolute. A document with a fault is refused: it could not be loaded again.
Status save_preset(const std::filesystem::path& file, const Document& document);

/// One line of JSON that holds only what determines the pixels of a result: the fields that matter, not the name.
/// Equal documents give equal bytes; surface.path stands in it as given.
std::string recipe_of(const Document& document);

/// The document of a recipe (or of a preset's text: the format is the same); fields that do not matter have defaults.
Result<Document> document_from_recipe(std::string_view text, const std::string& subject);

struct PresetEntry {
  std::string name;  ///< the file's name without its extension
  std::filesystem::path file;
};

/// Where presets are looked for: $GLINTSCOPE_PRESETS if it is set, else share/glintscope/presets beside the folder of
/// `executable` (links followed).
std::vector<std::filesystem::path> preset_folders(const std::filesystem::path& executable);

/// The presets of the folders by name; of two with one name the first folder's. Folders that cannot be read are empty.
std::vector<PresetEntry> list_presets(std::span<const std::filesystem::path> folders);

/// The file of a preset given by name, or by a path: what holds a slash, ends in .json or names an existing file.
/// A request error that lists the known names for an unknown one.
Result<std::filesystem::path> find_preset(const std::string& name_or_path,
                                          std::span<const std::filesystem::path> folders);

/// The JSON schema of presets, for editors; presets/schema.json is this text.
std::string preset_schema();

}  // namespace glint
