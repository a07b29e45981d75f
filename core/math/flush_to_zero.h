#pragma once

namespace glint {

/// While alive, this thread's floating-point units take and give 0 for denormal numbers, which are many times slower
/// and too small to count in single precision. Only on x86; elsewhere nothing happens.
class FlushToZero {
 public:
  FlushToZero();
  ~FlushToZero();
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_ = 0;
};

}  // namespace glint
