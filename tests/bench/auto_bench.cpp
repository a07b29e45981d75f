// Auto over many maps: on random footprints, who answers, whether its estimate met the tolerance, what its error
// measures (at normals drawn from it and from exact evaluation) and how much quicker its single normals are than exact
// ones.
//
//   bench_auto [--footprints N] [--most-sigma S] [--tolerance E] MAP…

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
#include "core/pndf/auto_pndf.h"
#include "core/study/study.h"

namespace {

using namespace glint;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

constexpr double k_roughness = 0.02;
constexpr double k_least_sigma = 1;
constexpr std::size_t k_normals = 64;  // drawn from each of auto and exact

double microseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

struct Options {
  int footprints = 20;
  double most_sigma = 200;
  double tolerance = 0.01;
  std::vector<std::string> maps;
};

struct Tally {
  int footprints = 0;
  int over = 0;  // of those whose estimate met the tolerance
  int unknown = 0;
  double worst = 0;
  double own_us = 0;
  double exact_us = 0;
  double choosing_us = 0;

  void add(const Tally& other) {
    footprints += other.footprints;
    over += other.over;
    unknown += other.unknown;
    worst = std::max(worst, other.worst);
    own_us += other.own_us;
    exact_us += other.exact_us;
    choosing_us += other.choosing_us;
  }
};

Footprint random_footprint(RandomStream& random, const NormalMap& map, double most) {
  const double narrow = k_least_sigma * std::pow(most / k_least_sigma, random.next_uniform());
  const double wide = std::min(most, narrow * (1 + 2 * random.next_uniform()));
  const double angle = 3.141592653589793 * random.next_uniform();
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double a = wide * wide;
  const double b = narrow * narrow;
  return {{map.width() * random.next_uniform(), map.height() * random.next_uniform()},
          {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
}

// The reference is exact evaluation with shifted vertices: where auto answers by that too, nothing is measured but its
// estimate.
Tally measure(const AutoPndf& model, const FastExactPndf& reference, const Footprint& footprint, double tolerance,
              std::uint64_t seed) {
  Tally tally;
  tally.footprints = 1;
  const Clock::time_point choosing = Clock::now();
  const AutoChoice choice = model.choose(footprint);
  tally.choosing_us = microseconds_since(choosing);
  PndfWorkspace own_workspace;
  PndfWorkspace exact_workspace;
  const FootprintPndf& own = model.at(footprint, own_workspace);
  const FootprintPndf& exact = reference.at(footprint, exact_workspace);
  RandomStream random(seed, 1);
  std::vector<glm::dvec2> s;
  for (std::size_t k = 0; k < k_normals; ++k) s.push_back(own.sample(random));
  for (std::size_t k = 0; k < k_normals; ++k) s.push_back(exact.sample(random));
  std::vector<double> of_own(s.size());
  std::vector<double> of_exact(s.size());
  const Clock::time_point asking = Clock::now();
  own.evaluate(s, of_own);
  tally.own_us = microseconds_since(asking);
  const Clock::time_point asking_exact = Clock::now();
  exact.evaluate(s, of_exact);
  tally.exact_us = microseconds_since(asking_exact);
  double error = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const double both = of_own[k] + of_exact[k];
    if (both > 0) error += 2 * std::abs(of_own[k] - of_exact[k]) / both / static_cast<double>(s.size());
  }
  if (!choice.known) {
    tally.unknown = 1;
  } else {
    tally.worst = error;
    if (error > tolerance) {
      tally.over = 1;
      fmt::print("    over: {:.4f} against {:.4f} by {} at {:.1f}, {:.1f} sigma^2 {:.1f} {:.1f} {:.1f}\n", error,
                 choice.estimated, choice.text(), footprint.center.x, footprint.center.y, footprint.covariance.xx,
                 footprint.covariance.xy, footprint.covariance.yy);
    }
  }
  return tally;
}

void print(const std::string& name, const Tally& t, const AutoPndf::Statistics& by) {
  fmt::print("{:<36} {:>5} {:>5} {:>7} {:>8.4f} {:>5} {:>4} {:>4} {:>4} {:>4} {:>6} {:>9.1f} {:>9.1f} {:>10.2f}\n",
             name, t.footprints, t.over, t.unknown, t.worst, by.lean, by.mixture[0], by.mixture[1], by.mixture[2],
             by.mixture[3], by.exact, t.own_us / t.footprints / (2 * k_normals),
             t.exact_us / t.footprints / (2 * k_normals), t.choosing_us / t.footprints / 1000);
  std::fflush(stdout);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int k = 1; k < argc; ++k) {
    const auto value = [&](const char* flag) { return std::strcmp(argv[k], flag) == 0 && k + 1 < argc; };
    if (value("--footprints")) {
      options.footprints = std::atoi(argv[++k]);
    } else if (value("--most-sigma")) {
      options.most_sigma = std::atof(argv[++k]);
    } else if (value("--tolerance")) {
      options.tolerance = std::atof(argv[++k]);
    } else {
      options.maps.emplace_back(argv[k]);
    }
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  fmt::print("{}, sigma_r {}, tolerance {}, footprints of sigma {} to {} texels, {} normals each\n", machine_name(),
             k_roughness, options.tolerance, k_least_sigma, options.most_sigma, 2 * k_normals);
  fmt::print("{:<36} {:>5} {:>5} {:>7} {:>8} {:>5} {:>4} {:>4} {:>4} {:>4} {:>6} {:>9} {:>9} {:>10}\n", "map", "fp.",
             "over", "unknown", "worst", "LEAN", "h 2", "1", "0.5", "0.25", "exact", "auto us", "exact us",
             "choose ms");
  Tally all;
  AutoPndf::Statistics by_all;
  for (const std::string& path : options.maps) {
    JobControl control;
    Result<ReadNormalMap> read = read_normal_map(path, {}, control);
    if (!read) {
      fmt::print("{}\n", read.error().message());
      continue;
    }
    const auto map = std::make_shared<const NormalMap>(std::move(read->map));
    const Surface surface(map, map->piecewise_constant() ? Interpolation::constant : Interpolation::smooth);
    const AutoPndf model(surface, k_roughness, {options.tolerance});
    ExactSettings shifted;
    shifted.vertex_shift = surface.interpolation() == Interpolation::smooth;
    const FastExactPndf reference(surface, k_roughness, shifted);
    RandomStream random(77, 0);
    Tally tally;
    for (int k = 0; k < options.footprints; ++k) {
      const Footprint footprint = random_footprint(random, *map, options.most_sigma);
      tally.add(measure(model, reference, footprint, options.tolerance, static_cast<std::uint64_t>(k)));
    }
    const AutoPndf::Statistics by = model.statistics();
    print(path.substr(path.rfind('/') + 1), tally, by);
    all.add(tally);
    by_all.lean += by.lean;
    by_all.exact += by.exact;
    for (std::size_t k = 0; k < by.mixture.size(); ++k) by_all.mixture[k] += by.mixture[k];
  }
  if (all.footprints > 0) print("all", all, by_all);
  return 0;
}
