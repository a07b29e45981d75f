// glintscope generate: a procedural normal map to a file. The options of each kind are the fields of its generator.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/document/names.h"
#include "core/image/normal_map_writer.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"

namespace glint::gui {
namespace {

constexpr std::string_view k_generator = "surface.generator.";

// "surface.generator.rms_slope" becomes "--rms-slope".
std::string flag_of(const Parameter& parameter) {
  std::string flag = "--" + std::string(parameter.path.substr(k_generator.size()));
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

// One kind of map, with an option for every field that has an effect on it.
struct Kind {
  SurfaceSource source;
  CLI::App* app;
  std::vector<std::unique_ptr<FieldOption>> fields;
};

Document document_of(SurfaceSource source, NoiseSettings::Spectrum spectrum) {
  Document document;
  document.surface.source = source;
  document.surface.noise.spectrum = spectrum;
  return document;
}

bool matters_to(const Parameter& parameter, SurfaceSource source) {
  using Spectrum = NoiseSettings::Spectrum;
  return parameter.matters(document_of(source, Spectrum::gaussian)) ||
         parameter.matters(document_of(source, Spectrum::band));
}

class GenerateCommand final : public Command {
 public:
  explicit GenerateCommand(CLI::App& app)
      : app_(*app.add_subcommand("generate", "Write a procedural normal map that repeats seamlessly.")) {
    app_.require_subcommand(1);
    add_kind(SurfaceSource::noise, "An isotropic random surface from its spectrum.");
    add_kind(SurfaceSource::scratches, "Scratched metal: engraved lines over gentle dents.");
    add_kind(SurfaceSource::flakes,
             "Metallic paint: flat flakes that do not overlap, one normal each. Files do not say that nothing is to be "
             "interpolated between their texels: read one with --surface constant.");
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  Status run(JobControl& control) override {
    const auto kind = std::find_if(kinds_.begin(), kinds_.end(), [](const Kind& k) { return k.app->parsed(); });
    return generate(*kind, control);  // the parser requires one
  }

 private:
  void add_kind(SurfaceSource source, const std::string& help) {
    Kind kind{source, app_.add_subcommand(std::string(choice_name(source)), help), {}};
    for (const Parameter& parameter : parameters()) {
      if (!parameter.path.starts_with(k_generator) || !matters_to(parameter, source)) continue;
      kind.fields.push_back(add_field_option(*kind.app, flag_of(parameter), parameter.path.data()));
    }
    kind.app->add_option("-o,--output", output_, "The map: .exr (signed float) or .png (16 bits, 2c - 1).")
        ->option_text("MAP.exr|MAP.png")
        ->required();
    kind.app->add_flag("--quiet", quiet_, "No messages and no progress; errors are still printed.");
    kinds_.push_back(std::move(kind));
  }

  Status generate(const Kind& kind, JobControl& control) const {
    Result<Document> document = document_for(kind);
    if (!document) return document.error();
    if (Status writable = check_output(output_, {}, {".exr", ".png"}); !writable) return writable;
    Result<LoadedSurface> made = content_error("", "");
    {
      const ProgressBar bar(control, quiet_);
      made = load_surface(document->surface, control);
    }
    if (!made) return with_flag(made.error());
    Status written = write_normal_map(output_, made->surface.map());
    if (written) print_message(quiet_, "wrote " + output_);
    return written;
  }

  // An option of one spectrum chooses that spectrum, unless another was asked for in words.
  static Result<Document> document_for(const Kind& kind) {
    const auto given = [&](std::string_view flag) {
      return std::any_of(kind.fields.begin(), kind.fields.end(),
                         [&](const auto& field) { return field->flag == flag && field->given(); });
    };
    const bool gaussian = given("--correlation-length") && !given("--spectrum");
    Document document =
        document_of(kind.source, gaussian ? NoiseSettings::Spectrum::gaussian : NoiseSettings().spectrum);
    for (const auto& field : kind.fields) {
      if (const Status done = apply(*field, document); !done) return done.error();
    }
    for (const auto& field : kind.fields) {
      if (field->given() && !field->parameter->matters(document)) {
        return request_error(
            field->flag, fmt::format("has no effect on the {} spectrum", choice_name(document.surface.noise.spectrum)));
      }
    }
    if (const std::optional<Error> fault = document_fault(document)) return with_flag(*fault);
    return document;
  }

  // What a field's fault is called here.
  static Error with_flag(Error error) {
    const Parameter* parameter = find_parameter(error.subject);
    if (parameter != nullptr && parameter->path.starts_with(k_generator)) error.subject = flag_of(*parameter);
    return error;
  }

  CLI::App& app_;
  std::vector<Kind> kinds_;
  std::string output_;
  bool quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> add_generate_command(CLI::App& app) {
  return std::make_unique<GenerateCommand>(app);
}

}  // namespace glint::gui
