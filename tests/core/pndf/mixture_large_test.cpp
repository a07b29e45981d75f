// Large footprints of the mixture: merged elements, spline windows and the atlas, each against what it stands for.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/math/gaussian.h"
#include "core/pndf/exact_pndf.h"
#include "core/pndf/fitted_window.h"
#include "core/pndf/mixture_atlas.h"
#include "core/pndf/mixture_merge.h"
#include "core/pndf/mixture_pndf.h"
#include "core/pndf/spline_footprint.h"
#include "tests/core/pndf/instruction_set_guard.h"
#include "tests/core/pndf/test_maps.h"

namespace glint {
namespace {

// A flat panel with a groove every 32 texels and a machining noise far below the roughness.
test::MapPointer machined_panel(int size) {
  RandomStream random(3, 0);
  return test::map_of(size, size, Wrap::repeat, [&](int i, int) {
    const double groove = i % 32 < 3 ? 0.15 * (i % 32 - 1) : 0;
    return glm::dvec2(0.1 + groove + 1e-5 * random.next_uniform(), -0.05);
  });
}

// --- merging

// The density of one element at s.
double density_at(const ElementList& e, std::size_t k, glm::dvec2 s) {
  const double x = s.x - static_cast<double>(e.x[k]);
  const double y = s.y - static_cast<double>(e.y[k]);
  const double across = static_cast<double>(e.w11[k]) * x + static_cast<double>(e.w12[k]) * y;
  const double down = static_cast<double>(e.w22[k]) * y;
  return static_cast<double>(e.amplitude[k]) * std::exp(-0.5 * (across * across + down * down));
}

double l1_distance(const ElementList& a, const ElementList& b, glm::dvec2 middle, double reach) {
  constexpr int k_points = 120;
  const double pitch = 2 * reach / k_points;
  double sum = 0;
  for (int j = 0; j < k_points; ++j) {
    for (int i = 0; i < k_points; ++i) {
      const glm::dvec2 s = middle + glm::dvec2((i + 0.5) * pitch - reach, (j + 0.5) * pitch - reach);
      double difference = 0;
      for (std::size_t k = 0; k < a.count; ++k) difference += density_at(a, k, s);
      for (std::size_t k = 0; k < b.count; ++k) difference -= density_at(b, k, s);
      sum += std::abs(difference) * pitch * pitch;
    }
  }
  return sum;
}

double mass_of(const ElementList& e) {
  double sum = 0;
  for (std::size_t k = 0; k < e.count; ++k) {
    sum += 2 * std::numbers::pi * static_cast<double>(e.amplitude[k]) /
           (static_cast<double>(e.w11[k]) * static_cast<double>(e.w22[k]));
  }
  return sum;
}

// Four rows of four seeds, one tile, whose means and covariances scatter by `scatter` roughnesses.
ElementList scattered_tile(RandomStream& random, double roughness, double scatter) {
  ElementList tile;
  tile.reserve(64);
  tile.count = 16;
  for (std::size_t k = 0; k < 16; ++k) {
    std::array<double, 4> xi{};
    random.fill_normal(xi);
    tile.x[k] = static_cast<float>(0.1 + scatter * roughness * xi[0]);
    tile.y[k] = static_cast<float>(-0.2 + scatter * roughness * xi[1]);
    const double more = roughness * (1 + 0.2 * scatter * std::abs(xi[2]));
    tile.w11[k] = static_cast<float>(1 / more);
    tile.w22[k] = static_cast<float>(1 / more);
    tile.w12[k] = static_cast<float>(0.1 * scatter * xi[3] / more);
    tile.amplitude[k] = static_cast<float>(0.2 + random.next_uniform());
    tile.room[k] = 9;
    tile.u[k] = static_cast<float>(0.1 * static_cast<double>(k % 4));
  }
  return tile;
}

TEST(ElementMerger, ItsBoundHoldsForRandomTiles) {
  const test::InstructionSetGuard guard;
  const Surface surface(test::constant_map({0, 0}), Interpolation::smooth);
  constexpr double k_roughness = 0.02;
  MixtureSettings settings;
  settings.merge_bound = 0.4;
  const MixtureFrame frame(surface, settings, isotropic_footprint({0.5, 0.5}, 3), glm::dvec2(k_roughness), 4.2);
  for (const InstructionSet set : supported_instruction_sets()) {
    force_instruction_set(set);
    ElementMerger merger(frame);
    RandomStream random(9, 0);
    int merged = 0;
    for (int k = 0; k < 60; ++k) {
      const double scatter = 0.02 + 0.5 * random.next_uniform();
      const ElementList tile = scattered_tile(random, k_roughness, scatter);
      ElementList one = tile;
      const double bound = merger.merge(one);
      if (one.count == tile.count) continue;
      ++merged;
      EXPECT_LE(l1_distance(tile, one, {0.1, -0.2}, 8 * k_roughness), bound) << scatter;
      EXPECT_NEAR(mass_of(one) / mass_of(tile), 1, 1e-5);
    }
    if (set == InstructionSet::scalar) continue;
    EXPECT_GE(merged, 15) << instruction_set_name(set);
  }
}

TEST(ElementMerger, LeavesFewElementsOfANearFlatMapAndAllOfARoughOne) {
  const auto left_of = [](const Surface& surface, double roughness) {
    const MixtureFrame frame(surface, {}, isotropic_footprint({60.3, 71.1}, 20), glm::dvec2(roughness), 4.2);
    MixtureRows rows(frame);
    ElementMerger merger(frame);
    ElementList band;
    std::size_t before = 0;
    std::size_t after = 0;
    for (std::int64_t row = frame.rows().first; row + 3 <= frame.rows().last; row += ElementMerger::k_rows) {
      band.count = 0;
      for (std::int64_t k = row; k < row + ElementMerger::k_rows; ++k) rows.append(k, band);
      before += band.count;
      merger.merge(band);
      after += band.count;
    }
    return static_cast<double>(after) / static_cast<double>(before);
  };
  EXPECT_LE(left_of(Surface(machined_panel(128), Interpolation::smooth), 0.02), 0.25);
  EXPECT_EQ(left_of(Surface(test::rough_map(128, 128, Wrap::repeat), Interpolation::smooth), 0.02), 1);
}

TEST(ElementMerger, ImagesMoveByLessThanTheirBound) {
  const Surface panel(machined_panel(128), Interpolation::smooth);
  const Surface board(test::quantised(*test::wavy_map(256, 256, Wrap::repeat, 0.02)), Interpolation::smooth);
  for (const Surface* surface : {&panel, &board}) {
    for (const double roughness : {0.005, 0.02, 0.05}) {
      const Footprint footprint = isotropic_footprint({60.3, 71.1}, 12);
      const PndfGrid grid = fitted_window(*surface, footprint, roughness, 128);
      MixtureSettings apart;
      apart.merge_bound = 0;
      const PndfImage whole = test::image_of(MixturePndf(*surface, roughness, apart), footprint, grid);
      const PndfImage merged = test::image_of(MixturePndf(*surface, roughness), footprint, grid);
      EXPECT_EQ(whole.error.bounded, 0);
      EXPECT_LE(merged.error.bounded, MixtureSettings().merge_bound * 1.01);
      EXPECT_LE(test::relative_l1(merged.density, whole.density), merged.error.bounded + 2e-4) << roughness;
      EXPECT_NEAR(integral(merged), integral(whole), 1e-4);
      EXPECT_FALSE(merged.error.total()) << "the step's error is not known";
    }
  }
}

// --- spline windows

TEST(SplineFootprint, SplinesArePartitionsOfUnityOfVarianceAThird) {
  for (const double x : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const std::array<double, 4> b = cubic_b_splines(x);
    EXPECT_NEAR(b[0] + b[1] + b[2] + b[3], 1, 1e-14);
    double first = 0;
    double second = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double d = x - (static_cast<double>(k) - 1);
      first += b[k] * d;
      second += b[k] * d * d;
    }
    EXPECT_NEAR(first, 0, 1e-14);
    EXPECT_NEAR(second, 1.0 / 3, 1e-14);
  }
}

// The integral of |G_p - sum| at 16 points a pitch, over the plane: the lattice's nodes are taken as they stand.
double fine_distance(const SplineLattice& lattice, const SplineFootprint& spline, const Footprint& footprint) {
  const Whitening whiten = whitening(footprint.covariance);
  const double reach_x = 6 * std::sqrt(footprint.covariance.xx);
  const double reach_y = 6 * std::sqrt(footprint.covariance.yy);
  const glm::dvec2 step = lattice.pitch / 16.0;
  const auto b3 = [](double x) {
    const double a = std::abs(x);
    return a < 1 ? 2.0 / 3 - a * a + 0.5 * a * a * a : a < 2 ? (2 - a) * (2 - a) * (2 - a) / 6 : 0.0;
  };
  double total = 0;
  for (double v = footprint.center.y - reach_y; v < footprint.center.y + reach_y; v += step.y) {
    std::vector<std::pair<double, double>> near;  // along u: node, weight times its spline along v
    for (const SplineFootprint::Node& node : spline.nodes()) {
      const double along_v = b3(v / lattice.pitch.y - static_cast<double>(node.j));
      if (along_v > 0) near.emplace_back(static_cast<double>(node.i), node.weight * along_v);
    }
    for (double u = footprint.center.x - reach_x; u < footprint.center.x + reach_x; u += step.x) {
      const glm::dvec2 w = whiten.apply(glm::dvec2(u, v) - footprint.center);
      const double gaussian = whiten.determinant() / (2 * std::numbers::pi) * std::exp(-0.5 * (w.x * w.x + w.y * w.y));
      double sum = 0;
      for (const auto& [i, weight] : near) sum += weight * b3(u / lattice.pitch.x - i);
      total += std::abs(gaussian - sum / (lattice.pitch.x * lattice.pitch.y)) * step.x * step.y;
    }
  }
  return total;
}

TEST(SplineFootprint, ItsBoundHoldsAndIsTight) {
  const NormalMap map(4096, 4096, std::vector<glm::vec2>(std::size_t{4096} * 4096), Wrap::clamp);
  RandomStream random(4, 0);
  for (int k = 0; k < 12; ++k) {
    const double narrow = 16 + 50 * random.next_uniform();
    const Footprint footprint =
        test::turned_footprint({2000 + 100 * random.next_uniform(), 2000 + 100 * random.next_uniform()},
                               narrow * (1 + 2 * random.next_uniform()), narrow, 3 * random.next_uniform());
    const SplineLattice lattice = SplineLattice::for_footprint(map, footprint.covariance);
    const SplineFootprint spline(lattice, map, footprint);
    double sum = 0;
    for (const SplineFootprint::Node& node : spline.nodes()) sum += node.weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    const double distance = fine_distance(lattice, spline, footprint);
    EXPECT_LE(distance, spline.bound()) << narrow;
    EXPECT_GE(distance, 0.8 * spline.bound()) << narrow;
    EXPECT_LE(spline.bound(), 4e-3);
  }
}

// --- atlas

class AtlasCase {
 public:
  AtlasCase(test::MapPointer map, const Footprint& footprint, double roughness = 0.02)
      : surface_(std::move(map), Interpolation::smooth),
        footprint_(footprint),
        roughness_(roughness),
        grid_(fitted_window(surface_, footprint, roughness, 96)) {}

