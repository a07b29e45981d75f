#include "core/pndf/lean_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "core/pndf/footprint_window.h"
#include "core/pndf/lean_footprint.h"
#include "core/pndf/lean_gathering.h"

namespace glint {
namespace {

constexpr double k_folded_exponent = 25;  // terms below exp(-25) are dropped
constexpr double k_most_periods = 4;
constexpr double k_turns_a_step = 32;  // multiply-adds in the time that the walk takes for a node
constexpr double k_wave_scale = 2 * std::numbers::pi * std::numbers::pi;

// A node holds point samples at the centres of its texels, which have this variance along each of its sides. The
// weights of nodes are those of a footprint narrower by it, so that what they spread over their texels has the
// footprint's.
double spread_of(std::int64_t extent) {
  const auto side = static_cast<double>(extent);
  return (side * side - 1) / 12;
}

SymmetricMatrix2 narrowed(const SymmetricMatrix2& c, std::int64_t across, std::int64_t down) {
  return {c.xx - spread_of(across), c.xy, c.yy - spread_of(down)};
}

// N(d; 0, c).
struct Bell {
  Whitening white;
  double peak;

  explicit Bell(const SymmetricMatrix2& c) : white(whitening(c)), peak(white.determinant() / (2 * std::numbers::pi)) {}
  [[nodiscard]] double operator()(glm::dvec2 d) const {
    const glm::dvec2 w = white.apply(d);
    return peak * std::exp(-0.5 * (w.x * w.x + w.y * w.y));
  }
};

// A bell at equally spaced points of a line, by two multiplications each: its second differences are constant where its
// logarithm is taken. Exponentials are taken anew before rounding adds up.
class BellRun {
 public:
  BellRun(const Bell& bell, double step)
      : bell_(bell), step_(step), bend_(std::exp(-bell.white.w11 * bell.white.w11 * step * step)) {}

  /// The next value, at `d`: one step to the right of the one before, unless restarted.
  double next(glm::dvec2 d) {
    if (left_ == 0) {
      const glm::dvec2 w = bell_.white.apply(d);
      value_ = bell_(d);
      ratio_ = std::exp(-bell_.white.w11 * step_ * (w.x + 0.5 * bell_.white.w11 * step_));
      left_ = k_length;
    } else {
      value_ *= ratio_;
      ratio_ *= bend_;
    }
    --left_;
    return value_;
  }
  void restart() { left_ = 0; }

 private:
  static constexpr int k_length = 64;

  const Bell& bell_;
  double step_;
  double bend_;
  double value_ = 0;
  double ratio_ = 0;
  int left_ = 0;
};

// The nodes of one axis of the map.
struct Axis {
  std::int64_t texels;
  std::int64_t size;

  [[nodiscard]] std::int64_t nodes() const { return (texels + size - 1) / size; }
  [[nodiscard]] std::int64_t extent(std::int64_t node) const { return std::min(size, texels - node * size); }
  /// Extent of the last node, which may be smaller.
  [[nodiscard]] std::int64_t last_extent() const { return extent(nodes() - 1); }
  /// Centre of a node, texels.
  [[nodiscard]] double center(std::int64_t node) const {
    return static_cast<double>(node * size) + 0.5 * static_cast<double>(extent(node));
  }
};

// Bells for nodes of full and of smaller extent.
class NodeBells {
 public:
  NodeBells(const SymmetricMatrix2& c, const Axis& u, const Axis& v)
      : size_(u.size),
        bells_{Bell(narrowed(c, u.size, v.size)), Bell(narrowed(c, u.last_extent(), v.size)),
               Bell(narrowed(c, u.size, v.last_extent())), Bell(narrowed(c, u.last_extent(), v.last_extent()))} {}

  [[nodiscard]] const Bell& of(std::int64_t across, std::int64_t down) const {
    return bells_[(across == size_ ? 0U : 1U) + (down == size_ ? 0U : 2U)];
  }

