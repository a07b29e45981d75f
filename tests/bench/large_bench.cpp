// Large footprints of the mixture: the atlas against the direct method and its bound on random footprints, merging on
// near-flat maps, and the time from a map in memory to a first answer. One thread unless said otherwise.
//
//   bench_large [--footprints N] [MAP…]      (maps that are merged besides the generated ones)

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/image/normal_map_reader.h"
#include "core/math/random.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/mixture_atlas.h"
#include "core/pndf/mixture_pndf.h"
#include "core/study/error_metrics.h"
#include "core/study/reference.h"
#include "core/study/study.h"
#include "core/surface/noise.h"
#include "core/surface/scratches.h"

namespace {

using namespace glint;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class Body>
double median_ms(int runs, Body body) {
  std::vector<double> times;
  for (int k = 0; k <= runs; ++k) {  // the first is warm-up
    const Clock::time_point begin = Clock::now();
    body();
    if (k > 0) times.push_back(milliseconds_since(begin));
  }
  return median(times);
}

Surface noise_surface() {
  JobControl control;
  return {std::make_shared<const NormalMap>(std::move(*generate_noise({}, control))), Interpolation::smooth};
}

void measure_atlas(const Surface& surface) {
  fmt::print(
      "\natlas, h 0.5, 256 x 256 cells of [-1, 1]^2; errors against the smooth surface where N = 100, else\n"
      "against the direct mixture; built on all threads, looked up on one\n");
  fmt::print("{:>5} {:>9} {:>7} {:>7} {:>9} {:>10} {:>10} {:>10} {:>10}\n", "N", "build ms", "blocks", "MB", "image ms",
             "direct ms", "rel. L1", "bound", "energy");
  for (const int n : {100, 200, 400, 600, 1000, 2000, 6000}) {
    const Footprint footprint = isotropic_footprint({512.5, 512.5}, n / 6.0);
    JobControl control;
    MixtureAtlas atlas(surface, 0.005, {}, PndfGrid{});
    const Clock::time_point begin = Clock::now();
    if (!atlas.build(footprint, control)) continue;
    const double build = milliseconds_since(begin);
    const ThreadLimit one(1);
    PndfImage image;
    const double looked_up = median_ms(50, [&] { image = *atlas.image(footprint); });
    double direct_ms = 0;
    PndfImage reference;
    const bool exact_does_it = n == 2000;  // of 0.3 periods: the direct method is the exact one, which takes minutes
    if (!exact_does_it) {
      const MixturePndf mixture(surface, 0.005);
      direct_ms = median_ms(1, [&] { reference = *mixture.image(footprint, PndfGrid{}, control); });
    }
    if (n == 100) {
      reference = reference_image(surface, 0.005, footprint, PndfGrid{}, CellContent::point, control)->image;
    }
    const PndfErrors errors = exact_does_it ? PndfErrors{} : compare(image, reference);
    fmt::print("{:>5} {:>9.1f} {:>7} {:>7.1f} {:>9.3f} {:>10.1f} {:>10.2e} {:>10.2e} {:>10.1e}\n", n, build,
               atlas.blocks(), static_cast<double>(atlas.bytes()) / 1e6, looked_up, direct_ms, errors.relative_l1,
               image.error.bounded, errors.energy_error);
    std::fflush(stdout);
  }
}

// The bound on the footprint's part against the measured distance from the direct mixture, whose elements are the same.
void check_bounds(const Surface& surface, int footprints) {
  RandomStream random(13, 0);
  MixtureAtlas atlas(surface, 0.02, {}, PndfGrid{-1, 1, -1, 1, 64, 64});
  MixtureSettings apart;
  apart.merge_bound = 0;
  const MixturePndf mixture(surface, 0.02, apart);
  int violated = 0;
  double largest_ratio = 0;
  double largest_bound = 0;
  for (int k = 0; k < footprints; ++k) {
    const double narrow = 16 + 44 * random.next_uniform();
    const double wide = narrow * (1 + random.next_uniform());
    const double angle = 3.14159 * random.next_uniform();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double a = wide * wide;
    const double b = narrow * narrow;
    const Footprint footprint{{1024 * random.next_uniform(), 1024 * random.next_uniform()},
                              {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
    JobControl control;
    if (!atlas.build(footprint, control)) continue;
    PndfImage image = *atlas.image(footprint);
    PndfImage direct = *mixture.image(footprint, {-1, 1, -1, 1, 64, 64}, control);
    // What the direct method's joint cut moves is none of the atlas's: both to unit mass.
    for (PndfImage* one : {&image, &direct}) {
      const double whole = integral(*one);
      for (double& density : one->density) density /= whole;
    }
    const double distance = compare(image, direct).relative_l1;
    if (distance > image.error.bounded) ++violated;
    largest_ratio = std::max(largest_ratio, distance / image.error.bounded);
    largest_bound = std::max(largest_bound, image.error.bounded);
  }
  fmt::print(
      "\nbound of the atlas on {} random footprints of sigma 16 to 120: violated {} times, the distance is at most "
      "{:.2f} of it, the bound at most {:.2e}\n",
      footprints, violated, largest_ratio, largest_bound);
}

void measure_merging(const std::string& name, const Surface& surface) {
  for (const double roughness : {0.005, 0.02, 0.05}) {
    for (const int n : {50, 200}) {
      const Footprint footprint =
          isotropic_footprint({0.4 * surface.map().width(), 0.45 * surface.map().height()}, n / 6.0);
      const PndfGrid grid = fitted_window(surface, footprint, roughness, 256);
      MixtureSettings apart;
      apart.merge_bound = 0;
      const MixturePndf whole(surface, roughness, apart);
      const MixturePndf merging(surface, roughness);
      JobControl control;
      const ThreadLimit one(1);
      PndfImage all;
      PndfImage merged;
      const double whole_ms = median_ms(3, [&] { all = *whole.image(footprint, grid, control); });
      const double merged_ms = median_ms(3, [&] { merged = *merging.image(footprint, grid, control); });
      fmt::print("{:<32} {:>7} {:>5} {:>9.2f} {:>9.2f} {:>6.1f} {:>10.1e} {:>10.1e}\n", name, roughness, n, whole_ms,
                 merged_ms, whole_ms / merged_ms, compare(merged, all).relative_l1, merged.error.bounded);
      std::fflush(stdout);
    }
  }
}

// From a map in memory to a first picture and a first single normal.
void measure_readiness() {
  JobControl control;
  NoiseSettings settings;
  settings.size = 2048;
  const auto map = std::make_shared<const NormalMap>(std::move(*generate_noise(settings, control)));
  const Surface surface(map, Interpolation::smooth);
  const Footprint footprint = isotropic_footprint({1000, 1000}, 3);
  const Clock::time_point begin = Clock::now();
  const MixturePndf mixture(surface, 0.005);
  PndfWorkspace workspace;
  const FootprintPndf& pndf = mixture.at(footprint, workspace);
  RandomStream random(1, 0);
  const double density = pndf.pdf(pndf.sample(random));
  const double first_ms = milliseconds_since(begin);
  fmt::print(
      "\n2048 x 2048 map: model and first normal (D = {:.3g}) {:.2f} ms after it is in memory; {:.3f} bytes held "
      "for each byte of the map\n",
      density, first_ms, static_cast<double>(mixture.info().bytes + map->bytes()) / static_cast<double>(map->bytes()));
}

}  // namespace

int main(int argc, char** argv) {
  int footprints = 1000;
  std::vector<std::string> maps;
  for (int k = 1; k < argc; ++k) {
    if (std::strcmp(argv[k], "--footprints") == 0 && k + 1 < argc) {
      footprints = std::atoi(argv[++k]);
    } else {
      maps.emplace_back(argv[k]);
    }
  }
  fmt::print("{}\n", machine_name());
  const Surface noise = noise_surface();
  measure_readiness();
  measure_atlas(noise);
  fmt::print("\nmerging (5e-3 a tile), 256 x 256 cells of the fitted window, one thread\n");
  fmt::print("{:<32} {:>7} {:>5} {:>9} {:>9} {:>6} {:>10} {:>10}\n", "map", "sigma_r", "N", "apart ms", "merged ms",
             "times", "moved", "bound");
  JobControl control;
  ScratchSettings few;
  few.count = 40;
  few.dent_rms_slope = 0;
  measure_merging(
      "40 scratches, flat between",
      {std::make_shared<const NormalMap>(std::move(*generate_scratches(few, control))), Interpolation::smooth});
  measure_merging("isotropic noise", noise);
  for (const std::string& path : maps) {
    Result<ReadNormalMap> read = read_normal_map(path, {}, control);
    if (!read) {
      fmt::print("{}\n", read.error().message());
      continue;
    }
    measure_merging(path.substr(path.rfind('/') + 1),
                    {std::make_shared<const NormalMap>(std::move(read->map)), Interpolation::smooth});
  }
  check_bounds(noise, footprints);
  return 0;
}
