#include "gui/console.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace glint::gui {
namespace {

constexpr int k_bar_width = 40;

void draw_bar(double progress) {
  const int filled = static_cast<int>(progress * k_bar_width);
  fmt::print(stderr, "\r[{:<{}}] {:3.0f} %", std::string(static_cast<std::size_t>(filled), '='), k_bar_width,
             100 * progress);
  std::fflush(stderr);
}

// File names may hold line breaks; a message must not.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

void print_error(const Error& error) {
  fmt::print(stderr, "glintscope: {}\n", one_line(error.message()));
}

int exit_status(const Error& error) {
  return error.kind == ErrorKind::request ? k_request_status : k_failed_status;
}

void print_message(bool quiet, const std::string& line) {
  if (!quiet) fmt::print(stderr, "glintscope: {}\n", one_line(line));
}

void print_report(bool quiet, const std::string& file, const ReadReport& report) {
  for (const ReadReport::Note& note : report.notes) {
    const bool warning = note.severity == ReadReport::Severity::warning;
    print_message(quiet, fmt::format("{}: {}{}", file, warning ? "warning: " : "", note.sentence));
  }
}

ProgressBar::ProgressBar(const JobControl& control, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return;
  thread_ = std::thread([this, &control] {
    // Nothing is drawn for work that is over in a moment.
    for (int tick = 0; !done_; ++tick) {
      if (tick > 4) draw_bar(control.progress());
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
    }
    fmt::print(stderr, "\r{:{}}\r", "", k_bar_width + 8);
    std::fflush(stderr);
  });
}

ProgressBar::~ProgressBar() {
  done_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace glint::gui
