#include "gui/jobs/latest_job.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace glint::gui {
namespace {

using namespace std::chrono_literals;

class LatestJobTest : public testing::Test {
 protected:
  void wait() {
    while (!job_.idle()) std::this_thread::sleep_for(1ms);
  }
  static void run_until_cancelled(const JobSteps& steps) {
    while (!steps.cancelled()) std::this_thread::sleep_for(1ms);
  }

  std::atomic<int> wakes_ = 0;
  const std::function<void()> wake_ = [this] { ++wakes_; };
  ErrorInbox errors_;
  LatestJob job_{wake_, errors_};
};

TEST_F(LatestJobTest, RunsWorkAndWakesAtItsEnd) {
  std::atomic<bool> done = false;
  job_.start([&](JobSteps&) { done = true; });
  wait();
  EXPECT_TRUE(done);
  while (wakes_ == 0) std::this_thread::sleep_for(1ms);
  EXPECT_FALSE(job_.status().busy);
}

TEST_F(LatestJobTest, OnlyTheNewestOfWhatWaitsIsRun) {
  std::atomic<int> ran = 0;
  std::atomic<bool> begun = false;
  job_.start([&](JobSteps& steps) {
    begun = true;
    run_until_cancelled(steps);
  });
  while (!begun) std::this_thread::sleep_for(1ms);
  for (int k = 1; k <= 100; ++k) job_.start([&ran, k](JobSteps& steps) { ran = steps.cancelled() ? -1 : k; });
  wait();
  EXPECT_EQ(ran, 100);
}

TEST_F(LatestJobTest, CancelEndsWhatRunsAndForgetsWhatWaits) {
  std::atomic<bool> begun = false;
  std::atomic<bool> second = false;
  job_.start([&](JobSteps& steps) {
    steps.spare_until(JobSteps::Clock::now() + 1h);
    begun = true;
    run_until_cancelled(steps);
  });
  while (!begun) std::this_thread::sleep_for(1ms);
  job_.start([&](JobSteps&) { second = true; });
  job_.cancel();
  wait();
  EXPECT_FALSE(second);
}

TEST_F(LatestJobTest, AnExceptionIsAnErrorAndTheNextJobRuns) {
  job_.start([](JobSteps& steps) {
    steps.begin("Binning");
    throw std::bad_alloc();
  });
  wait();
  job_.start([](JobSteps& steps) {
    steps.begin("Exact");
    throw std::runtime_error("of all things");
  });
  wait();
  const std::vector<Error> errors = errors_.take();
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].message(), "Binning: needs more memory than there is");
  EXPECT_EQ(errors[1].message(), "Exact: failed: of all things");
  EXPECT_TRUE(errors_.take().empty());
}

TEST(JobSteps, ASupersededRunIsSparedForItsTime) {
  JobSteps steps;
  const JobControl& control = steps.begin("first");
  steps.spare_until(JobSteps::Clock::now() + 1h);
  steps.supersede();
  steps.poll();
  EXPECT_FALSE(control.cancelled());
  EXPECT_TRUE(steps.superseded());
  steps.end_sparing();
  EXPECT_TRUE(control.cancelled());
  EXPECT_TRUE(steps.cancelled());
}

TEST(JobSteps, PollEndsASupersededRunWhoseTimeIsOver) {
  JobSteps steps;
  steps.spare_until(JobSteps::Clock::now() - 1ms);
  steps.poll();
  EXPECT_FALSE(steps.cancelled());
  steps.supersede();
  EXPECT_TRUE(steps.cancelled());
}

TEST(JobSteps, APersonCancelsASparedRunToo) {
  JobSteps steps;
  steps.spare_until(JobSteps::Clock::now() + 1h);
  steps.cancel();
  EXPECT_TRUE(steps.cancelled());
  EXPECT_TRUE(steps.begin("next").cancelled());
}

TEST(JobSteps, SayWhatIsDoneAndHowFarItIs) {
  JobSteps steps;
  JobControl& control = steps.begin("Binning", PndfMethod::binning);
  control.expect_steps(4);
  control.finish_step();
  const JobStatus status = steps.status();
  EXPECT_TRUE(status.busy);
  EXPECT_EQ(status.text, "Binning");
  EXPECT_EQ(status.progress, 0.25);
  EXPECT_EQ(status.method, PndfMethod::binning);
  steps.begin("next");
  EXPECT_EQ(steps.status().progress, 0);
  EXPECT_FALSE(steps.status().method);
}

}  // namespace
}  // namespace glint::gui
