#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/Quad.h"

/// Where lines pass through spheres, boxes, cylinders, cones and paraboloids, in 113 bits.
namespace oracle {

/// A stretch of a line; empty when leave < enter.
struct Stretch {
  Quad enter = -Quad(R3::infinity), leave = Quad(R3::infinity);

  bool IsEmpty() const { return !(enter <= leave); }
  void Keep(Quad from, Quad to) {
    if (from > enter) enter = from;
    if (to < leave) leave = to;
  }
  void KeepNothing() { Keep(1, -1); }
};

/// Keeps low <= o + t d <= high.
inline void KeepSlab(Stretch& stretch, Quad low, Quad high, Quad o, Quad d) {
  if (high < low) return stretch.KeepNothing();
  if (d == 0) {
    if (o < low || o > high) stretch.KeepNothing();
    return;
  }
  const Quad a = (low - o) / d, b = (high - o) / d;
  if (a < b)
    stretch.Keep(a, b);
  else
    stretch.Keep(b, a);
}

/// Keeps a t^2 - 2 b t + c <= 0, where a > 0.
inline void KeepBetweenRoots(Stretch& stretch, Quad a, Quad b, Quad c) {
  const Quad discriminant = b * b - a * c;
  if (discriminant < 0) return stretch.KeepNothing();
  const Quad q = b < 0 ? b - Sqrt(discriminant) : b + Sqrt(discriminant);
  if (q == 0) return stretch.Keep(0, 0);
  const Quad one = c / q, other = q / a;
  if (one < other)
    stretch.Keep(one, other);
  else
    stretch.Keep(other, one);
}

/// Keeps x^2 + z^2 <= (R0 + t R1)^2 with R0 + t R1 >= 0; R1 = 0 makes it a cylinder.
inline void KeepRound(Stretch& stretch, const Vector& o, const Vector& d, Quad R0, Quad R1) {
  const Quad a = d.x * d.x + d.z * d.z - R1 * R1, b = R0 * R1 - (o.x * d.x + o.z * d.z);
  const Quad c = o.x * o.x + o.z * o.z - R0 * R0;
  if (R1 > 0) stretch.Keep(-R0 / R1, Quad(R3::infinity));
  if (R1 < 0) stretch.Keep(-Quad(R3::infinity), -R0 / R1);
  if (a > 0) return KeepBetweenRoots(stretch, a, b, c);
  if (a == 0 && b == 0) {
    if (c > 0 || R0 < 0) stretch.KeepNothing();
    return;
  }
  // Steeper than the cone: inside it from the one root on its own side of the apex.
  const Quad root = Sqrt(b * b - a * c), q = b < 0 ? b - root : b + root;
  const Quad one = q == 0 ? Quad(0) : c / q, other = a < 0 ? q / a : one;
  if (R1 > 0) stretch.Keep(one > other ? one : other, Quad(R3::infinity));
  if (R1 < 0) stretch.Keep(-Quad(R3::infinity), one < other ? one : other);
}

/// Keeps x^2 + z^2 <= k (top - y).
inline void KeepParaboloid(Stretch& stretch, const Vector& o, const Vector& d, Quad k, Quad top) {
  const Quad a = d.x * d.x + d.z * d.z, b = -k * d.y / 2 - (o.x * d.x + o.z * d.z);
  const Quad c = o.x * o.x + o.z * o.z - k * (top - o.y);
  if (a > 0) return KeepBetweenRoots(stretch, a, b, c);
  if (b > 0) stretch.Keep(c / (2 * b), Quad(R3::infinity));
  if (b < 0) stretch.Keep(-Quad(R3::infinity), c / (2 * b));
  if (b == 0 && c > 0) stretch.KeepNothing();
}

struct Solid {
  std::string kind;
  std::vector<double> arguments;

  R3::Point Center() const {
    const auto& a = arguments;
    if (kind == "box") return {(a[0] + a[3]) / 2, (a[1] + a[4]) / 2, (a[2] + a[5]) / 2};
    return {a[0], a[1], a[2]};
  }
  double Size() const {
    const auto& a = arguments;
    if (kind == "box") return std::max({a[3] - a[0], a[4] - a[1], a[5] - a[2]});
    return kind == "sphere" ? a[3] : a[3] + a[4];
  }

  /// What of the line lies in the solid grown by `more` on all sides (shrunk when it is negative).
  Stretch Inside(const Line& line, Quad more) const {
    const auto& a = arguments;
    const Vector& d = line.d;
    Stretch stretch;
    if (kind == "box") {
      const Vector& o = line.o;
      KeepSlab(stretch, a[0] - more, a[3] + more, o.x, d.x);
      KeepSlab(stretch, a[1] - more, a[4] + more, o.y, d.y);
      KeepSlab(stretch, a[2] - more, a[5] + more, o.z, d.z);
      return stretch;
    }
    const Vector o = line.o - Of(Center());
    if (kind == "sphere") {
      const Quad r = a[3] + more;
      if (r < 0)
        stretch.KeepNothing();
      else
        KeepBetweenRoots(stretch, Dot(d, d), -Dot(o, d), Dot(o, o) - r * r);
      return stretch;
    }
    const Quad half = Quad(a[4]) / 2;
    KeepSlab(stretch, -half - more, half + more, o.y, d.y);
    if (kind == "cylinder") {
      if (a[3] + more < 0) stretch.KeepNothing();
      KeepRound(stretch, o, d, a[3] + more, 0);
    } else if (kind == "paraboloid") {
      // Lifted so far that even at the rim, where it is steepest, it is larger by `more` across its surface.
      // That is not enough where `more` is not small beside the radius: then the cylinder around all of it is taken.
      const Quad r = a[3], rise = 2 * Quad(a[4]) / r;
      if (more > r / 16)
        KeepRound(stretch, o, d, r + more, 0);
      else
        KeepParaboloid(stretch, o, d, r * r / Quad(a[4]), half + more * Sqrt(1 + rise * rise));
    } else {
      const Quad slope = Quad(a[3]) / Quad(a[4]);
      KeepRound(stretch, o, d, slope * (half - o.y) + more * Sqrt(1 + slope * slope), -slope * d.y);
      if (more > 0) KeepRound(stretch, o, d, a[3] + more, 0);  // the flat cone's rim, where it would grow far outward
    }
    return stretch;
  }
};

}  // namespace oracle
