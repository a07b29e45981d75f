#pragma once
// A subcommand: adds its options to the parser and, if it was chosen, runs.

#include <memory>

#include <CLI/CLI.hpp>

#include "core/math/parallel.h"
#include "core/math/result.h"

namespace glint::gui {

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// True if the words named this command.
  [[nodiscard]] virtual bool chosen() const = 0;
  /// Does the work; its error, if any, is printed by the caller.
  virtual Status run(JobControl& control) = 0;
};

std::unique_ptr<Command> add_pndf_command(CLI::App& app);
std::unique_ptr<Command> add_study_command(CLI::App& app);
std::unique_ptr<Command> add_generate_command(CLI::App& app);
std::unique_ptr<Command> add_presets_command(CLI::App& app);
std::unique_ptr<Command> add_screenshot_command(CLI::App& app);
/// What runs when no subcommand is named.
std::unique_ptr<Command> add_window_command(CLI::App& app);

}  // namespace glint::gui
