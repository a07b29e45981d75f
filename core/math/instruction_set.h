#pragma once
// Which vector instructions this process uses: the widest the processor has, unless a person forces others.

#include <string_view>
#include <vector>

namespace glint {

enum class InstructionSet { scalar, sse4, avx2, avx512 };

/// As on the command line: "avx512".
std::string_view instruction_set_name(InstructionSet set);

/// What this processor runs and this program was built for, narrowest first; never empty.
std::vector<InstructionSet> supported_instruction_sets();

/// What the vector kernels use now.
InstructionSet instruction_set();

/// From now on the vector kernels use these, which must be supported. For the whole process; not while kernels run.
void force_instruction_set(InstructionSet set);

}  // namespace glint
