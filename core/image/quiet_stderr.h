#pragma once
// libpng, libtiff and libjpeg print their complaints to standard error by themselves, whatever the program around them
// wants; the same complaints reach us through OpenImageIO. There is no switch for all of them, so the descriptor itself
// is turned away while a decoder runs.

#include <mutex>

namespace glint {

/// While alive, what anybody in this process writes to descriptor 2 is dropped. Holds a process-wide lock (descriptor 2
/// is process-wide too), so decoders run one at a time: keep it around the decoder's call only, and never nest it.
class QuietStderr {
 public:
  QuietStderr();
  ~QuietStderr();
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  int saved_descriptor_ = -1;  // -1: standard error is closed or could not be turned away; it then stays as it is
};

}  // namespace glint
