#pragma once

#include <optional>

#include "R3/Matrix.h"
#include "R3/Point.h"

namespace ray {

// Matrices of which scenes speak in words.

/// Where the three axes go, and the origin.
R3::Matrix Frame(const R3::Point& origin, const R3::Vector& x, const R3::Vector& y, const R3::Vector& z);
R3::Matrix Translation(const R3::Vector& way);
R3::Matrix Scaling(const R3::Vector& factors);
/// About a coordinate axis, 0 to 2, counter-clockwise seen from its positive end. Multiples of 90 degrees are exact.
R3::Matrix RotationAbout(int axis, double degrees);
/// About an axis of any length but 0, counter-clockwise seen from its tip; as exact where it is a coordinate axis.
R3::Matrix RotationAbout(const R3::Vector& axis, double degrees);
/// The rotation about x, then y, then z.
R3::Matrix TurnOf(const R3::Vector& radians);
/// The frame whose origin is `eye` and whose z axis goes to `target`, y as near to `up` as may be: all three unit, x to
/// the left of one who looks along z. Nothing where these name no frame.
std::optional<R3::Matrix> LookingAt(const R3::Point& eye, const R3::Point& target, const R3::Vector& up);
/// b first.
R3::Matrix operator*(const R3::Matrix& a, const R3::Matrix& b);

/// The rotation of the smallest angle that takes the unit vector `from` to the unit vector `to`; about some
/// perpendicular where they are opposite.
R3::Matrix SmallestRotation(const R3::Vector& from, const R3::Vector& to);

}  // namespace ray
