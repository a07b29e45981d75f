#include "viewers/pndf/pndf_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glint::view {
namespace {

// Index of the cell that holds s, if it lies in the window.
std::optional<std::size_t> index_at(const PndfGrid& grid, glm::dvec2 s) {
  const std::optional<glm::ivec2> cell = grid.cell_at(s);
  return cell ? std::optional(grid.index(cell->x, cell->y)) : std::nullopt;
}

double block_mean(const PndfGrid& grid, std::span<const double> cells, glm::ivec2 first, int side) {
  const int right = std::min(first.x + side, grid.columns);
  const int bottom = std::min(first.y + side, grid.rows);
  double sum = 0;
  for (int row = first.y; row < bottom; ++row) {
    for (int column = first.x; column < right; ++column) sum += cells[grid.index(column, row)];
  }
  return sum / ((right - first.x) * (bottom - first.y));
}

Texture value_texture(const GlFunctions& gl, const PndfGrid& grid, std::span<const double> cells) {
  const Texels texels = reduced_texels(grid, cells);
  return {gl, Texture::Format::value, texels.size, texels.values.data()};
}

}  // namespace

Texels reduced_texels(const PndfGrid& grid, std::span<const double> cells, int most) {
  const int side = (std::max(grid.columns, grid.rows) + most - 1) / most;
  Texels texels;
  texels.size = {(grid.columns + side - 1) / side, (grid.rows + side - 1) / side};
  texels.values.reserve(static_cast<std::size_t>(texels.size.x) * static_cast<std::size_t>(texels.size.y));
  if (side == 1) {
    for (const double value : cells) texels.values.push_back(static_cast<float>(value));
    return texels;
  }
  for (int y = 0; y < texels.size.y; ++y) {
    for (int x = 0; x < texels.size.x; ++x) {
      texels.values.push_back(static_cast<float>(block_mean(grid, cells, {x * side, y * side}, side)));
    }
  }
  return texels;
}

std::optional<CellReading> read_cell(const PndfImage& image, glm::dvec2 s) {
  const std::optional<std::size_t> cell = index_at(image.grid, s);
  if (!cell) return std::nullopt;
  CellReading reading{image.density[*cell], std::nullopt};
  if (!image.standard_error.empty()) reading.standard_error = image.standard_error[*cell];
  return reading;
}

double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) {
    const double size = std::abs(value);
    if (size > largest && std::isfinite(size)) largest = size;
  }
  return largest;
}

std::optional<DifferenceImage> difference_of(const PndfImage& image, const PndfImage& reference) {
  if (!(image.grid == reference.grid)) return std::nullopt;
  DifferenceImage difference{image.grid, {}, 0};
  difference.values.resize(image.density.size());
  std::transform(image.density.begin(), image.density.end(), reference.density.begin(), difference.values.begin(),
                 [](double a, double b) { return a - b; });
  difference.largest = largest_magnitude(difference.values);
  return difference;
}

std::optional<double> difference_at(const DifferenceImage& difference, glm::dvec2 s) {
  const std::optional<std::size_t> cell = index_at(difference.grid, s);
  if (!cell) return std::nullopt;
  return difference.values[*cell];
}

const ShownImage& PndfPictures::shown(const GlFunctions& gl, const ImagePointer& image) {
  const auto same = [&](const Kept<ShownImage>& kept) { return kept.shown->image == image; };
  const auto known = std::find_if(images_.begin(), images_.end(), same);
  if (known != images_.end()) {
    known->used = true;
    return *known->shown;
  }
  images_.push_back({std::make_unique<ShownImage>(image, value_texture(gl, image->grid, image->density),
                                                  largest_magnitude(image->density), integral(*image)),
                     true});
  return *images_.back().shown;
}

const ShownDifference* PndfPictures::shown_difference(const GlFunctions& gl, const ImagePointer& image,
                                                      const ImagePointer& reference) {
  const auto same = [&](const Kept<ShownDifference>& kept) {
    return kept.shown->image == image && kept.shown->reference == reference;
  };
  const auto known = std::find_if(differences_.begin(), differences_.end(), same);
  if (known != differences_.end()) {
    known->used = true;
    return known->shown.get();
  }
  std::optional<DifferenceImage> difference = difference_of(*image, *reference);
  if (!difference) return nullptr;
  Texture texture = value_texture(gl, difference->grid, difference->values);
  differences_.push_back(
      {std::make_unique<ShownDifference>(image, reference, *std::move(difference), std::move(texture)), true});
  return differences_.back().shown.get();
}

void PndfPictures::forget_unused() {
  const auto sweep = [](auto& all) {
    std::erase_if(all, [](const auto& kept) { return !kept.used; });
    for (auto& kept : all) kept.used = false;
  };
  sweep(images_);
  sweep(differences_);
}

std::pair<PndfMethod, PndfMethod> difference_pair(const std::vector<PndfMethod>& methods) {
  const bool has_exact = std::find(methods.begin(), methods.end(), PndfMethod::exact) != methods.end();
  if (!has_exact) return {methods[1], methods[0]};
  const auto other = std::find_if(methods.begin(), methods.end(), [](PndfMethod m) { return m != PndfMethod::exact; });
  return {*other, PndfMethod::exact};
}

}  // namespace glint::view
