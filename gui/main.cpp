#include <string>
#include <vector>

#include "gui/command_line.h"
#include "gui/interrupt.h"

int main(int argc, char** argv) {
  glint::JobControl control;
  glint::gui::cancel_on_interrupt(control);
  const int status = glint::gui::run_command_line(std::vector<std::string>(argv, argv + argc), control);
  return control.cancelled() ? glint::gui::k_interrupted_status : status;
}
