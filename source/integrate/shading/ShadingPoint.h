#pragma once

#include "R3/Departure.h"
#include "R3/Intersection.h"
#include "source/accelerate/Contact.h"
#include "source/integrate/TraceState.h"
#include "source/scene/Light.h"

namespace ray {

/// A point being shaded.
struct ShadingPoint {
  /// Sets the members that are known initially.
  ShadingPoint(const R3::Ray& ray, const PathState& arriving, const WorldHit& surface)
      : path(arriving), hit(surface), direction(ray.direction), time(ray.time) {}
  /// Creates the point that a camera ray hits, with its path constructed in place instead of copied.
  ShadingPoint(const R3::Ray& ray, const SampleIndex& index, const WorldHit& surface)
      : path{.index = index}, hit(surface), direction(ray.direction), time(ray.time) {}

  PathState path;  // its throughput includes absorption on the way here
  WorldHit hit;
  R3::Vector direction;  // of the ray that led here
  double time;
  R3::SurfacePoint at;
  const Material* material = nullptr;
  R2::Color kd;             // the material's, times its texture and vertex colors
  R3::Vector wo;            // unit
  R3::Vector N;             // unit shading normal on the viewer's side
  R3::Point free_point;     // origin of rays on the viewer's side
  R3::Departure departure;  // its relation to other surfaces there
  // R3::Ray::leaving of rays that stay on the viewer's side, and of those that go through the surface; these hit the
  // primitive again if `is_met_again`.
  std::int64_t leaving = -1, leaving_behind = -1;
  bool is_met_again = false;
  bool entering = false;     // the ray came from the side of the outward normal
  bool is_smoothed = false;  // N is not the surface's own normal
  // Set if light goes through the surface, see Media: the start of rays that have gone through, the solids that they
  // are inside of, and the index of refraction on this side over that on the other; 0: that of the material over 1, or
  // 1 over it.
  MediumSets::Number media_beyond = 0;
  const R3::Departure* beyond = nullptr;
  double relative_index = 0;
  double bias = 0;  // minimum distance at which rays from here may hit something

  /// Returns the reflectance for the scene's ambient light.
  R2::Color AmbientReflectance(const World& world) const {
    return material->texture_multiplies_ka ? TexturedAmbientReflectance(world) : material->ka;
  }
  /// Returns the surface's own normal on the viewer's side.
  R3::Vector Outward() const { return entering ? AsVector(at.normal) : -AsVector(at.normal); }
  /// Returns the index of refraction on the viewer's side over that on the other.
  double RelativeIndex() const {
    if (relative_index > 0) return relative_index;
    return entering ? 1 / material->ir : material->ir;
  }
  /// Returns true if a direction on N's side is inside the surface itself: no light can arrive from there.
  bool IsBehindSurface(const R3::Vector& way) const { return is_smoothed && !(Dot(Outward(), way) > 0); }
  /// Returns the color of the specular map; white without a map.
  R2::Color Shown() const {
    if (material->specular_map) [[unlikely]]
      return material->specular_map->On(at, material->texture_scale);
    return {1, 1, 1};
  }
  /// Returns a specular reflectance multiplied by the specular map.
  R2::Color Mapped(const R2::Color& reflected) const { return Shown() * reflected; }
  bool HasReflectance() const { return !IsBlack(kd) || !IsBlack(material->ks); }
  /// Returns the approximate reflectance for light from all directions.
  R2::Color Albedo() const { return kd + Mapped(material->kr) + material->kt; }
  /// Returns the light that the point sends back before any light is sampled.
  R2::Color EmittedAndAmbient(const World& world) const {
    return material->emission + AmbientReflectance(world) * world.scene().ambient;
  }

 private:
  R2::Color TexturedAmbientReflectance(const World& world) const;
};

/// Returns the surface where a path's ray hits. Subtracts absorption inside a solid on the way, see LeftAfter, from the
/// path's throughput, unless Media have done so.
ShadingPoint ShadingPointAt(const World& world, const R3::Ray& ray, const PathState& path, const WorldHit& hit);

/// Sets the primitive that rays from the point leave; its hit and viewer's side must be known.
inline void SetLeaving(const World& world, ShadingPoint& p) {
  const R3::Form form = world.Instances()[p.hit.instance].form;
  const std::int64_t primitive = world.PrimitiveId(p.hit);
  const auto is_met = [&](bool is_outward) {
    return !(form == R3::Form::flat || (form == R3::Form::convex && is_outward));
  };
  p.leaving = is_met(p.entering) ? -1 : primitive;
  p.leaving_behind = primitive, p.is_met_again = is_met(!p.entering);
}

/// Sets the start of rays from the point, to which `ray` led; its normal must be known.
void SetDeparture(const World& world, const R3::Ray& ray, ShadingPoint& p);

/// Returns the interpolated color of a mesh's vertices at a hit; white for other shapes.
R2::Color VertexColorAt(const World& world, const WorldHit& hit);
/// Returns the kd of a point whose surface is known.
inline R2::Color KdAt(const World& world, const ShadingPoint& p) {
  const Material& m = *p.material;
  const R2::Color kd = m.texture ? m.kd * m.texture->On(p.at, m.texture_scale) : m.kd;
  return m.has_vertex_colors ? kd * VertexColorAt(world, p.hit) : kd;
}
/// Reduces the throughput by absorption inside a solid on the way here; the last step of making a point.
void AbsorbOnTheWay(const R3::Ray& ray, ShadingPoint& p);

/// Returns the background color for a ray that hits nothing.
R2::Color Background(const Scene& scene, const R3::Vector& direction);

/// Returns the t_min of a ray from the point.
inline double BeginTowards(const ShadingPoint& surface, const R3::Vector& direction) {
  if (surface.bias > 0) [[unlikely]]
    return surface.bias / Length(direction);
  return surface.departure.BeginTowards(direction);
}

/// Returns a ray from the point in a new direction, on either side, at the same time. It must not outlive the point.
R3::Ray SpawnRay(const ShadingPoint& surface, const R3::Vector& direction);
/// Returns R3::Ray::leaving of a ray from a point towards a light; `facing` is N . to_light.
inline std::int64_t LeavingTowards(std::int64_t leaving, double facing) { return facing > 0 ? leaving : -1; }
/// Returns the t_max of a ray towards a light.
inline double EndOf(const ShadowTarget& light) {
  return light.is_infinite ? R3::infinity : light.reaching < 0 ? 1 : beyond_target;
}
/// The common properties of shadow rays from a point, to be read once for all of them.
struct ShadowOrigin {
  explicit ShadowOrigin(const ShadingPoint& p) : point(&p), place(p.free_point), time(p.time), leaving(p.leaving) {}

  const ShadingPoint* point;
  R3::Point place;
  double time;
  std::int64_t leaving;  // of rays that stay on the viewer's side
};
inline R3::Ray ShadowRay(const ShadingPoint& surface, const ShadowTarget& light) {
  return {.origin = surface.free_point,
          .direction = light.to_light,
          .t_min = BeginTowards(surface, light.to_light),
          .t_max = EndOf(light),
          .time = surface.time,
          .leaving = LeavingTowards(surface.leaving, Dot(surface.N, light.to_light)),
          .reaching = light.reaching,
          .departure = &surface.departure};
}

}  // namespace ray
