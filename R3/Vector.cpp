#include "R3/Vector.h"

namespace R3 {

double LengthOutOfRange(const Vector& v) {
  const double largest = MaxComponent(Abs(v));
  if (!(largest > 0) || !(largest < infinity)) return largest;
  const int exponent = std::ilogb(largest);
  const Vector w = ScaledByPower(v, -exponent);
  return std::scalbn(std::sqrt(Dot(w, w)), exponent);
}

Vector UnitOutOfRange(const Vector& v) {
  const double largest = MaxComponent(Abs(v));
  if (!(largest > 0) || !IsFinite(v)) return {};
  const int exponent = std::ilogb(largest);
  const Vector w = ScaledByPower(v, -exponent);
  return w / std::sqrt(Dot(w, w));
}

}  // namespace R3
