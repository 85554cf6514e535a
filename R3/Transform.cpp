#include "R3/Transform.h"

namespace R3 {
namespace {

using Rows = std::array<std::array<DoubleDouble, 4>, 3>;
using LinearPart = std::array<std::array<DoubleDouble, 3>, 3>;

DoubleDouble Scaled(const DoubleDouble& a, int exponent) {
  return {std::scalbn(a.high, exponent), std::scalbn(a.low, exponent)};
}

LinearPart ScaledLinearPart(const Rows& rows, int exponent) {
  LinearPart scaled;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) scaled[i][j] = Scaled(rows[i][j], exponent);
  return scaled;
}

Matrix Rounded(const Rows& rows) {
  Matrix rounded;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) rounded.m[i][j] = static_cast<double>(rows[i][j]);
  return rounded;
}

bool IsFinite(const Matrix& matrix) {
  for (const auto& row : matrix.m)
    for (const double entry : row)
      if (!std::isfinite(entry)) return false;
  return true;
}

DoubleDouble Cofactor(const LinearPart& a, std::size_t i, std::size_t j) {
  const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
}

}  // namespace

Product::Product() {
  for (std::size_t i = 0; i < 3; ++i) m_[i][i] = 1.0;
}

Product Product::operator*(const Matrix& next) const {
  Product result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      DoubleDouble sum = j == 3 ? m_[i][3] : DoubleDouble(0.0);
      for (std::size_t k = 0; k < 3; ++k) sum = sum + m_[i][k] * DoubleDouble(next.m[k][j]);
      result.m_[i][j] = sum;
    }
  return result;
}

std::optional<Transform> Transform::Of(const Product& product) {
  Transform result;
  result.forward_ = Rounded(product.m_);
  if (!IsFinite(result.forward_)) return {};
  double largest = 0;
  for (const auto& row : result.forward_.m)
    for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::abs(row[j]));
  if (!(largest > 0)) return {};

  // Scaling by a power of two brings the largest entry near 1, so that the cubic terms of the determinant stay in
  // range.
  const int exponent = -std::ilogb(largest);
  const LinearPart a = ScaledLinearPart(product.m_, exponent);
  const DoubleDouble determinant =
      a[0][0] * Cofactor(a, 0, 0) + a[0][1] * Cofactor(a, 0, 1) + a[0][2] * Cofactor(a, 0, 2);
  if (!(determinant.high != 0)) return {};
  result.mirrors_ = determinant.high < 0;

  // inverse = adjugate / determinant (Cramer's rule) in double-words, so that a bad condition costs only spare bits.
  Rows inverse;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      inverse[i][j] = Scaled(Cofactor(a, j, i) / determinant, exponent);
      inverse[i][3] = inverse[i][3] - inverse[i][j] * product.m_[j][3];
    }
  result.inverse_ = Rounded(inverse);
  if (!IsFinite(result.inverse_)) return {};
  return result;
}

Normal Transform::operator*(const Normal& n) const { return AsNormal(Unit(TransposeTimes(inverse_, AsVector(n)))); }

Intersection Transform::operator*(const Intersection& at) const {
  const Vector local = Abs(FromOrigin(at.position));
  const auto shift = [](const Matrix& a) {
    return Vector{std::abs(a.m[0][3]), std::abs(a.m[1][3]), std::abs(a.m[2][3])};
  };
  Intersection moved = at;
  moved.position = forward_ * at.position;
  // Rounding of the forward map: entries, products and sums of forward * position ...
  const Vector out = AbsTimes(forward_, local) + shift(forward_);
  // ... and of the inverse map, inverse * position, scaled to the size after the map.
  const Vector back = AbsTimes(inverse_, Abs(FromOrigin(moved.position))) + shift(inverse_);
  moved.error = AbsTimes(forward_, at.error + Gamma(6) * back) + Gamma(6) * out;
  moved.normal = *this * at.normal;
  moved.shading_normal = *this * at.shading_normal;
  return moved;
}

Box Transform::operator*(const Box& b) const {
  Box result;
  if (b.IsEmpty()) return result;
  for (int i = 0; i < 8; ++i) result.Extend(forward_ * b.Corner(i));
  return result;
}

}  // namespace R3
