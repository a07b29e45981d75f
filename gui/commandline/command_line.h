#pragma once
// The command line: `glintscope SUBCOMMAND …`, parsed with CLI11. Exit status 0 done, 1 the work failed, 2 the words
// are off, 130 interrupted.

#include <string>
#include <vector>

#include "core/math/parallel.h"

namespace glint::gui {

int run_command_line(const std::vector<std::string>& arguments, JobControl& control);

}  // namespace glint::gui
