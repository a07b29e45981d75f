#include "gui/command_line.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "gui/command.h"
#include "gui/console.h"

namespace glint::gui {
namespace {

// CLI11's own messages and exit codes, as ours: one line, status 2.
int report_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);  // --help, --version
  print_error(request_error("", error.what()));
  return k_request_status;
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, JobControl& control) {
  CLI::App app("See, understand and author the P-NDF of glinty surfaces.", "glintscope");
  app.set_version_flag("--version", "glintscope " GLINTSCOPE_VERSION);
  app.require_subcommand(0, 1);
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(add_pndf_command(app));
  commands.push_back(add_study_command(app));
  commands.push_back(add_generate_command(app));
  commands.push_back(add_presets_command(app));

  try {
    std::vector<std::string> words(arguments.rbegin(), arguments.rend() - 1);  // CLI11 takes them from the back
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error);
  }
  for (const std::unique_ptr<Command>& command : commands) {
    if (command->chosen()) return command->run(control);
  }
  fmt::print("{}", app.help());
  return 0;
}

}  // namespace glint::gui
