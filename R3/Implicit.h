#pragma once

#include "R3/Expression.h"
#include "R3/Shape.h"

namespace R3 {

/// The solid where a formula is not above 0, cut off by a box: its own surface and, where that leaves the box, the
/// box's faces. Where the formula is not defined is outside. Where it is 0 in a region is inside; where it only touches
/// 0, there is no surface. Where it has no slope at the surface, or a slope of 0, the normal is that a little before it
/// along the ray.
///
/// Along a ray, stretches in which interval arithmetic excludes 0 hold no crossing. In stretches in which it excludes 0
/// for the slope there is one if the signs at the ends differ, and it is found to the last bits. Others are divided in
/// eight, which are looked at together, and the nearest of these goes first, so that nothing is stepped over: what is
/// found is proven to be nearest. What cannot be decided before it is as short as rounding, as where a ray touches the
/// surface, or where the formula jumps, is decided by the signs at its ends. A ray divides at most 4,681 stretches, and
/// each root that it looks for takes at most 86 steps.
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
  /// The part of a hit on the formula's surface; the faces of the box are the parts before it.
  static constexpr int surface = 6;

  template <typename Take>
  void OfferCrossings(const Ray& ray, const Take& take) const;
  Intersection OnFace(const Point& p, int face) const;
  /// `way`: the direction of the ray that led to it.
  Intersection OnSurface(const Point& p, const Vector& way) const;
  Vector GradientAt(const Point& p) const;
  /// Returns the unit normal at a place of the surface where the formula has no slope, or a slope of 0.
  Vector DirectionNear(const Point& p, const Vector& way) const;
  /// Returns that of a place where the formula jumps. `way` is unit; `radius` is how far to look around.
  Vector AcrossJump(const Point& p, const Vector& way, double radius) const;

  Expression formula_;
  Box box_;
};

}  // namespace R3
