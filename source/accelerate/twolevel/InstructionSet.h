#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ray {

/// The names of all instruction sets that some machine may have.
inline constexpr std::array instruction_set_names{"avx512", "avx2", "sse4", "neon", "scalar"};
/// Returns the instruction sets that this machine has and this program was compiled for, the best first.
std::vector<std::string> InstructionSets();
std::string InstructionSetName(std::int64_t instruction_set);

/// Runs `choose` for the named instruction set, or the best one for "best"; throws std::invalid_argument. `choose` is a
/// dynamic dispatch of Highway, which uses the set that is active during the call.
void WithInstructionSet(const std::string& name, void (*choose)(void* result), void* result);

}  // namespace ray
