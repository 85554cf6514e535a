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

/// The most corners of a concave polygon that a scene spells out: that none of its sides cross is checked in quadratic
/// time.
inline constexpr std::size_t max_concave_corners = 256;

/// Triangles from the first corner of a polygon, which has at least 3 corners.
Cuts Fan(std::size_t corners);

/// Why a polygon that should be flat is none, for a message about it: "has corners that are not in one plane", "has
/// sides that cross"; null where it is one, as far as its corners were rounded.
const char* FaultOfPolygon(std::span<const Point> polygon);

/// The texture coordinates that the corners of a `quad` have.
std::vector<R2::Point> QuadUvs();

/// Cuts a polygon into triangles of its own corners, given as indices into it, so that faces that met along an edge
/// still do. A fan from the first corner, as the course has it, unless a triangle of it would be turned over, which
/// happens in concave polygons only: then ears are cut off. Judged in the coordinate plane that the polygon faces most,
/// so it need not be flat.
///   returns   polygon.size() - 2 triangles; nothing where it would take more than linear time, as some polygons of
///             more than 5,000 corners do that wind through one another
///   source    Newell's normal: Sutherland, Sproull, Schumacker, A characterization of ten hidden-surface algorithms
///             (1974); ears: Meisters, Polygons have ears (1975), with the bookkeeping of Eberly, Triangulation by ear
///             clipping (2002). A polygon that crosses itself may run out of ears; any corner is cut off then.
std::optional<Cuts> Triangulate(std::span<const Point> polygon);

/// Where one side of a polygon crosses another: at a share of the way from corner `side` to the next.
struct SideCrossing {
  std::uint32_t side = 0;
  double share = 0;  // in (0, 1)
};

/// A polygon cut into triangles of its corners and of places where its sides cross, which are numbered on after the
/// corners.
struct CutPolygon {
  Cuts cuts;
  std::vector<SideCrossing> crossings{};
};

/// Does as Triangulate, but flat polygons of up to max_concave_corners that cross themselves, at most as often as they
/// have corners, are cut where they do. Each part turns as its corners do, so the two halves of a bow tie face opposite
/// ways.
std::optional<CutPolygon> CutApart(std::span<const Point> polygon);

}  // namespace R3
