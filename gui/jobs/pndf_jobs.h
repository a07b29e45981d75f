#pragma once
// The P-NDF pictures of the live document, computed in the background: first coarse ones of all methods, then the full
// ones, then the reference and every picture's error against it. Only what a change invalidates is computed.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/workspace.h"
#include "core/study/reference.h"
#include "gui/jobs/atlas_keeper.h"
#include "gui/jobs/error_inbox.h"
#include "gui/jobs/latest_job.h"
#include "gui/jobs/picture_board.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::gui {

/// How long first pictures may take while newer requests wait, so that a drag shows any.
inline constexpr std::chrono::milliseconds k_first_pictures_time{150};

/// All members are called from the frame thread and never wait, except for the destructor.
class PndfJobs {
 public:
  PndfJobs(const std::function<void()>& wake, ErrorInbox& errors);

  /// Asks for the pictures of `document` on `surface`, the surface of its description. Where they are those already
  /// asked for, they only count as of the new revision from now on.
  void request(const Document& document, const std::shared_ptr<const view::SurfaceInUse>& surface,
               std::uint64_t revision);
  /// To be called every frame.
  void poll();
  void cancel() { job_.cancel(); }
  /// The next request starts even if it is the same as the last.
  void forget_request() { requested_.reset(); }

  [[nodiscard]] std::shared_ptr<const view::PndfResults> results() const { return board_.results(); }
  [[nodiscard]] bool idle() const { return job_.idle(); }
  [[nodiscard]] JobStatus status() const { return job_.status(); }

 private:
  struct RequestIdentity {
    std::shared_ptr<const NormalMap> map;
    std::string recipe;

    friend bool operator==(const RequestIdentity&, const RequestIdentity&) = default;
  };
  struct ReferenceIdentity {
    std::shared_ptr<const NormalMap> map;
    Interpolation interpolation;
    double intrinsic_roughness;
    Footprint footprint;
    PndfGrid grid;

    /// That of another surface over the same map.
    [[nodiscard]] ReferenceIdentity on(Interpolation other) const {
      ReferenceIdentity identity = *this;
      identity.interpolation = other;
      return identity;
    }

    friend bool operator==(const ReferenceIdentity&, const ReferenceIdentity&) = default;
  };
  struct KeptReference {
    ReferenceIdentity identity;
    CellContent content;
    std::shared_ptr<const ReferenceImage> reference;
  };
  struct Run {
    const Document& document;
    const std::shared_ptr<const view::SurfaceInUse>& surface;
    PndfGrid grid;
    JobSteps& steps;
  };

  // Of the background thread.
  void compute(PictureBoard::Label label, const std::shared_ptr<const view::SurfaceInUse>& surface, JobSteps& steps);
  void compute_first_pictures(const Run& run);
  void compute_full_pictures(const Run& run);
  void prepare_atlas(const Run& run);
  void compute_errors(const Run& run);
  void compute_picture(const Run& run, std::size_t index, bool coarse);
  bool report_fault(const Document& document, const Surface& surface, const PndfGrid& grid);
  [[nodiscard]] std::shared_ptr<const PndfImage> shown_reference(const ReferenceIdentity& identity) const;
  std::shared_ptr<const ReferenceImage> reference_for(const Run& run, Interpolation surface, CellContent content,
                                                      PndfMethod method);

  ErrorInbox& errors_;
  std::optional<RequestIdentity> requested_;
  std::uint64_t requests_ = 0;
  std::vector<KeptReference> references_;  // only of the background thread
  std::optional<Error> last_fault_;        // likewise
  AtlasKeeper atlas_;                      // likewise
  PictureBoard board_;
  const std::function<void()>& wake_;
  LatestJob job_;  // last: its thread uses the above
};

}  // namespace glint::gui
