#pragma once

#include <array>

#include "R3/Point.h"

namespace R3 {

/// An affine map as a scene states it: rows of a 3 x 4 matrix for column vectors, translation in column 3.
/// The last row of the full matrix is always 0 0 0 1 and is not kept.
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

/// The transpose of the linear part times `v`: how gradients, and so normals, move by the inverse.
inline Vector TransposeTimes(const Matrix& a, const Vector& v) {
  const auto column = [&](std::size_t j) { return a.m[0][j] * v.x + a.m[1][j] * v.y + a.m[2][j] * v.z; };
  return {column(0), column(1), column(2)};
}

/// Largest sum of magnitudes over a row of the linear part: how much the map can stretch a largest component.
double MaxRowSum(const Matrix& a);
/// Largest magnitude in the translation column.
double MaxTranslation(const Matrix& a);
/// Magnitudes of the linear part times `v`: with v the errors of a point, the errors of its image.
Vector AbsTimes(const Matrix& a, const Vector& v);

/// How far the linear part is from singular: (largest stretch of it) * (largest stretch of its inverse) in the row-sum
/// norm; infinity when singular or not finite. 1 for a rotation up to a factor 3; 1e6 when an axis is squeezed 1e-6.
double Condition(const Matrix& a);

}  // namespace R3
