#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

/// Stores a Kernels<Tree>, the search through trees of boxes, however they were built. For WithInstructionSet.
void ChooseKernels(void* kernels);

}  // namespace ray::wide
