// FastExactPndf::image: the cells of the surface are listed with the image rows that they can reach; the rows are cut
// into bands of about equal work; then each band adds up the triangles of each group of cells in one fixed order, so
// that results do not depend on the number of threads.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_image_setup.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/triangle_kernel.h"
#include "core/pndf/triangle_splat.h"

namespace glint {
namespace {

constexpr std::int64_t k_shares = 16;  // of the walk over the cells
constexpr double k_slab_cells =
    1U << 20U;                   // so that their lists stay below some 50 MB, if the footprint is not all but a line
constexpr int k_bands = 2;       // a triangle is prepared anew for each band that it reaches
constexpr int k_least_rows = 8;  // of a band
constexpr std::size_t k_group_cells = 1500;  // work for more threads than there are bands
constexpr std::size_t k_most_groups = 16;
constexpr std::size_t k_part_cells = 1U << 22U;  // of all groups' private images together
constexpr int k_most_triangles = 8192;  // added up in single precision, in which small terms are lost in large sums

struct ListedCell {
  CellIndex cell;
  int first_row;
  int last_row;
};

class FastExactImage : ExactImageSetup {
 public:
  FastExactImage(const ExactPndf& model, const Footprint& footprint, const PndfGrid& grid)
      : ExactImageSetup(model, footprint, grid), stride_(SplatBand::stride_for(grid.columns)) {
    const Whitening& w = window_.whitening();
    const glm::dvec2 k = grid_.pitch() / roughness_;
    frame_ = {
        static_cast<float>(w.w11),
        static_cast<float>(w.w12),
        static_cast<float>(w.w22),
        static_cast<float>(k.x),
        static_cast<float>(k.y),
        static_cast<float>(cut_),
        static_cast<float>(w.determinant() / (4 * std::numbers::pi * std::numbers::pi * roughness_.x * roughness_.y)),
        grid_.columns};
  }

  std::optional<PndfImage> compute(JobControl& control) const {
    // No more than there are where the map does not repeat.
    const auto reached = [](const SurfaceCells::Axis& axis, double reach) {
      return axis.periodic ? 2 * reach + 1 : std::min(2 * reach + 1, static_cast<double>(axis.count));
    };
    const double cells =
        reached(cells_.axis_u(), window_.reach_x(cut_)) * reached(cells_.axis_v(), window_.reach_y(cut_));
    const auto slabs = static_cast<std::int64_t>(std::clamp(std::ceil(cells / k_slab_cells), 1.0, 1e6));
    PndfImage image;
    image.grid = grid_;
    image.widening = widening_;
    image.density.resize(grid_.cells());
    double held = 0;
    for (std::int64_t slab = 0; slab < slabs; ++slab) {
      const std::optional<double> added = add_slab({slab, slabs}, image, control);
      if (!added) return std::nullopt;
      held += *added * grid_.cell_area();
    }
    image.error = cut_error(held);  // several times what single precision adds
    return image;
  }

 private:
  // The sum of what was added; nothing if cancelled.
  std::optional<double> add_slab(VisitShare slab, PndfImage& image, JobControl& control) const {
    std::vector<std::vector<ListedCell>> shares(static_cast<std::size_t>(k_shares));
    if (!parallel_blocks(shares.size(), control, [&](std::size_t share) {
          const auto first = slab.first * k_shares + static_cast<std::int64_t>(share);
          list_cells({first, slab.stride * k_shares}, shares[share], control);
        })) {
      return std::nullopt;
    }
    std::vector<ListedCell> cells;
    for (std::vector<ListedCell>& share : shares) {
      cells.insert(cells.end(), share.begin(), share.end());
      std::vector<ListedCell>().swap(share);
    }
    if (cells.empty()) return 0.0;
    const std::vector<int> borders = band_borders(cells);
    const std::size_t bands = borders.size() - 1;
    const std::size_t most_groups = std::clamp<std::size_t>(k_part_cells / grid_.cells(), 1, k_most_groups);
    const std::size_t groups = std::clamp<std::size_t>(cells.size() / k_group_cells, 1, most_groups);

    std::vector<std::vector<double>> parts(groups * bands);  // by group, then band
    if (!parallel_blocks(parts.size(), control, [&](std::size_t task) {
          const std::size_t band = task % bands;
          const std::size_t group = task / bands;
          const std::size_t begin = cells.size() * group / groups;
          const std::size_t end = cells.size() * (group + 1) / groups;
          const int rows = borders[band + 1] - borders[band];
          parts[task].resize(static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(rows));
          splat_band(std::span(cells).subspan(begin, end - begin), borders[band], rows, parts[task], control);
        })) {
      return std::nullopt;
    }
    double total = 0;
    for (std::size_t task = 0; task < parts.size(); ++task) {
      const std::size_t band = task % bands;
      total += add_part(parts[task], borders[band], image);
    }
    return total;
  }

