// ExactPndf::image: every triangle is turned into Gauss points, each splatted as a product of two 1D Gaussians.
// Triangles so long in whitened coordinates that this would need more points than cells are evaluated cell by cell
// instead.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/math/quadrature.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_image_setup.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/point_splatter.h"
#include "core/pndf/triangle_kernel.h"

namespace glint {
namespace {

constexpr std::size_t k_shares = 16;             // private sums of a band, added in order
constexpr std::size_t k_band_cells = 1U << 20U;  // so that the private sums stay below 16 x 8 MB
constexpr double k_flat_spread = 1e-4;           // normals so near each other, in deviations, are one
constexpr double k_longest_panel = 4;            // standard deviations
constexpr double k_cells_per_point = 100;        // a splatted point costs as much as …
constexpr double k_points_per_kernel = 5;        // … this share of one kernel evaluation

// Gauss points that integrate exp(-x^2 / 2) over a panel of this length to 1e-7 of its peak, wherever it lies.
int image_points(double length) {
  constexpr std::array<std::pair<double, int>, 7> k_rules = {
      {{0.02, 2}, {0.15, 3}, {0.5, 4}, {1.0, 5}, {1.7, 6}, {2.4, 7}, {3.0, 8}}};
  for (const auto& [longest, points] : k_rules) {
    if (length <= longest) return points;
  }
  return 9;
}

// The rays of a triangle: from the vertex opposite the shortest whitened edge to points of that edge.
struct RayRule {
  std::size_t apex;
  int panels_along;
  int points_along;
  int panels_across;
  int points_across;

  [[nodiscard]] double points() const {
    return static_cast<double>(panels_along) * points_along * panels_across * points_across;
  }
};

RayRule ray_rule(const WhitenedTriangle& shape) {
  const std::array<double, 3> lengths = {std::hypot(shape.r12 - shape.r11, shape.r22), std::hypot(shape.r12, shape.r22),
                                         std::abs(shape.r11)};
  const auto shortest = std::min_element(lengths.begin(), lengths.end());
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  // A triangle that needs a million panels is evaluated cell by cell anyway.
  const auto panels = [](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / k_longest_panel), 1.0, 1e6));
  };
  const int along = panels(longest);
  const int across = panels(*shortest);
  return {static_cast<std::size_t>(shortest - lengths.begin()), along, image_points(longest / along), across,
          image_points(*shortest / across)};
}

// Calls body(simplex coordinates, weight) for the points of a rule; the weights sum to 1/2.
template <class Body>
void for_points(const RayRule& rule, Body body) {
  constexpr std::array<glm::dvec2, 3> k_corners = {glm::dvec2{0, 0}, glm::dvec2{1, 0}, glm::dvec2{0, 1}};
  const glm::dvec2 apex = k_corners[rule.apex];
  const glm::dvec2 a = k_corners[(rule.apex + 1) % 3];
  const glm::dvec2 b = k_corners[(rule.apex + 2) % 3];
  const GaussRule along = gauss_legendre(rule.points_along);
  const GaussRule across = gauss_legendre(rule.points_across);
  for (int panel = 0; panel < rule.panels_across; ++panel) {
    for (std::size_t q = 0; q < across.nodes.size(); ++q) {
      const glm::dvec2 ray = a + (panel + across.nodes[q]) / rule.panels_across * (b - a) - apex;
      const double share = across.weights[q] / rule.panels_across;
      for (int part = 0; part < rule.panels_along; ++part) {
        for (std::size_t k = 0; k < along.nodes.size(); ++k) {
          const double z = (part + along.nodes[k]) / rule.panels_along;
          body(apex + z * ray, share * along.weights[k] / rule.panels_along * z);
        }
      }
    }
  }
}

