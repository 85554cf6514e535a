#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/integrate/TraceSettings.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/sample/DiscreteDistribution.h"
#include "source/scene/Light.h"

namespace ray {

/// Emissive triangles that are one light together, as in the 2008 course. Each of their points shines like a point
/// light of their emission without attenuation, and the arriving light is the mean over the points. So the light is as
/// strong as any other of its emission, regardless of its size and number of triangles.
class TriangleLamp {
 public:
  /// The triangles must be at least one, all of one instance.
  explicit TriangleLamp(std::vector<EmissiveTriangle> triangles);

  /// Returns the light that arrives from the point that `random`, in [0, 1)^2, picks uniformly by area at a time in [0,
  /// 1).
  LightSample SampleTowards(const R3::Point& seen_from, const R2::Point& random, double time) const {
    const auto [triangle, u] = by_area_ ? PickByArea(random) : Pick{&triangles_[0], random};
    const R3::Vector way = triangle->PointTowards(seen_from, u, time) - seen_from;
    return {.irradiance = triangle->RadianceAlong(way), .to_light = way, .reaching = triangle->primitive};
  }
  /// Returns true if the primitive is one of its triangles, which it does not light.
  bool Holds(std::int64_t primitive) const {
    return triangles_.front().primitive <= primitive && primitive <= triangles_.back().primitive;
  }
  const std::vector<EmissiveTriangle>& Triangles() const { return triangles_; }
  const R2::Color& Emission() const { return triangles_[0].emission; }
  const Instance* instance() const { return triangles_[0].instance; }
  double Area() const;
  std::string Describe() const;
  /// Returns the estimated contribution that light selection uses. Ignores attenuation, as in the course.
  LightBound Bound() const;

 private:
  /// One of the triangles, and a random point for the place on it.
  struct Pick {
    const EmissiveTriangle* triangle;
    R2::Point random;
  };
  Pick PickByArea(const R2::Point& random) const;

  std::vector<EmissiveTriangle> triangles_;        // ascending by primitive
  std::optional<DiscreteDistribution> by_area_{};  // if there are several
};

/// Returns true if all triangles of an instance, which is a mesh, are one lamp. Those of a quad or polygon, which the
/// course does not have, always are.
inline bool IsOneLamp(const Instance& instance, EmissiveMeshes meshes) {
  return meshes == EmissiveMeshes::whole || instance.mesh->Data().is_one_polygon;
}

/// Returns every lamp that consists of triangles.
std::vector<TriangleLamp> TriangleLamps(const World& world, EmissiveMeshes meshes);

}  // namespace ray
