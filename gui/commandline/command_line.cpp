#include "gui/commandline/command_line.h"

#include <algorithm>
#include <memory>
#include <new>
#include <sstream>

#include <CLI/CLI.hpp>

#include "gui/commandline/command.h"
#include "gui/commandline/console.h"

namespace glint::gui {
namespace {

// CLI11's own messages and exit codes, as ours: one line, status 2.
int report_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {  // --help, --version
    std::ostringstream text;
    app.exit(error, text, text);
    write_result(text.str());
    return 0;
  }
  const std::vector<std::string> rest = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty()) {
    print_error(request_error(rest.front(), "is no option or command here; --help lists them"));
  } else if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    print_error(request_error("", "a flag takes no value, and an option is given once"));
  } else {
    print_error(request_error("", error.what()));
  }
  return k_request_status;
}

int parse_and_run(const std::vector<std::string>& arguments, JobControl& control) {
  CLI::App app("See, understand and author the P-NDF of glinty surfaces.", "glintscope");
  app.set_version_flag("--version", "glintscope " GLINTSCOPE_VERSION);
  app.require_subcommand(0, 1);
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(add_pndf_command(app));
  commands.push_back(add_study_command(app));
  commands.push_back(add_generate_command(app));
  commands.push_back(add_presets_command(app));
  commands.push_back(add_screenshot_command(app));
  commands.push_back(add_window_command(app));  // last: it is what is left

  try {
    std::vector<std::string> words(arguments.rbegin(), arguments.rend() - 1);  // CLI11 takes them from the back
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error);
  }
  const auto chosen = std::find_if(commands.begin(), commands.end(), [](const auto& c) { return c->chosen(); });
  const Status done = (*chosen)->run(control);
  if (done) return 0;
  if (!control.cancelled()) print_error(done.error());
  return exit_status(done.error());
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, JobControl& control) {
  int status = k_failed_status;
  try {
    status = parse_and_run(arguments, control);
  } catch (const std::bad_alloc&) {
    print_error(content_error("", "there is not enough memory for what was asked"));
  }
  if (!results_written() && status == 0) {
    print_error(content_error("standard output", "cannot be written"));
    return k_failed_status;
  }
  return status;
}

}  // namespace glint::gui
