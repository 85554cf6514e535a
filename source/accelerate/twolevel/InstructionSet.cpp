#include "source/accelerate/twolevel/InstructionSet.h"

#include <mutex>
#include <stdexcept>

#include "R1/Targets.h"

namespace ray {

std::string InstructionSetName(std::int64_t instruction_set) {
  std::string name = hwy::TargetName(instruction_set);
  if (name == "AVX3") return "avx512";
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

std::vector<std::string> InstructionSets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.push_back(InstructionSetName(target));
  return names;
}

void WithInstructionSet(const std::string& name, void (*choose)(void* result), void* result) {
  static std::mutex one_at_a_time;  // Highway's supported targets are global
  const std::lock_guard lock(one_at_a_time);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name != "best" && name != InstructionSetName(target)) continue;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    choose(result);
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return;
  }
  throw std::invalid_argument("this CPU does not support " + name);
}

}  // namespace ray
