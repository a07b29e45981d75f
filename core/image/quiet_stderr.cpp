#include "core/image/quiet_stderr.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace glint {
namespace {

std::mutex& descriptor_lock() {
  static std::mutex lock;
  return lock;
}

}  // namespace

QuietStderr::QuietStderr() : lock_(descriptor_lock()) {
  std::fflush(stderr);
  const int null_device = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null_device < 0) return;
  saved_descriptor_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  if (saved_descriptor_ >= 0) ::dup2(null_device, STDERR_FILENO);
  ::close(null_device);
}

QuietStderr::~QuietStderr() {
  if (saved_descriptor_ < 0) return;
  std::fflush(stderr);
  ::dup2(saved_descriptor_, STDERR_FILENO);
  ::close(saved_descriptor_);
}

}  // namespace glint
