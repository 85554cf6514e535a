#include "source/draw/preview/ShadowViews.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "R1/Elementary.h"
#include "R3/Warp.h"
#include "source/draw/Drawing.h"

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

/// The clip matrix of a light's view, as Perspective defines it.
ClipMatrix From(const PreviewLight& light, const R3::Vector& towards, const R3::Vector& right, const R3::Vector& up) {
  const R3::Vector eye = AsVector(light.place);
  const double distance = Length(eye), farthest = distance + reach;
  const double lamp = light.is_flat ? 0 : light.radius;
  const double nearest = std::max({lamp, distance - reach, nearest_of_farthest * farthest});
  return Perspective(eye, towards, right, up, nearest, farthest);
}

ClipMatrix Cone(const PreviewLight& light, const R3::Vector& towards, double half_angle) {
  const R3::Tangents across = R3::TangentsOf(towards);
  const double scale = 1 / R1::Tan(half_angle);
  return From(light, towards, scale * across.first, scale * across.second);
}

/// One view of all that a light shines on; nothing where it takes six.
std::optional<ClipMatrix> OneView(const PreviewLight& light) {
  constexpr double widest_disc = 75 * std::numbers::pi / 180;
  const R3::Vector place = AsVector(light.place);
  if (light.is_infinite) return Along(-place);
  const double distance = Length(place), spot = R1::Acos(std::clamp(light.least_cosine, -1.0, 1.0));
  if (spot < widest_spot) return Cone(light, AsVector(light.direction), 1.01 * spot + 1e-3);
  if (distance > outside) return Cone(light, -place / distance, R1::Asin(reach / distance));
  if (light.is_disc || light.is_flat) return Cone(light, AsVector(light.direction), widest_disc);
  return {};
}

std::vector<ClipMatrix> SixViews(const PreviewLight& light) {
  constexpr double overlap = 0.01;  // radians, so that neighbors of a texel at the edge are there
  std::vector<ClipMatrix> six;
  for (const R3::Vector& axis : {R3::Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    for (const double sign : {1.0, -1.0}) six.push_back(Cone(light, sign * axis, std::numbers::pi / 4 + overlap));
  return six;
}

/// The light shrunk to each of its places: of its disc, or of that which a sphere is seen as from the scene's middle.
///   source   Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 25.4.61
std::vector<PreviewLight> PlacesOf(const PreviewLight& light) {
  const R3::Vector place = AsVector(light.place);
  const bool has_plane = light.is_disc || light.is_flat;
  const R3::Tangents across = R3::TangentsOf(has_plane ? AsVector(light.direction) : Unit(place));
  std::vector<PreviewLight> places{light};
  for (int i = 0; i < places_of_light - 1; ++i) {
    const double angle = 2 * std::numbers::pi * i / (places_of_light - 1), r = std::sqrt(2.0 / 3) * light.radius;
    const R3::Vector p = place + r * R1::Cos(angle) * across.first + r * R1::Sin(angle) * across.second;
    places.push_back(light);
    places.back().place = AsFloats(p);
  }
  return places;
}

}  // namespace

ShadowViews ShadowViewsOf(const std::vector<PreviewLight>& lights, std::size_t most) {
  ShadowViews found;
  auto& views = found.clip_from_drawing;
  const auto have_room = [&](std::size_t more) { return views.size() + more <= most; };
  for (const PreviewLight& light : lights) {
    found.first.push_back(0);
    found.places.push_back(1);
    if (!light.casts_shadows) continue;
    const int first = static_cast<int>(views.size()) + 1;
    const auto one = OneView(light);
    if (one && light.radius > 0 && !light.is_infinite && have_room(places_of_light)) {
      for (const PreviewLight& place : PlacesOf(light)) views.push_back(OneView(place).value_or(*one));
      found.first.back() = first;
      found.places.back() = places_of_light;
    } else if (one && have_room(1)) {
      views.push_back(*one);
      found.first.back() = first;
    } else if (!one && have_room(6)) {
      const auto six = SixViews(light);
      views.insert(views.end(), six.begin(), six.end());
      found.first.back() = -first;
    }
  }
  return found;
}

}  // namespace ray
