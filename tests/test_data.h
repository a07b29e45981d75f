#pragma once
// Where real test data lies: $GLINTSCOPE_DATA, else shared/data beside the checkout.

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace glint::test {

inline std::filesystem::path data_directory() {
  if (const char* set = std::getenv("GLINTSCOPE_DATA")) return set;
  return std::filesystem::path(GLINTSCOPE_SOURCE_DIR).parent_path() / "shared" / "data";
}

}  // namespace glint::test

/// Skips the test, saying so, where the real data is not there.
#define GLINT_NEEDS_DATA()                                           \
  if (!std::filesystem::is_directory(glint::test::data_directory())) \
  GTEST_SKIP() << "real data not found: set GLINTSCOPE_DATA"
