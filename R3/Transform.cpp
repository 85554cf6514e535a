#include "R3/Transform.h"

namespace R3 {
namespace {

DoubleDouble Scaled(const DoubleDouble& a, int exponent) {
  return {std::scalbn(a.high, exponent), std::scalbn(a.low, exponent)};
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
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const double entry = static_cast<double>(product.m_[i][j]);
      if (!std::isfinite(entry)) return {};
      result.forward_.m[i][j] = entry;
      if (j < 3) largest = std::max(largest, std::abs(entry));
    }
  if (!(largest > 0)) return {};

  // A power of two brings the largest entry near 1, so that the cubic terms of the determinant stay in range.
  const int exponent = -std::ilogb(largest);
  std::array<std::array<DoubleDouble, 3>, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) a[i][j] = Scaled(product.m_[i][j], exponent);

  // inverse = adjugate / determinant (Cramer's rule), in double-words, so that the condition costs only spare bits.
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
  };
  const DoubleDouble determinant = a[0][0] * cofactor(0, 0) + a[0][1] * cofactor(0, 1) + a[0][2] * cofactor(0, 2);
  if (!(determinant.high != 0)) return {};
  result.mirrors_ = determinant.high < 0;

  std::array<std::array<DoubleDouble, 3>, 3> inverse;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = Scaled(cofactor(j, i) / determinant, exponent);
  for (std::size_t i = 0; i < 3; ++i) {
    DoubleDouble shift = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      shift = shift - inverse[i][j] * product.m_[j][3];
      result.inverse_.m[i][j] = static_cast<double>(inverse[i][j]);
    }
    result.inverse_.m[i][3] = static_cast<double>(shift);
  }
  for (const auto& row : result.inverse_.m)
    for (const double entry : row)
      if (!std::isfinite(entry)) return {};
  return result;
}

Normal Transform::operator*(const Normal& n) const { return AsNormal(Unit(TransposeTimes(inverse_, AsVector(n)))); }

Box Transform::operator*(const Box& b) const {
  Box result;
  if (b.IsEmpty()) return result;
  for (int i = 0; i < 8; ++i) result.Extend(forward_ * b.Corner(i));
  return result;
}

}  // namespace R3
