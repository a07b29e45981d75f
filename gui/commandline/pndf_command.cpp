// glintscope pndf: D_P(s) of one footprint, as images or at given normals.

#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/image/pndf_exr.h"
#include "gui/commandline/command.h"
#include "gui/commandline/console.h"
#include "gui/commandline/document_options.h"
#include "gui/commandline/false_color.h"
#include "gui/commandline/queries.h"

namespace glint::gui {
namespace {

using Json = nlohmann::ordered_json;

struct ComputedImage {
  PndfMethod method;
  PndfModelInfo info;
  PndfImage image;
  double milliseconds;
};

struct MethodValues {
  PndfMethod method;
  std::vector<double> values;
};

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

std::string name_of(PndfMethod method) {
  return std::string(choice_name(method));
}

const Error k_cancelled = content_error("pndf", "cancelled");

class PndfCommand final : public Command {
 public:
  explicit PndfCommand(CLI::App& app)
      : app_(*app.add_subcommand("pndf", "D_P(s) of one footprint: an EXR or PNG of the chosen methods, or values.")),
        options_(app_) {
    add_words_option(app_, queries_, "--queries", "FILE|-",
                     "Print D_P at these normals, one `s t` a line; - is standard input.");
    add_words_option(app_, output_, "-o,--output", "OUT.exr|OUT.png",
                     "Write the images: .exr (one channel a method) or .png (false colour).");
    output_.option->excludes(queries_.option);
  }

  [[nodiscard]] bool chosen() const override { return app_.parsed(); }

  Status run(JobControl& control) override {
    Result<Document> document = options_.document();
    if (!document) return document.error();
    const Result<std::optional<int>> threads = options_.threads();
    if (!threads) return threads.error();
    if (Status chosen = options_.apply_instruction_set(); !chosen) return chosen;
    // Single normals are asked by those who want every digit.
    if (queries_.given() && !options_.gives("--precision")) {
      document->exact_precision = ExactPrecision::double_precision;
    }
    std::optional<ThreadLimit> limit;
    if (*threads) limit.emplace(**threads);
    if (output_.given()) {
      Status writable = check_output(output_.words, options_.inputs(*document), {".exr", ".png"});
      if (!writable) return writable;
    }
    Result<std::vector<glm::dvec2>> queries = std::vector<glm::dvec2>();
    if (queries_.given()) queries = read_queries(queries_.words);
    if (!queries) return queries.error();
    Result<LoadedSurface> loaded = prepare_surface(options_, *document, control);
    if (!loaded) return loaded.error();
    findings_ = say_findings(options_, *document, *loaded);
    return !queries_.given() ? make_images(*document, loaded->surface, control)
                             : answer(*document, loaded->surface, *queries, control);
  }

 private:
  Status answer(const Document& document, const Surface& surface, const std::vector<glm::dvec2>& queries,
                JobControl& control) {
    std::size_t outside = 0;
    for (const glm::dvec2& s : queries) outside += s.x * s.x + s.y * s.y > 1 ? 1 : 0;
    if (outside > 0) {
      print_message(options_.quiet(),
                    fmt::format("{} of {} queries lie outside the unit disk; the density of the plane "
                                "there is that of invalid normals",
                                outside, queries.size()));
    }
    std::vector<MethodValues> answers;
    {
      const ProgressBar bar(control, options_.quiet());
      for (const PndfMethod method : document.methods) {
        const std::unique_ptr<PndfModel> model = make_document_model(document, method, surface);
        MethodValues values{method, std::vector<double>(queries.size())};
        if (!evaluate_all(*model, document.footprint, queries, values.values, control)) return k_cancelled;
        answers.push_back(std::move(values));
      }
    }
    if (options_.json()) {
      Json results = Json::array();
      for (const MethodValues& a : answers) {
        Json result = {{"method", name_of(a.method)}, {"values", a.values}};
        if (a.method == PndfMethod::mixture) result["findings"] = findings_;
        results.push_back(std::move(result));
      }
      print_result("{}\n", head(document, surface, std::move(results)).dump());
      return success();
    }
    for (std::size_t k = 0; k < queries.size(); ++k) {
      std::string line;
      for (const MethodValues& a : answers) line += fmt::format("{}{:.9e}", line.empty() ? "" : " ", a.values[k]);
      print_result("{}\n", line);
    }
    return success();
  }

  Status make_images(const Document& document, const Surface& surface, JobControl& control) {
    const PndfGrid grid = document_grid(document, surface);
    if (const auto fault = grid_fault(grid)) return request_error("--window", *fault);
    std::vector<ComputedImage> made;
    {
      const ProgressBar bar(control, options_.quiet());
      for (const PndfMethod method : document.methods) {
        const std::unique_ptr<PndfModel> model = make_document_model(document, method, surface);
        const auto begin = std::chrono::steady_clock::now();
        std::optional<PndfImage> image = model->image(document.footprint, grid, control);
        if (!image) return k_cancelled;
        made.push_back({method, model->info(), std::move(*image), milliseconds_since(begin)});
      }
    }
    say_what_the_images_are(document, made);
    if (Status written = write(document, made); !written) return written;
    if (options_.json()) {
      print_result("{}\n", head(document, surface, image_results(document, made)).dump());
    } else {
      print_table(made);
    }
    return success();
  }

