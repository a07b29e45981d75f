#include "gui/jobs/latest_job.h"

#include <exception>
#include <new>
#include <utility>

namespace glint::gui {
namespace {

// Below this share of a step its duration is a guess that only confuses.
constexpr double k_least_progress = 0.02;
constexpr double k_least_seconds = 1;

}  // namespace

Error exception_error(std::string subject, const std::exception& failure) {
  if (dynamic_cast<const std::bad_alloc*>(&failure)) {
    return content_error(std::move(subject), "needs more memory than there is");
  }
  return content_error(std::move(subject), std::string("failed: ") + failure.what());
}

JobControl& JobSteps::begin(std::string text, std::optional<PndfMethod> method) {
  const std::lock_guard lock(mutex_);
  control_ = std::make_shared<JobControl>();
  if (cancelled_) control_->cancel();
  text_ = std::move(text);
  method_ = method;
  began_ = Clock::now();
  return *control_;
}

void JobSteps::cancel_locked() {
  cancelled_ = true;
  control_->cancel();
}

void JobSteps::cancel() {
  const std::lock_guard lock(mutex_);
  cancel_locked();
}

bool JobSteps::cancelled() const {
  const std::lock_guard lock(mutex_);
  return cancelled_;
}

void JobSteps::spare_until(Clock::time_point time) {
  const std::lock_guard lock(mutex_);
  spared_until_ = time;
}

void JobSteps::end_sparing() {
  const std::lock_guard lock(mutex_);
  spared_until_ = {};
  if (superseded_) cancel_locked();
}

void JobSteps::supersede() {
  {
    const std::lock_guard lock(mutex_);
    superseded_ = true;
  }
  poll();
}

bool JobSteps::superseded() const {
  const std::lock_guard lock(mutex_);
  return superseded_;
}

void JobSteps::poll() {
  const std::lock_guard lock(mutex_);
  if (superseded_ && Clock::now() >= spared_until_) cancel_locked();
}

JobStatus JobSteps::status() const {
  const std::lock_guard lock(mutex_);
  JobStatus status{true, text_, control_->progress(), std::nullopt, method_};
  if (status.progress > k_least_progress) {
    const std::chrono::duration<double> elapsed = Clock::now() - began_;
    const double left = elapsed.count() * (1 - status.progress) / status.progress;
    if (left > k_least_seconds) status.seconds_left = left;
  }
  return status;
}

LatestJob::LatestJob(const std::function<void()>& wake, ErrorInbox& errors)
    : wake_(wake), errors_(errors), thread_([this] { run(); }) {}

LatestJob::~LatestJob() {
  cancel();
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void LatestJob::start(Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(work);
    if (running_) running_->supersede();
  }
  changed_.notify_all();
}

void LatestJob::cancel() {
  const std::lock_guard lock(mutex_);
  waiting_ = nullptr;
  if (running_) running_->cancel();
}

void LatestJob::poll() {
  const std::lock_guard lock(mutex_);
  if (running_) running_->poll();
}

bool LatestJob::idle() const {
  const std::lock_guard lock(mutex_);
  return !waiting_ && !running_;
}

JobStatus LatestJob::status() const {
  const std::lock_guard lock(mutex_);
  if (running_) return running_->status();
  return {.busy = static_cast<bool>(waiting_), .text = {}, .seconds_left = {}, .method = {}};
}

void LatestJob::run_guarded(const Work& work, JobSteps& steps) {
  try {
    work(steps);
  } catch (const std::exception& failure) {
    errors_.post(exception_error(steps.status().text, failure));
  }
}

void LatestJob::run() {
  if (BackgroundPriority::is_wanted()) lower_priority_of_this_thread();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || waiting_; });
    if (ending_) return;
    Work work = std::exchange(waiting_, nullptr);
    const auto steps = std::make_shared<JobSteps>();
    running_ = steps;
    lock.unlock();
    run_guarded(work, *steps);
    work = nullptr;  // what it holds is freed here and not by whoever waits for the lock
    lock.lock();
    running_.reset();
    lock.unlock();
    wake_();
    lock.lock();
  }
}

}  // namespace glint::gui
