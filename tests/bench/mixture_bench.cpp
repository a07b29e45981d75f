// The Gaussian mixture: time and error against the smooth surface on the map of the speed tables, for every step and
// kind of element, each instruction set and one thread; and single normals, with what preparing their footprint takes.
//
//   bench_mixture [--json FILE]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/names.h"
#include "core/image/atomic_file.h"
#include "core/math/instruction_set.h"
#include "core/math/parallel.h"
#include "core/pndf/mixture_pndf.h"
#include "core/study/error_metrics.h"
#include "core/study/reference.h"
#include "core/study/study.h"
#include "core/surface/noise.h"

namespace {

using namespace glint;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

constexpr double k_roughness = 0.005;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double microseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

Footprint footprint_of(const Surface& surface, int n) {
  return isotropic_footprint({0.5 * surface.map().width() + 0.5, 0.5 * surface.map().height() + 0.5}, n / 6.0);
}

void measure_images(const Surface& surface, int n, Json& out) {
  const Footprint footprint = footprint_of(surface, n);
  JobControl control;
  const ReferenceImage reference =
      *reference_image(surface, k_roughness, footprint, PndfGrid{}, CellContent::point, control);
  const auto run = [&](const MixtureSettings& settings) {
    const MixturePndf model(surface, k_roughness, settings);
    const int runs = n == 10 ? 101 : n == 50 ? 21 : 7;
    std::vector<double> times;
    PndfImage image;
    const ThreadLimit one(1);
    for (int k = 0; k <= runs; ++k) {  // the first is warm-up
      const Clock::time_point begin = Clock::now();
      image = *model.image(footprint, PndfGrid{}, control);
      if (k > 0) times.push_back(microseconds_since(begin) / 1000);
    }
    const PndfErrors errors = compare(image, reference.image);
    const std::string_view isa = instruction_set_name(instruction_set());
    fmt::print("{:>4} {:>8} {:>10} {:>7.4f} {:>10.4f} {:>10.3f} {:>11.2e} {:>11.2e} {:>11.1e}\n", n, isa,
               choice_name(settings.elements), settings.step, settings.kappa.value_or(automatic_kappa(settings.step)),
               median(times), errors.relative_l1, errors.peak_error, errors.energy_error);
    out.push_back({{"n", n},
                   {"isa", isa},
                   {"elements", choice_name(settings.elements)},
                   {"step", settings.step},
                   {"median_ms", median(times)},
                   {"milliseconds", times},
                   {"relative_l1", errors.relative_l1},
                   {"peak_error", errors.peak_error},
                   {"energy_error", errors.energy_error},
                   {"reference_error", reference.own_error}});
  };
  for (const MixtureElements kind : {MixtureElements::flat, MixtureElements::curved, MixtureElements::corrected}) {
    for (const double step : {2.0, 1.0, 0.5, 1.0 / 3, 0.25}) run({step, std::nullopt, kind});
  }
  for (const InstructionSet set : supported_instruction_sets()) {
    if (set == InstructionSet::scalar || set == supported_instruction_sets().back()) continue;
    force_instruction_set(set);
    for (const double step : {0.5, 1.0 / 3}) run({step, std::nullopt, MixtureElements::corrected});
  }
  force_instruction_set(supported_instruction_sets().back());
  fmt::print("{:>4} the reference's own error is {:.1e}\n", n, reference.own_error);
}

void measure_queries(const Surface& surface, int n, Json& out) {
  constexpr std::size_t k_queries = 10'000;
  const Footprint footprint = footprint_of(surface, n);
  const MixturePndf model(surface, k_roughness);
  for (const InstructionSet set : supported_instruction_sets()) {
    if (set == InstructionSet::scalar) continue;
    force_instruction_set(set);
    PndfWorkspace workspace;
    RandomStream random(1, 2);
    std::vector<glm::dvec2> s(k_queries);
    for (glm::dvec2& normal : s) normal = model.at(footprint, workspace).sample(random);
    std::vector<double> density(k_queries);
    const auto time_queries = [&](const FootprintPndf& pndf) {
      std::vector<double> times;
      for (int run = 0; run < 6; ++run) {
        const Clock::time_point begin = Clock::now();
        for (std::size_t k = 0; k < k_queries; ++k) pndf.evaluate({&s[k], 1}, {&density[k], 1});
        if (run > 0) times.push_back(microseconds_since(begin) / k_queries);
      }
      return times;
    };
    std::vector<double> preparing;
    for (int k = 0; k < 20; ++k) {
      const FootprintPndf& pndf = model.at(footprint, workspace);
      pndf.expect_queries(k_queries);
      const Clock::time_point begin = Clock::now();
      pndf.evaluate({s.data(), 1}, {density.data(), 1});
      preparing.push_back(microseconds_since(begin));
    }
    const FootprintPndf& prepared = model.at(footprint, workspace);
    prepared.expect_queries(k_queries);
    const std::vector<double> times = time_queries(prepared);
    const FootprintPndf& unprepared = model.at(footprint, workspace);
    unprepared.expect_queries(1);
    const std::vector<double> times_unprepared = time_queries(unprepared);
    // As a renderer that asks one normal of every footprint.
    std::vector<double> times_alone;
    for (int run = 0; run < 6; ++run) {
      const Clock::time_point begin = Clock::now();
      for (std::size_t k = 0; k < k_queries; ++k) {
        model.at(footprint, workspace).evaluate({&s[k], 1}, {&density[k], 1});
      }
      if (run > 0) times_alone.push_back(microseconds_since(begin) / k_queries);
    }
    const double pays = median(preparing) / std::max(median(times_unprepared) - median(times), 1e-9);
    const std::string_view isa = instruction_set_name(set);
    fmt::print("{:>4} {:>8} {:>10.3f} {:>12.1f} {:>14.3f} {:>16.3f} {:>12.0f}\n", n, isa, median(times),
               median(preparing), median(times_unprepared), median(times_alone), pays);
    out.push_back({{"n", n},
                   {"isa", isa},
                   {"query_us", median(times)},
                   {"prepare_us", median(preparing)},
                   {"query_without_preparing_us", median(times_unprepared)},
                   {"one_query_a_footprint_us", median(times_alone)},
                   {"preparing_pays_from", pays}});
  }
}

}  // namespace

