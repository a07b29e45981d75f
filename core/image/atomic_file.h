#pragma once
// Files out, all or nothing: written beside their final name and renamed, so that an interrupted or failed run leaves
// the old file whole.

#include <filesystem>
#include <string_view>

#include "core/math/result.h"

namespace glint {

/// One output file on its way. Write to temporary(), close it, then commit(); without a commit the temporary file is
/// removed and the target stays as it was. Move-only; one thread at a time.
class AtomicFile {
 public:
  /// Creates an empty temporary file in the target's folder, named NAME.partial.N.EXT: the same extension, because
  /// image libraries choose the format by it. A request error where the target cannot be written.
  static Result<AtomicFile> create(const std::filesystem::path& target);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  ~AtomicFile();

  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

  /// Gives the temporary file its final name, in one step. A file that is replaced passes its permissions on, and a
  /// symbolic link goes on pointing at the file it names.
  Status commit();

 private:
  AtomicFile(std::filesystem::path asked, std::filesystem::path target, std::filesystem::path temporary);
  void discard() noexcept;

  std::filesystem::path asked_;      // as the caller wrote it, for messages
  std::filesystem::path target_;     // links followed
  std::filesystem::path temporary_;  // empty: nothing left to remove
};

/// `bytes` as the whole file `target`.
Status write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace glint
