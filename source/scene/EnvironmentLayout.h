#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "R1/Elementary.h"
#include "R2/Image.h"
#include "R3/Vector.h"

namespace ray {

/// The layout of an image of the whole surroundings. In every layout they are seen from the inside with y up, and -z is
/// ahead with +x to the right of it.
enum class EnvironmentLayout {
  /// 2:1. With width and height scaled to 1 from the lower left, u = 1/2 + atan2(x, -z) / (2 pi) and v = 1/2 + asin(y /
  /// length) / pi: -y is the lowest row, +y the highest, -z the middle, +z the left and right edge.
  latitude_longitude,
  /// 1:1. The center looks along -z; a point at the share r of the way to the middle of an edge looks pi r away from
  /// it, towards +x if to the right, +y if above. The circle's rim is +z; the corners beyond it are not used.
  /// Source: Debevec, Light probe image gallery (1998), the angular map.
  angular_probe,
  /// 3:4 or 4:3, a cube of six square faces unfolded:
  ///
  ///        +y             +y
  ///     -x -z +x       -x -z +x +z
  ///        -y             -y
  ///        +z
  ///
  /// +y has -z at its lower edge and -y at its upper. The lowest face of the upright cross is attached to -y, so it is
  /// upside down (-y above, +x to the right), as in Debevec's files. The areas between the arms are not used.
  cross
};

/// Returns "latitude-longitude map", "angular probe" or "cross of six faces".
std::string_view Name(EnvironmentLayout layout);

/// Determines the layout by the shape. Throws std::invalid_argument, with a message for the user, for an image of
/// another shape.
EnvironmentLayout LayoutOf(const R2::Image& image);

/// Converts an image of that layout to a latitude-longitude map; see Environment. Throws std::invalid_argument, with a
/// message for the user, if a value is negative or not finite.
R2::Image Unfolded(R2::Image image, EnvironmentLayout layout);

// Positions on a latitude-longitude map of `rows` rows and twice as many columns.

/// Returns the sine of the latitude of the edge below a row, of latitude -pi/2 + pi row / rows.
inline double SineOfEdge(int row, int rows) { return -R1::SinCosTurns(0.5 * row / rows).cosine; }

/// Returns the longitude, measured from -z towards +x, at a share of a column's width.
inline R1::SineCosine LongitudeOf(int column, double share, int rows) {
  return R1::SinCosTurnsInRange(0.5 * (column + share) / rows - 0.5);
}

/// Returns a unit direction.
inline R3::Vector Towards(double sine_of_latitude, const R1::SineCosine& longitude) {
  const double radius = std::sqrt(std::max(0.0, (1 - sine_of_latitude) * (1 + sine_of_latitude)));
  return {radius * longitude.sine, sine_of_latitude, -radius * longitude.cosine};
}

/// Returns the index of the part that contains `share` if [0, 1] is divided into `count` equal parts.
inline int Nearest(double share, int count) { return std::clamp(static_cast<int>(share * count), 0, count - 1); }

}  // namespace ray
