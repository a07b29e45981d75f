#pragma once
// Files opened as documents, in the background: presets, P-NDF images with a recipe, and maps.

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/math/parallel.h"
#include "core/math/result.h"
#include "gui/jobs/error_inbox.h"
#include "gui/jobs/latest_job.h"
#include "gui/jobs/surface_jobs.h"

namespace glint::gui {

/// A document that came from a file.
struct Opened {
  Document document;
  std::string label;  ///< of the step of undo: "Open wood.png"
};

/// The document of a file, and its surface: a preset (.json), an EXR with a recipe, else a map, which becomes the
/// surface of a copy of `current`, read with default options, its footprint moved to the middle if it lay outside.
struct OpenedFile {
  Opened opened;
  std::shared_ptr<const view::SurfaceInUse> surface;
};
Result<OpenedFile> open_file(const std::filesystem::path& file, const Document& current, JobControl& control);

/// All members are called from the frame thread and never wait, except for the destructor.
class OpenJobs {
 public:
  OpenJobs(const std::function<void()>& wake, ErrorInbox& errors);

  /// A newer file supersedes an older one. A failure is one error in the inbox.
  void open(std::filesystem::path file, Document current);
  /// What has been opened, once.
  std::optional<OpenedFile> take();
  void cancel();
  /// Nothing is being opened or waits to be taken.
  [[nodiscard]] bool idle() const;
  [[nodiscard]] JobStatus status() const { return job_.status(); }

 private:
  ErrorInbox& errors_;
  mutable std::mutex mutex_;
  std::optional<OpenedFile> opened_;  // guarded by mutex_
  LatestJob job_;                     // last: its thread uses the above
};

}  // namespace glint::gui
