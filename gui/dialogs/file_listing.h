#pragma once
// What a folder holds, as a file browser shows it, and what a person means by a path they type. Reads folders, draws
// nothing; any thread.

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/result.h"

namespace glint::gui {

/// Which files of a folder are shown.
struct FileFilter {
  std::string label;                    ///< "Pictures"
  std::vector<std::string> extensions;  ///< in small letters, with the dot; empty: all files

  /// By the extension alone, in any case.
  [[nodiscard]] bool matches(const std::filesystem::path& file) const;
};

struct ListedFile {
  std::filesystem::path path;  ///< of the folder as it was asked for, and the name
  std::string name;            ///< for a person: UTF-8 in one line, whatever the bytes of the file's name
  bool is_folder = false;
  std::uintmax_t bytes = 0;  ///< 0 for a folder
  std::string size;          ///< "1.4 MB"; empty for a folder
  std::string date;          ///< of the last change, local time: "2024-05-03 14:07"; empty where it is not known
};

struct FolderListing {
  std::filesystem::path folder;
  std::vector<ListedFile> entries;  ///< folders, then files; by name, numbers in it by their value
  bool writable = false;            ///< files can be put there
};

/// The folders and matching files of a folder. What is neither (devices, broken links) is left out; what begins with a
/// dot is only there if `with_hidden`. Errors: the folder does not exist, is a file, or may not be read; the sentence
/// continues "This folder …".
Result<FolderListing> list_folder(const std::filesystem::path& folder, const FileFilter& filter,
                                  bool with_hidden = false);

/// Order of names: upper and lower case alike, runs of digits by their value; never equal for different names.
bool natural_less(std::string_view a, std::string_view b);

/// "812 B", "1.4 kB", "23.5 MB": three digits at most, in steps of 1000.
std::string size_text(std::uintmax_t bytes);
/// "2024-05-03 14:07" in local time.
std::string date_text(std::time_t time);

/// A path as text for a person: UTF-8 in one line.
std::string shown_path(const std::filesystem::path& path);

/// None at the root.
std::optional<std::filesystem::path> parent_of(const std::filesystem::path& folder);

/// The path that a person means by `text` while they look at `folder`: "~" is the home folder, a relative path begins
/// at `folder`. Without "." and ".."; never ends in a slash, but for the root.
std::filesystem::path typed_path(std::string_view text, const std::filesystem::path& folder);

/// How a typed text can go on: whole texts to put in its place, folders with a slash at their end, in the order of a
/// listing, `most` at most. Letters match in either case.
std::vector<std::string> completions(std::string_view text, const std::filesystem::path& folder,
                                     const FileFilter& filter, std::size_t most = 8);

/// The file name (without extension) of something with that name: small letters, digits and single dashes; letters
/// beyond ASCII stay. "preset" where nothing is left of it.
std::string slug(std::string_view name);

}  // namespace glint::gui