 private:
  std::int64_t size_;
  std::array<Bell, 4> bells_;
};

// Calls body(node, its centre) for the nodes of an axis that meet [lo, hi], period after period where it repeats.
template <class Body>
void for_nodes(const Axis& axis, bool repeats, Interval range, Body body) {
  const auto length = static_cast<double>(axis.texels);
  const auto size = static_cast<double>(axis.size);
  const double first = repeats ? std::floor(range.lo / length) : 0;
  const double last = repeats ? std::floor(range.hi / length) : 0;
  for (double period = first; period <= last; ++period) {
    const double begin = period * length;
    const double from = std::floor((range.lo - begin) / size);
    const double to = std::floor((range.hi - begin) / size);
    const auto end = static_cast<double>(axis.nodes() - 1);
    if (from > end || to < 0) continue;
    const auto last_node = static_cast<std::int64_t>(std::min(to, end));
    for (auto node = static_cast<std::int64_t>(std::max(from, 0.0)); node <= last_node; ++node) {
      body(node, begin + axis.center(node));
    }
  }
}

class Walk {
 public:
  Walk(const LeanLattice& lattice, const Footprint& footprint)
      : lattice_(lattice),
        u_{lattice.map().width(), lattice.size()},
        v_{lattice.map().height(), lattice.size()},
        center_(footprint.center),
        covariance_(footprint.covariance),
        window_(footprint.covariance) {}

  SlopeMoments repeating() {
    const NodeBells bells(covariance_, u_, v_);
    const double reach = window_.reach_y(k_lean_cut);
    for_nodes(v_, true, {center_.y - reach, center_.y + reach},
              [&](std::int64_t j, double y) { add_row(j, y, true, bells); });
    return sum_.moments();
  }

  SlopeMoments clamping() {
    const NodeBells bells(covariance_, u_, v_);
    const double reach = window_.reach_y(k_lean_cut);
    for_nodes(v_, false, {center_.y - reach, center_.y + reach}, [&](std::int64_t j, double y) {
      add_row(j, y, false, bells);
      const std::int64_t extent = v_.extent(j);
      add_ends({static_cast<double>(extent), y - center_.y, extent}, lattice_.beyond_left(j), lattice_.beyond_right(j));
    });
    const auto bottom = static_cast<double>(v_.texels);
    add_beyond(
        {center_.y - reach, 0}, [&](std::int64_t i) { return lattice_.beyond_top(i); }, 0);
    add_beyond(
        {bottom, center_.y + reach}, [&](std::int64_t i) { return lattice_.beyond_bottom(i); }, v_.texels - 1);
    return sum_.moments();
  }

  // The footprint folded into one period by Poisson's summation: F(u) = sum over k = (a / W, b / H) of
  // exp(-2 pi^2 k^T Sigma k) exp(2 pi i k (u - centre)), up to a factor.
  SlopeMoments folded();
  // What that takes a node, in steps of the walk that `repeating` is.
  [[nodiscard]] double steps_folded() const;
  [[nodiscard]] double nodes() const { return static_cast<double>(u_.nodes()) * static_cast<double>(v_.nodes()); }

 private:
  // Calls body(a, b) for the terms a >= 0 that are not dropped, by b.
  template <class Body>
  void for_terms(Body body) const;

  // What lies at one height beyond the left and right end: constant along u.
  struct Line {
    double height;
    double y;             // offset from the centre
    std::int64_t extent;  // of the nodes whose texels it holds
  };

  void add_row(std::int64_t j, double y, bool repeats, const NodeBells& bells) {
    const std::int64_t down = v_.extent(j);
    const double half = 0.5 * static_cast<double>(down);
    const double offset = y - center_.y;
    const std::optional<Interval> columns = window_.columns({offset - half, offset + half}, k_lean_cut);
    if (!columns) return;
    const bool texels = lattice_.size() == 1;
    if (texels) sum_.begin_texels();
    BellRun run(bells.of(u_.size, down), static_cast<double>(u_.size));
    for_nodes(u_, repeats, {center_.x + columns->lo, center_.x + columns->hi}, [&](std::int64_t i, double x) {
      const std::int64_t across = u_.extent(i);
      const glm::dvec2 d{x - center_.x, offset};
      if (across == u_.size) {
        const double weight = run.next(d) * static_cast<double>(across * down);
        if (texels) {
          sum_.add_texel(weight, lattice_.map().texel(i, j));
        } else {
          sum_.add(weight, lattice_.node(i, j));
        }
        return;
      }
      sum_.add(bells.of(across, down)(d) * static_cast<double>(across * down), lattice_.node(i, j));
      run.restart();
    });
    if (texels) sum_.end_texels();
  }

