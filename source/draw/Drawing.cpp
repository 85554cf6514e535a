#include "source/draw/Drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ray {
namespace {

std::uint8_t Byte(double value) {
  return value > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::min(value, 1.0))) : std::uint8_t{0};  // 0 for NaN
}

}  // namespace

DrawingSpace DrawingSpace::Of(const R3::Box& scene) {
  DrawingSpace space;
  if (scene.IsEmpty()) return space;
  space.center = scene.Center();
  // Halved before subtraction: boxes may be as wide as the range of doubles.
  const double radius = Length(R3::Vector{scene.high.x / 2 - scene.low.x / 2, scene.high.y / 2 - scene.low.y / 2,
                                          scene.high.z / 2 - scene.low.z / 2});
  if (radius > 0) space.radius = std::min(radius, std::numeric_limits<double>::max());
  return space;
}

ClipMatrix FromRows(const std::array<ClipRow, 4>& rows) {
  ClipMatrix matrix{};
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c) matrix[4 * c + r] = rows[r][c];
  return matrix;
}

ClipMatrix Perspective(const R3::Vector& eye, const R3::Vector& towards, const R3::Vector& right, const R3::Vector& up,
                       double nearest, double farthest) {
  const double a = (farthest + nearest) / (farthest - nearest), b = -2 * farthest * nearest / (farthest - nearest);
  return FromRows({Row(right, -Dot(right, eye)), Row(up, -Dot(up, eye)), Row(a * towards, b - a * Dot(towards, eye)),
                   Row(towards, -Dot(towards, eye))});
}

void AddLine(Lines& lines, const std::array<float, 3>& from, const std::array<float, 3>& to, const Rgba& color) {
  lines.push_back({from, color});
  lines.push_back({to, color});
}

void Append(Lines& lines, const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); }

Rgba Shown(const R2::Color& color, double alpha) { return {Byte(color.r), Byte(color.g), Byte(color.b), Byte(alpha)}; }

Rgba LineOnLight(const Rgba& color) {
  constexpr double brightest = 0.2;  // luminance: a contrast of at least 3 : 1 on near white
  const int least = std::min({color[0], color[1], color[2]});
  const auto share = [&](std::size_t i) { return (color[i] - least) / 255.0; };
  R2::Color light = DecodeSrgb(R2::Color{share(0), share(1), share(2)});
  if (Luminance(light) > brightest) light = brightest / Luminance(light) * light;
  return Shown(EncodeSrgb(light), color[3] / 255.0);
}

Rgba Faded(Rgba color, std::size_t count, std::size_t most) {
  constexpr double faintest = 1.0 / 50;
  if (count <= most) return color;
  const double share = std::max(faintest, static_cast<double>(most) / static_cast<double>(count));
  color[3] = static_cast<std::uint8_t>(std::lround(share * color[3]));
  return color;
}

Rgba Label::OnLight(const Rgba& color) {
  constexpr int stronger = 2;
  const int least = std::min({color[0], color[1], color[2]});
  const auto channel = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::min(255, stronger * (c - least))); };
  return {channel(color[0]), channel(color[1]), channel(color[2]), color[3]};
}

}  // namespace ray
