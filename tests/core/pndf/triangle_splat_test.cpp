// The kernel of fast images, triangle by triangle against the double-precision kernel.

#include "core/pndf/triangle_splat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/random.h"
#include "core/pndf/footprint_window.h"
#include "core/pndf/triangle_kernel.h"
#include "tests/core/pndf/instruction_set_guard.h"

namespace glint {
namespace {

constexpr int k_cells = 24;
constexpr double k_cut = 5.6;

// One surface cell somewhere near the middle of an image whose pitch is `k` deviations.
struct Case {
  FootprintWindow window;
  OffsetBox box;
  std::array<glm::dvec2, 4> vertices;  // in cells of the image
  double k;
};

// Deviations of the footprint and changes of the normal over many orders of magnitude.
Case random_case(RandomStream& random) {
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * random.next_uniform(); };
  const double large = std::pow(10, uniform(-1.5, 3));
  const double small = large * std::pow(10, uniform(-3, 0));
  const double angle = uniform(0, std::numbers::pi);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double a = large * large;
  const double b = small * small;
  const FootprintWindow window({a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c});
  const glm::dvec2 corner{-uniform(0, 1), -uniform(0, 1)};
  const double k = uniform(0.1, 1.7);
  const double change = std::pow(10, uniform(-4, 1.8)) / k;  // of the normal over the cell, deviations
  const glm::dvec2 at{uniform(8, 16), uniform(8, 16)};
  const auto near = [&] { return at + change * glm::dvec2(uniform(-1, 1), uniform(-1, 1)); };
  std::array<glm::dvec2, 4> vertices{near(), near(), near(), near()};
  if (random.next_uniform() < 0.2) vertices[2] = 2.0 * vertices[1] - vertices[0];  // normals on one line
  return {window, {{corner.x, corner.x + 1}, {corner.y, corner.y + 1}}, vertices, k};
}

struct Outcome {
  double worst = 0;  // error in units of the triangles' scale
  double longest = 0;
  int compared = 0;
  int refused = 0;
};

// What is left out beyond the cut belongs to the model and not to the kernel.
Outcome compare(const Case& c) {
  CellVertices vertices;
  vertices.box = c.box;
  std::array<float, 4> x{};
  std::array<float, 4> y{};
  for (std::size_t v = 0; v < 4; ++v) {
    x[v] = static_cast<float>(c.vertices[v].x - 12);
    y[v] = static_cast<float>(c.vertices[v].y - 12);
    vertices.normals.push_back(c.vertices[v] * c.k);  // roughness 1
  }
  const Whitening& w = c.window.whitening();
  const auto k = static_cast<float>(c.k);
  const SplatFrame frame{static_cast<float>(w.w11),
                         static_cast<float>(w.w12),
                         static_cast<float>(w.w22),
                         k,
                         k,
                         static_cast<float>(k_cut),
                         static_cast<float>(w.determinant() / (4 * std::numbers::pi * std::numbers::pi)),
                         k_cells};
  std::vector<float> sums(static_cast<std::size_t>(SplatBand::stride_for(k_cells)) * k_cells);
  const SplatBand band(sums.data(), k_cells, 0, k_cells);
  SplatScratch scratch;
  std::vector<RefusedTriangle> refused;
  splat(frame, {static_cast<float>(c.box.x.lo), static_cast<float>(c.box.y.lo), 1, 1, 1, 1, 12, 12, x.data(), y.data()},
        band, scratch, refused);
  Outcome outcome;
  outcome.refused = static_cast<int>(refused.size());
  if (!refused.empty()) return outcome;
  std::vector<TriangleKernel> kernels;
  double scale = 0;
  for (const SurfaceTriangle& triangle : vertices.triangles(0, 0)) {
    const TriangleKernel& kernel = kernels.emplace_back(triangle, w, glm::dvec2(1));
    const WhitenedTriangle& shape = kernel.shape();
    const double between = std::hypot(shape.r12 - shape.r11, shape.r22);
    outcome.longest = std::max({outcome.longest, std::abs(shape.r11), std::hypot(shape.r12, shape.r22), between});
    const double twice_area = std::abs(shape.r11 * shape.r22);
    scale = std::max(scale, frame.scale * std::min(0.5, 2 * std::numbers::pi / twice_area));
  }
  for (int row = 0; row < k_cells; ++row) {
    for (int column = 0; column < k_cells; ++column) {
      double expected = 0;
      for (const TriangleKernel& kernel : kernels) {
        expected += kernel.density(glm::dvec2(column, row) * c.k, 8.5);
      }
      const double error = std::abs(static_cast<double>(band.row(row)[column]) - expected) / scale;
      outcome.worst = std::max(outcome.worst, error);
      if (!std::isfinite(band.row(row)[column]) || band.row(row)[column] < 0) outcome.worst = INFINITY;
      ++outcome.compared;
    }
  }
  return outcome;
}

TEST(TriangleSplat, IsWithin1e5OfTheTrianglesScaleInEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    RandomStream random(11, 0);
    double worst = 0;
    double longest = 0;
    int compared = 0;
    int refused = 0;
    for (int k = 0; k < 2000; ++k) {
      const Outcome outcome = compare(random_case(random));
      worst = std::max(worst, outcome.worst);
      if (outcome.compared > 0) longest = std::max(longest, outcome.longest);
      compared += outcome.compared;
      refused += outcome.refused;
    }
    EXPECT_LE(worst, 1e-5) << instruction_set_name(set);
    EXPECT_GT(longest, 200) << "deviations of an edge";
    EXPECT_GT(compared, 500'000) << instruction_set_name(set);
    EXPECT_GT(refused, 0) << instruction_set_name(set);
  }
}

}  // namespace
}  // namespace glint