int main(int argc, char** argv) {
  JobControl control;
  Result<NormalMap> noise = generate_noise({}, control);
  const Surface surface(std::make_shared<const NormalMap>(std::move(*noise)), Interpolation::smooth);
  force_instruction_set(supported_instruction_sets().back());
  fmt::print("{}, one thread, sigma_r {}, 256 x 256 cells of [-1, 1]^2, against the smooth surface\n", machine_name(),
             k_roughness);
  fmt::print("{:>4} {:>8} {:>10} {:>7} {:>10} {:>10} {:>11} {:>11} {:>11}\n", "N", "isa", "elements", "h", "kappa",
             "median ms", "relative L1", "peak error", "energy");
  Json images = Json::array();
  for (const int n : {10, 50, 200}) measure_images(surface, n, images);
  fmt::print("\n{:>4} {:>8} {:>10} {:>12} {:>14} {:>16} {:>12}   (h 0.5)\n", "N", "isa", "query us", "prepare us",
             "unprepared us", "one a footprint", "pays from");
  Json queries = Json::array();
  for (const int n : {18, 50, 200}) measure_queries(surface, n, queries);
  if (argc < 3 || std::string(argv[1]) != "--json") return 0;
  const Json document = {
      {"machine", machine_name()}, {"sigma_r", k_roughness}, {"images", images}, {"queries", queries}};
  const Status written = write_file(argv[2], document.dump(1) + "\n");
  if (!written) fmt::print(stderr, "{}\n", written.error().message());
  return written ? 0 : 1;
}
