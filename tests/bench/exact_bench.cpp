// Exact evaluation in single precision: time and error against double precision on the map of the speed tables and on
// any given, for each instruction set. Images for footprints of N = 10, 50 and 200 texels (sigma = N / 6) on one and
// two threads, interleaved, beside double precision, binning and the method of 2014 as published; single queries, one
// by one and by eight on one thread, at normals drawn from D_P; and how long the pyramid of a 2048^2 map takes.
//
//   bench_exact [--quick] [--json FILE] [--plot FILE.svg] [MAP...]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/image/atomic_file.h"
#include "core/image/normal_map_reader.h"
#include "core/math/instruction_set.h"
#include "core/math/parallel.h"
#include "core/pndf/binned_pndf.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/study/error_metrics.h"
#include "core/study/study.h"
#include "core/surface/noise.h"
#include "tests/bench/six_quadratics.h"
#include "tests/bench/svg_plot.h"

namespace {

using namespace glint;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

constexpr double k_roughness = 0.005;

struct Setting {
  InstructionSet set;
  int threads;
  std::vector<double> milliseconds = {};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double milliseconds_of(const PndfModel& model, const Footprint& footprint, PndfImage& image) {
  JobControl control;
  const Clock::time_point begin = Clock::now();
  image = *model.image(footprint, PndfGrid{}, control);
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const InstructionSet set : supported_instruction_sets()) {
    if (set == InstructionSet::scalar) continue;
    for (const int threads : {1, 2}) all.push_back({set, threads});
  }
  return all;
}

void print_image_row(const std::string& name, int n, const std::string& what, int threads, double median_ms,
                     double least_ms, const PndfErrors& errors) {
  fmt::print("{:<34} {:>4} {:>14} {:>8} {:>10.3f} {:>10.3f} {:>11.2e} {:>11.2e}\n", name, n, what, threads, median_ms,
             least_ms, errors.relative_l1, errors.peak_error);
}

void measure(const std::string& name, const Surface& surface, int n, int runs, Json& out, bench::PlotPanel& panel) {
  const double sigma = n / 6.0;
  const Footprint footprint =
      isotropic_footprint({0.5 * surface.map().width() + 0.5, 0.5 * surface.map().height() + 0.5}, sigma);
  const FastExactPndf fast(surface, k_roughness);
  PndfImage exact;
  milliseconds_of(ExactPndf(surface, k_roughness, {.image_cut = 8}), footprint, exact);
  std::vector<Setting> all = settings();
  PndfImage image;
  for (int run = 0; run <= runs; ++run) {  // the first is warm-up
    for (Setting& setting : all) {
      force_instruction_set(setting.set);
      const ThreadLimit limit(setting.threads);
      const double spent = milliseconds_of(fast, footprint, image);
      if (run > 0) setting.milliseconds.push_back(spent);
    }
  }
  const auto add = [&](const std::string& what, int threads, const std::vector<double>& times, std::size_t bytes,
                       const PndfErrors& errors) {
    const double spent = median(times);
    print_image_row(name, n, what, threads, spent, *std::min_element(times.begin(), times.end()), errors);
    const double triangles = 2 * 3.14159265 * sigma * sigma * FastExactPndf::k_image_cut * FastExactPndf::k_image_cut;
    out.push_back({{"map", name},
                   {"n", n},
                   {"what", what},
                   {"threads", threads},
                   {"median_ms", spent},
                   {"milliseconds", times},
                   {"ns_per_triangle", 1e6 * spent / triangles},
                   {"bytes", bytes},
                   {"relative_l1", errors.relative_l1},
                   {"peak_error", errors.peak_error}});
    if (threads == 1) panel.points.push_back({what, spent, errors.relative_l1});
  };
  for (const Setting& setting : all) {
    force_instruction_set(setting.set);
    milliseconds_of(fast, footprint, image);
    add(std::string(instruction_set_name(setting.set)), setting.threads, setting.milliseconds, fast.info().bytes,
        compare(image, exact));
  }
  PndfImage means;  // what counts are of
  milliseconds_of(ExactPndf(surface, k_roughness, {.image_cut = 8, .cell_means = true}), footprint, means);
  const ThreadLimit one(1);
  const auto repeated = [&](const std::function<double()>& once) {
    std::vector<double> times;
    for (int run = 0; run < (n == 200 ? 1 : 3); ++run) times.push_back(once());
    return times;
  };
  const ExactPndf in_double(surface, k_roughness);
  const std::vector<double> double_times = repeated([&] { return milliseconds_of(in_double, footprint, image); });
  add("double", 1, double_times, in_double.info().bytes, compare(image, exact));
  const std::vector<double> old_times = repeated([&] {
    const Clock::time_point begin = Clock::now();
    image = bench::six_quadratics_image(in_double, footprint, PndfGrid{});
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  });
  add("2014", 1, old_times, in_double.info().bytes, compare(image, exact));
  for (const std::uint64_t samples : {100'000U, 1'000'000U, 10'000'000U}) {
    BinnedSettings binned;
    binned.samples = samples;
    const BinnedPndf model(surface, k_roughness, binned);
    const std::vector<double> times = repeated([&] { return milliseconds_of(model, footprint, image); });
    add(fmt::format("binning {}", samples), 1, times, model.info().bytes, compare(image, means));
  }
}

void measure_queries(const std::string& name, const Surface& surface, int n, Json& out) {
  constexpr std::size_t k_queries = 10'000;
  const double sigma = n / 6.0;
  const Footprint footprint =
      isotropic_footprint({0.5 * surface.map().width() + 0.5, 0.5 * surface.map().height() + 0.5}, sigma);
  const Clock::time_point build = Clock::now();
  const FastExactPndf fast(surface, k_roughness);
  PndfWorkspace workspace;
  const FootprintPndf& pndf = fast.at(footprint, workspace);  // builds the pyramid
  const double build_ms = std::chrono::duration<double, std::milli>(Clock::now() - build).count();
  const ExactPndf exact(surface, k_roughness);
  PndfWorkspace other;
  RandomStream random(1, 2);
  std::vector<glm::dvec2> s(k_queries);
  for (glm::dvec2& normal : s) normal = pndf.sample(random);
  const std::size_t checked = surface.interpolation() == Interpolation::linear ? 500 : 50;
  std::vector<double> expected(checked);
  exact.at(footprint, other).evaluate({s.data(), checked}, expected);
  for (const InstructionSet set : supported_instruction_sets()) {
    if (set == InstructionSet::scalar) continue;
    force_instruction_set(set);
    std::vector<double> density(k_queries);
    std::vector<double> runs;
    const auto pass = [&](std::size_t together) {
      const Clock::time_point begin = Clock::now();
      for (std::size_t k = 0; k < k_queries; k += together) pndf.evaluate({&s[k], together}, {&density[k], together});
      return std::chrono::duration<double, std::micro>(Clock::now() - begin).count() / k_queries;
    };
    std::vector<double> by_eight;
    for (int run = 0; run < 6; ++run) {
      const double eight = pass(8);
      const double one = pass(1);
      if (run == 0) continue;
      runs.push_back(one);
      by_eight.push_back(eight);
    }
    double difference = 0;
    double sum = 0;
    for (std::size_t k = 0; k < checked; ++k) {
      difference += std::abs(density[k] - expected[k]);
      sum += expected[k];
    }
    const bool smooth = surface.interpolation() == Interpolation::smooth;
    fmt::print("{:<34} {:>4} {:>8} {:>9} {:>10.3f} {:>10.3f} {:>11.2e} {:>9.1f} {:>10.2f}\n", name, n,
               instruction_set_name(set), smooth ? 32 : 2, median(runs), median(by_eight), difference / sum, build_ms,
               static_cast<double>(fast.info().bytes) / static_cast<double>(surface.map().normals().size()));
    out.push_back({{"map", name},
                   {"n", n},
                   {"isa", instruction_set_name(set)},
                   {"triangles", smooth ? 32 : 2},
                   {"query_us", median(runs)},
                   {"query_by_eight_us", median(by_eight)},
                   {"relative_error", difference / sum},
                   {"build_ms", build_ms},
                   {"bytes", fast.info().bytes}});
  }
}

// The model of a map of 2048^2 texels, with its pyramid.
double large_build_ms() {
  NoiseSettings settings;
  settings.size = 2048;
  JobControl control;
  Result<NormalMap> noise = generate_noise(settings, control);
  const Surface surface(std::make_shared<const NormalMap>(std::move(*noise)), Interpolation::linear);
  std::vector<double> times;
  for (int run = 0; run < 5; ++run) {
    const Clock::time_point begin = Clock::now();
    const FastExactPndf fast(surface, k_roughness);
    PndfWorkspace workspace;
    fast.at(isotropic_footprint({1024.5, 1024.5}, 3), workspace);
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  return median(times);
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false;
  std::string json;
  std::string plot;
  std::vector<std::string> maps;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--quick") {
      quick = true;
    } else if (word == "--json" && k + 1 < argc) {
      json = argv[++k];
    } else if (word == "--plot" && k + 1 < argc) {
      plot = argv[++k];
    } else {
      maps.push_back(word);
    }
  }
  JobControl control;
  std::vector<std::pair<std::string, Surface>> surfaces;
  Result<NormalMap> noise = generate_noise({}, control);
  surfaces.emplace_back("isotropic noise 1024",
                        Surface(std::make_shared<const NormalMap>(std::move(*noise)), Interpolation::linear));
  for (const std::string& file : maps) {
    Result<ReadNormalMap> read = read_normal_map(file, {}, control);
    if (!read) {
      fmt::print(stderr, "{}\n", read.error().message());
      return 1;
    }
    surfaces.emplace_back(std::filesystem::path(file).filename().string(),
                          Surface(std::make_shared<const NormalMap>(std::move(read->map)), Interpolation::linear));
  }
  fmt::print("{}, sigma_r {}, 2 triangles per texel, 256 x 256 cells of [-1, 1]^2\n", machine_name(), k_roughness);
  fmt::print("{:<34} {:>4} {:>14} {:>8} {:>10} {:>10} {:>11} {:>11}\n", "map", "N", "what", "threads", "median ms",
             "least ms", "relative L1", "peak error");
  Json results = Json::array();
  std::vector<bench::PlotPanel> panels;  // of the map of the speed tables
  for (const auto& [name, surface] : surfaces) {
    for (const int n : {10, 50, 200}) {
      if (quick && n == 200) continue;
      bench::PlotPanel panel{fmt::format("{}, N = {}", name, n), {}};
      measure(name, surface, n, n == 10 ? 101 : n == 50 ? 21 : 9, results, panel);
      if (&surface == &surfaces.front().second) panels.push_back(std::move(panel));
    }
  }
  fmt::print("\n{:<34} {:>4} {:>8} {:>9} {:>10} {:>10} {:>11} {:>9} {:>10}\n", "map", "N", "isa", "triangles",
             "query us", "by eight", "mean error", "build ms", "B/texel");
  Json queries = Json::array();
  for (const auto& [name, surface] : surfaces) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
      for (const int n : {18, 50}) measure_queries(name, Surface(surface.shared_map(), interpolation), n, queries);
    }
  }
  const double build_ms = large_build_ms();
  fmt::print("\nmodel and pyramid of a 2048 x 2048 map: {:.1f} ms\n", build_ms);
  const Json document = {{"machine", machine_name()},
                         {"sigma_r", k_roughness},
                         {"images", results},
                         {"queries", queries},
                         {"large_build_ms", build_ms}};
  const auto wrote = [](const Status& status) {
    if (!status) fmt::print(stderr, "{}\n", status.error().message());
    return static_cast<bool>(status);
  };
  bool done = json.empty() || wrote(write_file(json, document.dump(1) + "\n"));
  if (!plot.empty()) {
    const std::string title =
        fmt::format("{}: one thread, sigma_r {}, 2 triangles per texel", machine_name(), k_roughness);
    done = wrote(bench::write_plot(plot, title, panels)) && done;
  }
  return done ? 0 : 1;
}