class ExactImage : ExactImageSetup {
 public:
  ExactImage(const ExactPndf& model, const Footprint& footprint, const PndfGrid& grid)
      : ExactImageSetup(model, footprint, grid) {
    if (FoldedFootprint::pays(cells_.surface().map(), footprint_.covariance, cut_)) {
      folded_ = std::make_unique<FoldedFootprint>(cells_.surface().map(), footprint_, cells_.border());
    }
  }

  std::optional<PndfImage> compute(JobControl& control) const {
    PndfImage image;
    image.grid = grid_;
    image.widening = widening_;
    image.density.resize(grid_.cells());
    const int band_rows = std::max(1, static_cast<int>(k_band_cells / static_cast<std::size_t>(grid_.columns)));
    for (int first = 0; first < grid_.rows; first += band_rows) {
      if (!compute_band(first, std::min(band_rows, grid_.rows - first), image, control)) return std::nullopt;
    }
    image.error = cut_error(integral(image));
    return image;
  }

 private:
  bool compute_band(int first_row, int rows, PndfImage& image, JobControl& control) const {
    std::vector<std::unique_ptr<PointSplatter>> parts(k_shares);
    const bool done = parallel_blocks(k_shares, control, [&](std::size_t share) {
      parts[share] = std::make_unique<PointSplatter>(grid_, first_row, rows, roughness_);
      splat_share({static_cast<std::int64_t>(share), k_shares}, band_box(first_row, rows), *parts[share], control);
    });
    if (!done) return false;
    double* out = image.density.data() + grid_.index(0, first_row);
    for (const auto& part : parts) {
      const std::span<const double> sums = part->sums();
      for (std::size_t k = 0; k < sums.size(); ++k) out[k] += sums[k];
    }
    return true;
  }

  // The normals of a band's cell centres.
  [[nodiscard]] NormalBox band_box(int first_row, int rows) const {
    return {grid_.center(0, first_row + rows - 1), grid_.center(grid_.columns - 1, first_row)};
  }

  void splat_share(VisitShare share, const NormalBox& band, PointSplatter& out, JobControl& control) const {
    CellVertices vertices;
    if (folded_) {
      const auto keep = [&](const NormalBox& box) { return squared_gap(box, band) < cut_ * cut_; };
      visit_period(cells_, share, keep, [&](CellIndex cell) {
        if (control.cancelled()) return;
        cells_.vertices(cell, {{0, 1}, {0, 1}}, vertices);
        const CellPolynomial weight = folded_->over_cell(cell.i, cell.j);
        vertices.for_each_triangle([&](const SurfaceTriangle& triangle) { splat_folded(triangle, weight, out); });
      });
      return;
    }
    visit_cells(
        cells_, window_, footprint_.center, cut_, share, [&](const NormalBox& box) { return squared_gap(box, band); },
        [&](CellIndex cell, const OffsetBox& box, const NormalBox&) {
          if (control.cancelled()) return;
          cells_.vertices(cell, box, vertices);
          if (splat_flat(vertices, out)) return;
          vertices.for_each_triangle([&](const SurfaceTriangle& triangle) { splat(triangle, out); });
        });
  }

  // A cell whose normals are all but equal is one point: its share of the footprint at its mean normal. To second order
  // in the spread (in units of the roughness) nothing is lost.
  bool splat_flat(const CellVertices& vertices, PointSplatter& out) const {
    const NormalBox box = vertices.normal_box();
    const glm::dvec2 spread = (box.hi - box.lo) / roughness_;
    if (spread.x > k_flat_spread || spread.y > k_flat_spread) return false;
    const glm::dvec2 size{vertices.box.x.hi - vertices.box.x.lo, vertices.box.y.hi - vertices.box.y.lo};
    const glm::dvec2 corner{vertices.box.x.lo, vertices.box.y.lo};
    const glm::dvec2 opposite{vertices.box.x.hi, vertices.box.y.hi};
    const double squared = window_.squared_distance(vertices.box);
    double share = 0;
    for (const SurfaceTriangle& half :
         {SurfaceTriangle{corner, size.x, size.y, {}}, SurfaceTriangle{opposite, -size.x, -size.y, {}}}) {
      // Equal normals, queried where they are: the kernel is the footprint's share times the roughness' peak.
      share += TriangleKernel(half, window_.whitening(), glm::dvec2(1)).density({0, 0}, cut_);
    }
    out.add(2 * std::numbers::pi * share, 0.5 * (box.lo + box.hi), std::sqrt(std::max(0.0, cut_ * cut_ - squared)));
    return true;
  }

