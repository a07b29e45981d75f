#include "gui/memory/user_folders.h"

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <ios>
#include <system_error>

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_largest_file = std::size_t{1} << 20U;  // bytes

// The specification has a relative path in these variables ignored.
std::optional<fs::path> folder_in(const char* variable) {
  const char* value = std::getenv(variable);
  if (!value || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

std::optional<fs::path> base_folder(const char* variable, const char* below_home) {
  if (const std::optional<fs::path> set = folder_in(variable)) return *set / "glintscope";
  if (const std::optional<fs::path> home = folder_in("HOME")) return *home / below_home / "glintscope";
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> config_folder() {
  return base_folder("XDG_CONFIG_HOME", ".config");
}

std::optional<fs::path> state_folder() {
  return base_folder("XDG_STATE_HOME", ".local/state");
}

std::optional<fs::path> user_presets_folder() {
  const std::optional<fs::path> config = config_folder();
  if (!config) return std::nullopt;
  return *config / "presets";
}

Status make_folder(const fs::path& folder) {
  std::error_code error;
  const bool created = fs::create_directories(folder, error);
  if (error) return content_error(folder.string(), "cannot be created: " + error.message());
  if (created) fs::permissions(folder, fs::perms::owner_all, error);  // a file system without them has none to lose
  return success();
}

Result<std::string> read_small_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return content_error(file.string(), "cannot be read: there is no such file");
  if (fs::is_directory(status)) return content_error(file.string(), "cannot be read: it is a folder");
  std::ifstream in(file, std::ios::binary);
  if (!in) return content_error(file.string(), "cannot be read: it cannot be opened");
  std::string text(k_largest_file + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) return content_error(file.string(), "cannot be read to its end");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > k_largest_file) return content_error(file.string(), "is larger than 1 MiB, too large to be read");
  return text;
}

}  // namespace glint::gui
