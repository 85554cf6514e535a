#pragma once

#include <cmath>

namespace ray {

/// The maximum magnitude of a coordinate: beyond it, the squares and products of an intersection would leave the range
/// of double.
inline constexpr double largest_coordinate = 1e150;

inline bool IsCoordinate(double x) { return std::abs(x) <= largest_coordinate; }

}  // namespace ray
