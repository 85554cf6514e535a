#pragma once

#include <memory>
#include <span>

#include "R3/ShapeKind.h"
#include "R3/shapes/PatchRoots.h"

namespace R3 {

/// Returns the argument names of 16 control points, row by row.
std::vector<Argument> PatchArguments();
/// Returns the control points given by 48 numbers, as vectors from the origin.
patch::Net<Vector> PatchNet(std::span<const double> numbers);

/// Makes the bicubic patch of control points in Bernstein's basis; `made_from` is its line of a scene file.
std::unique_ptr<const Shape> BezierPatch(const patch::Net<Vector>& net, Recipe made_from);

}  // namespace R3
