// Binning against exact evaluation on normal maps as artists and instruments make them.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/image/normal_map_reader.h"
#include "core/pndf/binned_pndf.h"
#include "core/pndf/fitted_window.h"
#include "tests/core/pndf/cell_means.h"
#include "tests/core/pndf/test_maps.h"
#include "tests/test_data.h"

namespace glint {
namespace {

// The relative L1 that noise alone is expected to give: sum sqrt(2 D / (pi n b^2)) / sum D.
double noise_alone(const std::vector<double>& means, double cell_area, double samples) {
  double noise = 0;
  double mass = 0;
  for (const double density : means) {
    noise += std::sqrt(2 * density / (std::numbers::pi * samples * cell_area));
    mass += density;
  }
  return noise / mass;
}

class BinnedOnRealMap : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Maps, BinnedOnRealMap,
                         testing::Values("dented_metal_512.png", "gaussian_beckmann_f32_512.exr"),
                         [](const auto& instance) {
                           const std::string name = instance.param;
                           return name.substr(0, name.find('.'));
                         });

TEST_P(BinnedOnRealMap, DiffersFromExactByNoMoreThanItsNoise) {
  GLINT_NEEDS_DATA();
  JobControl control;
  auto read = read_normal_map(test::data_directory() / "normals" / GetParam(), {}, control);
  ASSERT_TRUE(read) << read.error().message();
  const auto map = std::make_shared<NormalMap>(std::move(read->map));
  const Surface surface(map, Interpolation::linear);
  const Footprint footprint = isotropic_footprint({200, 300}, 20);
  constexpr double roughness = 0.02;
  const PndfGrid grid = fitted_window(surface, footprint, roughness, 128);
  const std::vector<double> means = test::cell_means(ExactPndf(surface, roughness), footprint, grid);
  for (const std::uint64_t samples : {1'000'000U, 4'000'000U}) {
    const PndfImage image = test::image_of(BinnedPndf(surface, roughness, {samples, 7, 128}), footprint, grid);
    const double error = test::relative_l1(image.density, means);
    const double noise = noise_alone(means, grid.cell_area(), static_cast<double>(samples));
    EXPECT_LE(error, 1.25 * noise) << samples;
    EXPECT_GE(error, 0.75 * noise) << samples;  // independent draws cannot be much better either
    EXPECT_NEAR(*image.error.estimated / error, 1, 0.1) << samples;
    RecordProperty("error over noise, " + std::to_string(samples), std::to_string(error / noise));
  }
}

}  // namespace
}  // namespace glint
