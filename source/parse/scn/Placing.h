#pragma once

#include <array>
#include <string>

#include "R3/Matrix.h"
#include "source/parse/scn/Statement.h"

namespace ray {

// Words that place a group, such as "translate 1 2 3".

/// How each is used, for the manual.
std::string UsageOfPlacements();
/// Whether the next word is one of them.
bool BeginsPlacement(Statement& statement);
/// Reads all that stand in a row, as one matrix: each moves what the ones behind it have placed, as groups within
/// groups do. So "translate 0 1 0 rotate 45 0 1 0" turns about the origin and then lifts.
R3::Matrix ReadPlacement(Statement& statement);

/// Says what is wrong with the next word, where a matrix or one of these should stand, and passes over its line.
void RefusePlacement(Statement& statement);

/// The arguments of look_at: an eye, a point to look at, and a vector that is up.
inline constexpr auto look_at_arguments = R3::ArgumentsNamed("ex", "ey", "ez", "tx", "ty", "tz", "ux", "uy", "uz");

}  // namespace ray