  void add_ends(const Line& line, const SlopeMoments& left, const SlopeMoments& right) {
    const SymmetricMatrix2 c = narrowed(covariance_, 1, line.extent);
    const double mean = c.xy / c.yy * line.y;
    const double deviation = std::sqrt(determinant(c) / c.yy);
    const double mass = line.height / std::sqrt(2 * std::numbers::pi * c.yy) * std::exp(-0.5 * line.y * line.y / c.yy);
    const auto end = static_cast<double>(u_.texels);
    sum_.add(mass * normal_cdf((0 - center_.x - mean) / deviation), left);
    sum_.add(mass * normal_cdf(-(end - center_.x - mean) / deviation), right);
  }

  // Above or below the map, by lines so near each other that the footprint changes little between them.
  template <class Border>
  void add_beyond(Interval range, Border border, std::int64_t corner_row) {
    if (!(range.lo < range.hi)) return;
    const SymmetricMatrix2& c = covariance_;
    const double deviation = std::sqrt(c.yy);
    const double drift = std::abs(c.xy) / c.yy;
    const double across = std::sqrt(determinant(c) / c.yy);
    const double widest = 0.5 * std::min(deviation, drift > 0 ? across / drift : deviation);
    const double lines = std::ceil((range.hi - range.lo) / std::max(widest, static_cast<double>(v_.size)));
    const double height = (range.hi - range.lo) / lines;
    const SlopeMoments left = lattice_.texel(0, corner_row);
    const SlopeMoments right = lattice_.texel(u_.texels - 1, corner_row);
    const Bell whole(narrowed(c, u_.size, 1));
    const Bell last(narrowed(c, u_.last_extent(), 1));
    for (double line = 0; line < lines; ++line) {
      const double y = range.lo + (line + 0.5) * height - center_.y;
      add_ends({height, y, 1}, left, right);
      const std::optional<Interval> columns = window_.columns({y - 0.5 * height, y + 0.5 * height}, k_lean_cut);
      if (!columns) continue;
      for_nodes(u_, false, {center_.x + columns->lo, center_.x + columns->hi}, [&](std::int64_t i, double x) {
        const std::int64_t extent = u_.extent(i);
        const double weight = (extent == u_.size ? whole : last)({x - center_.x, y});
        sum_.add(weight * height * static_cast<double>(extent), border(i));
      });
    }
  }

  const LeanLattice& lattice_;
  Axis u_;
  Axis v_;
  glm::dvec2 center_;
  SymmetricMatrix2 covariance_;
  FootprintWindow window_;
  LeanGathering sum_;
};

// exp(2 pi i k x) at the nodes of an axis, each narrowed by its own spread.
std::vector<std::complex<double>> node_wave(const Axis& axis, std::int64_t turns, double center) {
  const double k = static_cast<double>(turns) / static_cast<double>(axis.texels);
  const double scale = k_wave_scale * k * k;
  std::vector<std::complex<double>> wave(static_cast<std::size_t>(axis.nodes()));
  for (std::int64_t node = 0; node < axis.nodes(); ++node) {
    wave[static_cast<std::size_t>(node)] = std::polar(std::exp(scale * spread_of(axis.extent(node))),
                                                      2 * std::numbers::pi * k * (axis.center(node) - center));
  }
  return wave;
}

template <class Body>
void Walk::for_terms(Body body) const {
  const auto w = static_cast<double>(u_.texels);
  const auto h = static_cast<double>(v_.texels);
  const double det = determinant(covariance_);
  // k^T Sigma k is the squared distance in the metric whose covariance is Sigma^-1.
  const FootprintWindow ellipse({covariance_.yy / det, -covariance_.xy / det, covariance_.xx / det});
  const double cut = std::sqrt(k_folded_exponent / k_wave_scale);
  const auto most_b = static_cast<std::int64_t>(h * ellipse.reach_y(cut));
  for (std::int64_t b = -most_b; b <= most_b; ++b) {
    const double k_v = static_cast<double>(b) / h;
    const std::optional<Interval> range = ellipse.columns({k_v, k_v}, cut);
    if (!range) continue;
    for (auto a = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(w * range->lo)));
         static_cast<double>(a) <= w * range->hi; ++a) {
      body(a, b);
    }
  }
}

