#pragma once

#include "core/math/instruction_set.h"

namespace glint::test {

/// Gives back, at its end, the instruction set that was in use.
class InstructionSetGuard {
 public:
  InstructionSetGuard() = default;
  InstructionSetGuard(const InstructionSetGuard&) = delete;
  InstructionSetGuard& operator=(const InstructionSetGuard&) = delete;
  ~InstructionSetGuard() { force_instruction_set(before_); }

 private:
  InstructionSet before_ = instruction_set();
};

}  // namespace glint::test