  void splat(const SurfaceTriangle& triangle, PointSplatter& out) const {
    const double squared_u = window_.squared_distance(triangle.offsets());
    const double room = cut_ * cut_ - squared_u;
    if (room <= 0) return;
    const TriangleKernel kernel(triangle, window_.whitening(), roughness_);
    const RayRule rule = ray_rule(kernel.shape());
    const NormalBox box = triangle.normal_box();
    const glm::dvec2 reach = std::sqrt(room) * roughness_;
    if (rule.points() > k_cells_per_point) {
      const double cells = out.count_cells(box.lo - reach, box.hi + reach);
      if (rule.points() > k_points_per_kernel * cells) {
        out.add_cells(box.lo - reach, box.hi + reach, [&](glm::dvec2 s) { return kernel.density(s, cut_); });
        return;
      }
    }
    const glm::dvec2 along_u = triangle.normals[1] - triangle.normals[0];
    const glm::dvec2 along_v = triangle.normals[2] - triangle.normals[0];
    const double scale =
        std::abs(triangle.du * triangle.dv) * window_.whitening().determinant() / (2 * std::numbers::pi);
    for_points(rule, [&](glm::dvec2 simplex, double weight) {
      const glm::dvec2 offset = triangle.corner + glm::dvec2(triangle.du * simplex.x, triangle.dv * simplex.y);
      const glm::dvec2 white = window_.whitening().apply(offset);
      const double squared = white.x * white.x + white.y * white.y;
      if (squared >= cut_ * cut_) return;
      out.add(scale * weight * std::exp(-0.5 * squared),
              triangle.normals[0] + simplex.x * along_u + simplex.y * along_v, std::sqrt(cut_ * cut_ - squared));
    });
  }

  void splat_folded(const SurfaceTriangle& triangle, const CellPolynomial& weight_of, PointSplatter& out) const {
    const TriangleKernel kernel(triangle, window_.whitening(), roughness_);
    RayRule rule = ray_rule(kernel.shape());
    rule.points_along = std::max(rule.points_along, 3);  // the folded footprint is smooth but not constant
    rule.points_across = std::max(rule.points_across, 3);
    const NormalBox box = triangle.normal_box();
    const glm::dvec2 reach = cut_ * roughness_;
    if (rule.points() > k_cells_per_point &&
        rule.points() > k_points_per_kernel * out.count_cells(box.lo - reach, box.hi + reach)) {
      out.add_cells(box.lo - reach, box.hi + reach,
                    [&](glm::dvec2 s) { return weighted_density(triangle, s, roughness_, cut_, weight_of); });
      return;
    }
    const double area = std::abs(triangle.du * triangle.dv);
    for_points(rule, [&](glm::dvec2 simplex, double weight) {
      const glm::dvec2 position = triangle.corner + glm::dvec2(triangle.du * simplex.x, triangle.dv * simplex.y);
      const glm::dvec2 normal = triangle.normals[0] + simplex.x * (triangle.normals[1] - triangle.normals[0]) +
                                simplex.y * (triangle.normals[2] - triangle.normals[0]);
      out.add(area * weight * weight_of(position), normal, cut_);
    });
  }

  std::unique_ptr<FoldedFootprint> folded_;
};

}  // namespace

std::optional<PndfImage> ExactPndf::image(const Footprint& footprint, const PndfGrid& grid, JobControl& control) const {
  return ExactImage(*this, footprint, grid).compute(control);
}

}  // namespace glint
