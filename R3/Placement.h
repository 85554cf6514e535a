#pragma once

#include <optional>

#include "R3/Matrix.h"
#include "R3/Point.h"

namespace R3 {

// Matrices of which scenes speak in words.

/// Where the three axes go, and the origin.
Matrix Frame(const Point& origin, const Vector& x, const Vector& y, const Vector& z);
Matrix Translation(const Vector& way);
Matrix Scaling(const Vector& factors);
/// About a coordinate axis, 0 to 2, counter-clockwise seen from its positive end. Multiples of 90 degrees are exact.
Matrix RotationAbout(int axis, double degrees);
/// About an axis of any length but 0, counter-clockwise seen from its tip; as exact where it is a coordinate axis.
Matrix RotationAbout(const Vector& axis, double degrees);
/// The rotation about x, then y, then z.
Matrix TurnOf(const Vector& radians);
/// The frame whose origin is `eye` and whose z axis goes to `target`, y as near to `up` as may be: all three unit, x to
/// the left of one who looks along z. Nothing where these name no frame.
std::optional<Matrix> LookingAt(const Point& eye, const Point& target, const Vector& up);
/// b first.
Matrix operator*(const Matrix& a, const Matrix& b);

/// The rotation of the smallest angle that takes the unit vector `from` to the unit vector `to`; about some
/// perpendicular where they are opposite.
Matrix SmallestRotation(const Vector& from, const Vector& to);

}  // namespace R3
