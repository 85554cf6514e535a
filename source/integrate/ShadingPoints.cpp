#include "source/integrate/ShadingPoints.h"

#include <algorithm>
#include <cmath>

#include "R3/FlatTriangle.h"
#include "R3/Numeric.h"
#include "R3/Spawn.h"

namespace ray {
namespace {

/// Some vectors, each coordinate an array.
template <std::size_t most>
struct Vectors {
  alignas(64) double x[most], y[most], z[most];

  R3::Vector operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  R3::Point At(std::size_t i) const { return {x[i], y[i], z[i]}; }
  template <typename Xyz>
  void Set(std::size_t i, const Xyz& v) {
    x[i] = v.x, y[i] = v.y, z[i] = v.z;
  }
};

/// Flat triangles that rays have hit, and what the points there become.
struct FlatSurfaces {
  static constexpr std::size_t most = 16;  // so that all of it fits into a core's first cache

  std::size_t count = 0;
  std::array<ShadingPoint*, most> points;
  Vectors<most> corners[3], weights, direction;
  Vectors<most> position, error, normal, N, wo, shadow_origin;
  alignas(64) double facing[most];  // of the normal to the ray

  bool IsFull() const { return count == most; }
  void Add(ShadingPoint& p, const R3::Mesh& mesh) {
    points[count] = &p;
    const auto places = mesh.CornersInPlace(p.hit.element);
    for (std::size_t k = 0; k < 3; ++k) corners[k].Set(count, *places[k]);
    weights.Set(count, R3::Vector{1 - p.hit.u - p.hit.v, p.hit.u, p.hit.v});
    direction.Set(count++, p.path.ray.direction);
  }
};

/// False, with nothing to rely on, where lengths or areas leave the range of doubles.
R3_VECTORIZED
bool MakeSurfaces(FlatSurfaces& all) {
  std::uint64_t are_safe = 1;
  for (std::size_t i = 0; i < all.count; ++i) {
    const R3::Point p = all.corners[0].At(i), q = all.corners[1].At(i), r = all.corners[2].At(i);
    const R3::Vector direction = all.direction[i], area = R3::AreaOfTriangle(p, q, r);
    const R3::TrianglePlace place = R3::PlaceOnTriangle(p, q, r, all.weights[i]);
    const double area_square = Dot(area, area), square = Dot(direction, direction);
    are_safe &= R3::IsSafeArea(area) & R3::IsSafeSquare(area_square) & R3::IsSafeSquare(square);
    const R3::Vector normal = area / std::sqrt(area_square), wo = -(direction / std::sqrt(square));
    all.position.Set(i, place.position), all.error.Set(i, place.error);
    all.normal.Set(i, normal), all.wo.Set(i, wo);
    all.facing[i] = Dot(normal, direction);
    all.N.Set(i, all.facing[i] <= 0 ? normal : -normal);
    all.shadow_origin.Set(i, R3::SpawnedFrom(place.position, place.error, normal, wo));
  }
  return are_safe != 0;
}

/// The rest, which each point has of its own.
void Finish(const World& world, const FlatSurfaces& all) {
  for (std::size_t i = 0; i < all.count; ++i) {
    ShadingPoint& p = *all.points[i];
    p.at.position = all.position.At(i), p.at.error = all.error[i];
    p.at.normal = p.at.shading_normal = AsNormal(all.normal[i]);
    p.kd = p.material->kd;
    p.wo = all.wo[i];
    p.entering = all.facing[i] <= 0;
    p.N = all.N[i];
    p.is_smoothed = false;
    p.shadow_origin = all.shadow_origin.At(i);
    p.bias = world.scene().shadow_bias;
    AbsorbOnTheWay(p);
  }
}

void Complete(const World& world, FlatSurfaces& surfaces) {
  if (MakeSurfaces(surfaces)) [[likely]]
    Finish(world, surfaces);
  else
    for (std::size_t i = 0; i < surfaces.count; ++i) {
      ShadingPoint& p = *surfaces.points[i];
      p = ShadingPointAt(world, p.path, p.hit);
    }
  surfaces.count = 0;
}

/// Whether the surface is that of a triangle in the world, and needs no texture coordinates.
bool IsFlat(const Instance& instance, const Material& material) {
  return instance.mesh && instance.frame == 0 && !instance.mesh->IsSmooth() && !material.texture && !material.bump &&
         !material.normal_map;
}

}  // namespace

void CompleteShadingPoints(const World& world, std::span<ShadingPoint> points) {
  FlatSurfaces surfaces;
  for (ShadingPoint& p : points) {
    const Instance& instance = world.Instances()[p.hit.instance];
    if (!IsFlat(instance, *instance.material)) {
      p = ShadingPointAt(world, p.path, p.hit);
      continue;
    }
    p.material = instance.material;
    surfaces.Add(p, *instance.mesh);
    if (surfaces.IsFull()) Complete(world, surfaces);
  }
  Complete(world, surfaces);
}

}  // namespace ray
