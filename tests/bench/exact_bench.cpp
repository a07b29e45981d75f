// Exact evaluation in single precision: time and error against double precision on the map of the speed tables and on
// any given, for each instruction set. Images for footprints of N = 10, 50 and 200 texels (sigma = N / 6) on one and
// two threads, interleaved; single queries, one by one on one thread, at normals drawn from D_P.
//
//   bench_exact [--quick] [--json FILE] [MAP...]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/image/atomic_file.h"
#include "core/image/normal_map_reader.h"
#include "core/math/instruction_set.h"
#include "core/math/parallel.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/study/error_metrics.h"
#include "core/study/study.h"
#include "core/surface/noise.h"

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

void measure(const std::string& name, const Surface& surface, int n, int runs, Json& out) {
  const double sigma = n / 6.0;
  const Footprint footprint =
      isotropic_footprint({0.5 * surface.map().width() + 0.5, 0.5 * surface.map().height() + 0.5}, sigma);
  const FastExactPndf fast(surface, k_roughness);
  PndfImage exact;
  const double in_double = milliseconds_of(ExactPndf(surface, k_roughness), footprint, exact);
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
  for (const Setting& setting : all) {
    force_instruction_set(setting.set);
    milliseconds_of(fast, footprint, image);
    const PndfErrors errors = compare(image, exact);
    const double spent = median(setting.milliseconds);
    const double triangles = 2 * 3.14159265 * sigma * sigma * FastExactPndf::k_image_cut * FastExactPndf::k_image_cut;
    fmt::print("{:<34} {:>4} {:>8} {:>8} {:>10.3f} {:>10.3f} {:>10.1f} {:>11.2e} {:>11.2e}\n", name, n,
               instruction_set_name(setting.set), setting.threads, spent,
               *std::min_element(setting.milliseconds.begin(), setting.milliseconds.end()), 1e6 * spent / triangles,
               errors.relative_l1, errors.peak_error);
    out.push_back({{"map", name},
                   {"n", n},
                   {"isa", instruction_set_name(setting.set)},
                   {"threads", setting.threads},
                   {"median_ms", spent},
                   {"milliseconds", setting.milliseconds},
                   {"ns_per_triangle", 1e6 * spent / triangles},
                   {"relative_l1", errors.relative_l1},
                   {"peak_error", errors.peak_error},
                   {"double_ms", in_double}});
  }
  fmt::print("{:<34} {:>4} {:>8} {:>8} {:>10.0f}\n", name, n, "double", thread_count(), in_double);
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
    for (int run = 0; run < 6; ++run) {
      const Clock::time_point begin = Clock::now();
      for (std::size_t k = 0; k < k_queries; ++k) pndf.evaluate({&s[k], 1}, {&density[k], 1});
      const double spent = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
      if (run > 0) runs.push_back(spent / k_queries);
    }
    double difference = 0;
    double sum = 0;
    for (std::size_t k = 0; k < checked; ++k) {
      difference += std::abs(density[k] - expected[k]);
      sum += expected[k];
    }
    const bool smooth = surface.interpolation() == Interpolation::smooth;
    fmt::print("{:<34} {:>4} {:>8} {:>9} {:>10.3f} {:>11.2e} {:>9.1f} {:>10.2f}\n", name, n, instruction_set_name(set),
               smooth ? 32 : 2, median(runs), difference / sum, build_ms,
               static_cast<double>(fast.info().bytes) / static_cast<double>(surface.map().normals().size()));
    out.push_back({{"map", name},
                   {"n", n},
                   {"isa", instruction_set_name(set)},
                   {"triangles", smooth ? 32 : 2},
                   {"query_us", median(runs)},
                   {"relative_error", difference / sum},
                   {"build_ms", build_ms},
                   {"bytes", fast.info().bytes}});
  }
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false;
  std::string json;
  std::vector<std::string> maps;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--quick") {
      quick = true;
    } else if (word == "--json" && k + 1 < argc) {
      json = argv[++k];
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
  fmt::print("{:<34} {:>4} {:>8} {:>8} {:>10} {:>10} {:>10} {:>11} {:>11}\n", "map", "N", "isa", "threads", "median ms",
             "least ms", "ns/tri.", "relative L1", "peak error");
  Json results = Json::array();
  for (const auto& [name, surface] : surfaces) {
    for (const int n : {10, 50, 200}) {
      if (quick && n == 200) continue;
      measure(name, surface, n, n == 10 ? 101 : n == 50 ? 21 : 9, results);
    }
  }
  fmt::print("\n{:<34} {:>4} {:>8} {:>9} {:>10} {:>11} {:>9} {:>10}\n", "map", "N", "isa", "triangles", "query us",
             "mean error", "build ms", "B/texel");
  Json queries = Json::array();
  for (const auto& [name, surface] : surfaces) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
      for (const int n : {18, 50}) measure_queries(name, Surface(surface.shared_map(), interpolation), n, queries);
    }
  }
  if (json.empty()) return 0;
  const Json document = {
      {"machine", machine_name()}, {"sigma_r", k_roughness}, {"images", results}, {"queries", queries}};
  const Status written = write_file(json, document.dump(1) + "\n");
  if (!written) fmt::print(stderr, "{}\n", written.error().message());
  return written ? 0 : 1;
}
