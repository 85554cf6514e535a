#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "R1/Elementary.h"
#include "R2/Image.h"
#include "R3/Vector.h"

namespace ray {

/// How a picture of everything around is laid flat. In every layout it is seen from the inside with y up, and -z is
/// ahead with +x to the right of it.
enum class EnvironmentLayout {
  /// 2:1. Of width and height 1 from the lower left, u = 1/2 + atan2(x, -z) / (2 pi) and
  /// v = 1/2 + asin(y / length) / pi: -y is the lowest row, +y the highest, -z the middle, +z the left and right edge.
  latitude_longitude,
  /// 1:1. The middle looks along -z; a place at the share r of the way to the middle of an edge looks pi r away from
  /// it, towards +x when to the right, +y when above. The circle's rim is +z; the corners beyond it are not used.
  /// Source: Debevec, Light probe image gallery (1998), the angular map.
  angular_probe,
  /// 3:4 or 4:3, a cube of six square faces unfolded:
  ///
  ///        +y             +y
  ///     -x -z +x       -x -z +x +z
  ///        -y             -y
  ///        +z
  ///
  /// +y has -z at its lower edge and -y at its upper. The lowest face of the upright cross hangs from -y, so it stands
  /// on its head (-y above, +x to the right), as in Debevec's files. The places between the arms are not used.
  cross
};

/// "latitude-longitude map", "angular probe", "cross of six faces".
std::string_view Name(EnvironmentLayout layout);

/// Known by the shape. Throws std::invalid_argument, with a message for the user, for an image of another shape.
EnvironmentLayout LayoutOf(const R2::Image& image);

/// Turns an image of that layout into a latitude-longitude map; see Environment. Throws std::invalid_argument, with a
/// message for the user, where a value is negative or not finite.
R2::Image Unfolded(R2::Image image, EnvironmentLayout layout);

// Places on a latitude-longitude map of `rows` rows and twice as many columns.

/// The sine of the latitude of the edge below a row, of latitude -pi/2 + pi row / rows.
inline double SineOfEdge(int row, int rows) { return -R1::SinCosTurns(0.5 * row / rows).cosine; }

/// From -z by +x, at a share of a column's width.
inline R1::SineCosine LongitudeOf(int column, double share, int rows) {
  return R1::SinCosTurnsInRange(0.5 * (column + share) / rows - 0.5);
}

/// Unit.
inline R3::Vector Towards(double sine_of_latitude, const R1::SineCosine& longitude) {
  const double radius = std::sqrt(std::max(0.0, (1 - sine_of_latitude) * (1 + sine_of_latitude)));
  return {radius * longitude.sine, sine_of_latitude, -radius * longitude.cosine};
}

/// Index of the part that `share` falls into when [0, 1] is cut into `count` equal parts.
inline int Nearest(double share, int count) { return std::clamp(static_cast<int>(share * count), 0, count - 1); }

}  // namespace ray
