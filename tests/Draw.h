#pragma once

#include <cstdlib>
#include <random>

#include "R3/Matrix.h"
#include "R3/Vector.h"

/// Random numbers for tests: fixed seeds, so that every run is the same run.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double Between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int Whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  /// 10 to a power drawn evenly.
  double Scale(double low_power, double high_power) { return std::pow(10, Between(low_power, high_power)); }

  R3::Vector Direction() {
    for (;;) {
      const R3::Vector v{Between(-1, 1), Between(-1, 1), Between(-1, 1)};
      if (Dot(v, v) <= 1 && Dot(v, v) > 0.01) return Unit(v);
    }
  }

  /// A rotation: an orthonormal frame, up to rounding.
  R3::Matrix Rotation() {
    const R3::Vector a = Direction(), b = Unit(Cross(a, Direction())), c = Cross(a, b);
    R3::Matrix m;
    m.m = {{{a.x, b.x, c.x, 0}, {a.y, b.y, c.y, 0}, {a.z, b.z, c.z, 0}}};
    return m;
  }

  /// A rotation, a shear and a scale per axis of up to `powers` orders of magnitude (mirrored half of the time), a
  /// shift.
  R3::Matrix Affine(double powers) {
    const R3::Matrix turn = Rotation();
    R3::Matrix m;
    const double overall = Scale(-powers, powers);
    for (std::size_t j = 0; j < 3; ++j) {
      const double scale = overall * Scale(-0.5, 0.5) * (Whole(0, 1) ? 1 : -1);
      for (std::size_t i = 0; i < 3; ++i) m.m[i][j] = turn.m[i][j] * scale;
    }
    const double shear = Between(-1, 1);
    for (std::size_t i = 0; i < 3; ++i) {
      m.m[i][1] += shear * m.m[i][0];
      m.m[i][3] = overall * Between(-3, 3);
    }
    return m;
  }

 private:
  std::mt19937_64 engine_;
};

/// How many cases to try: `commit` on every change, `night` when RAYPRO_NIGHT is set.
inline int Count(int commit, int night) { return std::getenv("RAYPRO_NIGHT") ? night : commit; }
/// The number in an environment variable, for runs of a million by hand; without it, what Count says.
inline int Asked(const char* variable, int commit, int night) {
  const char* const number = std::getenv(variable);
  return number ? std::atoi(number) : Count(commit, night);
}
