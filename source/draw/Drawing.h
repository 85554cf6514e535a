#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "R3/Box.h"
#include "R3/Vector.h"

/// The contents of drawings, as lists without reference to OpenGL.
namespace ray {

/// The coordinates of drawings: relative to the center of a scene, in units of its radius, so that single precision
/// shows scenes of any size anywhere.
struct DrawingSpace {
  R3::Point center;
  double radius = 1;  // > 0

  /// Returns the space of a scene with this box; the radius is 1 for an empty box or a point.
  static DrawingSpace Of(const R3::Box& scene);
  std::array<float, 3> At(const R3::Point& p) const {
    return {static_cast<float>((p.x - center.x) / radius), static_cast<float>((p.y - center.y) / radius),
            static_cast<float>((p.z - center.z) / radius)};
  }
  /// Returns the point with these coordinates, in single precision.
  R3::Point PointAt(const std::array<float, 3>& at) const {
    return center + radius * R3::Vector{double{at[0]}, double{at[1]}, double{at[2]}};
  }
};

/// A matrix from a DrawingSpace to OpenGL's clip space, column by column.
using ClipMatrix = std::array<double, 16>;
using ClipRow = std::array<double, 4>;
inline ClipRow Row(const R3::Vector& v, double last) { return {v.x, v.y, v.z, last}; }
ClipMatrix FromRows(const std::array<ClipRow, 4>& rows);
/// Returns the perspective projection of an eye between two distances along `towards`, which has length 1. The lengths
/// of `right` and `up` are the inverse width and height of the view at distance 1.
ClipMatrix Perspective(const R3::Vector& eye, const R3::Vector& towards, const R3::Vector& right, const R3::Vector& up,
                       double nearest, double farthest);

/// A color with 8 bits per channel: red, green, blue, alpha.
using Rgba = std::array<std::uint8_t, 4>;
/// Returns the color of a line on a near white background that replaces one for a dark background: darker, with the
/// same hue.
Rgba LineOnLight(const Rgba& color);
/// Returns the color clamped to the displayable range.
Rgba Shown(const R2::Color& color, double alpha = 1);

/// Returns the color of one of `count` objects that together would hide everything behind them: unchanged up to `most`
/// objects, and fainter for more, down to 1/50.
Rgba Faded(Rgba color, std::size_t count, std::size_t most);

struct Vertex {
  std::array<float, 3> at{};  // in a DrawingSpace
  Rgba color{};
};

/// Lines, with two vertices each.
using Lines = std::vector<Vertex>;
void AddLine(Lines& lines, const std::array<float, 3>& from, const std::array<float, 3>& to, const Rgba& color);
void Append(Lines& lines, const Lines& more);

/// The size of letters in pixels; all have the same width.
struct LetterSize {
  double width = 8, height = 16;  // height of a line
};

/// A line of text; its lower left corner is in pixels from that of the drawing.
struct Label {
  double x = 0, y = 0;
  std::string text;                // UTF-8
  Rgba color{255, 255, 255, 255};  // light, for the black background
  /// Opacity of the black background: letters at least as light as (208, 208, 208) have a contrast of 4.5 : 1 even over
  /// white.
  static constexpr int ground_alpha = 170;
  /// Opacity of the near white background in a light theme: letters of OnLight have a contrast of 4.5 : 1 even over
  /// black.
  static constexpr int light_ground_alpha = 220;
  static constexpr std::uint8_t light_ground = 245;
  /// Returns the color on a light background that replaces a light color: dark, with the same hue.
  static Rgba OnLight(const Rgba& color);
};

// Numbers in single precision for the GPU. Values beyond its range become the largest finite float.

inline float AsFloat(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

inline std::array<float, 3> AsFloats(const R2::Color& c) { return {AsFloat(c.r), AsFloat(c.g), AsFloat(c.b)}; }
inline std::array<float, 3> AsFloats(const R3::Vector& v) { return {AsFloat(v.x), AsFloat(v.y), AsFloat(v.z)}; }

}  // namespace ray
