#include "source/integrate/media/Media.h"

#include <algorithm>

#include "source/integrate/shading/Absorption.h"

namespace ray {
namespace {

// The limit of successive surfaces without an effect on a path. Further ones count as surfaces, so that every search
// ends.
constexpr int most_passed = 1000;

}  // namespace

Media::Media(const World& world, const Accelerator& accelerator) : world_(world), accelerator_(accelerator) {
  for (std::uint32_t i = 0; i < world.Instances().size(); ++i) {
    const Instance& instance = world.Instances()[i];
    is_needed_ |= instance.IsClear() || instance.is_medium;
    is_absorbing_ |= instance.is_medium && !IsBlack(instance.material->absorb);
    if (!instance.is_medium) continue;
    media_.push_back(i);
  }
}

std::vector<std::uint32_t> Media::Around(const R3::Point& p) const {
  std::vector<std::uint32_t> around;
  for (const std::uint32_t i : media_)
    if (world_.Instances()[i].bounds.Contains(p)) around.push_back(i);
  return around;
}

/// Finds the solids around the origin of a ray: those that are left first along the ray. The search happens once for
/// many rays, so it counts as no ray's cost; otherwise costs would depend on the thread that does it.
MediumSets::Number Media::Find(const R3::Ray& ray, TraceState& state) const {
  const Counts so_far = state.workspace.counts;
  std::vector<std::uint32_t> undecided = Around(ray.origin);
  MediumSets::Number media = 0;
  R3::Ray along = ray;
  for (int passed = 0; !undecided.empty() && passed < most_passed; ++passed) {
    const auto hit = accelerator_.Intersect(along, state.workspace);
    if (!hit) break;
    const auto found = std::ranges::find(undecided, hit->instance);
    if (found != undecided.end()) {
      if (Dot(world_.At(along, *hit).normal, ray.direction) > 0) media = state.media.With(media, *found, world_);
      undecided.erase(found);
    }
    along = Beyond(along, {}, *hit, state);
  }
  state.workspace.counts = so_far;
  return media;
}

void Media::Arrive(R3::Ray& ray, PathState& path, std::optional<WorldHit>& hit, TraceState& state) const {
  for (int passed = 0; hit; ++passed) {
    if (path.media != 0 && is_absorbing_) {
      const double distance = (hit->t - std::max(ray.t_min, 0.0)) * Length(ray.direction);
      path.throughput = LeftOf(path.throughput, path.media, distance, state);
    }
    if (IsFirstOrLast(ray, path, *hit)) return;
    MediumSets::Number beyond = path.media;
    if (passed == most_passed || !Passes(ray, path, *hit, state, beyond)) return;
    ray = Beyond(ray, path, *hit, state);
    path.media = beyond;
    hit = accelerator_.Intersect(ray, state.workspace);
    state.Count(path.kind, 1);
  }
}

/// Returns true if the surface has no effect on the path. Sets `beyond` to the solids around the path behind it.
bool Media::Passes(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state,
                   MediumSets::Number& beyond) const {
  const Instance& instance = world_.Instances()[hit.instance];
  if (!instance.is_medium || !instance.IsClear()) return false;
  const bool leaves = Dot(world_.At(ray, hit).normal, ray.direction) > 0;
  // At edges between triangles of a mesh, a path may already have gone in or out. Elsewhere it has lost count at an
  // edge that it missed by rounding, and treats the surface as real.
  if (leaves != state.media.Has(path.media, hit.instance, world_)) return IsNearStart(ray, hit.t);
  beyond = leaves ? state.media.Without(path.media, hit.instance, world_)
                  : state.media.With(path.media, hit.instance, world_);
  return state.media.At(beyond, world_).material == state.media.At(path.media, world_).material;
}

/// Returns the ray continued straight behind a surface.
R3::Ray Media::Beyond(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state) const {
  ShadingPoint p = ShadingPointAt(world_, ray, path, hit);
  SetSides(p, state);
  return SpawnRay(p, ray.direction);
}

void Media::SetSides(ShadingPoint& p, TraceState& state) const {
  R3::Departure& beyond = state.departures.Add(p.departure);
  beyond.crossed = &state.crossings.Add({world_.PrimitiveId(p.hit), AsVector(p.at.normal), p.departure.crossed});
  p.beyond = &beyond;
  p.media_beyond = p.path.media;
  const std::uint32_t number = p.hit.instance;
  const Instance& instance = world_.Instances()[number];
  if (!instance.is_medium || p.entering == state.media.Has(p.path.media, number, world_)) return;
  p.media_beyond = p.entering ? state.media.With(p.path.media, number, world_)
                              : state.media.Without(p.path.media, number, world_);
  // The point itself knows the index of its material relative to empty space.
  if (MediumSets::IsWithin(p.path.media, number) && !instance.has_parts) return;
  p.relative_index = state.media.At(p.path.media, world_).Index() / state.media.At(p.media_beyond, world_).Index();
}

R2::Color Media::LeftOf(const R2::Color& light, MediumSets::Number media, double distance,
                        const TraceState& state) const {
  const R2::Color absorb = state.media.At(media, world_).absorb;
  return IsBlack(absorb) ? light : light * LeftAfter(absorb, distance);
}

}  // namespace ray
