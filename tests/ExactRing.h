#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/Quad.h"

namespace oracle {

/// A torus around the origin and the y direction, and lines seen from there.
struct Ring {
  double major, minor;

  double Size() const { return major + minor; }

  /// How far a point is outside the surface.
  Quad Outside(const Vector& p) const {
    const Quad across = Sqrt(p.x * p.x + p.z * p.z) - major;
    return Sqrt(across * across + p.y * p.y) - minor;
  }

  /// Places between which Outside rises or falls all the way, in order, the first and the last farther outside than
  /// `around`. Near its turns Outside is flat: their error, of a long double's rounding, makes no difference in it. None
  /// for a line without direction.
  std::vector<Quad> Breaks(const Line& line, Quad around) const {
    const Vector &p = line.o, &v = line.d;
    const Quad A = Dot(v, v), a = v.x * v.x + v.z * v.z, aside = p.x * v.z - p.z * v.x;
    if (!(A > 0)) return {};
    const Quad nearest = -Dot(p, v) / A;  // all below counts from there
    const Vector m = line.At(nearest);
    const Quad b = m.x * v.x + m.z * v.z, c = m.x * m.x + m.z * m.z;
    const Quad reach = 4 * (Size() + Length(m) + around) / Sqrt(A);
    const auto part = [&](Quad t) { return static_cast<long double>(t); };
    const auto slope = [&](long double t) {  // half the derivative of the squared distance
      const long double q = (part(a) * t + 2 * part(b)) * t + part(c);
      return part(A) * t - part(major) * (part(a) * t + part(b)) / std::sqrt(q);
    };
    // The second derivative is zero where the squared distance from the axis is (R aside^2 / A)^(2/3).
    const long double q = std::pow(part(Quad(major) * aside * aside / A), 2.0L / 3);
    const long double root = std::sqrt(part(b * b - a * c) + part(a) * q);  // NaN: convex everywhere
    std::vector<long double> ends{-part(reach), (-part(b) - root) / part(a), (-part(b) + root) / part(a), part(reach)};
    std::erase_if(ends, [&](long double t) { return !(std::abs(t) <= part(reach)); });
    std::vector<Quad> breaks;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const bool is_concave = ends.size() == 4 && i == 1;
      long double low = ends[i], high = ends[i + 1];
      for (int k = 0; k < 70; ++k) {
        const long double middle = low + (high - low) / 2;
        ((slope(middle) < 0) != is_concave ? low : high) = middle;
      }
      for (const long double t : {ends[i], low}) breaks.push_back(nearest + Quad(t));
    }
    breaks.push_back(nearest + Quad(ends.back()));
    return breaks;
  }
};

}  // namespace oracle
