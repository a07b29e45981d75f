#include "gui/commandline/document_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/document/value_words.h"
#include "core/image/atomic_file.h"
#include "core/math/instruction_set.h"
#include "gui/commandline/console.h"

namespace glint::gui {
namespace {

std::vector<std::string> split(const std::string& words) {
  std::vector<std::string> parts(1);
  for (const char c : words) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

// The whole text as a number, whatever the locale.
template <class Number>
std::optional<Number> number_from(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end || text.empty()) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> numbers_from(const std::string& words) {
  std::vector<double> values;
  for (const std::string& part : split(words)) {
    const std::optional<double> value = number_from<double>(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

// A value as it is typed: 8,32 and not [8, 32].
std::string typed(const ParameterValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return "not set";
  std::string text;
  for (const char c : value_text(value)) {
    if (c != '[' && c != ']' && c != '"' && c != ' ') text += c;
  }
  return text;
}

// What stands for the value in the help: N, X, A|B, SMIN,SMAX,TMIN,TMAX.
std::string placeholder(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::integer:
      return "N";
    case ParameterKind::choice:
      return fmt::format("{}", fmt::join(parameter.choices, "|"));
    case ParameterKind::choices:
      return fmt::format("LIST of {}", fmt::join(parameter.choices, ","));
    case ParameterKind::numbers: {
      std::string names = fmt::format("{}", fmt::join(parameter.components, ","));
      std::transform(names.begin(), names.end(), names.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
      return names;
    }
    default:
      return "X";
  }
}

std::string option_help(const Parameter& parameter) {
  std::string help(parameter.help);
  if (!parameter.unit.empty()) help += fmt::format(" [{}]", parameter.unit);
  if (parameter.kind == ParameterKind::flag) return help;
  const bool listed = parameter.kind == ParameterKind::choice || parameter.kind == ParameterKind::choices;
  if (!listed) help += fmt::format(" Allowed: {}.", parameter.allowed());
  return help + fmt::format(" Default: {}.", typed(parameter.default_value()));
}

Error wrong_words(const std::string& flag, const std::string& words, std::string_view allowed) {
  return request_error(flag, fmt::format("'{}' is not {}", words, allowed));
}

}  // namespace

Result<ParameterValue> parse_value(const Parameter& parameter, const std::string& flag, const std::string& words) {
  Result<ParameterValue> value = value_from_words(parameter, words);
  if (!value) return request_error(flag, value.error().sentence);
  return value;
}

std::unique_ptr<FieldOption> add_field_option(CLI::App& app, const std::string& flag, const char* path) {
  auto field = std::make_unique<FieldOption>();
  field->flag = flag;
  field->parameter = find_parameter(path);
  const std::string help = option_help(*field->parameter);
  if (field->parameter->kind == ParameterKind::flag) {
    field->option = app.add_flag(flag, field->words, help);  // alone it says true
  } else {
    field->option = app.add_option(flag, field->words, help)->option_text(placeholder(*field->parameter));
  }
  return field;
}

void add_words_option(CLI::App& app, WordsOption& words, const std::string& flag, const std::string& placeholder,
                      const std::string& help) {
  words.option = app.add_option(flag, words.words, help)->option_text(placeholder);
}

Status apply(const FieldOption& option, Document& document) {
  if (!option.given()) return success();
  const Result<ParameterValue> value = parse_value(*option.parameter, option.flag, option.words);
  if (!value) return value.error();
  return option.parameter->set(document, *value);
}

DocumentOptions::DocumentOptions(CLI::App& app) {
  add_words_option(app, map_, "--map", "FILE", "A normal map, or a height field with --height.");
  add_words_option(app, preset_, "--preset", "NAME|FILE",
                   "A preset by name or file, or an EXR with a recipe; other options override it.");
  preset_.option->excludes(map_.option);
  struct Binding {
    const char* flag;
    const char* path;
  };
  static constexpr std::array k_bindings = {Binding{"--range", "surface.range"},
                                            Binding{"--green", "surface.green"},
                                            Binding{"--height", "surface.height_scale"},
                                            Binding{"--wrap", "surface.wrap"},
                                            Binding{"--sigma-r", "intrinsic_roughness"},
                                            Binding{"--method", "methods"},
                                            Binding{"--surface", "surface.interpolation"},
                                            Binding{"--vertex-shift", "exact.vertex_shift"},
                                            Binding{"--precision", "exact.precision"},
                                            Binding{"--step", "mixture.step"},
                                            Binding{"--kappa", "mixture.kappa"},
                                            Binding{"--elements", "mixture.elements"},
                                            Binding{"--tolerance", "auto.tolerance"},
                                            Binding{"--samples", "binning.samples"},
                                            Binding{"--size", "grid.size"},
                                            Binding{"--window", "grid.window"},
                                            Binding{"--seed", "seed"}};
  for (const Binding& binding : k_bindings) fields_.push_back(add_field_option(app, binding.flag, binding.path));
  add_words_option(app, triangles_, "--triangles", "2|32", "Short for the surface: 2 is linear, 32 is smooth.");
  add_words_option(app, footprint_, "--footprint", "X,Y,SXX,SXY,SYY",
                   "Any footprint: centre in texels, covariance in texels squared.");
  add_words_option(app, pixel_, "--pixel", "X,Y",
                   "An isotropic footprint's centre in texels; texel (i, j) is at i + 0.5, j + 0.5.");
  pixel_.option->excludes(footprint_.option);
  add_words_option(app, radius_, "--radius", "R", "The deviation of the --pixel footprint in texels. Default: 5.");
  radius_.option->needs(pixel_.option);
  add_words_option(app, threads_, "--threads", "N", "Threads to use. Default: all.");
  add_words_option(app, isa_, "--isa", "auto|avx512|avx2|sse4|scalar",
                   "The vector instructions to use. Default: auto, the widest that the processor has.");
  app.add_flag("--quiet", quiet_, "No messages and no progress; errors are still printed.");
  app.add_flag("--json", json_, "Print the results as one JSON object.");
}

Status DocumentOptions::apply_source(Document& document) const {
  if (preset_.given()) {
    Result<std::filesystem::path> file = find_preset(preset_.words, preset_folders(executable_path()));
    if (!file) return request_error("--preset", file.error().message());
    Result<Document> loaded = load_document(*file);
    if (!loaded) return loaded.error();
    document = std::move(*loaded);
  } else if (map_.given()) {
    document.surface.source = SurfaceSource::file;
    document.surface.path = map_.words;
  } else {
    return request_error("", "nothing to look at: give --map FILE or --preset NAME");
  }
  return success();
}

Status DocumentOptions::apply_footprint(Document& document) const {
  if (footprint_.given()) {
    const auto numbers = numbers_from(footprint_.words);
    if (!numbers || numbers->size() != 5)
      return wrong_words("--footprint", footprint_.words, "five numbers X,Y,SXX,SXY,SYY");
    const std::vector<double>& n = *numbers;
    document.footprint = {{n[0], n[1]}, {n[2], n[3], n[4]}};
  } else if (pixel_.given()) {
    const auto numbers = numbers_from(pixel_.words);
    if (!numbers || numbers->size() != 2) return wrong_words("--pixel", pixel_.words, "two numbers X,Y");
    const auto radius = !radius_.given() ? std::optional(5.0) : number_from<double>(radius_.words);
    if (!radius || !(*radius > 0 && *radius <= 1e5)) {
      return wrong_words("--radius", radius_.words, "a number of texels above 0 and at most 100000");
    }
    document.footprint = isotropic_footprint({(*numbers)[0], (*numbers)[1]}, *radius);
  } else {
    return success();
  }
  const std::optional<std::string> fault = footprint_fault(document.footprint);
  if (fault) return request_error(!footprint_.given() ? "--pixel" : "--footprint", *fault);
  return success();
}

Status DocumentOptions::apply_triangles(Document& document) const {
  if (!triangles_.given()) return success();
  if (triangles_.words != "2" && triangles_.words != "32")
    return wrong_words("--triangles", triangles_.words, "2 or 32");
  const Interpolation wanted = triangles_.words == "2" ? Interpolation::linear : Interpolation::smooth;
  std::optional<Interpolation>& asked = document.surface.interpolation;
  const auto surface =
      std::find_if(fields_.begin(), fields_.end(), [](const auto& f) { return f->flag == "--surface"; });
  // A preset's surface may be overridden; two options that disagree may not.
  if ((*surface)->given() && asked && *asked != wanted) {
    return request_error("--triangles", fmt::format("{} means the {} surface and cannot stand beside --surface {}",
                                                    triangles_.words, choice_name(wanted), choice_name(*asked)));
  }
  asked = wanted;
  return success();
}

Result<Document> DocumentOptions::document() const {
  Document document;
  if (const Status done = apply_source(document); !done) return done.error();
  for (const std::unique_ptr<FieldOption>& field : fields_) {
    if (const Status done = apply(*field, document); !done) return done.error();
  }
  if (const Status done = apply_footprint(document); !done) return done.error();
  if (const Status done = apply_triangles(document); !done) return done.error();
  if (const std::optional<Error> fault = document_fault(document)) return with_flag(*fault);
  say_what_has_no_effect(document);
  return document;
}

Error DocumentOptions::with_flag(Error error) const {
  if (error.subject == "surface.path") error.subject = "--map";
  if (error.subject.starts_with("footprint.")) error.subject = pixel_.given() ? "--pixel" : "--footprint";
  for (const std::unique_ptr<FieldOption>& field : fields_) {
    if (field->parameter->path == error.subject) error.subject = field->flag;
  }
  return error;
}

void DocumentOptions::say_what_has_no_effect(const Document& document) const {
  for (const std::unique_ptr<FieldOption>& field : fields_) {
    if (!field->given() || field->parameter->matters(document)) continue;
    print_message(quiet_, field->flag + " has no effect here");
  }
}

bool DocumentOptions::footprint_open() const {
  return !preset_.given() && !footprint_.given() && !pixel_.given();
}

std::vector<std::filesystem::path> DocumentOptions::inputs(const Document& document) const {
  std::vector<std::filesystem::path> files;
  if (document.surface.source == SurfaceSource::file) files.push_back(document.surface.path);
  if (preset_.given()) {
    const auto file = find_preset(preset_.words, preset_folders(executable_path()));
    if (file) files.push_back(*file);
  }
  return files;
}

Result<std::optional<int>> DocumentOptions::threads() const {
  if (!threads_.given()) return std::optional<int>();
  const std::optional<int> count = number_from<int>(threads_.words);
  if (!count || *count < 1 || *count > 1024)
    return wrong_words("--threads", threads_.words, "a whole number from 1 to 1024");
  return count;
}

Status DocumentOptions::apply_instruction_set() const {
  if (!isa_.given() || isa_.words == "auto") return success();
  std::string supported = "auto";
  for (const InstructionSet set : supported_instruction_sets()) {
    if (instruction_set_name(set) == isa_.words) {
      force_instruction_set(set);
      return success();
    }
    supported += fmt::format(", {}", instruction_set_name(set));
  }
  return wrong_words("--isa", isa_.words, "something this processor has: " + supported);
}

bool DocumentOptions::gives(std::string_view flag) const {
  return std::any_of(fields_.begin(), fields_.end(),
                     [&](const auto& field) { return field->flag == flag && field->given(); });
}

Result<LoadedSurface> prepare_surface(const DocumentOptions& options, Document& document, JobControl& control) {
  Result<LoadedSurface> loaded = content_error("", "");
  {
    const ProgressBar bar(control, options.quiet());
    loaded = load_surface(document.surface, control);
  }
  if (!loaded) return options.with_flag(loaded.error());
  const NormalMap& map = loaded->surface.map();
  if (loaded->report) {
    print_report(options.quiet(), document.surface.path.string(), *loaded->report);
    if (const auto note = quantisation_note(*loaded->report, document.intrinsic_roughness)) {
      print_message(options.quiet(), document.surface.path.string() + ": warning: " + *note);
    }
  }
  if (options.footprint_open()) document.footprint.center = {0.5 * map.width(), 0.5 * map.height()};
  if (const auto fault = footprint_position_fault(document.footprint, map)) return options.with_flag(*fault);
  return loaded;
}

std::vector<std::string> say_findings(const DocumentOptions& options, const Document& document,
                                      const LoadedSurface& loaded) {
  std::vector<std::string> sentences;
  for (const PndfMethod method : document.methods) {
    const std::vector<MixtureFinding> findings = document_findings(document, method, loaded.surface);
    for (const std::string& said : unreported_sentences(findings, loaded.report, document.intrinsic_roughness)) {
      print_message(options.quiet(), fmt::format("{}: {}", choice_name(method), said));
    }
    for (const MixtureFinding& finding : findings) sentences.push_back(finding.sentence);
  }
  return sentences;
}

Status check_output(const std::string& output, const std::vector<std::filesystem::path>& inputs,
                    const std::vector<std::string>& extensions) {
  const std::filesystem::path path(output);
  if (std::find(extensions.begin(), extensions.end(), path.extension().string()) == extensions.end()) {
    return request_error(output, fmt::format("the output must end in {}", fmt::join(extensions, " or ")));
  }
  for (const std::filesystem::path& input : inputs) {
    std::error_code missing;
    if (std::filesystem::equivalent(path, input, missing)) return request_error(output, "the output is the input");
  }
  const Result<AtomicFile> trial = AtomicFile::create(path);
  if (!trial) return request_error(trial.error().subject, trial.error().sentence);
  return success();
}

std::string map_name(const Document& document) {
  if (document.surface.source == SurfaceSource::file) return document.surface.path.string();
  return std::string(choice_name(document.surface.source));
}

std::filesystem::path executable_path() {
  std::error_code unreadable;
  return std::filesystem::read_symlink("/proc/self/exe", unreadable);
}

}  // namespace glint::gui
