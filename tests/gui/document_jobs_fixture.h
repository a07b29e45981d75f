#pragma once
// Jobs with a small document and the frame loop around them.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "gui/jobs/document_jobs.h"

namespace glint::gui::test {

/// A job that only ends by being cancelled.
inline constexpr std::uint64_t k_endless_samples = 10'000'000'000;

inline Document small_document() {
  Document document;
  document.surface.source = SurfaceSource::noise;
  document.surface.noise.size = document.surface.scratches.size = document.surface.flakes.size = 64;
  document.surface.noise.spectrum = NoiseSettings::Spectrum::gaussian;
  document.surface.interpolation = Interpolation::linear;  // whose reference is quick
  document.footprint = isotropic_footprint({32, 32}, 2);
  document.intrinsic_roughness = 0.03;
  document.methods = {PndfMethod::exact, PndfMethod::binning};
  document.binning_samples = 20'000;
  document.grid.size = 32;
  return document;
}

class DocumentJobsTest : public testing::Test {
 protected:
  static constexpr std::chrono::seconds k_patience{600};  // jobs give way to all else on a busy machine

  void frame() {
    jobs_.update(document_, revision_);
    const std::shared_ptr<const view::PndfResults> results = jobs_.results();
    if (results && (seen_.empty() || seen_.back() != results)) seen_.push_back(results);
    for (Error& error : jobs_.take_errors()) errors_.push_back(std::move(error));
  }

  /// Frames until `done`; false if that takes too long.
  bool frames_until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + k_patience;
    while (std::chrono::steady_clock::now() < end) {
      frame();
      if (done()) return true;
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, std::chrono::milliseconds(5), [this] { return wakes_ > 0; });
      wakes_ = 0;
      if (frame_by_frame_) {
        lock.unlock();
        frame();
        lock.lock();
        held_ = false;
        woken_.notify_all();
      }
    }
    return false;
  }

  bool settle() {
    return frames_until([this] { return jobs_.idle(); });
  }

  bool show(const Document& document) {
    document_ = document;
    ++revision_;
    return settle();
  }

  /// From now on a background thread waits at every step until a frame has seen it.
  void see_every_step() {
    const std::lock_guard lock(mutex_);
    frame_by_frame_ = true;
  }

  void wake() {
    std::unique_lock lock(mutex_);
    ++wakes_;
    woken_.notify_all();
    if (!frame_by_frame_) return;
    held_ = true;
    woken_.wait_for(lock, k_patience, [this] { return !held_ || !frame_by_frame_; });
  }

  void TearDown() override {
    const std::lock_guard lock(mutex_);
    frame_by_frame_ = false;
    woken_.notify_all();
  }

  [[nodiscard]] const view::MethodPicture& picture(std::size_t index) const { return jobs_.results()->methods[index]; }
  [[nodiscard]] const Surface& surface() const { return jobs_.surface()->loaded.surface; }

  std::mutex mutex_;
  std::condition_variable woken_;
  int wakes_ = 0;
  bool held_ = false;
  bool frame_by_frame_ = false;

  Document document_ = small_document();
  std::uint64_t revision_ = 0;
  std::vector<std::shared_ptr<const view::PndfResults>> seen_;
  std::vector<Error> errors_;
  DocumentJobs jobs_{[this] { wake(); }};
};

}  // namespace glint::gui::test