  [[nodiscard]] std::unique_ptr<MixtureAtlas> atlas(std::size_t most_bytes = MixtureAtlas::k_most_bytes) const {
    return std::make_unique<MixtureAtlas>(surface_, roughness_, MixtureSettings(), grid_, most_bytes);
  }
  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] const Footprint& footprint() const { return footprint_; }
  [[nodiscard]] const PndfGrid& grid() const { return grid_; }
  [[nodiscard]] double roughness() const { return roughness_; }

 private:
  Surface surface_;
  Footprint footprint_;
  double roughness_;
  PndfGrid grid_;
};

TEST(MixtureAtlas, IsTheMixtureWithinItsBound) {
  const std::vector<AtlasCase> cases{
      {test::rough_map(200, 200, Wrap::repeat, 0.1), isotropic_footprint({90.2, 101.7}, 17)},
      {test::rough_map(200, 200, Wrap::repeat, 0.1), isotropic_footprint({3.2, 198.7}, 22)},
      {test::wavy_map(331, 257, Wrap::repeat), test::turned_footprint({90.2, 101.7}, 45, 18, 0.7)},
      {test::wavy_map(331, 257, Wrap::clamp), test::turned_footprint({5, 250}, 40, 20, -0.4)},
      {test::quantised(*test::wavy_map(256, 256, Wrap::repeat, 0.02)), isotropic_footprint({100, 100}, 30), 0.005}};
  for (const AtlasCase& c : cases) {
    const auto atlas = c.atlas();
    ASSERT_TRUE(atlas->suits(c.footprint().covariance));
    EXPECT_EQ(atlas->missing_share(c.footprint()), 1);
    EXPECT_FALSE(atlas->image(c.footprint()));
    JobControl control;
    ASSERT_TRUE(atlas->build(c.footprint(), control));
    EXPECT_EQ(atlas->missing_share(c.footprint()), 0);
    const std::optional<PndfImage> image = atlas->image(c.footprint());
    ASSERT_TRUE(image);
    const PndfImage direct = test::image_of(MixturePndf(c.surface(), c.roughness()), c.footprint(), c.grid());
    // What the cuts and the merging of the direct image leave is not the atlas's.
    EXPECT_LE(test::relative_l1(image->density, direct.density), image->error.bounded + 6e-4);
    EXPECT_NEAR(integral(*image), 1, 2e-3);
    EXPECT_LE(image->error.bounded, 5e-3);
    EXPECT_FALSE(image->error.total());
  }
}