double Walk::steps_folded() const {
  std::set<std::int64_t> turns;
  for_terms([&](std::int64_t a, std::int64_t) { turns.insert(a); });
  return 1 + static_cast<double>(turns.size()) / k_turns_a_step;
}

SlopeMoments Walk::folded() {
  struct Term {
    double amplitude;
    const std::vector<std::complex<double>>* wave_y;
  };
  std::map<std::int64_t, std::vector<std::complex<double>>> waves_x;
  std::map<std::int64_t, std::vector<std::complex<double>>> waves_y;
  std::map<std::int64_t, std::vector<Term>> terms;  // by their turns along u, >= 0: k and -k are one real term
  for_terms([&](std::int64_t a, std::int64_t b) {
    const double k_u = static_cast<double>(a) / static_cast<double>(u_.texels);
    const double k_v = static_cast<double>(b) / static_cast<double>(v_.texels);
    const double form = covariance_.xx * k_u * k_u + 2 * covariance_.xy * k_u * k_v + covariance_.yy * k_v * k_v;
    if (!waves_x.contains(a)) waves_x.emplace(a, node_wave(u_, a, center_.x));
    if (!waves_y.contains(b)) waves_y.emplace(b, node_wave(v_, b, center_.y));
    terms[a].push_back({(a == 0 ? 1 : 2) * std::exp(-k_wave_scale * form), &waves_y.at(b)});
  });
  std::vector<double> row(static_cast<std::size_t>(u_.nodes()));
  for (std::int64_t j = 0; j < v_.nodes(); ++j) {
    std::fill(row.begin(), row.end(), 0.0);
    for (const auto& [a, of_a] : terms) {
      std::complex<double> factor = 0;
      for (const Term& term : of_a) factor += term.amplitude * (*term.wave_y)[static_cast<std::size_t>(j)];
      const std::vector<std::complex<double>>& wave = waves_x.at(a);
      for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] += factor.real() * wave[i].real() - factor.imag() * wave[i].imag();
      }
    }
    for (std::int64_t i = 0; i < u_.nodes(); ++i) {
      // Where the footprint all but vanishes rounding may leave less than nothing.
      const double weight = std::max(row[static_cast<std::size_t>(i)], 0.0);
      sum_.add(weight * static_cast<double>(u_.extent(i) * v_.extent(j)), lattice_.node(i, j));
    }
  }
  return sum_.moments();
}

}  // namespace

SlopeMoments lattice_moments(const LeanLattice& lattice, const Footprint& footprint) {
  const NormalMap& map = lattice.map();
  Walk walk(lattice, footprint);
  if (map.wrap() == Wrap::clamp) return walk.clamping();
  const double reached = std::numbers::pi * k_lean_cut * k_lean_cut * std::sqrt(determinant(footprint.covariance));
  if (!(reached > k_most_periods * map.width() * map.height())) return walk.repeating();
  // A long footprint along a diagonal has terms of as many turns as a narrow one.
  const auto size = static_cast<double>(lattice.size());
  return walk.nodes() * walk.steps_folded() < reached / (size * size) ? walk.folded() : walk.repeating();
}

}  // namespace glint
