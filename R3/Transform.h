#pragma once

#include <array>
#include <optional>

#include "R1/DoubleDouble.h"
#include "R3/Box.h"
#include "R3/Intersection.h"
#include "R3/Matrix.h"
#include "R3/Normal.h"
#include "R3/Ray.h"

namespace R3 {

/// The product of a chain of matrices, kept in double-words so that 100,000 links lose nothing visible in doubles.
class Product {
 public:
  Product();  // the identity
  Product operator*(const Matrix& next) const;

 private:
  friend class Transform;
  std::array<std::array<DoubleDouble, 4>, 3> m_;
};

/// An affine map together with its inverse; names state where it maps to (`world_from_node`).
///   accuracy   every entry of both is within 1 ulp of the exact value for the product of the given matrices, up
///              to a condition of 1e15 (tests/extremes/transforms.cpp)
class Transform {
 public:
  Transform() = default;  // the identity

  /// Makes a transform; std::nullopt if the linear part is singular, or the map or its inverse does not fit into
  /// doubles.
  static std::optional<Transform> Of(const Product& product);
  static std::optional<Transform> Of(const Matrix& matrix) { return Of(Product() * matrix); }

  const Matrix& Forward() const { return forward_; }
  const Matrix& Inverse() const { return inverse_; }
  bool IsIdentity() const { return R3::IsIdentity(forward_); }
  /// Returns true if the map mirrors, that is, turns right hands into left hands.
  bool Mirrors() const { return mirrors_; }

  Point operator*(const Point& p) const { return forward_ * p; }
  Vector operator*(const Vector& v) const { return forward_ * v; }
  /// Transforms a normal by the inverse transpose, to unit length. The outward side stays outward under mirroring: the
  /// inverse transpose maps the gradient of the surface, and a gradient points outward in either handedness.
  Normal operator*(const Normal& n) const;
  /// Transforms an intersection. The error also covers the rounding of mapping the point back, so that a ray that
  /// starts outside of it starts outside the surface.
  Intersection operator*(const Intersection& at) const;
  /// Returns the box around the images of the eight corners.
  Box operator*(const Box& b) const;

  /// Returns the ray mapped by the inverse, with the same t.
  Ray Back(const Ray& ray) const {
    Ray local = ray;
    local.origin = inverse_ * ray.origin, local.direction = inverse_ * ray.direction;
    return local;
  }

 private:
  Matrix forward_, inverse_;
  bool mirrors_ = false;
};

}  // namespace R3
