#pragma once
// The bar at the bottom of the window: what is being computed and how long it will take, what each method took, and
// what happened last. Main thread.

#include <optional>
#include <string>
#include <vector>

#include "core/pndf/model_factory.h"
#include "gui/jobs/latest_job.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

/// What the picture of a method took.
struct StatusTime {
  PndfMethod method = PndfMethod::exact;
  std::optional<double> ms;  ///< none: not known yet
};

struct StatusInput {
  JobStatus job;
  bool cancelled = false;         ///< nothing runs because a person ended it
  std::vector<StatusTime> times;  ///< in the order of the document
  double frame_ms = 0;            ///< of drawing one frame; 0: not known yet
  std::string machine;            ///< "2 threads, AVX-512"
  std::string note;               ///< last message or explanation
};

struct StatusEvents {
  bool cancel = false;
};

/// Everything keeps its place while figures come and go. Where room is short, the methods' names go first, then the
/// machine, then the frame time; the note is cut. What differs from run to run is recorded as such: status.job,
/// status.time.exact …, status.frame, status.machine.
StatusEvents draw_status_bar(view::Ui& ui, const view::Rectangle& area, const StatusInput& input);

}  // namespace glint::gui
