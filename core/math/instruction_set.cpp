#include "core/math/instruction_set.h"

#include <array>
#include <cstdint>

#include <hwy/highway.h>

namespace glint {
namespace {

struct Known {
  InstructionSet set;
  std::string_view name;
  std::int64_t target;
};

constexpr std::array k_known = {
    Known{InstructionSet::scalar, "scalar", HWY_SCALAR | HWY_EMU128}, Known{InstructionSet::sse4, "sse4", HWY_SSE4},
    Known{InstructionSet::avx2, "avx2", HWY_AVX2}, Known{InstructionSet::avx512, "avx512", HWY_AVX3 | HWY_AVX3_DL}};

std::int64_t usable_targets() {
  return hwy::SupportedTargets() & HWY_TARGETS;
}

}  // namespace

std::string_view instruction_set_name(InstructionSet set) {
  for (const Known& known : k_known) {
    if (known.set == set) return known.name;
  }
  return "scalar";
}

std::vector<InstructionSet> supported_instruction_sets() {
  // What the processor has, whatever is forced now.
  static const std::int64_t usable = [] {
    const std::int64_t forced = hwy::SupportedTargets();
    hwy::SetSupportedTargetsForTest(0);
    const std::int64_t all = usable_targets();
    if (forced != hwy::SupportedTargets()) hwy::SetSupportedTargetsForTest(forced);
    return all;
  }();
  std::vector<InstructionSet> sets;
  for (const Known& known : k_known) {
    if ((known.target & usable) != 0) sets.push_back(known.set);
  }
  return sets;
}

InstructionSet instruction_set() {
  const std::int64_t usable = usable_targets();
  InstructionSet widest = InstructionSet::scalar;
  for (const Known& known : k_known) {
    if ((known.target & usable) != 0) widest = known.set;
  }
  return widest;
}

void force_instruction_set(InstructionSet set) {
  std::int64_t allowed = 0;
  for (const Known& known : k_known) {
    if (known.set <= set) allowed |= known.target;
  }
  supported_instruction_sets();  // remembers the true ones first
  hwy::SetSupportedTargetsForTest(allowed);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace glint
