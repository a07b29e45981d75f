#pragma once
// Errors of background jobs, until the frame loop takes them.

#include <mutex>
#include <utility>
#include <vector>

#include "core/math/result.h"

namespace glint::gui {

/// Members may be called from any thread.
class ErrorInbox {
 public:
  void post(Error error) {
    const std::lock_guard lock(mutex_);
    errors_.push_back(std::move(error));
  }
  /// Each error once, oldest first.
  std::vector<Error> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(errors_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Error> errors_;
};

}  // namespace glint::gui