  void say_what_the_images_are(const Document& document, const std::vector<ComputedImage>& made) const {
    for (const ComputedImage& m : made) {
      if (m.image.widening != glm::dvec2(0)) {
        print_message(
            options_.quiet(),
            fmt::format("sigma_r {} is below 0.6 of the cell pitch: cells of the {} image hold means, its "
                        "sigma_r^2 widened by {:.3g} along s and {:.3g} along t",
                        document.intrinsic_roughness, name_of(m.method), m.image.widening.x, m.image.widening.y));
      }
      if (!m.image.answer.text.empty()) print_message(options_.quiet(), answer_sentence(m));
      if (!holds_lobe(m.image)) {
        print_message(options_.quiet(),
                      fmt::format("the window does not contain the lobe: the {} image holds {:.3g} % of it",
                                  name_of(m.method), 100 * integral(m.image)));
      }
    }
  }

  static std::string answer_sentence(const ComputedImage& m) {
    const double total = 100 * m.image.error.total().value_or(0);
    if (m.image.answer.known) {
      return fmt::format("{} was answered by {}, off by about {:.2g} %", name_of(m.method), m.image.answer.text, total);
    }
    return fmt::format("{} was answered by {}: no method it has is known to meet the tolerance here (about {:.2g} %)",
                       name_of(m.method), m.image.answer.text, total);
  }

  // Energy is only meaningful where the window contains the lobe.
  static bool holds_lobe(const PndfImage& image) { return integral(image) > 0.995; }

  Status write(const Document& document, const std::vector<ComputedImage>& made) const {
    if (!output_.given()) return success();
    Status written = success();
    if (output_.words.ends_with(".exr")) {
      std::vector<NamedPndfImage> named;
      named.reserve(made.size());
      for (const ComputedImage& m : made) named.push_back({name_of(m.method), &m.image});
      written = write_pndf_exr(output_.words, named, recipe_of(document));
    } else {
      std::vector<MethodImage> images;
      images.reserve(made.size());
      for (const ComputedImage& m : made) images.push_back({m.method, m.info.surface, &m.image});
      const Canvas canvas = false_color_picture(document, images);
      if (canvas.text_missing()) print_message(options_.quiet(), "no font was found: the picture has no text");
      written = canvas.write_png(output_.words);
    }
    if (written) print_message(options_.quiet(), "wrote " + output_.words);
    return written;
  }

  [[nodiscard]] Json image_results(const Document& document, const std::vector<ComputedImage>& made) const {
    Json results = Json::array();
    for (const ComputedImage& m : made) {
      const glm::dvec2 mean = mean_normal(m.image);
      Json result = {{"method", name_of(m.method)},
                     {"surface", choice_name(m.info.surface)},
                     {"guarantee", m.info.guarantee},
                     {"integral", integral(m.image)},
                     {"mean", {mean.x, mean.y}},
                     {"image_ms", m.milliseconds},
                     {"widening", {m.image.widening.x, m.image.widening.y}}};
      if (!m.image.answer.text.empty()) {
        result["answered_by"] = m.image.answer.text;
        result["tolerance_met"] = m.image.answer.known;
      }
      result["error_bounded"] = m.image.error.bounded;
      result["error_estimated"] = m.image.error.estimated ? Json(*m.image.error.estimated) : Json();
      if (m.method == PndfMethod::mixture) {
        result["kappa"] = document.mixture.kappa.value_or(automatic_kappa(document.mixture.step));
        result["findings"] = findings_;
      }
      if (m.method == PndfMethod::binning) {
        result["own_noise"] = m.image.error.estimated ? Json(*m.image.error.estimated) : Json();
        result["invalid_samples"] = m.image.invalid_samples;
        result["outside_samples"] = m.image.outside_samples;
      }
      const PndfGrid& g = m.image.grid;
      result["window"] = {g.s_min, g.s_max, g.t_min, g.t_max};
      result["window_holds_lobe"] = holds_lobe(m.image);
      result["image_size"] = g.columns;
      results.push_back(std::move(result));
    }
    return results;
  }

  [[nodiscard]] static Json head(const Document& document, const Surface& surface, Json results) {
    const SymmetricMatrix2& c = document.footprint.covariance;
    return {{"map", map_name(document)},
            {"map_size", {surface.map().width(), surface.map().height()}},
            {"surface", choice_name(surface.interpolation())},
            {"sigma_r", document.intrinsic_roughness},
            {"footprint", {document.footprint.center.x, document.footprint.center.y, c.xx, c.xy, c.yy}},
            {"results", std::move(results)}};
  }

  static void print_table(const std::vector<ComputedImage>& made) {
    print_result("{:<10} {:<9} {:>10} {:>10} {:>10} {:>11} {:>11}\n", "method", "surface", "integral", "mean s",
                 "mean t", "own noise", "time");
    for (const ComputedImage& m : made) {
      const glm::dvec2 mean = mean_normal(m.image);
      print_result("{:<10} {:<9} {:>10.6f} {:>10.6f} {:>10.6f} {:>11} {:>8.1f} ms\n", name_of(m.method),
                   choice_name(m.info.surface), integral(m.image), mean.x, mean.y, noise_text(m.image), m.milliseconds);
    }
  }

  CLI::App& app_;
  DocumentOptions options_;
  WordsOption queries_;
  WordsOption output_;
  std::vector<std::string> findings_;  // of the mixture
};

}  // namespace

std::unique_ptr<Command> add_pndf_command(CLI::App& app) {
  return std::make_unique<PndfCommand>(app);
}

}  // namespace glint::gui
