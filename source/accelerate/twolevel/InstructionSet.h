#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ray {

/// All the instruction sets that some machine may have, by name.
inline constexpr std::array instruction_set_names{"avx512", "avx2", "sse4", "neon", "scalar"};
/// The instruction sets that this machine has and this program was compiled for, the best first.
std::vector<std::string> InstructionSets();
std::string InstructionSetName(std::int64_t instruction_set);

/// Runs `choose` for the instruction set of that name, or for the best with "best"; throws std::invalid_argument.
/// `choose` is a dynamic dispatch of Highway, which looks at what is set meanwhile.
void WithInstructionSet(const std::string& name, void (*choose)(void* result), void* result);

}  // namespace ray
