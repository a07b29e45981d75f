#include "core/math/flush_to_zero.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace glint {

#if defined(__SSE2__)
FlushToZero::FlushToZero() : before_(_mm_getcsr()) {
  constexpr unsigned k_results_and_operands = 0x8040;
  _mm_setcsr(before_ | k_results_and_operands);
}
FlushToZero::~FlushToZero() {
  _mm_setcsr(before_);
}
#else
FlushToZero::FlushToZero() = default;
FlushToZero::~FlushToZero() = default;
#endif

}  // namespace glint
