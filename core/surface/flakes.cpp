#include "core/surface/flakes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <numbers>
#include <optional>
#include <utility>

#include "core/surface/generator_checks.h"
#include "core/surface/slope_field.h"

namespace glint {
namespace {

constexpr int k_smallest_size = 8;
constexpr double k_most_flakes = 6e6;
constexpr double k_density = 0.7;  // of maximal Poisson disks, per radius^2

std::optional<Error> check(const FlakeSettings& settings) {
  if (auto error = check_size(settings.size, k_smallest_size, false)) return error;
  const glm::dvec2 radii = flake_radii(settings.size);
  if (auto error = check_number("radius", settings.radius, radii.x, radii.y)) return error;
  if (auto error = check_number("alpha", settings.alpha, 0, 10)) return error;
  return check_number("flat_share", settings.flat_share, 0, 1);
}

// Centres over a torus, no two nearer than the radius. Cells are so small that none holds two, and so large that what
// is within the radius of a cell lies at most k_reach cells away.
class PoissonDisk {
 public:
  PoissonDisk(int size, double radius)
      : size_(size),
        squared_radius_(radius * radius),
        side_(static_cast<int>(std::ceil(size * std::numbers::sqrt2 / radius))),
        cell_(size / static_cast<double>(side_)),
        center_in_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), k_none) {}

  // Until there is no room for another (Ebeida et al. 2012): darts are thrown at squares that are not covered yet,
  // which are then quartered. Neighbours are taken together, so that large maps keep to the caches; among them every
  // free place has the same chance.
  bool fill(RandomStream& random, JobControl& control) {
    std::vector<Square> active = all_cells();
    std::vector<Square> quarters;
    std::vector<Square> together;
    for (int level = 0; level <= k_deepest && !active.empty(); ++level) {
      quarters.clear();
      control.expect_steps((active.size() + k_together - 1) / k_together);
      for (std::size_t first = 0; first < active.size(); first += k_together) {
        if (control.cancelled()) return false;
        const std::size_t last = std::min(first + k_together, active.size());
        together.assign(active.begin() + static_cast<std::ptrdiff_t>(first),
                        active.begin() + static_cast<std::ptrdiff_t>(last));
        throw_darts(together, level, random);
        add_uncovered_quarters(together, level, quarters);
        control.finish_step();
      }
      active.swap(quarters);
    }
    return true;
  }

  [[nodiscard]] const std::vector<glm::dvec2>& centers() const { return centers_; }

  // The centre nearest to a place on the map.
  [[nodiscard]] std::size_t nearest(glm::dvec2 place) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    visit(cell_of(place.x), cell_of(place.y), [&](std::size_t center) {
      const double distance = squared_distance(place, centers_[center]);
      if (distance < least) {
        least = distance;
        found = center;
      }
      return true;
    });
    return found;
  }

 private:
  // Square (i, j) of level l has the side cell_ / 2^l.
  struct Square {
    std::int32_t i;
    std::int32_t j;
  };

  static constexpr std::size_t k_together = 4096;  // squares
  static constexpr std::int32_t k_none = -1;
  static constexpr int k_reach = 2;
  static constexpr int k_deepest = 16;    // what is left then is less than 2e-5 of a cell wide
  static constexpr double k_darts = 0.7;  // a square and level

  [[nodiscard]] int cell_of(double x) const { return std::min(static_cast<int>(x / cell_), side_ - 1); }
  [[nodiscard]] int wrapped(int k) const { return k < 0 ? k + side_ : k < side_ ? k : k - side_; }
  [[nodiscard]] std::int32_t& center_in(int i, int j) {
    return center_in_[static_cast<std::size_t>(j) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(i)];
  }
  [[nodiscard]] double along(double a, double b) const {
    const double d = std::abs(a - b);
    return std::min(d, size_ - d);
  }
  [[nodiscard]] double squared_distance(glm::dvec2 a, glm::dvec2 b) const {
    const double x = along(a.x, b.x);
    const double y = along(a.y, b.y);
    return x * x + y * y;
  }

  // Hands on the centres in the cells around one until `see` returns false; says whether it never did.
  template <class See>
  bool visit(int cell_i, int cell_j, const See& see) const {
    for (int b = -k_reach; b <= k_reach; ++b) {
      const auto row = static_cast<std::size_t>(wrapped(cell_j + b)) * static_cast<std::size_t>(side_);
      for (int a = -k_reach; a <= k_reach; ++a) {
        const std::int32_t center = center_in_[row + static_cast<std::size_t>(wrapped(cell_i + a))];
        if (center != k_none && !see(static_cast<std::size_t>(center))) return false;
      }
    }
    return true;
  }

  // Tile by tile, so that k_together in a row are neighbours, and so are their quarters.
  [[nodiscard]] std::vector<Square> all_cells() const {
    constexpr int k_tile = 64;
    static_assert(k_together == std::size_t{k_tile} * k_tile);
    std::vector<Square> cells;
    cells.reserve(center_in_.size());
    for (int top = 0; top < side_; top += k_tile) {
      for (int left = 0; left < side_; left += k_tile) {
        for (int j = top; j < std::min(top + k_tile, side_); ++j) {
          for (int i = left; i < std::min(left + k_tile, side_); ++i) cells.push_back({i, j});
        }
      }
    }
    return cells;
  }

  void throw_darts(std::vector<Square>& active, int level, RandomStream& random) {
    const double side = std::ldexp(cell_, -level);
    const auto darts = static_cast<std::size_t>(std::ceil(k_darts * static_cast<double>(active.size())));
    for (std::size_t dart = 0; dart < darts && !active.empty(); ++dart) {
      const auto drawn = static_cast<std::size_t>(random.next_uniform() * static_cast<double>(active.size()));
      const std::size_t pick = std::min(drawn, active.size() - 1);
      const Square square = active[pick];
      std::int32_t& taken_by = center_in(square.i >> level, square.j >> level);
      const double x = (square.i + random.next_uniform()) * side;
      const double y = (square.j + random.next_uniform()) * side;
      const glm::dvec2 place{x < size_ ? x : 0, y < size_ ? y : 0};
      const bool is_free = taken_by == k_none && visit(square.i >> level, square.j >> level, [&](std::size_t center) {
                             return squared_distance(place, centers_[center]) >= squared_radius_;
                           });
      if (!is_free && taken_by == k_none) continue;
      if (is_free) {
        taken_by = static_cast<std::int32_t>(centers_.size());
        centers_.push_back(place);
      }
      active[pick] = active.back();
      active.pop_back();
    }
  }

  void add_uncovered_quarters(const std::vector<Square>& active, int level, std::vector<Square>& quarters) const {
    const double half = 0.5 * std::ldexp(cell_, -level);
    for (const Square& square : active) {
      for (const auto& [a, b] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
        const Square quarter{2 * square.i + a, 2 * square.j + b};
        const glm::dvec2 middle{(quarter.i + 0.5) * half, (quarter.j + 0.5) * half};
        const bool is_open = visit(square.i >> level, square.j >> level, [&](std::size_t center) {
          const double x = along(middle.x, centers_[center].x) + 0.5 * half;  // of the farthest corner
          const double y = along(middle.y, centers_[center].y) + 0.5 * half;
          return x * x + y * y >= squared_radius_;
        });
        if (is_open) quarters.push_back(quarter);
      }
    }
  }

  double size_;
  double squared_radius_;
  int side_;  // of the map, in cells
  double cell_;
  std::vector<std::int32_t> center_in_;
  std::vector<glm::dvec2> centers_;
};

