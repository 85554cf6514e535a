#pragma once

#include "R3/Shape.h"

namespace R3 {

/// A shape whose surface exists only for rays that arrive at its front, the side of its normal; other rays pass through
/// it. It is therefore not a solid, whatever the wrapped shape is. Refers to the shape, which must outlive it.
class OneSided : public Shape {
 public:
  explicit OneSided(const Shape& shape) : shape_(shape) {}

  std::optional<Hit> Intersect(const Ray& ray, int element) const override {
    Ray rest = ray;
    while (true) {
      const auto hit = shape_.Intersect(rest, element);
      if (!hit || Dot(shape_.At(ray, *hit, element).normal, ray.direction) < 0) return hit;
      rest.t_min = hit->t;
    }
  }

  int Elements() const override { return shape_.Elements(); }
  Box Bounds(int element) const override { return shape_.Bounds(element); }
  Intersection At(const Ray& ray, const Hit& hit, int element) const override { return shape_.At(ray, hit, element); }
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const override {
    return shape_.UvTangentsAt(ray, hit, element);
  }
  MeshData Tessellate(int fineness) const override { return shape_.Tessellate(fineness); }
  bool IsBounded() const override { return shape_.IsBounded(); }
  bool CanBeSampled() const override { return shape_.CanBeSampled(); }
  std::optional<SurfaceSample> Sample(const Point& from, const R2::Point& u, int element) const override {
    return shape_.Sample(from, u, element);
  }
  bool DrawsInSight() const override { return shape_.DrawsInSight(); }
  double Pdf(const Point& from, const Vector& way, const Normal& normal, int element) const override {
    return shape_.Pdf(from, way, normal, element);
  }
  Form FormOfElements() const override { return shape_.FormOfElements(); }
  bool IsSolid() const override { return false; }
  bool HasTextureCoordinates() const override { return shape_.HasTextureCoordinates(); }
  bool IsDegenerate() const override { return shape_.IsDegenerate(); }
  Profile ProfileInBounds() const override { return shape_.ProfileInBounds(); }
  std::vector<int> MaterialsOfParts() const override { return shape_.MaterialsOfParts(); }
  int MaterialOf(const Hit& hit) const override { return shape_.MaterialOf(hit); }
  std::optional<Recipe> MadeFrom() const override { return shape_.MadeFrom(); }

 private:
  const Shape& shape_;
};

}  // namespace R3
