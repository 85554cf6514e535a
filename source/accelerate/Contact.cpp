#include "source/accelerate/Contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ray {
namespace {

constexpr double rounding_share = 64 * R3::unit_roundoff;  // see Contact.h

/// A crossing in a form that can be compared with others.
struct Crossing {
  R3::Vector normal;
  double along;  // n . direction
  double off;    // error along the normal

  Crossing(const World& world, const R3::Ray& ray, const WorldHit& hit) {
    const R3::Intersection at = world.At(ray, hit);
    normal = AsVector(at.normal);
    along = Dot(normal, ray.direction);
    const double size = MaxComponent(Abs(FromOrigin(ray.origin))) + std::abs(hit.t) * MaxComponent(Abs(ray.direction));
    off = Dot(Abs(normal), at.error) + rounding_share * size;
  }
};

/// Returns true if two primitives are triangles, in one mesh or separate, with one or two common corners.
bool AreNeighbors(const World& world, std::int64_t a, std::int64_t b) {
  const Instance &of_a = world.InstanceOf(a), &of_b = world.InstanceOf(b);
  if (!of_a.mesh || !of_b.mesh || of_a.frame != of_b.frame) return false;
  if (&of_a != &of_b && of_a.mesh->Elements() + of_b.mesh->Elements() != 2) return false;
  int common = 0;
  for (const R3::Point& p : of_a.mesh->Corners(static_cast<int>(a - of_a.first_primitive)))
    for (const R3::Point& q : of_b.mesh->Corners(static_cast<int>(b - of_b.first_primitive))) common += p == q;
  return common == 1 || common == 2;
}

/// Returns true if the path has crossed the primitive here, or a neighbor where they meet.
bool HasCrossed(const World& world, const R3::Ray& ray, std::int64_t primitive, const R3::Vector& normal) {
  const R3::Vector& arriving = ray.departure->arriving;
  for (const R3::Crossed* crossed = ray.departure->crossed; crossed; crossed = crossed->before) {
    if (crossed->primitive == primitive) return true;
    const bool is_same_side = Dot(crossed->normal, arriving) * Dot(normal, arriving) > 0;
    if (is_same_side && AreNeighbors(world, crossed->primitive, primitive)) return true;
  }
  return false;
}

/// Returns half the size of the shape that was hit, infinite for a plane.
double RadiusOf(const World& world, const WorldHit& hit) {
  const Instance& instance = world.Instances()[hit.instance];
  if (!instance.is_bounded) return R3::infinity;
  return world.InWorld(instance.frame, instance.shape->Bounds(hit.element)).Radius();
}

/// A hit with which others are compared.
struct Reference {
  Reference(const World& world, const R3::Ray& ray, const WorldHit& hit)
      : t(hit.t), primitive(world.PrimitiveId(hit)), crossing(world, ray, hit), radius(RadiusOf(world, hit)) {}

  bool IsCoincidentWith(const World& world, const R3::Ray& ray, const WorldHit& other) const {
    if (world.PrimitiveId(other) == primitive) return true;
    const Crossing b(world, ray, other);
    const double error = crossing.off + b.off;
    if (!(std::abs(other.t - t) * std::abs(crossing.along) <= error)) return false;
    const double sine = Length(Cross(crossing.normal, b.normal));
    return sine == 0 || sine * std::min(radius, RadiusOf(world, other)) <= 4 * error;
  }

  double t;
  std::int64_t primitive;
  Crossing crossing;
  double radius;
};

/// The effect of crossing a surface on the set of media that contain the path.
enum class MediumCrossing { none, entry, exit };

MediumCrossing CrossingOf(const World& world, const R3::Ray& ray, const WorldHit& hit) {
  const Instance& instance = world.Instances()[hit.instance];
  if (!instance.is_medium || !instance.IsClear()) return MediumCrossing::none;
  return Dot(world.At(ray, hit).normal, ray.direction) > 0 ? MediumCrossing::exit : MediumCrossing::entry;
}

}  // namespace

bool IsAhead(const World& world, const R3::Ray& ray, const WorldHit& hit) {
  if (!ray.departure) return true;
  const Crossing crossing(world, ray, hit);
  const bool is_crossed = HasCrossed(world, ray, world.PrimitiveId(hit), crossing.normal);
  const double reach = 2 * crossing.off + (is_crossed ? 2 * ray.departure->clearance : 0);
  if (!(std::abs(hit.t * crossing.along) <= reach)) return hit.t > 0;
  const double goes_on = crossing.along * Dot(crossing.normal, ray.departure->arriving);
  if (goes_on == 0) return hit.t > 0;
  return (goes_on > 0) != is_crossed;
}

bool IsInTheWay(const World& world, const R3::Ray& ray, const WorldHit& hit) {
  if (ray.t_max == R3::infinity || !(hit.t > end_of_certainty * ray.t_max)) return true;
  const double target = ray.reaching < 0 ? ray.t_max : ray.t_max / beyond_target;
  const Crossing crossing(world, ray, hit);
  if (!(std::abs((target - hit.t) * crossing.along) <= 2 * crossing.off)) return hit.t < target;
  return world.Emits(hit) && world.PrimitiveId(hit) < ray.reaching;  // the target of the ray emits
}

std::vector<WorldHit> CoincidentOf(const World& world, const R3::Ray& ray, std::vector<WorldHit> hits) {
  const auto primitive = [&](const WorldHit& hit) { return world.PrimitiveId(hit); };
  const auto is_before = [&](const WorldHit& a, const WorldHit& b) {
    return a.t != b.t ? a.t < b.t : primitive(a) < primitive(b);
  };
  const Reference nearest(world, ray, *std::ranges::min_element(hits, is_before));
  std::erase_if(hits, [&](const WorldHit& hit) { return !nearest.IsCoincidentWith(world, ray, hit); });
  std::ranges::sort(hits, {}, primitive);
  const auto is_same = [&](const WorldHit& a, const WorldHit& b) { return primitive(a) == primitive(b); };
  hits.erase(std::unique(hits.begin(), hits.end(), is_same), hits.end());
  std::ranges::stable_partition(hits, [&](const WorldHit& hit) { return world.Emits(hit); });
  return hits;
}

WorldHit SeenOf(const World& world, const R3::Ray& ray, std::vector<WorldHit> hits) {
  hits = CoincidentOf(world, ray, std::move(hits));
  const auto first = [&](MediumCrossing crossing) {
    return std::ranges::find(hits, crossing, [&](const WorldHit& hit) { return CrossingOf(world, ray, hit); });
  };
  const auto exit = first(MediumCrossing::exit), entry = first(MediumCrossing::entry);
  if (exit == hits.end()) return hits[0];
  const bool is_between_media = first(MediumCrossing::none) == hits.end();
  return is_between_media && entry != hits.end() ? *entry : *exit;
}

}  // namespace ray
