#pragma once
// What is in a file, before it is opened: a small picture and a few facts, read off the frame thread.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "gui/jobs/error_inbox.h"
#include "gui/jobs/latest_job.h"

namespace glint::gui {

struct FilePreview {
  struct Fact {
    std::string caption;  ///< "Size"
    std::string value;    ///< "1024 × 1024"
  };

  std::vector<Fact> facts;
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;  ///< of `size`, rows from the top; empty: no picture
  std::string reason;              ///< why there is none, or why the file cannot be opened: a whole sentence
  std::string remark;              ///< what else is worth knowing: a sentence
};

/// Pictures above this are not decoded for a preview.
inline constexpr std::int64_t k_most_preview_pixels = 64'000'000;

/// The preview of a preset (.json), or of a picture: no side of it has more than `most_side` pixels. Values below zero
/// and above one are brought into range, so that normals and densities show.
FilePreview preview_of(const std::filesystem::path& file, int most_side, JobControl& control);

/// The preview of the file that was wanted last. Members are called from one thread and never wait, except for the
/// destructor, which cancels and joins.
class FilePreviews {
 public:
  /// `wake` is called from a background thread when there is something new to see.
  explicit FilePreviews(std::function<void()> wake);

  /// Nothing happens where it is the file that was wanted last.
  void want(const std::filesystem::path& file, int most_side);
  /// Wants none, and reads a file again that is wanted later.
  void forget();
  /// Of the file that was wanted last; null while it is being read.
  [[nodiscard]] std::shared_ptr<const FilePreview> current() const;
  [[nodiscard]] bool idle() const { return job_.idle(); }

 private:
  const std::function<void()> wake_;
  ErrorInbox errors_;  // of a run that threw: the file then has no preview
  std::filesystem::path wanted_;
  mutable std::mutex mutex_;
  std::shared_ptr<const FilePreview> current_;  // guarded by mutex_
  LatestJob job_;                               // last: its thread uses the above
};

}  // namespace glint::gui
