// glintscope study: speed against error of the chosen methods on one footprint.

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/names.h"
#include "core/math/instruction_set.h"
#include "core/study/study.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"

namespace glint::gui {
namespace {

using Json = nlohmann::ordered_json;

Json reference_json(const StudyReference& reference) {
  return {{"surface", choice_name(reference.surface)}, {"precision", "double"}, {"relative_l1", reference.relative_l1}};
}

Json settings_json(const Document& document, const StudyResult& result) {
  switch (result.method) {
    case PndfMethod::binning:
      return {{"samples", document.binning_samples}, {"seed", document.seed}};
    case PndfMethod::mixture:
      return {{"step", document.mixture.step},
              {"kappa", document.mixture.kappa.value_or(automatic_kappa(document.mixture.step))},
              {"elements", choice_name(document.mixture.elements)},
              {"storage", "float"}};
    case PndfMethod::lean:
      return Json::object();
    case PndfMethod::automatic:
      return {{"tolerance", document.automatic.tolerance}, {"answered_by", result.answered_by}};
    case PndfMethod::exact:
      break;
  }
  Json settings = {{"precision", choice_name(document.exact_precision)}, {"vertex_shift", document.exact_vertex_shift}};
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
          {"prepare_ms", r.prepare_ms},
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
    add_words_option(app_, repeat_, "--repeat", "N",
                     "Images timed after one warm-up; the median is reported. Default: 5.");
    add_words_option(app_, reference_, "--reference", "smooth|linear|constant",
                     "The surface of the reference. Default: the method's own.");
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  Status run(JobControl& control) override {
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
    if (!results) return options_.with_flag(results.error());
    findings_ = say_findings(options_, *document, *loaded);
    say_short_counts(*results);
    const int threads = std::min(asked->threads.value_or(thread_count()), thread_count());
    if (options_.json()) {
      print_json(*document, *results, threads);
    } else {
      print_table(*results, threads);
    }
    return success();
  }

 private:
  [[nodiscard]] Result<StudySettings> settings() const {
    StudySettings settings;
    const Result<std::optional<int>> threads = options_.threads();
    if (!threads) return threads.error();
    settings.threads = *threads;
    if (const Status chosen = options_.apply_instruction_set(); !chosen) return chosen.error();
    if (repeat_.given()) {
      const char* end = repeat_.words.data() + repeat_.words.size();
      const auto [stop, fault] = std::from_chars(repeat_.words.data(), end, settings.repeats);
      if (fault != std::errc() || stop != end || settings.repeats < 1 || settings.repeats > 10'000) {
        return request_error("--repeat", "'" + repeat_.words + "' is not a whole number from 1 to 10000");
      }
    }
    if (reference_.given()) {
      settings.reference_surface = choice_named<Interpolation>(reference_.words);
      if (!settings.reference_surface) {
        return request_error("--reference", "'" + reference_.words + "' is not smooth, linear or constant");
      }
    }
    return settings;
  }

  // The figure is defined over 10^4 normals: fewer must be loud.
  void say_short_counts(const std::vector<StudyResult>& results) const {
    for (const StudyResult& r : results) {
      const std::size_t least = std::min(r.query_count, r.query_uniform_count);
      if (least >= k_study_queries) continue;
      print_message(options_.quiet(),
                    fmt::format("{}: a mean time per query is over {} normals only, not {}: they are slow",
                                choice_name(r.method), least, k_study_queries));
    }
  }

  void print_json(const Document& document, const std::vector<StudyResult>& results, int threads) const {
    Json object = {{"machine", machine_name()},
                   {"isa", instruction_set_name(instruction_set())},
                   {"threads", threads},
                   {"map", map_name(document)},
                   {"sigma_r", document.intrinsic_roughness},
                   {"reference", reference_json(results.front().reference)},
                   {"results", Json::array()}};
    for (const StudyResult& result : results) {
      object["results"].push_back(result_json(document, result));
      if (result.method == PndfMethod::mixture) object["results"].back()["findings"] = findings_;
    }
    print_result("{}\n", object.dump());
  }

  static void print_table(const std::vector<StudyResult>& results, int threads) {
    print_result("{}, {} used, {}\n", machine_name(), threads, instruction_set_name(instruction_set()));
    print_result("{:<10} {:<9} {:>9} {:>10} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "method", "surface",
                 "build ms", "image ms", "query us", "uniform us", "relative L1", "peak error", "energy err",
                 "own noise");
    for (const StudyResult& r : results) {
      print_result("{:<10} {:<9} {:>9.3g} {:>10.4g} {:>11.4g} {:>11.4g} {:>11.3g} {:>11.3g} {:>11.3g} {:>11.3g}\n",
                   choice_name(r.method), choice_name(r.surface), r.build_ms, r.image_ms, r.query_us,
                   r.query_uniform_us, r.relative_l1, r.peak_error, r.energy_error, r.own_noise);
    }
    for (const StudyResult& r : results) {
      print_result(
          "{}: reference exact on the {} surface in double precision, own error {:.2g}; queries timed: {} and {}\n",
          choice_name(r.method), choice_name(r.reference.surface), r.reference.relative_l1, r.query_count,
          r.query_uniform_count);
    }
  }

  CLI::App& app_;
  DocumentOptions options_;
  WordsOption repeat_;
  WordsOption reference_;
  std::vector<std::string> findings_;  // of the mixture
};

}  // namespace

std::unique_ptr<Command> add_study_command(CLI::App& app) {
  return std::make_unique<StudyCommand>(app);
}

}  // namespace glint::gui
