#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

/// The search through trees of boxes, however they were built, for WithInstructionSet: stores a Kernels<Tree>.
void ChooseKernels(void* kernels);

}  // namespace ray::wide
