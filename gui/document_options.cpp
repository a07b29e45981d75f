#include "gui/document_options.h"

#include <array>
#include <charconv>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/image/atomic_file.h"
#include "core/image/pndf_exr.h"
#include "gui/console.h"

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

std::string option_help(const Parameter& parameter) {
  std::string help(parameter.help);
  if (!parameter.unit.empty()) help += fmt::format(" [{}]", parameter.unit);
  return help + fmt::format(" Allowed: {}. Default: {}.", parameter.allowed(), value_text(parameter.default_value()));
}

Error wrong_words(const std::string& flag, const std::string& words, std::string_view allowed) {
  return request_error(flag, fmt::format("'{}' is not {}", words, allowed));
}

}  // namespace

Result<ParameterValue> parse_value(const Parameter& parameter, const std::string& flag, const std::string& words) {
  ParameterValue value = words;
  switch (parameter.kind) {
    case ParameterKind::number:
      if (const auto number = number_from<double>(words)) value = *number;
      break;
    case ParameterKind::integer:
      if (const auto number = number_from<std::uint64_t>(words)) {
        value = *number;
      } else if (const auto written = number_from<double>(words)) {  // 1e7
        value = *written;
      }
      break;
    case ParameterKind::numbers:
      if (words == parameter.instead) break;
      if (auto numbers = numbers_from(words)) value = std::move(*numbers);
      break;
    case ParameterKind::choices:
      value = split(words);
      break;
    case ParameterKind::text:
    case ParameterKind::path:
    case ParameterKind::choice:
      break;
  }
  Result<ParameterValue> checked = parameter.checked(value);
  if (!checked) return request_error(flag, checked.error().sentence);
  return checked;
}

std::unique_ptr<FieldOption> add_field_option(CLI::App& app, const std::string& flag, const char* path) {
  auto field = std::make_unique<FieldOption>();
  field->flag = flag;
  field->parameter = find_parameter(path);
  field->option = app.add_option(flag, field->words, option_help(*field->parameter))->option_text(" ");
  return field;
}

Status apply(const FieldOption& option, Document& document) {
  if (!option.given()) return success();
  const Result<ParameterValue> value = parse_value(*option.parameter, option.flag, option.words);
  if (!value) return value.error();
  return option.parameter->set(document, *value);
}

DocumentOptions::DocumentOptions(CLI::App& app) {
  app.add_option("--map", map_, "A normal map, or a height field with --height.")->option_text("FILE");
  app.add_option("--preset", preset_, "A preset by name or file, or an EXR with a recipe; other options override it.")
      ->option_text("NAME|FILE")
      ->excludes("--map");
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
                                            Binding{"--samples", "binning.samples"},
                                            Binding{"--size", "grid.size"},
                                            Binding{"--window", "grid.window"},
                                            Binding{"--seed", "seed"}};
  for (const Binding& binding : k_bindings) fields_.push_back(add_field_option(app, binding.flag, binding.path));
  app.add_option("--triangles", triangles_, "Short for the surface: 2 is linear, 32 is smooth.")->option_text("2|32");
  app.add_option("--footprint", footprint_, "Any footprint: centre in texels, covariance in texels squared.")
      ->option_text("X,Y,SXX,SXY,SYY");
  app.add_option("--pixel", pixel_, "An isotropic footprint's centre in texels; texel (i, j) is at i + 0.5, j + 0.5.")
      ->option_text("X,Y")
      ->excludes("--footprint");
  app.add_option("--radius", radius_, "The deviation of the --pixel footprint in texels. Default: 5.")
      ->option_text("R")
      ->needs("--pixel");
  app.add_option("--threads", threads_, "Threads to use. Default: all.")->option_text("N");
  app.add_flag("--quiet", quiet_, "No messages and no progress; errors are still printed.");
  app.add_flag("--json", json_, "Print the results as one JSON object.");
}

