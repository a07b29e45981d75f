#include "gui/commandline/console.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace glint::gui {
namespace {

constexpr int k_bar_width = 40;

void write_error(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void draw_bar(double progress) {
  const int filled = static_cast<int>(progress * k_bar_width);
  write_error(fmt::format("\r[{:<{}}] {:3.0f} %", std::string(static_cast<std::size_t>(filled), '='), k_bar_width,
                          100 * progress));
}

// File names may hold line breaks and worse; a message must not.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

}  // namespace

void write_result(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

bool results_written() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

void print_error(const Error& error) {
  write_error(fmt::format("glintscope: {}\n", one_line(error.message())));
}

int exit_status(const Error& error) {
  return error.kind == ErrorKind::request ? k_request_status : k_failed_status;
}

void print_message(bool quiet, const std::string& line) {
  if (!quiet) write_error(fmt::format("glintscope: {}\n", one_line(line)));
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
    write_error(fmt::format("\r{:{}}\r", "", k_bar_width + 8));
  });
}

ProgressBar::~ProgressBar() {
  done_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace glint::gui
