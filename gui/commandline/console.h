#pragma once
// What a command says: messages and progress on standard error, results on standard output. Nothing here throws: a full
// disk behind standard output is found out by results_written(), one behind standard error is nobody's business.

#include <atomic>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/image/normal_map_reader.h"
#include "core/math/parallel.h"
#include "core/math/result.h"

namespace glint::gui {

inline constexpr int k_failed_status = 1;   ///< the work failed
inline constexpr int k_request_status = 2;  ///< the words are off

/// Results, on standard output.
void write_result(std::string_view text);
template <class... Arguments>
void print_result(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_result(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Flushes standard output; false if anything of the results was lost.
bool results_written();

/// One line on standard error: "glintscope: <subject>: <sentence>".
void print_error(const Error& error);
int exit_status(const Error& error);

/// A message that is no error; nothing when quiet.
void print_message(bool quiet, const std::string& line);
/// The notes of a file's reader.
void print_report(bool quiet, const std::string& file, const ReadReport& report);

/// While alive, draws the progress of a job on standard error: a bar on a terminal, nothing in a pipe or when quiet.
class ProgressBar {
 public:
  ProgressBar(const JobControl& control, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

 private:
  std::atomic<bool> done_{false};
  std::thread thread_;
};

}  // namespace glint::gui
