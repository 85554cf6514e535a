#include "grader/RuledDepth.h"

#include <cmath>

namespace ray::grade {
namespace {

/// Calls `visit` with each element and the ray in its frame, until it returns true. Returns true if it did.
template <typename Visit>
bool VisitElements(const World& world, const R3::Ray& ray, const Visit& visit) {
  LocalRays local(world, ray);
  for (std::uint32_t i = 0; i < world.Instances().size(); ++i) {
    const Instance& instance = world.Instances()[i];
    if (!instance.is_bounded || instance.is_repeated) continue;
    for (int e = 0; e < instance.shape->Elements(); ++e)
      if (visit(i, e, local.In(instance.frame))) return true;
  }
  return false;
}

/// Returns the second intersection with a sphere, if there is one.
std::optional<R3::Hit> FarSide(const R3::Shape& shape, R3::Ray local, int element, const R3::Hit& near) {
  if (!shape.AsSphere()) return near;
  // Beyond the rounding of the first intersection, which is many such steps before the second except at the rim.
  constexpr double step = 1e-9;
  local.t_min = near.t + step * std::abs(near.t);
  const auto far = shape.Intersect(local, element);
  return far ? far : near;
}

}  // namespace

void RuledDepth::Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const {
  std::optional<WorldHit> chosen;
  double least = R3::infinity;
  VisitElements(world_, ray, [&](std::uint32_t instance, int element, const R3::Ray& local) {
    auto hit = FirstCrossing(world_, ray, local, instance, element, workspace.counts);
    if (hit && rules_.far_side_of_spheres) hit = FarSide(*world_.Instances()[instance].shape, local, element, *hit);
    if (!hit) return false;
    const double length = rules_.choice == DepthRules::Choice::by_local_length ? Length(local.direction) : 1;
    const double key = hit->t * length;
    const bool counts = rules_.choice == DepthRules::Choice::last_in_file || key < least;
    if (counts) least = key, chosen = {*hit, instance, element};
    return rules_.choice == DepthRules::Choice::first_in_file;
  });
  if (chosen) nearest.Offer(*chosen);
}

bool RuledDepth::Any(const R3::Ray& ray, Workspace& workspace) const {
  return VisitElements(world_, ray, [&](std::uint32_t instance, int element, const R3::Ray& local) {
    if (rules_.glass_casts_no_shadow && world_.Instances()[instance].IsClear()) return false;
    return IsInTheWay(world_, ray, local, instance, element, workspace.counts);
  });
}

}  // namespace ray::grade