TEST(MixtureAtlas, FoldsFootprintsOfAboutTheMapsSize) {
  for (const double radius : {20.0, 40.0, 60.0, 300.0}) {
    const AtlasCase c(test::wavy_map(64, 64, Wrap::repeat), isotropic_footprint({11, 40}, radius), 0.05);
    const auto atlas = c.atlas();
    JobControl control;
    ASSERT_TRUE(atlas->build(c.footprint(), control)) << radius;
    const PndfImage exact = test::image_of(ExactPndf(c.surface(), c.roughness()), c.footprint(), c.grid());
    EXPECT_LE(test::relative_l1(atlas->image(c.footprint())->density, exact.density), 5e-3) << radius;
  }
}

TEST(MixtureAtlas, HasTheSameBytesForAnyThreadsAndHistory) {
  // Nine nodes a side: classes of cells that meet over the border.
  const AtlasCase c(test::rough_map(100, 100, Wrap::repeat, 0.1), isotropic_footprint({50, 50}, 17));
  JobControl control;
  const auto two = c.atlas();
  ASSERT_TRUE(two->build(c.footprint(), control));
  const ThreadLimit limit(1);
  const auto one = c.atlas();
  ASSERT_TRUE(one->build(c.footprint(), control));
  EXPECT_EQ(one->image(c.footprint())->density, two->image(c.footprint())->density);
  const auto later = c.atlas();
  ASSERT_TRUE(later->build(isotropic_footprint({20, 70}, 17), control));
  ASSERT_TRUE(later->build(c.footprint(), control));
  EXPECT_EQ(later->image(c.footprint())->density, two->image(c.footprint())->density);
}

