// glintscope study: speed against error of the chosen methods on one footprint.

#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/names.h"
#include "core/study/study.h"
#include "gui/command.h"
#include "gui/console.h"
#include "gui/document_options.h"

namespace glint::gui {
namespace {

using Json = nlohmann::ordered_json;

Json reference_json(const StudyReference& reference) {
  return {{"surface", choice_name(reference.surface)}, {"precision", "double"}, {"relative_l1", reference.relative_l1}};
}

Json settings_json(const Document& document, const StudyResult& result) {
  if (result.method == PndfMethod::binning) return {{"samples", document.binning_samples}, {"seed", document.seed}};
  Json settings = {{"precision", "double"}};
  if (result.surface == Interpolation::linear) settings["triangles"] = 2;
  if (result.surface == Interpolation::smooth) settings["triangles"] = 32;
  return settings;
}

Json result_json(const Document& document, const StudyResult& r) {
  const SymmetricMatrix2& c = document.footprint.covariance;
  return {{"method", choice_name(r.method)},
          {"settings", settings_json(document, r)},
          {"surface", choice_name(r.surface)},
          {"reference", reference_json(r.reference)},
          {"footprint", {document.footprint.center.x, document.footprint.center.y, c.xx, c.xy, c.yy}},
          {"build_ms", r.build_ms},
          {"bytes", r.bytes},
          {"image_ms", r.image_ms},
          {"image_size", document.grid.size},
          {"query_us", r.query_us},
          {"query_uniform_us", r.query_uniform_us},
          {"query_count", r.query_count},
          {"query_uniform_count", r.query_uniform_count},
          {"relative_l1", r.relative_l1},
          {"peak_error", r.peak_error},
          {"energy_error", r.energy_error},
          {"own_noise", r.own_noise},
          {"error_kind", "measured"}};
}

class StudyCommand final : public Command {
 public:
  explicit StudyCommand(CLI::App& app)
      : app_(*app.add_subcommand("study", "Speed against error of the chosen methods at one footprint.")),
        options_(app_) {
    app_.add_option("--repeat", repeat_, "Images timed after one warm-up; the median is reported. Default: 5.")
        ->option_text("N");
    app_.add_option("--reference", reference_, "The surface of the reference. Default: the method's own.")
        ->option_text("smooth|linear|constant");
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  int run(JobControl& control) override {
    const Status done = run_checked(control);
    if (done) return 0;
    if (!control.cancelled()) print_error(done.error());
    return exit_status(done.error());
  }

 private:
  [[nodiscard]] Result<StudySettings> settings() const {
    StudySettings settings;
    const Result<std::optional<int>> threads = options_.threads();
    if (!threads) return threads.error();
    settings.threads = *threads;
    if (!repeat_.empty()) {
      const char* end = repeat_.data() + repeat_.size();
      const auto [stop, fault] = std::from_chars(repeat_.data(), end, settings.repeats);
      if (fault != std::errc() || stop != end || settings.repeats < 1 || settings.repeats > 10'000) {
        return request_error("--repeat", "'" + repeat_ + "' is not a whole number from 1 to 10000");
      }
    }
    if (!reference_.empty()) {
      settings.reference_surface = choice_named<Interpolation>(reference_);
      if (!settings.reference_surface) {
        return request_error("--reference", "'" + reference_ + "' is not smooth, linear or constant");
      }
    }
    return settings;
  }

  Status run_checked(JobControl& control) {
    Result<Document> document = options_.document();
    if (!document) return document.error();
    const Result<StudySettings> asked = settings();
    if (!asked) return asked.error();
    const Result<LoadedSurface> loaded = prepare_surface(options_, *document, control);
    if (!loaded) return loaded.error();
    Result<std::vector<StudyResult>> results = std::vector<StudyResult>();
    {
      const ProgressBar bar(control, options_.quiet());
      results = run_study(*document, loaded->surface, *asked, control);
    }
    if (!results) return results.error();
    const int threads = asked->threads.value_or(thread_count());
    if (options_.json()) {
      print_json(*document, *results, threads);
    } else {
      print_table(*results, threads);
    }
    return success();
  }

  static void print_json(const Document& document, const std::vector<StudyResult>& results, int threads) {
    Json object = {{"machine", machine_name()},
                   {"isa", instruction_set()},
                   {"threads", threads},
                   {"map", map_name(document)},
                   {"sigma_r", document.intrinsic_roughness},
                   {"reference", reference_json(results.front().reference)},
                   {"results", Json::array()}};
    for (const StudyResult& result : results) object["results"].push_back(result_json(document, result));
    fmt::print("{}\n", object.dump());
  }

  static void print_table(const std::vector<StudyResult>& results, int threads) {
    fmt::print("{}, {} used, {}\n", machine_name(), threads, instruction_set());
    fmt::print("{:<10} {:<9} {:>9} {:>10} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "method", "surface", "build ms",
               "image ms", "query us", "uniform us", "relative L1", "peak error", "energy err", "own noise");
    for (const StudyResult& r : results) {
      fmt::print("{:<10} {:<9} {:>9.3g} {:>10.4g} {:>11.4g} {:>11.4g} {:>11.3g} {:>11.3g} {:>11.3g} {:>11.3g}\n",
                 choice_name(r.method), choice_name(r.surface), r.build_ms, r.image_ms, r.query_us, r.query_uniform_us,
                 r.relative_l1, r.peak_error, r.energy_error, r.own_noise);
    }
    for (const StudyResult& r : results) {
      fmt::print(
          "{}: reference exact on the {} surface in double precision, own error {:.2g}; queries timed: {} and {}\n",
          choice_name(r.method), choice_name(r.reference.surface), r.reference.relative_l1, r.query_count,
          r.query_uniform_count);
    }
  }

  CLI::App& app_;
  DocumentOptions options_;
  std::string repeat_;
  std::string reference_;
};

}  // namespace

std::unique_ptr<Command> add_study_command(CLI::App& app) {
  return std::make_unique<StudyCommand>(app);
}

}  // namespace glint::gui
