#pragma once

#include <array>

#include "R3/Point.h"

namespace R3 {

/// An affine map as stated in a scene: rows of a 3 x 4 matrix for column vectors, with the translation in column 3. The
/// last row of the full matrix, always 0 0 0 1, is not stored.
struct Matrix {
  std::array<std::array<double, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  friend bool operator==(const Matrix&, const Matrix&) = default;
};

inline bool IsIdentity(const Matrix& a) { return a == Matrix{}; }

inline Point operator*(const Matrix& a, const Point& p) {
  const auto row = [&](int i) {
    const auto& r = a.m[static_cast<std::size_t>(i)];
    return r[0] * p.x + r[1] * p.y + r[2] * p.z + r[3];
  };
  return {row(0), row(1), row(2)};
}

inline Vector operator*(const Matrix& a, const Vector& v) {
  const auto row = [&](int i) {
    const auto& r = a.m[static_cast<std::size_t>(i)];
    return r[0] * v.x + r[1] * v.y + r[2] * v.z;
  };
  return {row(0), row(1), row(2)};
}

/// Returns the transpose of the linear part times `v`. With the inverse matrix, this transforms gradients and therefore
/// normals.
inline Vector TransposeTimes(const Matrix& a, const Vector& v) {
  const auto column = [&](std::size_t j) { return a.m[0][j] * v.x + a.m[1][j] * v.y + a.m[2][j] * v.z; };
  return {column(0), column(1), column(2)};
}

/// Returns the largest row sum of magnitudes of the linear part: a bound on how much the map can stretch a largest
/// component.
double MaxRowSum(const Matrix& a);
/// Returns the largest magnitude in the translation column.
double MaxTranslation(const Matrix& a);
/// Returns the magnitudes of the linear part times `v`: given the errors of a point, the errors of its image.
Vector AbsTimes(const Matrix& a, const Vector& v);

/// Returns the condition of the linear part: (its largest stretch) * (largest stretch of its inverse) in the row-sum
/// norm; infinity if singular or not finite. 1 for a rotation up to a factor 3; 1e6 if an axis is scaled by 1e-6.
double Condition(const Matrix& a);

}  // namespace R3
