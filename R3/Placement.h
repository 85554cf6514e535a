#pragma once

#include <optional>

#include "R3/Matrix.h"
#include "R3/Point.h"

namespace R3 {

// Matrices for the transforms of scene languages.

/// Returns the matrix that maps the axes to x, y and z, and the origin to `origin`.
Matrix Frame(const Point& origin, const Vector& x, const Vector& y, const Vector& z);
Matrix Translation(const Vector& way);
Matrix Scaling(const Vector& factors);
/// Returns the rotation about a coordinate axis, 0 to 2, counter-clockwise seen from its positive end. Multiples of 90
/// degrees are exact.
Matrix RotationAbout(int axis, double degrees);
/// Returns the rotation about an axis of any length but 0, counter-clockwise seen from its tip; also exact for
/// multiples of 90 degrees about a coordinate axis.
Matrix RotationAbout(const Vector& axis, double degrees);
/// Returns the rotation about x, then y, then z.
Matrix TurnOf(const Vector& radians);
/// Returns the frame with origin `eye` whose z axis points to `target`, with y as near to `up` as possible. All axes
/// are unit; x points to the left of a viewer who looks along z. std::nullopt if the arguments define no frame.
std::optional<Matrix> LookingAt(const Point& eye, const Point& target, const Vector& up);
/// Returns the map that applies b first, then a.
Matrix operator*(const Matrix& a, const Matrix& b);

/// Returns the rotation by the smallest angle that maps the unit vector `from` to the unit vector `to`; about any
/// perpendicular axis if they are opposite.
Matrix SmallestRotation(const Vector& from, const Vector& to);

}  // namespace R3
