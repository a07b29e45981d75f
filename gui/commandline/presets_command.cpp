// glintscope presets: list | show NAME | check FILE.

#include <fmt/format.h>

#include "core/document/preset.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"

namespace glint::gui {
namespace {

class PresetsCommand final : public Command {
 public:
  explicit PresetsCommand(CLI::App& app)
      : app_(*app.add_subcommand("presets", "The presets that are known: list | show NAME | check FILE.")),
        list_(*app_.add_subcommand("list", "The names and files of all presets.")),
        show_(*app_.add_subcommand("show", "Print a preset with every field that matters to it.")),
        check_(*app_.add_subcommand("check", "Say whether a preset file is right, and where it is not.")) {
    app_.require_subcommand(1);
    show_.add_option("NAME", name_, "A preset by name or file.")->required();
    check_.add_option("FILE", file_, "A preset file.")->required();
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  Status run(JobControl& /*control*/) override { return list_.parsed() ? list() : show_.parsed() ? show() : check(); }

 private:
  static Status list() {
    for (const PresetEntry& entry : list_presets(preset_folders(executable_path()))) {
      print_result("{:<24} {}\n", entry.name, entry.file.lexically_normal().string());
    }
    return success();
  }

  [[nodiscard]] Status show() const {
    const Result<std::filesystem::path> file = find_preset(name_, preset_folders(executable_path()));
    if (!file) return file.error();
    const Result<Document> document = load_preset(*file);
    if (!document) return document.error();
    print_result("{}", preset_text(*document));
    return success();
  }

  [[nodiscard]] Status check() const {
    const Result<Document> document = load_preset(file_);
    if (!document) return document.error();
    print_result("{}: ok\n", file_);
    return success();
  }

  CLI::App& app_;
  CLI::App& list_;
  CLI::App& show_;
  CLI::App& check_;
  std::string name_;
  std::string file_;
};

}  // namespace

std::unique_ptr<Command> add_presets_command(CLI::App& app) {
  return std::make_unique<PresetsCommand>(app);
}

}  // namespace glint::gui
