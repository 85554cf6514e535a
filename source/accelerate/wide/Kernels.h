#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::bvh {

/// The search through trees of boxes, whoever built them, for WithInstructionSet: stores a Kernels<Tree>.
void ChooseKernels(void* kernels);

}  // namespace ray::bvh
