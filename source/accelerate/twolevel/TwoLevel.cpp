#include "source/accelerate/twolevel/TwoLevel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

namespace ray {

Coordinates FitCoordinates(const PrimitiveSet& space) {
  const R3::Box box = tbb::parallel_reduce(
      tbb::blocked_range<std::uint32_t>(0, space.Items(), 4096), R3::Box(),
      [&](const auto& r, R3::Box sum) {
        for (std::uint32_t i = r.begin(); i != r.end(); ++i) sum.Extend(space.Bounds(i));
        return sum;
      },
      [](R3::Box a, const R3::Box& b) {
        a.Extend(b);
        return a;
      });
  Coordinates fit;
  if (box.IsEmpty()) return fit;
  fit.center = box.Center();
  // A point has no size; any scale does, as long as the center itself is resolved.
  const double half = MaxComponent(Abs(box.Size())) / 2;
  const double size = std::max(half, 0x1p-40 * MaxComponent(Abs(FromOrigin(fit.center))));
  const int exponent = size > 0 ? std::ilogb(size) + 1 : 0;
  fit.scale = std::scalbn(1.0, std::clamp(-exponent, -1022, 1022));
  return fit;
}

void FillBlock(TriangleBlock& block, const PrimitiveSet& space, const Coordinates& coordinates,
               const std::uint32_t* items, int count) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < width; ++i) {
    const bool is_there = i < count;
    block.item[i] = is_there ? items[i] : 0;
    R3::Vector corner, edge1, edge2;
    if (is_there) {
      const auto corners = space.MeshOf(items[i])->Corners(space[items[i]].element);
      corner = coordinates(corners[0]);
      edge1 = coordinates.scale * (corners[1] - corners[0]);
      edge2 = coordinates.scale * (corners[2] - corners[0]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      block.corner[axis][i] = is_there ? static_cast<float>(corner[axis]) : nan;
      block.edge1[axis][i] = static_cast<float>(edge1[axis]);
      block.edge2[axis][i] = static_cast<float>(edge2[axis]);
    }
  }
}

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
  static std::mutex one_at_a_time;  // what Highway takes for supported is global
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
  throw std::invalid_argument("this machine has no instruction set " + name);
}

}  // namespace ray
