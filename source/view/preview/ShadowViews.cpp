#include "source/view/preview/ShadowViews.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Warp.h"

namespace ray {
namespace {

constexpr double reach = 1.02;                // of the scene from its middle, in its radii, and a little more
constexpr double outside = 1.2 * reach;       // from here one view sees all of it, less than 57 degrees to each side
constexpr double widest_spot = 1;             // radians from its middle
constexpr double nearest_of_farthest = 1e-3;  // with 24 bits of depth

R3::Vector AsVector(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

ClipMatrix Along(const R3::Vector& towards) {
  const R3::Tangents across = R3::TangentsOf(towards);
  return FromRows({Row(across.first / reach, 0), Row(across.second / reach, 0), Row(towards / reach, 0), Row({}, 1)});
}

/// As Perspective has it.
ClipMatrix From(const PreviewLight& light, const R3::Vector& towards, const R3::Vector& right, const R3::Vector& up) {
  const R3::Vector eye = AsVector(light.place);
  const double distance = Length(eye), farthest = distance + reach;
  const double nearest = std::max({light.radius, distance - reach, nearest_of_farthest * farthest});
  return Perspective(eye, towards, right, up, nearest, farthest);
}

ClipMatrix Cone(const PreviewLight& light, const R3::Vector& towards, double half_angle) {
  const R3::Tangents across = R3::TangentsOf(towards);
  const double scale = 1 / R1::Tan(half_angle);
  return From(light, towards, scale * across.first, scale * across.second);
}

/// What one light needs.
std::vector<ClipMatrix> ViewsOf(const PreviewLight& light) {
  const R3::Vector place = AsVector(light.place);
  if (light.is_infinite) return {Along(-place)};
  const double distance = Length(place), spot = R1::Acos(std::clamp(light.least_cosine, -1.0, 1.0));
  if (spot < widest_spot) return {Cone(light, AsVector(light.direction), 1.01 * spot + 1e-3)};
  if (distance > outside) return {Cone(light, -place / distance, R1::Asin(reach / distance))};
  std::vector<ClipMatrix> six;
  for (const R3::Vector& axis : {R3::Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    for (const double sign : {1.0, -1.0}) six.push_back(Cone(light, sign * axis, std::numbers::pi / 4));
  return six;
}

}  // namespace

ShadowViews ShadowViewsOf(const std::vector<PreviewLight>& lights) {
  ShadowViews found;
  auto& views = found.clip_from_drawing;
  for (const PreviewLight& light : lights) {
    found.first.push_back(0);
    if (!light.casts_shadows) continue;
    const std::vector<ClipMatrix> own = ViewsOf(light);
    if (views.size() + own.size() > most_shadow_views) continue;
    const int first = static_cast<int>(views.size()) + 1;
    found.first.back() = own.size() == 1 ? first : -first;
    views.insert(views.end(), own.begin(), own.end());
  }
  return found;
}

}  // namespace ray
