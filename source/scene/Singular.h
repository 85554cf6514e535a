#pragma once

#include "R3/Matrix.h"

namespace ray {

/// A group whose matrix has a larger condition cannot be intersected: a double has no digits left for its inverse.
inline constexpr double singular_condition = 3e14;  // about 10^14.5
/// Above this condition, a warning says that digits are running short.
inline constexpr double nearly_singular_condition = 3e10;  // about 10^10.5

/// Returns true if the subtree under such a matrix is skipped.
inline bool IsSingular(const R3::Matrix& matrix) { return !(Condition(matrix) < singular_condition); }

}  // namespace ray
