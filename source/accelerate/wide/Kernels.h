#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

/// The search through trees of boxes, whoever built them, for WithInstructionSet: stores a Kernels<Tree>.
void ChooseKernels(void* kernels);

}  // namespace ray::wide