Status DocumentOptions::apply_source(Document& document) const {
  if (!preset_.empty()) {
    Result<std::filesystem::path> file = find_preset(preset_, preset_folders(executable_path()));
    if (!file) return request_error("--preset", file.error().message());
    if (file->extension() == ".exr") {
      const Result<std::string> recipe = read_recipe(*file);
      if (!recipe) return recipe.error();
      Result<Document> loaded = document_from_recipe(*recipe, file->string());
      if (!loaded) return loaded.error();
      document = std::move(*loaded);
    } else {
      Result<Document> loaded = load_preset(*file);
      if (!loaded) return loaded.error();
      document = std::move(*loaded);
    }
  } else if (!map_.empty()) {
    document.surface.source = SurfaceSource::file;
    document.surface.path = map_;
  } else {
    return request_error("", "nothing to look at: give --map FILE or --preset NAME");
  }
  return success();
}

Status DocumentOptions::apply_footprint(Document& document) const {
  if (!footprint_.empty()) {
    const auto numbers = numbers_from(footprint_);
    if (!numbers || numbers->size() != 5) return wrong_words("--footprint", footprint_, "five numbers X,Y,SXX,SXY,SYY");
    const std::vector<double>& n = *numbers;
    document.footprint = {{n[0], n[1]}, {n[2], n[3], n[4]}};
  } else if (!pixel_.empty()) {
    const auto numbers = numbers_from(pixel_);
    if (!numbers || numbers->size() != 2) return wrong_words("--pixel", pixel_, "two numbers X,Y");
    const auto radius = radius_.empty() ? std::optional(5.0) : number_from<double>(radius_);
    if (!radius || !(*radius > 0)) return wrong_words("--radius", radius_, "a number of texels above 0");
    document.footprint = isotropic_footprint({(*numbers)[0], (*numbers)[1]}, *radius);
  } else {
    return success();
  }
  const std::optional<std::string> fault = footprint_fault(document.footprint);
  if (fault) return request_error(footprint_.empty() ? "--pixel" : "--footprint", *fault);
  return success();
}

Status DocumentOptions::apply_triangles(Document& document) const {
  if (triangles_.empty()) return success();
  if (triangles_ != "2" && triangles_ != "32") return wrong_words("--triangles", triangles_, "2 or 32");
  const Interpolation wanted = triangles_ == "2" ? Interpolation::linear : Interpolation::smooth;
  std::optional<Interpolation>& asked = document.surface.interpolation;
  const auto surface =
      std::find_if(fields_.begin(), fields_.end(), [](const auto& f) { return f->flag == "--surface"; });
  // A preset's surface may be overridden; two options that disagree may not.
  if ((*surface)->given() && asked && *asked != wanted) {
    return request_error("--triangles", fmt::format("{} means the {} surface and cannot stand beside --surface {}",
                                                    triangles_, choice_name(wanted), choice_name(*asked)));
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
  if (std::optional<Error> fault = document_fault(document)) return std::move(*fault);
  return document;
}

bool DocumentOptions::footprint_open() const {
  return preset_.empty() && footprint_.empty() && pixel_.empty();
}

std::vector<std::filesystem::path> DocumentOptions::inputs(const Document& document) const {
  std::vector<std::filesystem::path> files;
  if (document.surface.source == SurfaceSource::file) files.push_back(document.surface.path);
  if (!preset_.empty()) {
    const auto file = find_preset(preset_, preset_folders(executable_path()));
    if (file) files.push_back(*file);
  }
  return files;
}

Result<std::optional<int>> DocumentOptions::threads() const {
  if (threads_.empty()) return std::optional<int>();
  const std::optional<int> count = number_from<int>(threads_);
  if (!count || *count < 1 || *count > 1024) return wrong_words("--threads", threads_, "a whole number from 1 to 1024");
  return count;
}

Result<LoadedSurface> prepare_surface(const DocumentOptions& options, Document& document, JobControl& control) {
  Result<LoadedSurface> loaded = load_surface(document.surface, control);
  if (!loaded) return loaded;
  const NormalMap& map = loaded->surface.map();
  if (loaded->report) {
    print_report(options.quiet(), document.surface.path.string(), *loaded->report);
    if (const auto note = quantisation_note(*loaded->report, document.intrinsic_roughness)) {
      print_message(options.quiet(), document.surface.path.string() + ": warning: " + *note);
    }
  }
  if (options.footprint_open()) document.footprint.center = {0.5 * map.width(), 0.5 * map.height()};
  if (std::optional<Error> fault = footprint_position_fault(document.footprint, map)) return std::move(*fault);
  return loaded;
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
