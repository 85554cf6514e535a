#include "source/integrate/lights/TriangleLamp.h"

#include <algorithm>
#include <limits>

#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns the weight of a triangle. Areas at the end of the range of doubles are not finite.
double Weight(const EmissiveTriangle& triangle) {
  return triangle.area < std::numeric_limits<double>::max() ? triangle.area : std::numeric_limits<double>::max();
}

DiscreteDistribution ByArea(const std::vector<EmissiveTriangle>& triangles) {
  std::vector<double> weights;
  for (const EmissiveTriangle& triangle : triangles) weights.push_back(Weight(triangle));
  return DiscreteDistribution(weights);
}

}  // namespace

TriangleLamp::TriangleLamp(std::vector<EmissiveTriangle> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.size() > 1) by_area_ = ByArea(triangles_);
}

TriangleLamp::Pick TriangleLamp::PickByArea(const R2::Point& random) const {
  const DiscreteDistribution::Drawn drawn = by_area_->Draw(random.x);
  return {&triangles_[drawn.index], {drawn.rest, random.y}};
}

double TriangleLamp::Area() const {
  double area = 0;
  for (const EmissiveTriangle& triangle : triangles_) area += triangle.area;
  return area;
}

std::string TriangleLamp::Describe() const {
  if (triangles_.size() == 1) return triangles_[0].Describe();
  return "lamp of " + Counted(triangles_.size(), "emissive triangle") + ", primitives " +
         std::to_string(triangles_.front().primitive) + " to " + std::to_string(triangles_.back().primitive);
}

LightBound TriangleLamp::Bound() const {
  if (triangles_.size() == 1) return triangles_[0].Bound();
  R3::Box box;
  for (const EmissiveTriangle& triangle : triangles_) box.Extend(triangle.Bounds());
  return BoundWithoutFalloff(box, Luminance(Emission()));
}

std::vector<TriangleLamp> TriangleLamps(const World& world, EmissiveMeshes meshes) {
  std::vector<TriangleLamp> lamps;
  const std::vector<EmissiveTriangle> triangles = EmissiveTriangles(world);
  for (auto first = triangles.begin(); first != triangles.end();) {
    const bool is_alone = !IsOneLamp(*first->instance, meshes);
    const auto is_other = [&](const EmissiveTriangle& t) { return is_alone || t.instance != first->instance; };
    const auto end = std::find_if(first + 1, triangles.end(), is_other);
    lamps.emplace_back(std::vector(first, end));
    first = end;
  }
  return lamps;
}

}  // namespace ray
