#pragma once

#include <numbers>

#include "R1/Elementary.h"
#include "R3/GridMesh.h"
#include "R3/Intersection.h"
#include "R3/Numeric.h"
#include "R3/UvTangents.h"
#include "R3/Warp.h"
#include "R3/shapes/Quadric.h"
#include "R3/shapes/Span.h"

/// Functions shared by cylinder and cone, which are both rotated about a line parallel to y.
namespace R3 {

/// Returns the share of a turn about +y: 0 at -z, 0.25 at +x, 0.5 at +z, 0.75 at -x; in [0, 1].
inline double TurnAboutY(const Vector& outward) {
  const double turn = R1::Atan2(outward.x, -outward.z) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

/// Clips to the infinite cylinder of this radius about the line through `center`; returns false on a miss.
inline bool ClipToCylinder(Span& span, const Ray& ray, const Point& center, double radius, int part) {
  if (ray.direction.x == 0 && ray.direction.z == 0)
    return R1::Hypot(ray.origin.x - center.x, ray.origin.z - center.z) <= radius;
  const auto roots = QuadricRoots({ray.origin.x, 0, ray.origin.z}, {ray.direction.x, 0, ray.direction.z},
                                  {center.x, 0, center.z}, radius);
  if (roots) span.Clip(roots->first, roots->second, part, part);
  return roots.has_value();
}

/// Returns the intersection at the flat end at height y; `side` is +1 if it faces up, -1 if it faces down.
inline Intersection AtCap(const Point& p, const Point& center, double radius, double y, double side) {
  Intersection at;
  at.position = {p.x, y, p.z};
  at.error = Gamma(2) * Abs(FromOrigin(at.position));
  at.normal = at.shading_normal = {0, side, 0};
  at.uv = {0.5 + (p.x - center.x) / (2 * radius), 0.5 - (p.z - center.z) / (2 * radius)};
  return at;
}

inline UvTangents UvTangentsAtCap(double radius) { return {{2 * radius, 0, 0}, {0, 0, -2 * radius}}; }

/// Returns dp/du for u = TurnAboutY, at a radius from the axis in the unit direction `outward`.
inline Vector AlongTurn(const Vector& outward, double radius) {
  return 2 * std::numbers::pi * radius * Vector{-outward.z, 0, outward.x};
}

/// Samples a point on the flat end uniformly.
inline Intersection DrawOnCap(const R2::Point& u, const Point& center, double radius, double y, double side) {
  const R2::Point on_disc = SampleUniformDiskConcentric(u);
  return AtCap({center.x + radius * on_disc.x, y, center.z + radius * on_disc.y}, center, radius, y, side);
}

/// Returns the unit direction from the axis that is rotated by `angle` from that of `from`; from +x if that has none.
inline Vector OutwardBeside(const Vector& from, double angle) {
  const Vector unit = Unit({from.x, 0, from.z});
  const Vector towards = unit == Vector{} ? Vector{1, 0, 0} : unit;
  const auto [sine, cosine] = R1::SinCos(angle);
  return Unit({cosine * towards.x - sine * towards.z, 0, sine * towards.x + cosine * towards.z});
}

/// Returns the outward direction after `column` of `columns` steps of a turn, for display. It turns opposite to
/// TurnAboutY, as fronts require if columns run to the right and +y is up. The last column is bit-identical to the
/// first.
inline Vector ColumnOutward(int column, int columns) {
  const auto [sine, cosine] = R1::SinCosTurns(-static_cast<double>(column % columns) / columns);
  return {sine, 0, -cosine};
}
inline double ColumnTurn(int column, int columns) { return 1 - static_cast<double>(column) / columns; }

/// Adds a flat end for display; the arguments are those of AtCap.
inline void AddCap(MeshData& data, int columns, const Point& center, double radius, double y, double side) {
  const int rows = std::max(1, columns / 8);
  AddGrid(data, columns, rows, [&](int column, int row) {
    const double share = static_cast<double>(side > 0 ? rows - row : row) / rows;
    const Vector outward = ColumnOutward(column, columns);
    const Point p{center.x + share * radius * outward.x, y, center.z + share * radius * outward.z};
    return GridCorner{p, {0, side, 0}, AtCap(p, center, radius, y, side).uv};
  });
}

}  // namespace R3
