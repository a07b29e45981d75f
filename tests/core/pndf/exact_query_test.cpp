// Single normals of exact evaluation in single precision, held against double precision; and the normals drawn.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "tests/core/pndf/chi_square.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

constexpr double k_stated = 1e-5;  // of the roughness' own peak

struct Case {
  std::string what;
  test::MapPointer map;
  Footprint footprint;
  double roughness;
  double error = k_stated;
};

std::vector<Case> cases() {
  const test::MapPointer odd = test::rough_map(67, 130, Wrap::repeat, 0.1);
  const test::MapPointer small = test::rough_map(7, 5, Wrap::repeat, 0.1);
  const test::MapPointer clamped = test::rough_map(90, 80, Wrap::clamp, 0.1);
  return {
      {"inside", odd, isotropic_footprint({33.3, 60.1}, 3), 0.01},
      {"across the border", odd, isotropic_footprint({66.9, 129.8}, 4), 0.01},
      {"many periods away", odd, isotropic_footprint({67 * 300 + 0.2, -130 * 200 + 0.3}, 2), 0.01},
      {"larger than the map", small, isotropic_footprint({3, 3}, 6), 0.02},
      {"a hundredth of a texel", odd, isotropic_footprint({33.3, 60.1}, 0.01), 0.01, 4e-5},  // what the cut leaves out
      {"one to a hundred at 45 degrees", odd, test::turned_footprint({31, 33}, 8, 0.08, 0.785398163), 0.01},
      {"one to ten thousand at 45 degrees", odd, test::turned_footprint({31, 33}, 30, 0.003, 0.785398163), 0.01},
      {"hardly any roughness", odd, isotropic_footprint({33.3, 60.1}, 0.5), 1e-8},
      {"one to a thousand along v", odd, test::turned_footprint({31, 33}, 8, 0.008, std::numbers::pi / 2), 0.01},
      {"a rough lobe", odd, isotropic_footprint({33.3, 60.1}, 3), 0.3},
      {"a sharp lobe", odd, isotropic_footprint({33.3, 60.1}, 2), 0.0008},
      {"sharper than single precision", odd, isotropic_footprint({33.3, 60.1}, 1), 2e-5},
      {"inside a map that clamps", clamped, isotropic_footprint({45, 40}, 3), 0.01},
      {"over the border of a map that clamps", clamped, isotropic_footprint({2, 78}, 3), 0.01}};
}

// Normals that the footprint holds, some beside them and some far away.
std::vector<glm::dvec2> normals_for(const FootprintPndf& pndf, double roughness, int count) {
  RandomStream random(5, 7);
  std::vector<glm::dvec2> all;
  for (int k = 0; k < count; ++k) {
    glm::dvec2 s = pndf.sample(random);
    if (k % 4 == 1) s.x += 4 * roughness * (2 * random.next_uniform() - 1);
    if (k % 16 == 3) s = {2 * random.next_uniform() - 1, 2 * random.next_uniform() - 1};
    all.push_back(s);
  }
  return all;
}

void expect_close_to_double(const Case& c, Interpolation interpolation, int count, bool shift = false) {
  const Surface surface(c.map, interpolation);
  ExactSettings settings;
  settings.vertex_shift = shift;
  const FastExactPndf fast(surface, c.roughness, settings);
  const ExactPndf exact(surface, c.roughness, settings);
  PndfWorkspace workspace;
  PndfWorkspace other;
  const FootprintPndf& pndf = fast.at(c.footprint, workspace);
  const std::vector<glm::dvec2> s = normals_for(pndf, c.roughness, count);
  std::vector<double> values(s.size());
  std::vector<double> expected(s.size());
  pndf.evaluate(s, values);
  exact.at(c.footprint, other).evaluate(s, expected);
  const double peak = 1 / (2 * std::numbers::pi * c.roughness * c.roughness);
  for (std::size_t k = 0; k < s.size(); ++k) {
    ASSERT_TRUE(std::isfinite(values[k]) && values[k] >= 0) << c.what << ' ' << values[k];
    ASSERT_NEAR(values[k] / peak, expected[k] / peak, c.error) << c.what;
  }
  EXPECT_LE(test::relative_l1(values, expected), 1e-4) << c.what;
}

TEST(ExactQuery, IsThatOfDoublePrecisionOnTwoTriangles) {
  for (const Case& c : cases()) expect_close_to_double(c, Interpolation::linear, 32);
}

TEST(ExactQuery, IsThatOfDoublePrecisionOn32Triangles) {
  for (const Case& c : cases()) expect_close_to_double(c, Interpolation::smooth, 8);
}

TEST(ExactQuery, IsThatOfDoublePrecisionOnShiftedVertices) {
  for (const Case& c : cases()) expect_close_to_double(c, Interpolation::smooth, 8, true);
}

