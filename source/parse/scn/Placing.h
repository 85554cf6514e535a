#pragma once

#include <string>

#include "R3/Matrix.h"
#include "source/parse/scn/Statement.h"

namespace ray {

// Words that place a group, such as "translate 1 2 3".

/// Returns the usage of all of them, for the manual.
std::string UsageOfPlacements();
/// Returns true if the next word is one of them.
bool BeginsPlacement(Statement& statement);
/// Reads all consecutive placements as one matrix. Each transforms the result of those after it, like nested groups:
/// "translate 0 1 0 rotate 45 0 1 0" rotates about the origin and then lifts.
R3::Matrix ReadPlacement(Statement& statement);

/// Reports the next word, where a matrix or a placement should be, and skips its line.
void RefusePlacement(Statement& statement);

/// The arguments of look_at: an eye, a target, and an up vector.
inline constexpr auto look_at_arguments = R3::ArgumentsNamed("ex", "ey", "ez", "tx", "ty", "tz", "ux", "uy", "uz");

}  // namespace ray
