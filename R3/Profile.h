#pragma once

namespace R3 {

/// A rotationally symmetric bound of a shape about y. In coordinates from -1 to 1 within the shape's bounding box, the
/// shape lies inside
///
///     x^2 + z^2 + bulge y^2 <= (radius + taper y)^2.
///
/// The default contains the whole box.
struct Profile {
  double radius = 2, taper = 0;  // radius >= |taper|
  double bulge = 0;              // 0 or 1

  static constexpr Profile Ball() { return {1, 0, 1}; }
  static constexpr Profile Upright() { return {1, 0, 0}; }  // a cylinder
  static constexpr Profile Pointed() { return {0.5, -0.5, 0}; }
};

}  // namespace R3
