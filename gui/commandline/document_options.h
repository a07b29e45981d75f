#pragma once
// Options that set fields of the document. What an option allows, its default and its help all come from the field's
// one declaration (core/document/parameter.h).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/document/document.h"
#include "core/document/parameter.h"
#include "core/document/workspace.h"
#include "core/math/parallel.h"

namespace glint::gui {

/// The words of one option that stands for one field.
struct FieldOption {
  std::string flag;  ///< "--sigma-r"
  const Parameter* parameter;
  CLI::Option* option;
  std::string words;

  [[nodiscard]] bool given() const { return option->count() > 0; }
};

/// The words of an option that stands for no single field.
struct WordsOption {
  CLI::Option* option = nullptr;
  std::string words;

  /// Also when the words are empty: `-o ""` is a mistake, not a wish for the default.
  [[nodiscard]] bool given() const { return option->count() > 0; }
};

/// Adds it under `flag`, shown with `placeholder`. The option keeps a pointer to `words`.
void add_words_option(CLI::App& app, WordsOption& words, const std::string& flag, const std::string& placeholder,
                      const std::string& help);

/// A field's value from the words of its option; the error's subject is the flag.
Result<ParameterValue> parse_value(const Parameter& parameter, const std::string& flag, const std::string& words);

/// An option for the field at `path`; its help is the declaration's. The option holds a pointer to the result's words.
std::unique_ptr<FieldOption> add_field_option(CLI::App& app, const std::string& flag, const char* path);

/// Applies the words to the document, if the option was given.
Status apply(const FieldOption& option, Document& document);

/// --map or --preset, how the file is read, the footprint, sigma_r, the surface, methods and grid: shared by
/// subcommands.
class DocumentOptions {
 public:
  explicit DocumentOptions(CLI::App& app);

  /// The document that the options ask for, free of faults except for what only the map can tell.
  [[nodiscard]] Result<Document> document() const;
  /// True if neither options nor a preset say where the footprint is: it then goes to the middle of the map.
  [[nodiscard]] bool footprint_open() const;
  /// The files that are read: an output may be none of them.
  [[nodiscard]] std::vector<std::filesystem::path> inputs(const Document& document) const;

  [[nodiscard]] bool quiet() const { return quiet_; }
  [[nodiscard]] bool json() const { return json_; }
  /// An error of a field, under the name of the option that sets it.
  [[nodiscard]] Error with_flag(Error error) const;
  /// --threads, checked; nothing if it was not given.
  [[nodiscard]] Result<std::optional<int>> threads() const;
  /// Makes the kernels use what --isa says.
  [[nodiscard]] Status apply_instruction_set() const;
  /// Whether the option of a field was given.
  [[nodiscard]] bool gives(std::string_view flag) const;

 private:
  Status apply_source(Document& document) const;
  Status apply_footprint(Document& document) const;
  Status apply_triangles(Document& document) const;
  void say_what_has_no_effect(const Document& document) const;

  WordsOption map_;
  WordsOption preset_;
  WordsOption pixel_;
  WordsOption radius_;
  WordsOption footprint_;
  WordsOption triangles_;
  WordsOption threads_;
  WordsOption isa_;
  bool quiet_ = false;
  bool json_ = false;
  std::vector<std::unique_ptr<FieldOption>> fields_;
};

/// The surface of the document, its reader's notes printed; places an open footprint and checks its position.
Result<LoadedSurface> prepare_surface(const DocumentOptions& options, Document& document, JobControl& control);

/// What is to be said of the document's mixture, if it has one: said, but for what the file's reader already did, and
/// returned.
std::vector<std::string> say_findings(const DocumentOptions& options, const Document& document,
                                      const LoadedSurface& loaded);

/// Fails for an output that is one of the inputs, has none of the extensions or cannot be written.
Status check_output(const std::string& output, const std::vector<std::filesystem::path>& inputs,
                    const std::vector<std::string>& extensions);

/// The name of the document's map in reports: its file, or its generator.
std::string map_name(const Document& document);

/// This executable, for finding the presets that were installed with it.
std::filesystem::path executable_path();

}  // namespace glint::gui
