#include "tests/bench/six_quadratics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/pndf/cell_visit.h"
#include "core/pndf/fast_exact_pndf.h"

namespace glint::bench {
namespace {

constexpr double k_root_half_pi = 1.2533141373155003;  // sqrt(pi / 2)

// c0 + c1 z + c2 z^2 for z in [from, to].
struct Quadratic {
  double from;
  double to;
  std::array<double, 3> c;
};

// Chebyshev interpolation of erf, three pieces on either side of 0; 1 beyond 3. Largest error 6e-3.
const std::array<Quadratic, 6>& erf_pieces() {
  static const std::array<Quadratic, 6> k_pieces = [] {
    const std::array<double, 7> borders{-3, -1.7, -0.85, 0, 0.85, 1.7, 3};
    std::array<Quadratic, 6> pieces{};
    for (std::size_t k = 0; k < 6; ++k) {
      const double middle = 0.5 * (borders[k] + borders[k + 1]);
      const double half = 0.5 * (borders[k + 1] - borders[k]) * std::cos(std::numbers::pi / 6);
      const double lo = std::erf(middle - half);
      const double at = std::erf(middle);
      const double hi = std::erf(middle + half);
      const double slope = (hi - lo) / (2 * half);
      const double bend = (hi - 2 * at + lo) / (2 * half * half);
      pieces[k] = {
          borders[k], borders[k + 1], {at - slope * middle + bend * middle * middle, slope - 2 * bend * middle, bend}};
    }
    return pieces;
  }();
  return k_pieces;
}

// Integral of exp(-x^2 / 2) (d0 + d1 x + d2 x^2) over [from, to].
double gaussian_times(double from, double to, double d0, double d1, double d2) {
  const double root_half = std::numbers::sqrt2 / 2;
  const double mass = k_root_half_pi * (std::erf(to * root_half) - std::erf(from * root_half));
  const double at_from = std::exp(-0.5 * from * from);
  const double at_to = std::exp(-0.5 * to * to);
  return (d0 + d2) * mass + d1 * (at_from - at_to) + d2 * (from * at_from - to * at_to);
}

// Integral of exp(-x^2 / 2) erf(y(x) / sqrt(2)) along the edge from p to q.
double along_edge(glm::dvec2 p, glm::dvec2 q) {
  if (p.x == q.x) return 0;
  if (p.x > q.x) return -along_edge(q, p);
  const double slope = (q.y - p.y) / (q.x - p.x) * std::numbers::sqrt2 / 2;  // of z = y / sqrt(2)
  const double at_zero = p.y * std::numbers::sqrt2 / 2 - slope * p.x;
  const auto clipped = [&](double z_from, double z_to) {
    if (slope == 0) return at_zero >= z_from && at_zero < z_to ? glm::dvec2(p.x, q.x) : glm::dvec2(0);
    const double a = (z_from - at_zero) / slope;
    const double b = (z_to - at_zero) / slope;
    return glm::dvec2(std::clamp(std::min(a, b), p.x, q.x), std::clamp(std::max(a, b), p.x, q.x));
  };
  double sum = 0;
  for (const Quadratic& piece : erf_pieces()) {
    const glm::dvec2 x = clipped(piece.from, piece.to);
    if (!(x.y > x.x)) continue;
    const auto& [c0, c1, c2] = piece.c;
    sum += gaussian_times(x.x, x.y, c0 + at_zero * (c1 + c2 * at_zero), slope * (c1 + 2 * c2 * at_zero),
                          c2 * slope * slope);
  }
  const glm::dvec2 below = clipped(-1e300, -3);
  if (below.y > below.x) sum += gaussian_times(below.x, below.y, -1, 0, 0);
  const glm::dvec2 above = clipped(3, 1e300);
  if (above.y > above.x) sum += gaussian_times(above.x, above.y, 1, 0, 0);
  return sum;
}

// A triangle whose QR is done, for many normals.
struct Prepared {
  std::array<double, 4> q;  // unit vectors that span it
  std::array<double, 4> p;
  double r11, r12, r22;
  std::array<double, 2> corner;  // whitened offset of the right angle
  glm::dvec2 normal;
  double factor;
};

double dot(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Prepared prepare(const SurfaceTriangle& t, const Whitening& w, double roughness) {
  const auto column = [&](glm::dvec2 leg, glm::dvec2 normal) {
    const glm::dvec2 white = w.apply(leg);
    const glm::dvec2 change = (normal - t.normals[0]) / roughness;
    return std::array<double, 4>{white.x, white.y, change.x, change.y};
  };
  Prepared out{column({t.du, 0}, t.normals[1]), column({0, t.dv}, t.normals[2]), 0, 0, 0, {}, t.normals[0], 0};
  out.r11 = std::sqrt(dot(out.q, out.q));
  for (double& x : out.q) x /= out.r11;
  out.r12 = dot(out.q, out.p);
  for (std::size_t k = 0; k < 4; ++k) out.p[k] -= out.r12 * out.q[k];
  out.r22 = std::sqrt(dot(out.p, out.p));
  for (double& x : out.p) x /= out.r22;
  const glm::dvec2 corner = w.apply(t.corner);
  out.corner = {corner.x, corner.y};
  out.factor =
      std::abs(t.du * t.dv) * w.determinant() / (4 * std::numbers::pi * std::numbers::pi * roughness * roughness);
  return out;
}

double density(const Prepared& t, glm::dvec2 s, double roughness, double cut) {
  const glm::dvec2 change = (t.normal - s) / roughness;
  const std::array<double, 4> f{t.corner[0], t.corner[1], change.x, change.y};
  const double x = dot(t.q, f);
  const double y = dot(t.p, f);
  const double residual = dot(f, f) - x * x - y * y;
  if (residual >= cut * cut) return 0;
  return t.factor * std::exp(-0.5 * residual) * six_quadratics_over_simplex({{x, y}, t.r11, t.r12, t.r22});
}

}  // namespace

double six_quadratics_over_simplex(const WhitenedTriangle& t) {
  const glm::dvec2 b = t.w0 + glm::dvec2(t.r11, 0);
  const glm::dvec2 c = t.w0 + glm::dvec2(t.r12, t.r22);
  const double around = along_edge(t.w0, b) + along_edge(b, c) + along_edge(c, t.w0);
  return std::max(0.0, -k_root_half_pi * around / (t.r11 * t.r22));
}

PndfImage six_quadratics_image(const ExactPndf& model, const Footprint& footprint, const PndfGrid& grid) {
  const SurfaceCells& cells = model.cells();
  const double roughness = model.intrinsic_roughness();
  const double cut = FastExactPndf::k_image_cut;
  const Footprint reduced{reduced_center(cells.surface().map(), footprint.center), footprint.covariance};
  const FootprintWindow window(reduced.covariance);
  PndfImage image;
  image.grid = grid;
  image.density.assign(grid.cells(), 0);
  CellVertices vertices;
  const auto everywhere = [](const NormalBox&) { return 0.0; };
  visit_cells(cells, window, reduced.center, cut, {}, everywhere,
              [&](CellIndex cell, const OffsetBox& box, const NormalBox&) {
                cells.vertices(cell, box, vertices);
                vertices.for_each_triangle([&](const SurfaceTriangle& triangle) {
                  const double room = cut * cut - window.squared_distance(triangle.offsets());
                  if (room <= 0) return;
                  const double reach = std::sqrt(room) * roughness;
                  const NormalBox normals = triangle.normal_box();
                  const Prepared prepared = prepare(triangle, window.whitening(), roughness);
                  const auto column = [&](double s) {
                    return static_cast<int>(std::clamp((s - grid.s_min) / grid.pitch().x, 0.0, grid.columns - 1.0));
                  };
                  const auto row = [&](double t) {
                    return static_cast<int>(std::clamp((grid.t_max - t) / grid.pitch().y, 0.0, grid.rows - 1.0));
                  };
                  for (int r = row(normals.hi.y + reach); r <= row(normals.lo.y - reach); ++r) {
                    for (int c = column(normals.lo.x - reach); c <= column(normals.hi.x + reach); ++c) {
                      image.density[grid.index(c, r)] += density(prepared, grid.center(c, r), roughness, cut);
                    }
                  }
                });
              });
  return image;
}

}  // namespace glint::bench
