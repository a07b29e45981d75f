#pragma once
// A background thread for one kind of work, of which only the newest request matters: a new one takes the place of what
// waits and cancels what runs.

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/math/parallel.h"
#include "core/pndf/model_factory.h"
#include "gui/jobs/error_inbox.h"

namespace glint::gui {

/// What a job is doing, for the status line.
struct JobStatus {
  bool busy = false;
  std::string text;                    ///< "Binning", "reading wood.png"; empty when not busy
  double progress = 0;                 ///< of what `text` says, 0 to 1
  std::optional<double> seconds_left;  ///< estimated from the progress; none while unknown or at most a second
  std::optional<PndfMethod> method;    ///< whose picture is being computed
};

/// What a job that threw says of it: not enough memory, or the exception's own words.
Error exception_error(std::string subject, const std::exception& failure);

/// Cancellation and progress of one run of a job, which is a sequence of steps. Members may be called from any thread,
/// except where they say otherwise.
class JobSteps {
 public:
  using Clock = std::chrono::steady_clock;

  /// Begins the next step. Only for the job itself; the control lives until the next step.
  JobControl& begin(std::string text, std::optional<PndfMethod> method = std::nullopt);

  void cancel();
  [[nodiscard]] bool cancelled() const;

  /// From now until `time` a newer request does not cancel this run, only a person does.
  void spare_until(Clock::time_point time);
  /// The end of that: cancelled, if a newer request came meanwhile.
  void end_sparing();
  /// A newer request waits: cancels at once, or when the run is no longer spared.
  void supersede();
  [[nodiscard]] bool superseded() const;
  /// Cancels a superseded run whose time is over.
  void poll();

  [[nodiscard]] JobStatus status() const;

 private:
  void cancel_locked();

  mutable std::mutex mutex_;
  std::shared_ptr<JobControl> control_ = std::make_shared<JobControl>();
  std::string text_;
  std::optional<PndfMethod> method_;
  Clock::time_point began_{};
  Clock::time_point spared_until_{};
  bool cancelled_ = false;
  bool superseded_ = false;
};

/// All members are called from one thread and never wait, except for the destructor, which cancels and joins.
class LatestJob {
 public:
  using Work = std::function<void(JobSteps&)>;

  /// `wake` is called by the background thread when a run has ended. Exceptions of a run end up in `errors`. Both must
  /// outlive this.
  LatestJob(const std::function<void()>& wake, ErrorInbox& errors);
  ~LatestJob();
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  /// Runs `work` as soon as what runs now has ended; what was waiting is forgotten.
  void start(Work work);
  /// Cancels what runs, forgets what waits.
  void cancel();
  /// To be called often while busy: ends the time a superseded run is spared.
  void poll();
  /// Nothing runs or waits.
  [[nodiscard]] bool idle() const;
  [[nodiscard]] JobStatus status() const;

 private:
  void run();
  void run_guarded(const Work& work, JobSteps& steps);

  const std::function<void()>& wake_;
  ErrorInbox& errors_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Work waiting_;
  std::shared_ptr<JobSteps> running_;
  bool ending_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace glint::gui