  double add_part(const std::vector<double>& part, int first_row, PndfImage& image) const {
    double* to = image.density.data() + grid_.index(0, first_row);
    for (std::size_t k = 0; k < part.size(); ++k) to[k] += part[k];
    return std::accumulate(part.begin(), part.end(), 0.0);
  }

  void list_cells(VisitShare share, std::vector<ListedCell>& list, JobControl& control) const {
    const double limit = cut_ * cut_;
    const NormalBox seen{{grid_.s_min, grid_.t_min}, {grid_.s_max, grid_.t_max}};
    visit_cells(
        cells_, window_, footprint_.center, cut_, share, [&](const NormalBox& box) { return squared_gap(box, seen); },
        [&](CellIndex cell, const OffsetBox& box, const NormalBox& normals) {
          if (control.cancelled()) return;
          const double reach = std::sqrt(limit - window_.squared_distance(box)) * roughness_.y;
          const auto row_at = [&](double t) {
            return static_cast<int>(std::clamp((grid_.t_max - t) / grid_.pitch().y - 0.5, 0.0, grid_.rows - 1.0));
          };
          list.push_back({cell, row_at(normals.hi.y + reach), row_at(normals.lo.y - reach)});
        });
  }

  // The first rows of the bands, and the end of the last: about the same number of rows of cells in each.
  [[nodiscard]] std::vector<int> band_borders(const std::vector<ListedCell>& cells) const {
    std::vector<std::int64_t> begins(static_cast<std::size_t>(grid_.rows) + 1);  // how many more cells reach this row
    std::int64_t all = 0;
    for (const ListedCell& cell : cells) {
      ++begins[static_cast<std::size_t>(cell.first_row)];
      --begins[static_cast<std::size_t>(cell.last_row) + 1];
      all += cell.last_row - cell.first_row + 1;
    }
    std::vector<int> borders{0};
    std::int64_t here = 0;
    std::int64_t sum = 0;
    for (int row = 0; row < grid_.rows; ++row) {
      here += begins[static_cast<std::size_t>(row)];
      sum += here;
      const auto wanted = static_cast<std::int64_t>(borders.size()) * all / k_bands;
      const bool tall = row + 1 - borders.back() >= k_least_rows && grid_.rows - row - 1 >= k_least_rows;
      if (tall && sum >= wanted && static_cast<int>(borders.size()) < k_bands) borders.push_back(row + 1);
    }
    borders.push_back(grid_.rows);
    return borders;
  }

  void splat_band(std::span<const ListedCell> cells, int first_row, int rows, std::vector<double>& out,
                  JobControl& control) const {
    const FlushToZero quick;
    const double reach_u = window_.reach_x(cut_);
    const double reach_v = window_.reach_y(cut_);
    std::vector<float> sums(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows));
    const SplatBand band(sums.data(), grid_.columns, first_row, rows);
    SplatScratch scratch;
    CellVertices vertices;
    std::vector<float> x;
    std::vector<float> y;
    std::vector<RefusedTriangle> refused;
    int triangles = 0;
    for (const ListedCell& listed : cells) {
      if (listed.last_row < first_row || listed.first_row >= first_row + rows) continue;
      if (control.cancelled()) return;
      const OffsetBox box{cells_.column_span(listed.cell.i, footprint_.center.x, reach_u),
                          cells_.row_span(listed.cell.j, footprint_.center.y, reach_v)};
      cells_.vertices(listed.cell, box, vertices);
      splat(frame_, to_grid(vertices, x, y), band, scratch, refused);
      for (const RefusedTriangle& triangle : refused) add_in_double(vertices, triangle, band);
      refused.clear();
      triangles += 2 * vertices.columns * vertices.rows;
      if (triangles >= k_most_triangles) {
        move_sums(band, out);
        triangles = 0;
      }
    }
    move_sums(band, out);
  }

