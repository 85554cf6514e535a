#include "source/integrate/ShadingPoint.h"

#include "source/integrate/Absorption.h"
#include "source/integrate/Bump.h"

namespace ray {
namespace {

R3::Vector Facing(const R3::Normal& n, bool entering) { return entering ? AsVector(n) : -AsVector(n); }

}  // namespace

ShadingPoint ShadingPointAt(const World& world, const PathState& ray, const WorldHit& hit) {
  ShadingPoint s(ray, hit);
  s.at = world.At(ray.ray, hit);
  s.material = &world.MaterialAt(hit);
  s.bias = world.scene().shadow_bias;
  s.kd = KdAt(s);
  s.wo = -Unit(ray.ray.direction);
  s.entering = Dot(s.at.normal, ray.ray.direction) <= 0;
  SetLeaving(world, s);
  s.N = Facing(s.at.shading_normal, s.entering);
  if (s.material->normal_map) s.N = NormalMapped(s, world.UvTangentsAt(ray.ray, hit));
  if (s.material->bump) s.N = Bumped(s, world.UvTangentsAt(ray.ray, hit));
  s.is_smoothed = !(s.N == Facing(s.at.normal, s.entering));
  s.shadow_origin = SpawnPoint(s.at, s.wo);
  AbsorbOnTheWay(s);
  return s;
}

void AbsorbOnTheWay(ShadingPoint& p) {
  if (p.entering || IsBlack(p.material->absorb)) return;
  const double distance = (p.hit.t - p.path.ray.t_min) * Length(p.path.ray.direction);
  p.path.throughput = p.path.throughput * LeftAfter(p.material->absorb, distance);
}

R2::Color ShadingPoint::AmbientReflectance() const {
  if (!material->texture_multiplies_ka || !material->texture) return material->ka;
  return material->ka * material->texture->On(at);
}

R2::Color Background(const Scene& scene, const R3::Vector& direction) {
  return scene.environment ? scene.environment->Radiance(direction) : scene.background;
}

R3::Ray SpawnRay(const ShadingPoint& surface, const R3::Vector& direction) {
  const R3::Vector n = AsVector(surface.at.normal);
  const bool is_towards_viewer = (Dot(n, direction) < 0) == (Dot(n, surface.wo) < 0);
  return {.origin = is_towards_viewer ? surface.shadow_origin : SpawnPoint(surface.at, direction),
          .direction = direction,
          .t_min = LeastT(surface, direction),
          .time = surface.path.ray.time,
          .leaving = is_towards_viewer ? surface.leaving : surface.leaving_behind};
}

}  // namespace ray
