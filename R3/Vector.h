#pragma once

#include <cmath>

#include "R1/Elementary.h"
#include "R3/Numeric.h"

namespace R3 {

/// A displacement, transformed by the linear part only.
struct Vector {
  double x = 0, y = 0, z = 0;

  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const Vector&, const Vector&) = default;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& v) { return {-v.x, -v.y, -v.z}; }
inline Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
inline Vector operator*(const Vector& v, double s) { return s * v; }
inline Vector operator/(const Vector& v, double s) { return {v.x / s, v.y / s, v.z / s}; }

inline double Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Returns the cross product, each component within 1.5 ulp of the exact value.
inline Vector Cross(const Vector& a, const Vector& b) {
  return {DifferenceOfProducts(a.y, b.z, a.z, b.y), DifferenceOfProducts(a.z, b.x, a.x, b.z),
          DifferenceOfProducts(a.x, b.y, a.y, b.x)};
}

inline Vector Abs(const Vector& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
inline bool IsFinite(const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
/// Returns v times 2^exponent: exact within the range of doubles.
inline Vector ScaledByPower(const Vector& v, int exponent) {
  return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}
inline double MaxComponent(const Vector& v) {
  const double of_two = v.x < v.y ? v.y : v.x;
  return of_two < v.z ? v.z : of_two;
}

/// Returns the axis of the largest component in magnitude; the lowest of equals.
inline int MaxAxis(const Vector& v) {
  const Vector a = Abs(v);
  // Computed by sums, because branches on rays of all directions are mispredicted.
  const int x_or_y = a.y > a.x, is_z = (a.z > a.x) & (a.z > a.y);
  return 2 * is_z + (1 - is_z) * x_or_y;
}

/// Returns `v` rotated about a unit vector by an angle in radians, counter-clockwise seen from its tip.
///   source   Rodrigues, Des lois geometriques qui regissent les deplacements d'un systeme solide (1840)
inline Vector Turned(const Vector& v, const Vector& axis, double angle) {
  const auto [sine, cosine] = R1::SinCos(angle);
  return cosine * v + sine * Cross(axis, v) + (1 - cosine) * Dot(axis, v) * axis;
}

// The range in which sums of squares have neither overflowed nor lost bits.
inline constexpr double smallest_safe_square = 0x1p-960, largest_safe_square = 0x1p960;
constexpr bool IsSafeSquare(double square) { return (square > smallest_safe_square) & (square < largest_safe_square); }

/// Returns the power of two by which to scale a vector before squaring it, given its square without scaling: nearly
/// always 1. Written as two selections, since loops with conditions joined by "and" are not vectorized.
inline double SafeScale(double square) {
  const double if_small = square < smallest_safe_square ? 0x1p600 : 1;
  return square > largest_safe_square ? 0x1p-600 : if_small;
}

/// Returns the Euclidean length within 3 u relative. It has no branches, for loops that are to become vector
/// instructions.
inline double BranchlessLength(const Vector& v) {
  const double square = Dot(v, v);
  const Vector w = SafeScale(square) * v;
  const double length = std::sqrt(Dot(w, w));
  const double if_small = square < smallest_safe_square ? 0x1p-600 * length : length;
  return square > largest_safe_square ? 0x1p600 * length : if_small;
}
/// Returns the same bits as BranchlessLength in less time for a single vector: the branch is nearly always predicted
/// correctly.
inline double Length(const Vector& v) {
  const double square = Dot(v, v);
  return IsSafeSquare(square) ? std::sqrt(square) : BranchlessLength(v);
}

/// Returns v / |v| within 4 u; zero for the zero vector and for one with NaN or infinity. It has no branches, for loops
/// that are to become vector instructions.
inline Vector BranchlessUnit(const Vector& v) {
  const Vector w = SafeScale(Dot(v, v)) * v;
  const double square = Dot(w, w), length = std::sqrt(square < infinity ? square : 0);
  const Vector unit = w / length;
  return {length > 0 ? unit.x : 0, length > 0 ? unit.y : 0, length > 0 ? unit.z : 0};
}
/// Returns the same bits as BranchlessUnit in less time for a single vector.
inline Vector Unit(const Vector& v) {
  const double square = Dot(v, v);
  return IsSafeSquare(square) ? v / std::sqrt(square) : BranchlessUnit(v);
}

/// Returns the axis of the smallest component, the first one of equals: a cross product with it is far from 0.
inline Vector LeastAxis(const Vector& v) {
  const Vector a = Abs(v);
  return a.x <= a.y && a.x <= a.z ? Vector{1, 0, 0} : a.y <= a.z ? Vector{0, 1, 0} : Vector{0, 0, 1};
}

}  // namespace R3
