#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "R3/Ray.h"

/// 113-bit arithmetic as an oracle: its own rounding is 2^60 times finer than a double's.
#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 Quad;
#else
typedef long double Quad;  // 113 bits where the type above is missing
#endif

namespace oracle {

inline Quad Abs(Quad x) { return x < 0 ? -x : x; }

/// Square root within a few units of 2^-113: Newton's iteration from the double one.
inline Quad Sqrt(Quad x) {
  if (!(x > 0)) return 0;
  int exponent = 0;
  while (x > Quad(0x1p500)) x *= Quad(0x1p-400), exponent += 200;
  while (x < Quad(0x1p-500)) x *= Quad(0x1p400), exponent -= 200;
  Quad y = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3; ++i) y = (y + x / y) / 2;
  const Quad step = exponent > 0 ? Quad(0x1p200) : Quad(0x1p-200);
  for (int i = 0; i < std::abs(exponent); i += 200) y *= step;
  return y;
}

struct Vector {
  Quad x = 0, y = 0, z = 0;
};
inline Vector Of(const R3::Vector& v) { return {v.x, v.y, v.z}; }
inline Vector Of(const R3::Point& p) { return {p.x, p.y, p.z}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(Quad s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
inline Quad Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Quad Length(const Vector& v) { return Sqrt(Dot(v, v)); }
inline double Double(Quad x) { return static_cast<double>(x); }

/// Points o + t d, to 113 bits.
struct Line {
  Vector o, d;

  Vector At(Quad t) const { return o + t * d; }
};
inline Line Of(const R3::Ray& ray) { return {Of(ray.origin), Of(ray.direction)}; }

/// The ray in hexadecimal, so that it can be replayed bit for bit.
inline std::string Hex(const R3::Ray& ray) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "origin %a %a %a direction %a %a %a t %a %a", ray.origin.x, ray.origin.y,
                ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.t_min, ray.t_max);
  return text.data();
}

}  // namespace oracle
