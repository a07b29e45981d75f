#pragma once
// Everything that is computed for the live document, off the frame loop: its surface, its P-NDF pictures and their
// errors, and files opened as new documents.
//
// Each frame: update() with the live document, then what is asked is up to date. All members are called from the frame
// thread and never wait, except for the destructor, which cancels and joins. While idle() is false the frame loop has
// to come round about ten times a second even without events, for progress and for what a drag has superseded.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/math/result.h"
#include "gui/jobs/error_inbox.h"
#include "gui/jobs/latest_job.h"
#include "gui/jobs/open_jobs.h"
#include "gui/jobs/pndf_jobs.h"
#include "gui/jobs/precision_check.h"
#include "gui/jobs/surface_jobs.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::gui {

class DocumentJobs {
 public:
  /// `wake` is called from background threads when there is something new to see, until the destructor returns.
  explicit DocumentJobs(std::function<void()> wake);
  ~DocumentJobs();
  DocumentJobs(const DocumentJobs&) = delete;
  DocumentJobs& operator=(const DocumentJobs&) = delete;

  /// Sees to it that what is computed is that of `document`. Equal revisions are equal documents.
  void update(const Document& document, std::uint64_t revision);

  /// Loads a file in the background: a preset, an EXR with a recipe, or a map for the document of the last update().
  void open(std::filesystem::path file);
  /// What has been opened, once, with its surface loaded: the update() that follows with this document uses it.
  std::optional<Opened> take_opened();

  /// A file is on its way, or waits to be taken.
  [[nodiscard]] bool opening() const { return !open_.idle(); }
  /// The document's map is being read or generated.
  [[nodiscard]] bool loading_surface() const { return !surface_.idle(); }

  /// Each error once, oldest first.
  std::vector<Error> take_errors() { return errors_.take(); }

  /// The newest that was published, of whatever revision; null at first. Its document has the description of the
  /// surface it was computed on, which is not the live document's while that cannot be loaded.
  [[nodiscard]] std::shared_ptr<const view::PndfResults> results() const { return pndf_.results(); }
  /// The surface in use; null until the first is loaded.
  [[nodiscard]] std::shared_ptr<const view::SurfaceInUse> surface() const { return surface_.in_use(); }
  /// Why the surface in use is not the document's.
  [[nodiscard]] const std::optional<Error>& surface_error() const { return surface_.error(); }

  /// Compares the exact picture with double precision at a normal, in the background.
  void check_precision(glm::dvec2 s) { check_.request(results(), s); }
  std::optional<PrecisionReading> take_precision_reading() { return check_.take(); }

  [[nodiscard]] JobStatus status() const;
  /// Nothing runs or waits: all that can be had for the document of the last update() is there, unless cancelled(). A
  /// file that was opened waits to be taken.
  [[nodiscard]] bool idle() const;

  /// Ends what runs; it is not begun again before the document changes in more than its name and view.
  void cancel();
  [[nodiscard]] bool cancelled() const { return cancelled_; }
  /// Computes what was cancelled; what had been finished is kept.
  void restart();
  /// Reads the file of the surface again, or generates it again.
  void reload_surface();

 private:
  void ask_for_pictures();
  void begin_again();

  const std::function<void()> wake_;
  ErrorInbox errors_;
  std::optional<Document> document_;  // of the last update
  std::uint64_t revision_ = 0;
  std::string recipe_;  // what of the document is computed
  bool cancelled_ = false;
  bool pictures_wanted_ = false;                             // pndf_ is to be asked as soon as the surface is settled
  std::shared_ptr<const view::SurfaceInUse> asked_surface_;  // that of the last request to pndf_
  OpenJobs open_;
  SurfaceJobs surface_;
  PndfJobs pndf_;
  PrecisionCheck check_;
};

}  // namespace glint::gui