  void move_sums(const SplatBand& band, std::vector<double>& out) const {
    for (int row = 0; row < band.rows(); ++row) {
      double* to = out.data() + static_cast<std::ptrdiff_t>(row) * grid_.columns;
      float* from = band.row(row);
      for (int column = 0; column < grid_.columns; ++column) to[column] += from[column];
      std::fill(from, from + grid_.columns, 0.0F);
    }
  }

  // The vertices in cells of the image, from an origin near them.
  [[nodiscard]] SplatCell to_grid(const CellVertices& vertices, std::vector<float>& x, std::vector<float>& y) const {
    const glm::dvec2 pitch = grid_.pitch();
    const auto column_of = [&](double s) { return (s - grid_.s_min) / pitch.x - 0.5; };
    const auto row_of = [&](double t) { return (grid_.t_max - t) / pitch.y - 0.5; };
    const double origin_column = std::floor(std::clamp(column_of(vertices.normals[0].x), 0.0, grid_.columns - 1.0));
    const double origin_row = std::floor(std::clamp(row_of(vertices.normals[0].y), 0.0, grid_.rows - 1.0));
    x.clear();
    y.clear();
    for (const glm::dvec2& normal : vertices.normals) {
      x.push_back(static_cast<float>(column_of(normal.x) - origin_column));
      y.push_back(static_cast<float>(row_of(normal.y) - origin_row));
    }
    return {static_cast<float>(vertices.box.x.lo),
            static_cast<float>(vertices.box.y.lo),
            static_cast<float>((vertices.box.x.hi - vertices.box.x.lo) / vertices.columns),
            static_cast<float>((vertices.box.y.hi - vertices.box.y.lo) / vertices.rows),
            vertices.columns,
            vertices.rows,
            static_cast<int>(origin_column),
            static_cast<int>(origin_row),
            x.data(),
            y.data()};
  }

  void add_in_double(const CellVertices& vertices, const RefusedTriangle& which, const SplatBand& band) const {
    const SurfaceTriangle triangle = vertices.triangles(which.column, which.row)[static_cast<std::size_t>(which.half)];
    const double room = cut_ * cut_ - window_.squared_distance(triangle.offsets());
    if (room <= 0) return;
    const TriangleKernel kernel(triangle, window_.whitening(), roughness_);
    const NormalBox box = triangle.normal_box();
    const glm::dvec2 reach = std::sqrt(room) * roughness_;
    const glm::dvec2 pitch = grid_.pitch();
    const auto column_at = [&](double s) {
      return static_cast<int>(std::clamp((s - grid_.s_min) / pitch.x, 0.0, grid_.columns - 1.0));
    };
    const auto row_at = [&](double t) {
      const double last = band.first_row() + band.rows() - 1.0;
      return static_cast<int>(std::clamp((grid_.t_max - t) / pitch.y, static_cast<double>(band.first_row()), last));
    };
    const int last_row = row_at(box.lo.y - reach.y);
    const int last_column = column_at(box.hi.x + reach.x);
    for (int row = row_at(box.hi.y + reach.y); row <= last_row; ++row) {
      float* sums = band.row(row - band.first_row());
      for (int column = column_at(box.lo.x - reach.x); column <= last_column; ++column) {
        sums[column] += static_cast<float>(kernel.density(grid_.center(column, row), cut_));
      }
    }
  }

  SplatFrame frame_{};
  int stride_;
};

}  // namespace

std::optional<PndfImage> FastExactPndf::image(const Footprint& footprint, const PndfGrid& grid,
                                              JobControl& control) const {
  if (!suits_single_precision(FootprintWindow(footprint.covariance), exact_.image_cut()) ||
      FoldedFootprint::pays(exact_.cells().surface().map(), footprint.covariance, exact_.image_cut())) {
    return exact_.image(footprint, grid, control);
  }
  return FastExactImage(exact_, footprint, grid).compute(control);
}

}  // namespace glint
