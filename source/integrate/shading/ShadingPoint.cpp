#include "source/integrate/shading/ShadingPoint.h"

#include <algorithm>

#include "source/integrate/shading/Absorption.h"
#include "source/integrate/shading/Bump.h"

namespace ray {
namespace {

R3::Vector Facing(const R3::Normal& n, bool entering) { return entering ? AsVector(n) : -AsVector(n); }

}  // namespace

ShadingPoint ShadingPointAt(const World& world, const R3::Ray& ray, const PathState& path, const WorldHit& hit) {
  ShadingPoint s(ray, path, hit);
  s.at = world.At(ray, hit);
  s.material = &world.MaterialAt(hit);
  s.bias = world.scene().shadow_bias;
  s.kd = KdAt(world, s);
  s.wo = -Unit(ray.direction);
  s.entering = Dot(s.at.normal, ray.direction) <= 0;
  SetLeaving(world, s);
  s.N = Facing(s.at.shading_normal, s.entering);
  if (s.material->normal_map) s.N = NormalMapped(s, world.UvTangentsAt(ray, hit));
  if (s.material->bump) s.N = Bumped(s, world.UvTangentsAt(ray, hit));
  s.is_smoothed = !(s.N == Facing(s.at.normal, s.entering));
  SetDeparture(world, ray, s);
  AbsorbOnTheWay(ray, s);
  return s;
}

void SetDeparture(const World& world, const R3::Ray& ray, ShadingPoint& p) {
  if (HasNotMoved(ray, p.hit.t)) {
    p.free_point = ray.origin, p.departure = *ray.departure;
  } else {
    const R3::FreePoint free =
        R3::FreePointBefore(ray.origin, ray.direction, std::max(ray.t_min, 0.0), p.hit.t,
                            Dot(p.at.normal, ray.direction), world.Instances()[p.hit.instance].error);
    p.free_point = free.place;
    p.departure = {free.clearance, ray.direction, nullptr};
  }
}

void AbsorbOnTheWay(const R3::Ray& ray, ShadingPoint& p) {
  if (p.entering || p.path.media != 0 || IsBlack(p.material->absorb)) return;
  const double distance = (p.hit.t - std::max(ray.t_min, 0.0)) * Length(ray.direction);
  p.path.throughput = p.path.throughput * LeftAfter(p.material->absorb, distance);
}

R2::Color VertexColorAt(const World& world, const WorldHit& hit) {
  const R3::Mesh* mesh = world.Instances()[hit.instance].mesh;
  return mesh ? mesh->ColorAt(hit, hit.element) : R2::Color{1, 1, 1};
}

R2::Color ShadingPoint::TexturedAmbientReflectance(const World& world) const {
  const R2::Color ka =
      material->texture ? material->ka * material->texture->On(at, material->texture_scale) : material->ka;
  return material->has_vertex_colors ? ka * VertexColorAt(world, hit) : ka;
}

R2::Color Background(const Scene& scene, const R3::Vector& direction) {
  return scene.environment ? scene.environment->Radiance(direction) : scene.background;
}

R3::Ray SpawnRay(const ShadingPoint& surface, const R3::Vector& direction) {
  const double along = Dot(surface.at.normal, direction);
  const bool is_towards_viewer = (along < 0) == (Dot(surface.at.normal, surface.wo) < 0);
  R3::Ray ray{.origin = surface.free_point,
              .direction = direction,
              .t_min = BeginTowards(surface, direction),
              .time = surface.time,
              .leaving = is_towards_viewer ? surface.leaving : surface.leaving_behind,
              .departure = &surface.departure};
  if (is_towards_viewer) return ray;
  if (surface.is_met_again)
    ray.leaving_until = std::max(ray.t_min, surface.departure.Reach(ray.origin) / std::abs(along));
  if (surface.beyond) ray.departure = surface.beyond;
  return ray;
}

}  // namespace ray
