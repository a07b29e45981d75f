// Presets as files: reading, writing, and finding them by name.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/document/parameter.h"
#include "core/document/preset.h"
#include "core/image/atomic_file.h"
#include "core/image/pndf_exr.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_largest_preset = std::size_t{1} << 20U;  // bytes

Result<std::string> read_text(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return content_error(file.string(), "cannot be read: there is no such file");
  if (fs::is_directory(status)) return content_error(file.string(), "cannot be read: it is a folder, not a preset");
  std::ifstream in(file, std::ios::binary);
  if (!in) return content_error(file.string(), "cannot be read: it cannot be opened");
  std::string text(k_largest_preset + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) return content_error(file.string(), "cannot be read to its end");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > k_largest_preset) {
    return content_error(file.string(), "is larger than 1 MiB, which no preset is");
  }
  return text;
}

// How a preset in `folder` names the file: relative only where that means the same file wherever the folder is moved,
// and never across "..", which is another place behind a symbolic link.
fs::path stored_path(const fs::path& file, const fs::path& folder) {
  if (file.empty()) return file;
  std::error_code error;
  fs::path absolute = fs::absolute(file, error);
  if (error) return file;
  const fs::path home = fs::absolute(folder, error).lexically_normal();
  const bool climbs = std::find(absolute.begin(), absolute.end(), "..") != absolute.end();
  fs::path relative = absolute.lexically_normal().lexically_relative(home);
  if (error || climbs || relative.empty() || *relative.begin() == "..") return absolute;
  return relative;
}

std::string known_names(std::span<const fs::path> folders) {
  std::string names;
  for (const PresetEntry& entry : list_presets(folders)) names += (names.empty() ? "" : ", ") + entry.name;
  return names.empty() ? "none, their folder is empty or missing" : names;
}

}  // namespace

Result<Document> load_preset(const fs::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return text.error();
  Result<Document> document = parse_preset(*text, file.string());
  if (!document) return document;
  fs::path& map = document->surface.path;
  if (!map.empty() && map.is_relative()) map = file.parent_path() / map;
  return document;
}

Result<Document> load_document(const fs::path& file) {
  if (file.extension() != ".exr") return load_preset(file);
  const Result<std::string> recipe = read_recipe(file);
  if (!recipe) return recipe.error();
  Result<Document> document = document_from_recipe(*recipe, file.string());
  if (!document) return document;
  fs::path& map = document->surface.path;
  std::error_code missing;
  if (map.is_relative() && !fs::exists(map, missing)) {
    const fs::path beside = file.parent_path() / map;
    if (fs::exists(beside, missing)) map = beside;
  }
  return document;
}

Status save_preset(const fs::path& file, const Document& document) {
  if (std::optional<Error> fault = document_fault(document)) return *std::move(fault);
  Document stored = document;
  stored.surface.path = stored_path(document.surface.path, file.parent_path().empty() ? "." : file.parent_path());
  return write_file(file, preset_text(stored));
}

std::vector<fs::path> preset_folders(const fs::path& executable) {
  if (const char* set = std::getenv("GLINTSCOPE_PRESETS"); set && *set != '\0') return {set};
  std::error_code error;
  fs::path resolved = fs::weakly_canonical(executable, error);
  if (error) resolved = executable;
  return {(resolved.parent_path() / ".." / "share" / "glintscope" / "presets").lexically_normal()};
}

std::vector<PresetEntry> list_presets(std::span<const fs::path> folders) {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const fs::path& file = entry->path();
      std::error_code unreadable;
      if (file.extension() != ".json" || file.filename() == "schema.json") continue;
      if (fs::is_regular_file(file, unreadable)) by_name.emplace(file.stem().string(), file);
    }
  }
  std::vector<PresetEntry> presets;
  presets.reserve(by_name.size());
  for (auto& [name, file] : by_name) presets.push_back({name, std::move(file)});
  return presets;
}

Result<fs::path> find_preset(const std::string& name_or_path, std::span<const fs::path> folders) {
  const fs::path path(name_or_path);
  if (path.has_parent_path() || path.extension() == ".json") return path;
  for (PresetEntry& entry : list_presets(folders)) {
    if (entry.name == name_or_path) return std::move(entry.file);
  }
  std::error_code error;
  if (fs::is_regular_file(path, error)) return path;
  return request_error(name_or_path, "is no known preset; known: " + known_names(folders));
}

}  // namespace glint
