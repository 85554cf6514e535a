#pragma once

#include <memory>
#include <span>

#include "R3/ShapeKind.h"
#include "R3/shapes/PatchRoots.h"

namespace R3 {

/// The names of the coordinates of 16 control points, row by row.
std::vector<Argument> PatchArguments();
/// The control points that these 48 numbers are, as vectors from the origin.
patch::Net<Vector> PatchNet(std::span<const double> numbers);

/// The bicubic patch of these control points in Bernstein's basis, which a line of a scene file made.
std::unique_ptr<const Shape> BezierPatch(const patch::Net<Vector>& net, Recipe made_from);

}  // namespace R3