TEST(MixtureAtlas, ForgetsWhatIsOldAndNothingThatIsNeeded) {
  const AtlasCase c(test::rough_map(1024, 256, Wrap::repeat, 0.1), isotropic_footprint({100, 100}, 17), 0.05);
  JobControl control;
  const auto roomy = c.atlas();
  ASSERT_TRUE(roomy->build(c.footprint(), control));
  const std::size_t limit = std::max<std::size_t>(2 * roomy->bytes(), 5'000'000);
  ASSERT_GT(5 * roomy->bytes(), limit);
  const auto atlas = c.atlas(limit);
  for (const double x : {100.0, 300.0, 500.0, 700.0, 900.0}) {
    const Footprint there = isotropic_footprint({x, 100}, 17);
    ASSERT_TRUE(atlas->build(there, control));
    EXPECT_LE(atlas->bytes(), limit);
    EXPECT_TRUE(atlas->image(there));
  }
  EXPECT_FALSE(atlas->image(c.footprint())) << "the first was forgotten";
}

TEST(MixtureAtlas, KeepsWhatIsSpreadThinlyBesideAPeak) {
  // One texel in twenty is anything, the rest is flat: far below the peak, and yet a twentieth of the mass.
  RandomStream random(8, 0);
  const test::MapPointer map = test::map_of(128, 128, Wrap::repeat, [&](int, int) {
    const double x = random.next_uniform();
    const double y = random.next_uniform();
    return random.next_uniform() < 0.05 ? glm::dvec2(1.2 * x - 0.6, 1.2 * y - 0.6) : glm::dvec2(0, 0);
  });
  const Surface surface(map, Interpolation::constant);
  const Footprint footprint = isotropic_footprint({60, 70}, 18);
  const PndfGrid grid{-1, 1, -1, 1, 256, 256};
  MixtureAtlas atlas(surface, 1e-3, {}, grid);
  JobControl control;
  ASSERT_TRUE(atlas.build(footprint, control));
  const PndfImage image = *atlas.image(footprint);
  const PndfImage direct = test::image_of(MixturePndf(surface, 1e-3), footprint, grid);
  EXPECT_NEAR(integral(image), integral(direct), 2e-3);
  EXPECT_LE(test::relative_l1(image.density, direct.density), image.error.bounded + 2e-3);
}