// Flake k takes the k-th numbers of every stream.
std::vector<glm::dvec2> draw_normals(const FlakeSettings& settings, std::size_t count) {
  RandomStream slopes = random_stream(settings.seed, RandomPurpose::flake_slopes);
  RandomStream flatness = random_stream(settings.seed, RandomPurpose::flake_flatness);
  std::vector<glm::dvec2> normals(count, glm::dvec2(0));
  for (glm::dvec2& normal : normals) {
    const double steepness = settings.alpha * std::sqrt(-std::log(slopes.next_uniform()));
    const double direction = 2 * std::numbers::pi * slopes.next_uniform();
    const bool flat = flatness.next_uniform() < settings.flat_share;
    if (flat || steepness <= 0) continue;  // no zero with a sign
    const double length = steepness / std::sqrt(1 + steepness * steepness);
    normal = {length * std::cos(direction), length * std::sin(direction)};
  }
  return normals;
}

Result<PoissonDisk> placed(const FlakeSettings& settings, JobControl& control) {
  RandomStream random = random_stream(settings.seed, RandomPurpose::flake_centers);
  PoissonDisk disk(settings.size, settings.radius);
  if (!disk.fill(random, control)) return cancelled_error();
  return disk;
}

Result<NormalMap> generate(const FlakeSettings& settings, JobControl& control) {
  const Result<PoissonDisk> disk = placed(settings, control);
  if (!disk) return disk.error();
  const std::vector<glm::dvec2> normals = draw_normals(settings, disk->centers().size());
  const auto n = static_cast<std::size_t>(settings.size);
  std::vector<glm::vec2> texels(n * n);
  const bool finished = for_each_row(settings.size, control, [&](int row) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t flake = disk->nearest({static_cast<double>(i) + 0.5, row + 0.5});
      texels[static_cast<std::size_t>(row) * n + i] = glm::vec2(normals[flake]);
    }
  });
  if (!finished) return cancelled_error();
  return NormalMap(settings.size, settings.size, std::move(texels), Wrap::repeat, true);
}

}  // namespace

glm::dvec2 flake_radii(int size) {
  const double least = std::max(1.0, size * std::sqrt(k_density / k_most_flakes));
  return {std::ceil(1000 * least) / 1000, size / 4.0};
}

Result<std::vector<Flake>> place_flakes(const FlakeSettings& settings, JobControl& control) {
  if (auto error = check(settings)) return *std::move(error);
  try {
    const Result<PoissonDisk> disk = placed(settings, control);
    if (!disk) return disk.error();
    const std::vector<glm::dvec2> normals = draw_normals(settings, disk->centers().size());
    std::vector<Flake> flakes(normals.size());
    for (std::size_t k = 0; k < flakes.size(); ++k) flakes[k] = {disk->centers()[k], normals[k]};
    return flakes;
  } catch (const std::bad_alloc&) {
    return memory_error(settings.size);
  }
}

Result<NormalMap> generate_flakes(const FlakeSettings& settings, JobControl& control) {
  if (auto error = check(settings)) return *std::move(error);
  try {
    return generate(settings, control);
  } catch (const std::bad_alloc&) {
    return memory_error(settings.size);
  }
}

}  // namespace glint
