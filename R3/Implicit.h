#pragma once

#include "R3/Expression.h"
#include "R3/Shape.h"

namespace R3 {

/// The solid where a formula is not above 0, clipped by a box: its own surface and, where that leaves the box, the
/// box's faces. Points where the formula is undefined are outside. A region where it is 0 is inside; where it only
/// touches 0, there is no surface. If it has no slope at the surface, or a slope of 0, the normal is that a little
/// before it along the ray.
///
/// Along a ray, stretches in which interval arithmetic excludes 0 contain no crossing. Stretches in which it excludes 0
/// for the slope contain one if the signs at the ends differ, and it is found to the last bits. Others are divided in
/// eight, which are examined together, nearest first, so that nothing is skipped: the hit is proven to be the nearest.
/// Stretches that remain undecided until they are as short as rounding, as where a ray touches the surface, or where
/// the formula jumps, are decided by the signs at their ends. A ray divides at most 4,681 stretches, and each root
/// takes at most 86 steps.
///   source   Moore, Interval Analysis (1966); Mitchell, Robust ray intersection with interval arithmetic (1990)
class Implicit : public Shape {
 public:
  Implicit(Expression formula, const Box& box) : formula_(std::move(formula)), box_(box) {}

  Box Bounds(int) const override { return box_; }
  std::optional<Hit> Intersect(const Ray& ray, int) const override;
  Crossings CrossingsAlong(const Ray& ray, int) const override;
  Intersection At(const Ray& ray, const Hit& hit, int) const override;
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const override;
  bool IsDegenerate() const override;
  std::optional<Recipe> MadeFrom() const override;

 private:
  /// The part of a hit on the formula's surface; lower numbers are the faces of the box.
  static constexpr int surface = 6;

  template <typename Take>
  void OfferCrossings(const Ray& ray, const Take& take) const;
  Intersection OnFace(const Point& p, int face) const;
  /// Makes the intersection at a point; `way` is the direction of the ray that led to it.
  Intersection OnSurface(const Point& p, const Vector& way) const;
  Vector GradientAt(const Point& p) const;
  /// Returns the unit normal at a point of the surface where the formula has no slope, or a slope of 0.
  Vector DirectionNear(const Point& p, const Vector& way) const;
  /// Returns the unit normal where the formula jumps. `way` is unit; `radius` is the size of the neighborhood searched.
  Vector AcrossJump(const Point& p, const Vector& way, double radius) const;

  Expression formula_;
  Box box_;
};

}  // namespace R3
