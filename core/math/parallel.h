#pragma once
// The one door to threads. Work is cut into blocks whose number and borders do not depend on the number of threads;
// what each block produces is combined in block order by the caller, so results are the same bytes for any thread
// count.

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace glint {

/// Cancellation and progress of one job. All members may be called from any thread.
class JobControl {
 public:
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  /// Announces more work; a job may announce several times.
  void expect_steps(std::size_t count) { expected_.fetch_add(count, std::memory_order_relaxed); }
  void finish_step() { finished_.fetch_add(1, std::memory_order_relaxed); }
  /// Share of the announced work that is done, in [0, 1]; 0 before anything was announced.
  [[nodiscard]] double progress() const;

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<std::size_t> expected_{0};
  std::atomic<std::size_t> finished_{0};
};

/// Runs body(0) … body(block_count - 1), in any order, on all allowed threads; each block is one step of `control`.
/// Blocks not yet begun are dropped once `control` is cancelled; a long body should ask control.cancelled() itself.
/// Returns false if the job was cancelled. The body must not throw.
bool parallel_blocks(std::size_t block_count, JobControl& control, const std::function<void(std::size_t)>& body);

/// Runs `body`; while loops inside it wait for their last blocks, this thread takes none of the loops around it. For
/// what is done under a lock or once: a block taken up meanwhile may wait for the same.
void run_isolated(const std::function<void()>& body);

/// The number of threads parallel_blocks may use now.
int thread_count();

/// While alive, bounds the threads of every parallel_blocks of this process.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// How much lower: a third of the time of an equal thread where there is not enough for all.
inline constexpr int k_background_nice = 5;

/// Makes the operating system prefer other threads to the calling one, for the rest of its life: raising the priority
/// again takes a privilege. Only on Linux; elsewhere nothing happens.
void lower_priority_of_this_thread();

/// While one is alive, every thread that oneTBB lends to a parallel_blocks gets a lower priority, as above; the calling
/// thread keeps its own. For a process with a window, which stays smooth while its jobs take every core. What was
/// lowered stays so after its end.
class BackgroundPriority {
 public:
  BackgroundPriority();
  ~BackgroundPriority();
  /// Whether one is alive.
  static bool is_wanted();
  BackgroundPriority(const BackgroundPriority&) = delete;
  BackgroundPriority& operator=(const BackgroundPriority&) = delete;
};

}  // namespace glint
