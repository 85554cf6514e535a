#include "R3/Matrix.h"

#include "R3/Transform.h"

namespace R3 {

double MaxRowSum(const Matrix& a) {
  double largest = 0;
  for (const auto& r : a.m) largest = std::max(largest, std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2]));
  return largest;
}

double MaxTranslation(const Matrix& a) {
  return std::max({std::abs(a.m[0][3]), std::abs(a.m[1][3]), std::abs(a.m[2][3])});
}

Vector AbsTimes(const Matrix& a, const Vector& v) {
  const auto row = [&](std::size_t i) {
    return std::abs(a.m[i][0]) * v.x + std::abs(a.m[i][1]) * v.y + std::abs(a.m[i][2]) * v.z;
  };
  return {row(0), row(1), row(2)};
}

double Condition(const Matrix& a) {
  const auto transform = Transform::Of(a);
  if (!transform) return infinity;
  return MaxRowSum(a) * MaxRowSum(transform->Inverse());
}

}  // namespace R3
