#include "core/math/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace glint {
namespace {

TEST(ParallelBlocks, RunsEveryBlockOnce) {
  std::vector<std::atomic<int>> runs(1000);
  JobControl control;
  EXPECT_TRUE(parallel_blocks(runs.size(), control, [&](std::size_t block) { runs[block].fetch_add(1); }));
  for (const std::atomic<int>& count : runs) ASSERT_EQ(count.load(), 1);
}

TEST(ParallelBlocks, OfNothingSucceeds) {
  JobControl control;
  EXPECT_TRUE(parallel_blocks(0, control, [](std::size_t) { FAIL() << "there is no block"; }));
  EXPECT_EQ(control.progress(), 0);
}

TEST(ParallelBlocks, CombinedInBlockOrderGivesTheSameBytesForAnyNumberOfThreads) {
  const auto sum = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> parts(777);
    JobControl control;
    EXPECT_TRUE(parallel_blocks(parts.size(), control, [&](std::size_t block) {
      for (std::size_t k = 0; k < 100; ++k) parts[block] += std::sin(static_cast<double>(block * 100 + k));
    }));
    double total = 0;
    for (const double part : parts) total += part;
    return total;
  };
  const double one = sum(1);
  EXPECT_EQ(one, sum(2));
  EXPECT_EQ(one, sum(4));
}

TEST(ParallelBlocks, OnOneThreadNeverRunsTwoBlocksAtATime) {
  const ThreadLimit limit(1);
  std::atomic<int> running{0};
  std::atomic<int> most{0};
  JobControl control;
  parallel_blocks(200, control, [&](std::size_t) {
    most = std::max(most.load(), ++running);
    --running;
  });
  EXPECT_EQ(most.load(), 1);
}

TEST(ParallelBlocks, RunsNothingOnceCancelled) {
  JobControl control;
  control.cancel();
  EXPECT_FALSE(parallel_blocks(100, control, [](std::size_t) { FAIL() << "the job was cancelled"; }));
}

TEST(ParallelBlocks, DropsWhatIsLeftWhenABlockCancels) {
  const ThreadLimit limit(1);
  std::atomic<int> runs{0};
  JobControl control;
  EXPECT_FALSE(parallel_blocks(100, control, [&](std::size_t) {
    if (++runs == 3) control.cancel();
  }));
  EXPECT_EQ(runs.load(), 3);
  EXPECT_LT(control.progress(), 0.1);
}

TEST(ParallelBlocks, OnTwoThreadsStopsSoonAfterACancel) {
  const ThreadLimit limit(2);
  std::atomic<int> runs_after{0};
  JobControl control;
  EXPECT_FALSE(parallel_blocks(10'000, control, [&](std::size_t) {
    if (control.cancelled()) ++runs_after;
    control.cancel();
  }));
  EXPECT_LE(runs_after.load(), 2);
}

TEST(ParallelBlocks, InsideABlockOfACancelledJobAnotherJobStillFinishes) {
  for (int repeat = 0; repeat < 10; ++repeat) {
    JobControl outer;
    std::atomic<int> unfinished{0};
    parallel_blocks(64, outer, [&](std::size_t) {
      outer.cancel();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));  // another thread meets the cancelled job meanwhile
      JobControl inner;
      std::atomic<int> runs{0};
      const bool finished = parallel_blocks(500, inner, [&](std::size_t) { ++runs; });
      if (!finished || runs.load() != 500) ++unfinished;
    });
    ASSERT_EQ(unfinished.load(), 0);
  }
}

TEST(JobControl, ProgressIsTheShareOfTheAnnouncedSteps) {
  JobControl control;
  EXPECT_EQ(control.progress(), 0);
  control.expect_steps(4);
  EXPECT_EQ(control.progress(), 0);
  control.finish_step();
  EXPECT_EQ(control.progress(), 0.25);
  control.expect_steps(4);
  EXPECT_EQ(control.progress(), 0.125);
  for (int step = 0; step < 9; ++step) control.finish_step();
  EXPECT_EQ(control.progress(), 1);  // never beyond, even if a job announced too little
}

TEST(JobControl, ABlockIsAStep) {
  const ThreadLimit limit(1);
  JobControl control;
  std::vector<double> seen;
  parallel_blocks(4, control, [&](std::size_t) { seen.push_back(control.progress()); });
  EXPECT_EQ(seen, (std::vector<double>{0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(control.progress(), 1);
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const int before = thread_count();
  EXPECT_GE(before, 1);
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(thread_count(), 1);
    {
      const ThreadLimit wider(2);
      EXPECT_EQ(thread_count(), 1);  // the tighter one counts
    }
  }
  EXPECT_EQ(thread_count(), before);
  const ThreadLimit nonsense(-3);
  EXPECT_EQ(thread_count(), 1);
}

#ifdef __linux__
int nice_of_this_thread() {
  return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

TEST(BackgroundPriority, LowersLentThreadsAndNotTheCaller) {
  if (thread_count() < 2) GTEST_SKIP() << "one thread lends none";
  const int own = nice_of_this_thread();
  if (own >= k_background_nice) GTEST_SKIP() << "the test itself has a low priority";
  const BackgroundPriority background;
  const auto caller = std::this_thread::get_id();
  std::atomic<int> lent_blocks{0};
  std::vector<double> parts(200);
  std::vector<int> nice(parts.size());
  JobControl control;
  ASSERT_TRUE(parallel_blocks(parts.size(), control, [&](std::size_t block) {
    const bool lent = std::this_thread::get_id() != caller;
    if (lent) ++lent_blocks;
    nice[block] = nice_of_this_thread() - (lent ? k_background_nice : own);
    parts[block] = static_cast<double>(block);
    // The caller waits for a lent thread to come, so that there is one.
    for (int wait = 0; wait < 1000 && !lent && lent_blocks == 0; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }));
  EXPECT_GT(lent_blocks.load(), 0);
  EXPECT_EQ(std::accumulate(parts.begin(), parts.end(), 0.0), 199.0 * 200 / 2);
  EXPECT_EQ(std::count(nice.begin(), nice.end(), 0), 200);
  EXPECT_EQ(nice_of_this_thread(), own);
}

TEST(BackgroundPriority, OfAThreadOfOnesOwnIsLoweredOnce) {
  const int own = nice_of_this_thread();
  int lowered = 0;
  int again = 0;
  std::thread([&] {
    lower_priority_of_this_thread();
    lowered = nice_of_this_thread();
    lower_priority_of_this_thread();
    again = nice_of_this_thread();
  }).join();
  EXPECT_EQ(lowered, std::max(own, k_background_nice));
  EXPECT_EQ(again, lowered);
  EXPECT_EQ(nice_of_this_thread(), own);
}
#endif

}  // namespace
}  // namespace glint
