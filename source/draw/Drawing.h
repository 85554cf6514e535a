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

/// What is drawn, as lists that know nothing of OpenGL.
namespace ray {

/// The coordinates of drawings: relative to the center of a scene, in units of its radius, so that single precision
/// shows scenes of any size anywhere.
struct DrawingSpace {
  R3::Point center;
  double radius = 1;  // > 0

  /// The space of a scene with this box; radius 1 for an empty one or a point.
  static DrawingSpace Of(const R3::Box& scene);
  std::array<float, 3> At(const R3::Point& p) const {
    return {static_cast<float>((p.x - center.x) / radius), static_cast<float>((p.y - center.y) / radius),
            static_cast<float>((p.z - center.z) / radius)};
  }
};

/// From a DrawingSpace to OpenGL's clip space, column by column.
using ClipMatrix = std::array<double, 16>;
using ClipRow = std::array<double, 4>;
inline ClipRow Row(const R3::Vector& v, double last) { return {v.x, v.y, v.z, last}; }
ClipMatrix FromRows(const std::array<ClipRow, 4>& rows);
/// What an eye sees between two distances along `towards`, which is of length 1. `right` and `up` are as long as what
/// is seen at distance 1 is wide and high, inverted.
ClipMatrix Perspective(const R3::Vector& eye, const R3::Vector& towards, const R3::Vector& right, const R3::Vector& up,
                       double nearest, double farthest);

/// 8 bits per channel: red, green, blue, alpha.
using Rgba = std::array<std::uint8_t, 4>;
/// What stands for the color of a line on a dark ground where the ground is near white: darker, and of the same hue.
Rgba LineOnLight(const Rgba& color);
/// Clamped to what can be shown.
Rgba Shown(const R2::Color& color, double alpha = 1);

/// The color of one of `count` things that together would hide what is behind them: as it is up to `most`, and then
/// the fainter, the more there are, down to 1/50.
Rgba Faded(Rgba color, std::size_t count, std::size_t most);

struct Vertex {
  std::array<float, 3> at{};  // in a DrawingSpace
  Rgba color{};
};

/// Two vertices per line.
using Lines = std::vector<Vertex>;
void AddLine(Lines& lines, const std::array<float, 3>& from, const std::array<float, 3>& to, const Rgba& color);
void Append(Lines& lines, const Lines& more);

/// How large letters are, in pixels; all have one width.
struct LetterSize {
  double width = 8, height = 16;  // the latter of a line
};

/// A line of text, its lower left corner in pixels from that of the drawing.
struct Label {
  double x = 0, y = 0;
  std::string text;                // UTF-8
  Rgba color{255, 255, 255, 255};  // light, as on the black behind it
  /// Opacity of the black behind it: letters as light as (208, 208, 208) keep 4.5 : 1, also where that covers white.
  static constexpr int ground_alpha = 170;
  /// Opacity of the near white behind it in a light theme: letters of OnLight keep 4.5 : 1, also where that covers
  /// black.
  static constexpr int light_ground_alpha = 220;
  static constexpr std::uint8_t light_ground = 245;
  /// What stands for a light color there: dark, and of the same hue.
  static Rgba OnLight(const Rgba& color);
};

// Numbers in single precision, as a GPU takes them: what is beyond its range becomes the largest there is.

inline float AsFloat(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

inline std::array<float, 3> AsFloats(const R2::Color& c) { return {AsFloat(c.r), AsFloat(c.g), AsFloat(c.b)}; }
inline std::array<float, 3> AsFloats(const R3::Vector& v) { return {AsFloat(v.x), AsFloat(v.y), AsFloat(v.z)}; }

}  // namespace ray
