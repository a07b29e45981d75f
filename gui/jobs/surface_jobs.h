#pragma once
// The surface of the live document, read or generated in the background.

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
#include "viewers/pndf/pndf_results.h"

namespace glint::gui {

/// Reads or generates it; a cancelled job is an error like any other, whose sentence nobody should see.
Result<std::shared_ptr<const view::SurfaceInUse>> load_surface_in_use(const SurfaceDescription& description,
                                                                      JobControl& control);

/// What loading it does, for the status line: "reading wood.png", "generating noise".
std::string loading_text(const SurfaceDescription& description);

/// Equal for descriptions of the same map: the interpolation and fields without effect play no part.
struct MapIdentity {
  std::string recipe;
  std::filesystem::path path;

  friend bool operator==(const MapIdentity&, const MapIdentity&) = default;
};
MapIdentity map_identity(const SurfaceDescription& description);

/// All members are called from the frame thread and never wait, except for the destructor.
class SurfaceJobs {
 public:
  SurfaceJobs(const std::function<void()>& wake, ErrorInbox& errors);

  /// Asks for the surface of `description`. The map in use is kept if it is the same, an offered one is taken; else a
  /// map is loaded, unless the same request has failed or was cancelled before.
  void request(const SurfaceDescription& description);
  /// A surface that has been loaded elsewhere, for the next request if it asks for the same map.
  void offer(std::shared_ptr<const view::SurfaceInUse> surface) { offered_ = std::move(surface); }
  [[nodiscard]] bool has_offer() const { return offered_ != nullptr; }
  /// Takes over what has been loaded.
  void poll();
  /// Loads the requested surface again, whatever is in use.
  void reload();
  /// What was loading stays unsettled until restart() or another request.
  void cancel();
  /// Loads what was cancelled, and nothing else.
  void restart();

  /// Null until the first is there.
  [[nodiscard]] const std::shared_ptr<const view::SurfaceInUse>& in_use() const { return in_use_; }
  /// Why the requested surface is not the one in use.
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// The request has been answered, by a surface or an error.
  [[nodiscard]] bool settled() const { return !pending_; }
  [[nodiscard]] bool idle() const;
  [[nodiscard]] JobStatus status() const { return job_.status(); }

 private:
  struct Loaded {
    MapIdentity identity;
    Result<std::shared_ptr<const view::SurfaceInUse>> surface;
  };

  void load();
  void use(std::shared_ptr<const view::SurfaceInUse> surface, MapIdentity identity);

  ErrorInbox& errors_;
  SurfaceDescription wanted_;
  MapIdentity wanted_identity_;
  std::shared_ptr<const view::SurfaceInUse> in_use_;
  MapIdentity in_use_identity_;
  std::shared_ptr<const view::SurfaceInUse> offered_;
  std::optional<Error> error_;
  bool pending_ = false;  // the wanted map has been asked for and is neither here nor refused
  mutable std::mutex mutex_;
  std::optional<Loaded> loaded_;  // guarded by mutex_: by the job for poll()
  LatestJob job_;                 // last: its thread uses the above
};

}  // namespace glint::gui
