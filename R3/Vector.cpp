#include "R3/Vector.h"

namespace R3 {
namespace {

// Squares of numbers in this range neither overflow nor lose bits when summed.
constexpr double smallest_safe = 0x1p-480, largest_safe = 0x1p480;

}  // namespace

double Length(const Vector& v) {
  const double largest = MaxComponent(Abs(v));
  if (largest > smallest_safe && largest < largest_safe) return std::sqrt(Dot(v, v));
  if (!(largest > 0) || !(largest < infinity)) return largest;
  const int exponent = std::ilogb(largest);
  const Vector w{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  return std::scalbn(std::sqrt(Dot(w, w)), exponent);
}

Vector Unit(const Vector& v) {
  const double largest = MaxComponent(Abs(v));
  if (!(largest > 0) || !(largest < infinity) || !(Dot(v, v) == Dot(v, v))) return {};
  if (largest > smallest_safe && largest < largest_safe) return v / std::sqrt(Dot(v, v));
  const int exponent = std::ilogb(largest);
  const Vector w{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  return w / std::sqrt(Dot(w, w));
}

}  // namespace R3
