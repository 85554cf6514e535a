#pragma once

#include <string>
#include <vector>

#include "source/view/ViewerState.h"

namespace ray {

/// What is written over the view.
std::vector<Label> MakeLabels(const ViewerState& viewer);
/// The mistakes of the file that was to be read, which stay to be seen until it is right; empty without any.
std::string TextOfProblems(const ViewerState& viewer);

}  // namespace ray
