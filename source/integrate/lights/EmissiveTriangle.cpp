#include "source/integrate/lights/EmissiveTriangle.h"

#include <array>
#include <cmath>
#include <set>

#include "R3/Warp.h"

namespace ray {
namespace {

// Corners are rounded once on the way to the world (4 u of the terms summed), points between them a few times more.
constexpr double rounding = R3::Gamma(16);

R3::Vector Magnitude(const R3::Transform& world_from_local, const R3::Point& local) {
  const R3::Matrix& forward = world_from_local.Forward();
  return AbsTimes(forward, Abs(FromOrigin(local))) +
         R3::Vector{std::abs(forward.m[0][3]), std::abs(forward.m[1][3]), std::abs(forward.m[2][3])};
}

/// A frame and the corners in it. A ray that hits several triangles with the same ones hits the first.
using Place = std::array<double, 10>;
Place PlaceOf(std::uint32_t frame, const std::array<R3::Point, 3>& c) {
  return {static_cast<double>(frame), c[0].x, c[0].y, c[0].z, c[1].x, c[1].y, c[1].z, c[2].x, c[2].y, c[2].z};
}

R3::Vector Largest(const R3::Vector& a, const R3::Vector& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

R3::Point EmissiveTriangle::PointTowards(const R3::Point& seen_from, const R2::Point& random, double time) const {
  const auto [a, b, c] = R3::SampleUniformTriangle(random);
  R3::Intersection at;
  at.position = R3::Point{} +
                (a * FromOrigin(corners[0]) + b * FromOrigin(corners[1]) + c * FromOrigin(corners[2]) + time * motion);
  at.error = corner_error;
  at.normal = normal;
  return SpawnPoint(at, seen_from - at.position);
}

std::string EmissiveTriangle::Describe() const { return "emissive triangle, primitive " + std::to_string(primitive); }

R3::Box EmissiveTriangle::Bounds() const {
  R3::Box box;
  for (const R3::Point& corner : corners) box.Extend(corner);
  return Along(box, motion);
}

LightBound EmissiveTriangle::Bound() const { return BoundWithoutFalloff(Bounds(), Luminance(emission)); }

std::vector<EmissiveTriangle> EmissiveTriangles(const World& world) {
  std::vector<EmissiveTriangle> triangles;
  std::set<Place> places;
  for (const Instance& instance : world.Instances()) {
    if (!instance.mesh || !instance.Emits()) continue;
    const R3::Transform& world_from_local = world.Frames()[instance.frame];
    for (int i = 0; i < instance.mesh->Elements(); ++i) {
      const auto local = instance.mesh->Corners(i);
      if (!places.insert(PlaceOf(instance.frame, local)).second) continue;
      EmissiveTriangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        t.corners[k] = world_from_local * local[k];
        t.corner_error = Largest(t.corner_error, rounding * Magnitude(world_from_local, local[k]));
      }
      t.motion = world.MotionOf(instance.frame);
      t.corner_error = t.corner_error + rounding * Abs(t.motion);
      t.normal = world_from_local * R3::AsNormal(Unit(Cross(local[1] - local[0], local[2] - local[0])));
      t.area = Length(Cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0])) / 2;
      t.emission = instance.material->emission;
      t.behind = EmissionBehindOf(instance);
      t.instance = &instance;
      t.primitive = instance.first_primitive + i;
      triangles.push_back(t);
    }
  }
  return triangles;
}

}  // namespace ray
