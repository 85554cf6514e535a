#include "source/view/Drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ray {
namespace {

std::uint8_t Byte(double value) {
  return value > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::min(value, 1.0))) : std::uint8_t{0};  // also NaN
}

}  // namespace

DrawingSpace DrawingSpace::Of(const R3::Box& scene) {
  DrawingSpace space;
  if (scene.IsEmpty()) return space;
  space.center = scene.Center();
  // Halved before they are subtracted: boxes may be as wide as doubles go.
  const double radius = Length(R3::Vector{scene.high.x / 2 - scene.low.x / 2, scene.high.y / 2 - scene.low.y / 2,
                                          scene.high.z / 2 - scene.low.z / 2});
  if (radius > 0) space.radius = std::min(radius, std::numeric_limits<double>::max());
  return space;
}

void AddLine(Lines& lines, const std::array<float, 3>& from, const std::array<float, 3>& to, const Rgba& color) {
  lines.push_back({from, color});
  lines.push_back({to, color});
}

void Append(Lines& lines, const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); }

Rgba Shown(const R2::Color& color, double alpha) { return {Byte(color.r), Byte(color.g), Byte(color.b), Byte(alpha)}; }

Rgba Faded(Rgba color, std::size_t count, std::size_t most) {
  constexpr double faintest = 1.0 / 50;
  if (count <= most) return color;
  const double share = std::max(faintest, static_cast<double>(most) / static_cast<double>(count));
  color[3] = static_cast<std::uint8_t>(std::lround(share * color[3]));
  return color;
}

}  // namespace ray
