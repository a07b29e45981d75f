#include "gui/commandline/interrupt.h"

#include <csignal>
#include <sys/time.h>
#include <unistd.h>

namespace glint::gui {
namespace {

JobControl* interrupted_job = nullptr;  // a signal handler has nowhere else to look

void end_at_once(int /*signal*/) {
  _exit(k_interrupted_status);
}

void cancel_job(int /*signal*/) {
  if (interrupted_job->cancelled()) _exit(k_interrupted_status);  // asked twice
  interrupted_job->cancel();
  const itimerval soon{{0, 0}, {0, 100'000}};
  setitimer(ITIMER_REAL, &soon, nullptr);
}

}  // namespace

void cancel_on_interrupt(JobControl& control) {
  interrupted_job = &control;
  std::signal(SIGALRM, end_at_once);
  if (std::signal(SIGINT, cancel_job) == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // a caller's wish, as of nohup
}

}  // namespace glint::gui
