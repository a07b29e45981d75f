#pragma once
// Runs the glintscope executable as a person would and gives back what it said.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace glint::test {

struct ProgramRun {
  int status = -1;  ///< exit status, or 128 + the signal that ended it
  std::string out;
  std::string err;
  double seconds = 0;
};

struct RunOptions {
  std::string input;                     ///< standard input
  std::vector<std::string> environment;  ///< NAME=VALUE, added to this process's own
  double interrupt_after = 0;            ///< seconds until SIGINT is sent; 0: never
};

ProgramRun run_glintscope(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace glint::test
