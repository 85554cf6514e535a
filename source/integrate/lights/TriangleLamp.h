#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/integrate/TraceSettings.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/sample/DiscreteDistribution.h"
#include "source/scene/Light.h"

namespace ray {

/// Triangles that emit and are one light together, as the 2008 course has it: from each point of them it shines like a
/// point light of its emission without fall-off, and what arrives is the mean over its points. So it is as strong as
/// any other lamp of its emission, whatever its size and however many triangles it is cut into.
class TriangleLamp {
 public:
  /// At least one, all of one instance.
  explicit TriangleLamp(std::vector<EmissiveTriangle> triangles);

  /// What arrives from the point of it that `random`, in [0, 1)^2, picks evenly by area at a time in [0, 1).
  LightSample SampleTowards(const R3::Point& seen_from, const R2::Point& random, double time) const {
    const auto [triangle, u] = by_area_ ? PickByArea(random) : Pick{&triangles_[0], random};
    const R3::Vector way = triangle->PointTowards(seen_from, u, time) - seen_from;
    return {.irradiance = triangle->RadianceAlong(way), .to_light = way, .reaching = triangle->primitive};
  }
  /// Whether the primitive is one of its triangles, which it does not light.
  bool Holds(std::int64_t primitive) const {
    return triangles_.front().primitive <= primitive && primitive <= triangles_.back().primitive;
  }
  const std::vector<EmissiveTriangle>& Triangles() const { return triangles_; }
  const R2::Color& Emission() const { return triangles_[0].emission; }
  const Instance* instance() const { return triangles_[0].instance; }
  double Area() const;
  std::string Describe() const;
  /// What choosing among lights goes by, without fall-off as the course has it.
  LightBound Bound() const;

 private:
  /// One of the triangles, and a random point for the place on it.
  struct Pick {
    const EmissiveTriangle* triangle;
    R2::Point random;
  };
  Pick PickByArea(const R2::Point& random) const;

  std::vector<EmissiveTriangle> triangles_;        // ascending by primitive
  std::optional<DiscreteDistribution> by_area_{};  // of several
};

/// Whether all triangles of an instance, which is a mesh, are one lamp: those of a quad or polygon, which the course
/// does not have, always are.
inline bool IsOneLamp(const Instance& instance, EmissiveMeshes meshes) {
  return meshes == EmissiveMeshes::whole || instance.mesh->Data().is_one_polygon;
}

/// Every lamp that is made of triangles.
std::vector<TriangleLamp> TriangleLamps(const World& world, EmissiveMeshes meshes);

}  // namespace ray
