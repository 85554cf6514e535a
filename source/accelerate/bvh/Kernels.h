#pragma once

#include <string>
#include <vector>

#include "source/accelerate/NearestHit.h"
#include "source/accelerate/bvh/Tree.h"

namespace ray::bvh {

/// The trees of a world: one over the world itself, one inside each shared mesh.
struct Forest {
  const World* world = nullptr;
  std::vector<Tree> trees;  // the world's first, then shared mesh i at i + 1

  std::size_t Bytes() const;
};

/// The walk through the trees, compiled once for each instruction set; all find the same hits.
struct Kernels {
  const char* name;  // as -simd and -explain say it
  void (*nearest)(const Forest& forest, const R3::Ray& ray, NearestHit& nearest, Counts& counts);
  /// Whether there is any hit.
  bool (*any)(const Forest& forest, const R3::Ray& ray, Counts& counts);
};

/// Names of the instruction sets that this machine has and this program was compiled for, the best first.
std::vector<std::string> InstructionSets();

/// The kernels for the named one of InstructionSets(), or for the best with "best".
const Kernels& ChooseKernels(const std::string& instruction_set);

}  // namespace ray::bvh
