#include "R3/Placement.h"

#include <numbers>

#include "R1/Elementary.h"

namespace R3 {
namespace {

R1::SineCosine OfDegrees(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90, &quarters);
  const auto [s, c] = R1::SinCosTurns(rest / 360);
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace

Matrix Frame(const Point& origin, const Vector& x, const Vector& y, const Vector& z) {
  return {{{{x.x, y.x, z.x, origin.x}, {x.y, y.y, z.y, origin.y}, {x.z, y.z, z.z, origin.z}}}};
}

Matrix Translation(const Vector& way) { return {{{{1, 0, 0, way.x}, {0, 1, 0, way.y}, {0, 0, 1, way.z}}}}; }

Matrix Scaling(const Vector& factors) { return {{{{factors.x, 0, 0, 0}, {0, factors.y, 0, 0}, {0, 0, factors.z, 0}}}}; }

Matrix RotationAbout(int axis, double degrees) {
  const auto [sine, cosine] = OfDegrees(degrees);
  const auto a = static_cast<std::size_t>((axis + 1) % 3), b = static_cast<std::size_t>((axis + 2) % 3);
  Matrix matrix;
  matrix.m[a][a] = matrix.m[b][b] = cosine;
  matrix.m[a][b] = -sine;
  matrix.m[b][a] = sine;
  return matrix;
}

Matrix TurnOf(const Vector& radians) {
  constexpr double degrees = 180 / std::numbers::pi;
  return RotationAbout(2, radians.z * degrees) * RotationAbout(1, radians.y * degrees) *
         RotationAbout(0, radians.x * degrees);
}

// Rodrigues' formula, cos I + sin [a] + (1 - cos) a a^T.
Matrix RotationAbout(const Vector& axis, double degrees) {
  const R1::SineCosine turn = OfDegrees(degrees);
  const Vector a = Unit(axis);
  const auto column = [&](const Vector& e) {
    return turn.cosine * e + turn.sine * Cross(a, e) + (1 - turn.cosine) * Dot(a, e) * a;
  };
  return Frame({}, column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}));
}

std::optional<Matrix> LookingAt(const Point& eye, const Point& target, const Vector& up) {
  const Vector z = Unit(target - eye), x = Unit(Cross(Unit(up), z));
  if (z == Vector{} || x == Vector{}) return {};
  return Frame(eye, x, Cross(z, x), z);
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  const auto column = [&](std::size_t i) { return a * Vector{b.m[0][i], b.m[1][i], b.m[2][i]}; };
  return Frame(a * Point{b.m[0][3], b.m[1][3], b.m[2][3]}, column(0), column(1), column(2));
}

// With v = from x to and c = from . to, the matrix is I + [v] + [v]^2 / (1 + c): Moller, Hughes, Efficiently building a
// matrix to rotate one vector to another (1999), eq. 3. Beyond a right angle it is composed of two halves, so that 1 +
// c is never small.
Matrix SmallestRotation(const Vector& from, const Vector& to) {
  const double c = Dot(from, to);
  if (c < 0) {
    Vector middle = from + to;
    if (!(Length(middle) > 0)) middle = Cross(from, LeastAxis(from));
    const Vector half = Unit(middle);
    return SmallestRotation(half, to) * SmallestRotation(from, half);
  }
  const Vector v = Cross(from, to);
  const double k = 1 / (1 + c);
  const auto column = [&](const Vector& e) { return c * e + Cross(v, e) + k * Dot(v, e) * v; };
  return Frame({}, column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}));
}

}  // namespace R3
