#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "R2/Point.h"
#include "R3/Point.h"

namespace R3 {

using Cuts = std::vector<std::array<std::uint32_t, 3>>;

/// The maximum number of corners of a concave polygon that is written in a scene. Checking that none of its sides cross
/// takes quadratic time.
inline constexpr std::size_t max_concave_corners = 256;

/// Returns triangles from the first corner of a polygon, which has at least 3 corners.
Cuts Fan(std::size_t corners);

/// Returns why a polygon is invalid, for a message: "has corners that are not in one plane", "has sides that cross".
/// Null if the polygon is valid within the rounding of its corners.
const char* FaultOfPolygon(std::span<const Point> polygon);

/// Returns the texture coordinates of the corners of a `quad`.
std::vector<R2::Point> QuadUvs();

/// Splits a polygon into triangles of its own corners, given as indices into it, so that faces that met along an edge
/// still do. Uses a fan from the first corner, as the course does, unless a triangle of it would be flipped, which
/// happens in concave polygons only: these are split by ear clipping. Decided in the coordinate plane that the polygon
/// faces most, so it need not be flat.
///   returns   polygon.size() - 2 triangles; std::nullopt if it would take more than linear time, as for some polygons
///             of
///             more than 5,000 corners that wind through one another
///   source    Newell's normal: Sutherland, Sproull, Schumacker, A characterization of ten hidden-surface algorithms
///             (1974); ears: Meisters, Polygons have ears (1975), with the bookkeeping of Eberly, Triangulation by ear
///             clipping (2002). A polygon that crosses itself may run out of ears; any corner is cut off then.
std::optional<Cuts> Triangulate(std::span<const Point> polygon);

/// A point where one side of a polygon crosses another: at a share of the way from corner `side` to the next.
struct SideCrossing {
  std::uint32_t side = 0;
  double share = 0;  // in (0, 1)
};

/// A polygon split into triangles of its corners and the crossings of its sides, which are numbered after the corners.
struct CutPolygon {
  Cuts cuts;
  std::vector<SideCrossing> crossings{};
};

/// Works like Triangulate, but also splits flat polygons that cross themselves, with up to max_concave_corners corners
/// and at most as many crossings. Each part turns as its corners do, so the two halves of a bow tie face opposite ways.
std::optional<CutPolygon> CutApart(std::span<const Point> polygon);

}  // namespace R3
