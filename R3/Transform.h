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

/// The product of a chain of matrices, kept in double-words so that 100,000 links lose nothing a double could show.
class Product {
 public:
  Product();  // the identity
  Product operator*(const Matrix& next) const;

 private:
  friend class Transform;
  std::array<std::array<DoubleDouble, 4>, 3> m_;
};

/// An affine map and its inverse together; a name says where it goes (`world_from_node`).
///   accuracy   every entry of both is within 1 ulp of the truth for the exact product of the given matrices, up
///              to a condition of 1e15 (tests/extremes/transforms.cpp)
class Transform {
 public:
  Transform() = default;  // the identity

  /// Nothing when the linear part is singular, or the map or its inverse does not fit into doubles.
  static std::optional<Transform> Of(const Product& product);
  static std::optional<Transform> Of(const Matrix& matrix) { return Of(Product() * matrix); }

  const Matrix& Forward() const { return forward_; }
  const Matrix& Inverse() const { return inverse_; }
  bool IsIdentity() const { return R3::IsIdentity(forward_); }
  /// Whether the map turns right hands into left hands.
  bool Mirrors() const { return mirrors_; }

  Point operator*(const Point& p) const { return forward_ * p; }
  Vector operator*(const Vector& v) const { return forward_ * v; }
  /// By the inverse transpose; of unit length. The outward side stays outward under mirroring: the inverse
  /// transpose carries the gradient of the surface along, and a gradient points outward whichever hand is used.
  Normal operator*(const Normal& n) const;
  /// The error also covers the rounding of seeing the place from before the map again, so that a ray that starts
  /// outside it starts outside the surface.
  Intersection operator*(const Intersection& at) const;
  /// The box around the eight corners' images.
  Box operator*(const Box& b) const;

  /// The ray as seen from before the map: same t.
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