TEST(ExactQuery, IsTheSameForEveryInstructionSet) {
  const test::InstructionSetGuard guard;
  const std::vector<Case> all = cases();
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    for (const std::size_t k : {0U, 1U, 5U}) {
      expect_close_to_double(all[k], Interpolation::linear, 16);
      expect_close_to_double(all[k], Interpolation::smooth, 4);
      expect_close_to_double(all[k], Interpolation::smooth, 4, true);
    }
  }
}

TEST(ExactQuery, OfManyNormalsIsThatOfEach) {
  for (const std::size_t which : {1U, 4U, 11U}) {
    const Case c = cases()[which];
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
      const FastExactPndf model(Surface(c.map, interpolation), c.roughness);
      PndfWorkspace workspace;
      const FootprintPndf& pndf = model.at(c.footprint, workspace);
      const std::vector<glm::dvec2> s = normals_for(pndf, c.roughness, 20);
      std::vector<double> together(s.size());
      pndf.evaluate(s, together);
      for (std::size_t k = 0; k < s.size(); ++k) EXPECT_EQ(together[k], pndf.pdf(s[k])) << c.what;
    }
  }
}

TEST(ExactQuery, IsZeroThirtyDeviationsOut) {
  const FastExactPndf model(Surface(test::constant_map({0.1, 0.2}), Interpolation::linear), 0.01);
  EXPECT_EQ(test::density_of(model, isotropic_footprint({4, 4}, 1), {0.4, 0.2}), 0);
  EXPECT_NEAR(test::density_of(model, isotropic_footprint({4, 4}, 1), {0.1, 0.2}) * 2 * std::numbers::pi * 1e-4, 1,
              k_stated);
}

TEST(NormalBounds, HoldEveryNormalOfTheirCells) {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth, Interpolation::constant}) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
      const SurfaceCells cells(Surface(test::rough_map(70, 37, wrap), interpolation), 4, wrap == Wrap::clamp);
      const NormalBounds bounds(cells);
      CellVertices vertices;
      for (std::int64_t j = 0; j < cells.axis_v().count; ++j) {
        for (std::int64_t i = 0; i < cells.axis_u().count; ++i) {
          cells.vertices({cells.axis_u().first + i, cells.axis_v().first + j}, {{0, 1}, {0, 1}}, vertices);
          const NormalNode& tile = bounds.tile(static_cast<int>(i / 16), static_cast<int>(j / 16));
          const NormalNode& group = bounds.group(static_cast<int>(i / 64), static_cast<int>(j / 64));
          const auto block = static_cast<std::size_t>(j / 4 % 4 * 4 + i / 4 % 4);
          const auto child = static_cast<std::size_t>(j / 16 % 4 * 4 + i / 16 % 4);
          for (const glm::dvec2& n : vertices.normals) {
            const std::array<double, 4> axes{n.x, n.y, n.x + n.y, n.x - n.y};
            for (std::size_t axis = 0; axis < 4; ++axis) {
              const double value = axes[axis] / NormalBounds::k_step;
              ASSERT_TRUE(tile.lo[axis][block] <= value && value <= tile.hi[axis][block]);
              ASSERT_TRUE(group.lo[axis][child] <= value && value <= group.hi[axis][child]);
            }
          }
        }
      }
    }
  }
}

TEST(NormalBounds, TakeLittleMoreThanAByteATexel) {
  const SurfaceCells cells(Surface(test::rough_map(256, 256, Wrap::repeat), Interpolation::linear), 1, false);
  EXPECT_LE(static_cast<double>(NormalBounds::bytes_for(cells)), 1.07 * 256 * 256);
}

TEST(ExactSampling, DrawsNormalsWithTheirDensityOnTenFootprints) {
  const Surface surface(test::rough_map(64, 64, Wrap::repeat, 0.1), Interpolation::linear);
  const FastExactPndf model(surface, 0.02);
  RandomStream random(3, 3);
  for (int k = 0; k < 10; ++k) {
    const glm::dvec2 center{64 * random.next_uniform(), 64 * random.next_uniform()};
    const double large = 0.3 + 6 * random.next_uniform();
    const double small = large * (0.1 + 0.9 * random.next_uniform());
    const Footprint footprint = test::turned_footprint(center, large, small, 3 * random.next_uniform());
    PndfWorkspace workspace;
    const FootprintPndf& pndf = model.at(footprint, workspace);
    const PndfGrid grid = fitted_window(surface, footprint, 0.02, test::k_chi_square_cells);
    const PndfImage fine = test::image_of(model, footprint, test::finer(grid));
    EXPECT_LE(test::chi_square_deviate(pndf, grid, fine), 3.5) << k;
  }
}

}  // namespace
}  // namespace glint
