#pragma once

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "core/pndf/pndf_model.h"

namespace glint::test {

/// The image must be a job of many seconds.
inline void expect_no_image_once_cancelled(const PndfModel& model, const Footprint& footprint, const PndfGrid& grid) {
  JobControl before;
  before.cancel();
  EXPECT_FALSE(model.image(footprint, grid, before));
  JobControl meanwhile;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    meanwhile.cancel();
  });
  EXPECT_FALSE(model.image(footprint, grid, meanwhile));
  other.join();
}

}  // namespace glint::test
