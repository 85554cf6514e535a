#pragma once

namespace R3 {

/// How round a shape is within its bounding box, about y: in coordinates that run from -1 to 1 in the box, nothing of
/// it lies outside
///
///     x^2 + z^2 + bulge y^2 <= (radius + taper y)^2.
///
/// The default holds all of the box.
struct Profile {
  double radius = 2, taper = 0;  // radius >= |taper|
  double bulge = 0;              // 0 or 1

  static constexpr Profile Ball() { return {1, 0, 1}; }
  static constexpr Profile Upright() { return {1, 0, 0}; }  // a cylinder
  static constexpr Profile Pointed() { return {0.5, -0.5, 0}; }
};

}  // namespace R3
