#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <vector>

#include "gui/commandline/command_line.h"
#include "gui/commandline/interrupt.h"

namespace {

// A file must never be given the number of a standard stream that the caller closed.
void open_standard_streams() {
  for (int opened = ::open("/dev/null", O_RDWR); opened >= 0; opened = ::open("/dev/null", O_RDWR)) {
    if (opened > STDERR_FILENO) {
      ::close(opened);
      return;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  glint::JobControl control;
  glint::gui::cancel_on_interrupt(control);
  const int status = glint::gui::run_command_line(std::vector<std::string>(argv, argv + argc), control);
  return control.cancelled() ? glint::gui::k_interrupted_status : status;
}
