#include "core/surface/spectral.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <numbers>
#include <vector>

#include <kiss_fft.h>

namespace glint {
namespace {

// Eight columns are one cache line of every row, and 16 KiB of a 1024 map: a block is copied out, transformed, copied
// in.
constexpr std::size_t k_lines_per_block = 8;

struct PlanDeleter {
  void operator()(kiss_fft_state* plan) const { kiss_fft_free(plan); }
};
using Plan = std::unique_ptr<kiss_fft_state, PlanDeleter>;

// Transforms lines [first, last) whose elements stand `element_stride` apart and which stand `line_stride` apart.
void transform_lines(kiss_fft_state* plan, std::span<glm::vec2> field, std::size_t size, std::size_t first,
                     std::size_t last, std::size_t element_stride, std::size_t line_stride) {
  const std::size_t lines = last - first;
  std::vector<kiss_fft_cpx> in(lines * size);
  std::vector<kiss_fft_cpx> out(size);
  // The line runs in the inner loop so that columns are read a cache line at a time.
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t line = 0; line < lines; ++line) {
      const glm::vec2 value = field[(first + line) * line_stride + k * element_stride];
      in[line * size + k] = {value.x, value.y};
    }
  }
  for (std::size_t line = 0; line < lines; ++line) {
    kiss_fft(plan, &in[line * size], out.data());  // only reads the plan, as input and output differ
    std::copy(out.begin(), out.end(), &in[line * size]);
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t line = 0; line < lines; ++line) {
      const kiss_fft_cpx value = in[line * size + k];
      field[(first + line) * line_stride + k * element_stride] = {value.r, value.i};
    }
  }
}

}  // namespace

bool transform_in_place(std::span<glm::vec2> field, int size, TransformDirection direction, JobControl& control) {
  const auto n = static_cast<std::size_t>(size);
  assert(field.size() == n * n);
  const Plan plan(kiss_fft_alloc(size, direction == TransformDirection::inverse ? 1 : 0, nullptr, nullptr));
  if (!plan) throw std::bad_alloc();
  const std::size_t blocks = (n + k_lines_per_block - 1) / k_lines_per_block;
  const auto all_lines = [&](std::size_t element_stride, std::size_t line_stride) {
    return parallel_blocks(blocks, control, [&](std::size_t block) {
      const std::size_t first = block * k_lines_per_block;
      transform_lines(plan.get(), field, n, first, std::min(first + k_lines_per_block, n), element_stride, line_stride);
    });
  };
  return all_lines(1, n) && all_lines(n, 1);
}

double wave_number(int index, int size) {
  const int periods = index > size / 2 ? index - size : index;
  return 2 * std::numbers::pi * periods / size;
}

}  // namespace glint
