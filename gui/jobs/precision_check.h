#pragma once
// Single against double precision at one normal, when a person asks: how far the exact picture can be trusted there.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include <glm/vec2.hpp>

#include "gui/jobs/error_inbox.h"
#include "gui/jobs/latest_job.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::gui {

/// The same cell of the same picture in both precisions.
struct PrecisionReading {
  glm::dvec2 s{0, 0};  ///< the cell's centre
  double single_precision = 0;
  double double_precision = 0;
  double largest = 0;  ///< of the picture
};

/// All members are called from the frame thread and never wait, except for the destructor.
class PrecisionCheck {
 public:
  PrecisionCheck(const std::function<void()>& wake, ErrorInbox& errors) : job_(wake, errors) {}

  /// Why nothing can be compared at `s` in these results, or "".
  static const char* reason_against(const view::PndfResults* results, glm::dvec2 s);
  /// Compares at the cell that holds `s`, on the surface and the triangles of the picture; there must be no reason
  /// against it.
  void request(std::shared_ptr<const view::PndfResults> results, glm::dvec2 s);
  /// What came of the newest request, once.
  std::optional<PrecisionReading> take();
  /// Ends what runs; what came of it is forgotten.
  void cancel();
  [[nodiscard]] bool idle() const { return job_.idle(); }
  [[nodiscard]] JobStatus status() const { return job_.status(); }

 private:
  std::mutex mutex_;
  std::optional<PrecisionReading> reading_;
  LatestJob job_;  // last: its thread uses the above
};

}  // namespace glint::gui
