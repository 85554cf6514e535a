#pragma once

#include "R3/Intersection.h"
#include "source/integrate/TraceState.h"
#include "source/scene/Light.h"

namespace ray {

/// A point being shaded.
struct ShadingPoint {
  /// What is known at first.
  ShadingPoint(const PathState& arriving, const WorldHit& surface) : path(arriving), hit(surface) {}

  PathState path;  // that led here; its throughput is what is left after the way
  WorldHit hit;
  R3::Intersection at;
  const Material* material = nullptr;
  R2::Color kd;              // the material's, times its texture
  R3::Vector wo;             // unit
  bool entering = false;     // whether the ray came from the side of the outward normal
  R3::Vector N;              // unit shading normal on the viewer's side
  bool is_smoothed = false;  // N is not the surface's own normal
  R3::Point shadow_origin;   // where shadow rays and reflections start: off the surface, on the viewer's side
  // R3::Ray::leaving of rays that start here on the viewer's side, and of those on the other.
  std::int64_t leaving = -1, leaving_behind = -1;
  double bias = 0;     // where they may first hit something, in distance from there
  R2::Color radiance;  // back along the ray, as far as it is known

  /// What of the scene's ambient light is reflected.
  R2::Color AmbientReflectance() const;
  /// The surface's own normal on the viewer's side.
  R3::Vector Outward() const { return entering ? AsVector(at.normal) : -AsVector(at.normal); }
  /// Whether a direction that N faces leads into the surface itself: from there no light can arrive.
  bool IsBehindSurface(const R3::Vector& direction) const { return is_smoothed && !(Dot(Outward(), direction) > 0); }
  bool HasReflectance() const { return !IsBlack(kd) || !IsBlack(material->ks); }
  /// What it scatters of light from everywhere, about.
  R2::Color Albedo() const { return kd + material->kr + material->kt; }
  /// What it sends back before any light is sampled.
  R2::Color EmittedAndAmbient(const Scene& scene) const {
    return material->emission + AmbientReflectance() * scene.ambient;
  }
};

/// The surface where a ray was found to hit. What the inside of a solid absorbed on the way, see LeftAfter, is taken
/// from the path's throughput.
ShadingPoint ShadingPointAt(const World& world, const PathState& ray, const WorldHit& hit);

/// Of a point whose hit and viewer's side are known, what rays from there leave.
inline void SetLeaving(const World& world, ShadingPoint& p) {
  const R3::Form form = world.Instances()[p.hit.instance].form;
  const std::int64_t primitive = world.PrimitiveId(p.hit);
  const auto leaving_if = [&](bool is_outward) {
    return form == R3::Form::flat || (form == R3::Form::convex && is_outward) ? primitive : -1;
  };
  p.leaving = leaving_if(p.entering), p.leaving_behind = leaving_if(!p.entering);
}

/// Of a point whose surface is known, its kd; and the last of these.
inline R2::Color KdAt(const ShadingPoint& p) {
  return p.material->texture ? p.material->kd * p.material->texture->On(p.at) : p.material->kd;
}
void AbsorbOnTheWay(ShadingPoint& p);

/// What a ray that hits nothing sees.
R2::Color Background(const Scene& scene, const R3::Vector& direction);

/// Where a ray may first hit something, as a share of its direction's length.
inline double LeastT(const ShadingPoint& surface, const R3::Vector& direction) {
  return surface.bias > 0 ? surface.bias / Length(direction) : 0;
}

/// The same place, a new direction: off the surface on the side it heads for, in the same moment.
R3::Ray SpawnRay(const ShadingPoint& surface, const R3::Vector& direction);
/// Sends a ray from the viewer's side towards a light.
inline void AimShadowRay(const ShadingPoint& surface, const R3::Vector& to_light, R3::Ray& ray) {
  ray.direction = to_light;
  ray.t_min = LeastT(surface, to_light);
  ray.leaving = Dot(surface.N, to_light) > 0 ? surface.leaving : -1;
}
inline R3::Ray ShadowRay(const ShadingPoint& surface, const ShadowTarget& light) {
  R3::Ray ray{.origin = surface.shadow_origin,
              .direction = light.to_light,
              .t_max = light.is_infinite ? R3::infinity : 1,
              .time = surface.path.ray.time,
              .reaching = light.reaching};
  AimShadowRay(surface, light.to_light, ray);
  return ray;
}

}  // namespace ray
