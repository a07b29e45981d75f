#include "core/math/parallel.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

// ThreadSanitizer cannot see how oneTBB hands work from thread to thread, so the hand-over is marked here, once.
#if defined(__SANITIZE_THREAD__)
#define GLINT_TSAN 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GLINT_TSAN 1
#endif
#endif
#ifdef GLINT_TSAN
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
#define GLINT_NOT_TRACED __attribute__((no_sanitize("thread")))
#else
#define GLINT_NOT_TRACED
#endif

namespace glint {
namespace {

void hand_over([[maybe_unused]] void* token) {
#ifdef GLINT_TSAN
  __tsan_release(token);
#endif
}

void take_over([[maybe_unused]] void* token) {
#ifdef GLINT_TSAN
  __tsan_acquire(token);
#endif
}

// oneTBB's threads belong to the whole process, so what is asked of them does too. Its own observers of threads see one
// arena each, and every thread that starts a loop has another.
std::atomic<int> background_wishes{0};

void lower_priority_of_lent_thread() {
  thread_local bool lowered = false;
  if (lowered || background_wishes.load(std::memory_order_relaxed) == 0) return;
  // Slot 0 of an arena is the thread's that it belongs to.
  if (tbb::this_task_arena::current_thread_index() <= 0) return;
  lower_priority_of_this_thread();
  lowered = true;
}

}  // namespace

double JobControl::progress() const {
  const auto expected = static_cast<double>(expected_.load(std::memory_order_relaxed));
  const auto finished = static_cast<double>(finished_.load(std::memory_order_relaxed));
  return expected > 0 ? std::min(1.0, finished / expected) : 0.0;
}

bool parallel_blocks(std::size_t block_count, JobControl& control, const std::function<void(std::size_t)>& body) {
  control.expect_steps(block_count);
  char begin = 0;
  char end = 0;
  // Isolated: a loop inside a block of another job must not lose blocks when only that other job is cancelled.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  const auto run = [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block != last; ++block) {
      if (control.cancelled()) {
        context.cancel_group_execution();
        return;
      }
      body(block);
      control.finish_step();
    }
  };
  hand_over(&begin);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, block_count, 1),
      // The range and this closure were written by whichever thread split the work: before any hand-over.
      [&](const tbb::blocked_range<std::size_t>& range) GLINT_NOT_TRACED {
        take_over(&begin);
        lower_priority_of_lent_thread();
        run(range.begin(), range.end());
        hand_over(&end);
      },
      tbb::simple_partitioner(), context);
  take_over(&end);
  return !control.cancelled();
}

void run_isolated(const std::function<void()>& body) {
  tbb::this_task_arena::isolate([&] { body(); });
}

int thread_count() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

struct ThreadLimit::Control {
  explicit Control(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(1, threads))) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}
ThreadLimit::~ThreadLimit() = default;

void lower_priority_of_this_thread() {
#ifdef __linux__
  const auto thread = static_cast<id_t>(gettid());  // Linux has a priority for each thread, not for a process
  if (getpriority(PRIO_PROCESS, thread) < k_background_nice) setpriority(PRIO_PROCESS, thread, k_background_nice);
#endif
}

BackgroundPriority::BackgroundPriority() {
  background_wishes.fetch_add(1, std::memory_order_relaxed);
}
bool BackgroundPriority::is_wanted() {
  return background_wishes.load(std::memory_order_relaxed) > 0;
}
BackgroundPriority::~BackgroundPriority() {
  background_wishes.fetch_sub(1, std::memory_order_relaxed);
}

}  // namespace glint
