#include "gui/commandline/opening.h"

#include <system_error>

#include "core/document/preset.h"
#include "gui/commandline/document_options.h"

namespace glint::gui {

Result<std::filesystem::path> named_document(const std::string& words) {
  Result<std::filesystem::path> file = find_preset(words, preset_folders(executable_path()));
  if (!file)
    return request_error(
        words, "is no file, and no preset; known" + file.error().sentence.substr(file.error().sentence.rfind(':')));
  std::error_code missing;
  if (!std::filesystem::exists(*file, missing)) return request_error(words, "there is no such file");
  return file;
}

Status open_document(Application& application, const std::string& words) {
  const Result<std::filesystem::path> file = named_document(words);
  if (!file) return file.error();
  return application.open(*file);
}

}  // namespace glint::gui
