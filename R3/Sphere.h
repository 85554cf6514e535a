#pragma once

#include <optional>

#include "R3/Hit.h"
#include "R3/Ray.h"
#include "R3/SphereData.h"
#include "R3/SurfacePlace.h"
#include "R3/shapes/Quadric.h"
#include "R3/shapes/Span.h"

namespace R3 {

/// Returns the nearest crossing of a ray with a sphere, strictly between ray.t_min and ray.t_max.
std::optional<Hit> IntersectSphere(const Ray& ray, const SphereData& sphere);

/// Returns both crossings.
Crossings CrossSphere(const Ray& ray, const SphereData& sphere);

/// IntersectSphere with explicit limits, inlined into callers that are compiled for an instruction set.
inline std::optional<Hit> IntersectSphereInline(const Ray& ray, const SphereData& sphere, double t_min, double t_max) {
  if (!(sphere.radius > 0)) return {};
  const auto leaves_from = [&](const Point& p) {
    return IsCertainlyLeaving(p - sphere.center, ray.direction, sphere.radius);
  };
  if (leaves_from(ray.origin) && (t_min >= 0 || leaves_from(ray.At(BeforeHits(t_min))))) return {};
  const auto roots = QuadricRootsInline(ray.origin, ray.direction, sphere.center, sphere.radius);
  if (!roots) return {};
  return Span{roots->first, roots->second, 0, 0}.First(t_min, t_max);
}

/// Returns the point in a unit direction from the center. It has no branches, so that loops over many become vector
/// instructions.
///   accuracy   the direction errs by 4 u, its product with the radius by one more, the sum by one of the result
inline SurfacePlace PlaceOnSphere(const Point& center, double radius, const Vector& outward) {
  const Point place = center + radius * outward;
  return {{place.x, place.y, place.z}, Gamma(6) * radius * Abs(outward) + Gamma(2) * Abs(FromOrigin(place))};
}

}  // namespace R3