TEST(MixtureAtlas, IsNotForWorkWithoutEnd) {
  const Surface small(test::wavy_map(64, 64, Wrap::repeat), Interpolation::smooth);
  const Surface clamped(test::wavy_map(64, 64, Wrap::clamp), Interpolation::smooth);
  const PndfGrid grid{-1, 1, -1, 1, 64, 64};
  const SymmetricMatrix2 needle = test::turned_footprint({0, 0}, 1e5, 50, 0.785).covariance;
  EXPECT_FALSE(MixtureAtlas(small, 0.02, {}, grid).suits(needle));
  EXPECT_FALSE(MixtureAtlas(clamped, 0.02, {}, grid).suits(isotropic_footprint({0, 0}, 1e4).covariance));
  EXPECT_FALSE(MixtureAtlas(small, 1e-7, {}, grid).suits(isotropic_footprint({0, 0}, 20).covariance));
}

TEST(MixtureAtlas, RefusesWhatItCannotHoldAndStopsWhenCancelled) {
  const AtlasCase c(test::wavy_map(256, 256, Wrap::repeat), isotropic_footprint({100, 100}, 17));
  JobControl control;
  EXPECT_FALSE(c.atlas()->suits(isotropic_footprint({100, 100}, 15).covariance));
  EXPECT_FALSE(c.atlas(10'000)->suits(c.footprint().covariance));
  EXPECT_FALSE(c.atlas(10'000)->build(c.footprint(), control));
  control.cancel();
  const auto atlas = c.atlas();
  EXPECT_FALSE(atlas->build(c.footprint(), control));
  EXPECT_FALSE(atlas->image(c.footprint()));
  JobControl later;
  std::thread canceller([&] {
    while (later.progress() == 0) std::this_thread::yield();  // some cells are done
    later.cancel();
  });
  EXPECT_FALSE(atlas->build(c.footprint(), later));
  canceller.join();
  EXPECT_FALSE(atlas->image(c.footprint()));
  JobControl again;
  EXPECT_TRUE(atlas->build(c.footprint(), again));
}

TEST(MixtureAtlas, AnswersForTheMixtureOfItsOwnSettingsAlone) {
  const AtlasCase c(test::rough_map(200, 200, Wrap::repeat, 0.1), isotropic_footprint({90.2, 101.7}, 17));
  const std::shared_ptr<MixtureAtlas> atlas = c.atlas();
  JobControl control;
  ASSERT_TRUE(atlas->build(c.footprint(), control));
  const auto bound_of = [&](double roughness, double step, const PndfGrid& grid) {
    MixtureSettings settings;
    settings.step = step;
    return test::image_of(MixturePndf(c.surface(), roughness, settings, atlas), c.footprint(), grid).error.bounded;
  };
  const double of_atlas = atlas->image(c.footprint())->error.bounded;
  EXPECT_EQ(bound_of(c.roughness(), 0.5, c.grid()), of_atlas);
  EXPECT_NE(bound_of(0.021, 0.5, c.grid()), of_atlas);
  EXPECT_NE(bound_of(c.roughness(), 1, c.grid()), of_atlas);
  EXPECT_NE(bound_of(c.roughness(), 0.5, PndfGrid{-1, 1, -1, 1, 96, 96}), of_atlas);
}

}  // namespace
}  // namespace glint
