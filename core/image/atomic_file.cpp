#include "core/image/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr int k_most_links = 40;
constexpr int k_most_temporaries = 1000;  // beside one target: left by runs that were killed, or by runs at work

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

fs::path temporary_name(const fs::path& target, int number) {
  fs::path name = target.stem();
  name += fmt::format(".partial.{}", number);
  name += target.extension();
  return target.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(fs::path asked, fs::path target, fs::path temporary)
    : asked_(std::move(asked)), target_(std::move(target)), temporary_(std::move(temporary)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : asked_(std::move(other.asked_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, fs::path())) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  asked_ = std::move(other.asked_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, fs::path());
  return *this;
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::discard() noexcept {
  if (temporary_.empty()) return;
  std::error_code ignored;  // nothing more can be done about a file that cannot be removed
  fs::remove(temporary_, ignored);
  temporary_.clear();
}

Result<AtomicFile> AtomicFile::create(const fs::path& target) {
  const auto refuse = [&](const std::string& why) {
    return request_error(target.string(), fmt::format("cannot be written: {}", why));
  };
  if (target.filename().empty()) return refuse("a file name is needed");
  std::error_code error;
  fs::path final_target = target;
  for (int hop = 0; fs::is_symlink(final_target, error); ++hop) {  // by hand: what a link names may not exist yet
    if (hop == k_most_links) return refuse("its links go round in a circle");
    const fs::path next = fs::read_symlink(final_target, error);
    if (error) return refuse(error.message());
    final_target = final_target.parent_path() / next;
  }
  const fs::file_status status = fs::status(final_target, error);
  if (fs::is_directory(status)) return refuse("it is a folder");
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) return refuse("it is not a regular file");
    // Renaming needs only the folder's permission; a file that its owner made read-only is left alone.
    if (!OpenFile(std::fopen(final_target.c_str(), "r+b"))) return refuse(reason(errno));
  }
  for (int number = 0; number < k_most_temporaries; ++number) {
    const fs::path temporary = temporary_name(final_target, number);
    if (OpenFile(std::fopen(temporary.c_str(), "wbx"))) return AtomicFile(target, final_target, temporary);
    if (errno != EEXIST) return refuse(reason(errno));
  }
  return refuse(fmt::format("its folder holds {} unfinished files of this name", k_most_temporaries));
}

Status AtomicFile::commit() {
  std::error_code error;
  const fs::file_status replaced = fs::status(target_, error);
  if (fs::is_regular_file(replaced)) fs::permissions(temporary_, replaced.permissions(), error);
  fs::rename(temporary_, target_, error);
  if (error) {
    discard();
    return content_error(asked_.string(), fmt::format("cannot be written: {}", error.message()));
  }
  temporary_.clear();
  return success();
}

Status write_file(const fs::path& target, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(target);
  if (!file) return file.error();
  OpenFile out(std::fopen(file->temporary().c_str(), "wb"));
  bool written = out && std::fwrite(bytes.data(), 1, bytes.size(), out.get()) == bytes.size();
  int error_number = errno;
  if (out && std::fclose(out.release()) != 0 && written) {  // what was buffered may fail only now
    written = false;
    error_number = errno;
  }
  if (!written) {
    return content_error(target.string(), fmt::format("cannot be written: {}", reason(error_number)));
  }
  return file->commit();
}

}  // namespace glint
