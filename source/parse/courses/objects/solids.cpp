#include <array>

#include "R3/Placement.h"
#include "source/parse/Coordinate.h"
#include "source/parse/courses/objects/Kinds.h"

namespace ray {
namespace {

/// Reads a direction, which must not be zero; returns `otherwise`, if given, for a missing key.
R3::Vector Direction(Mapping& object, Mapping::Names names, const std::optional<R3::Vector>& otherwise = {}) {
  const auto field = otherwise ? object.Find(names) : object.Need(names);
  const R3::Vector fallback = otherwise.value_or(R3::Vector{0, 0, 1});
  if (!field) return fallback;
  const auto direction = field->Vector();
  if (direction && *direction == R3::Vector{}) field->Error("must not be 0 0 0: it is a direction");
  return direction && !(*direction == R3::Vector{}) ? *direction : fallback;
}

/// Returns the placement of a shape whose axis is y, so that it has the unit vector `axis` and its origin at `place`.
R3::Matrix Along(const R3::Vector& axis, const R3::Point& place) {
  return Translation(FromOrigin(place)) * SmallestRotation({0, 1, 0}, axis);
}

/// The keys shared by cylinders and cones: base, axis with the length of the height, radius.
struct Upright {
  R3::Point base;
  R3::Vector axis;
  double radius = 0;
};

Upright ReadUpright(Mapping& object) {
  Upright read;
  if (object.Has({"p1"})) {
    read.base = object.NeedPoint({"p1"});
    const auto top = object.Need({"p2"});
    const auto end = top ? top->Vector() : std::nullopt;
    if (end) read.axis = R3::Point{} + *end - read.base;
    if (end && read.axis == R3::Vector{}) top->Error("must not be the same as p1");
  } else {
    read.base = object.NeedPoint({"position", "center"});
    if (object.Has({"height"})) {
      const R3::Vector direction = Direction(object, {"direction", "axis", "up"}, R3::Vector{0, 1, 0});
      read.axis = object.NeedNumber({"height"}, positive) * Unit(direction);
    } else {
      read.axis = Direction(object, {"up", "axis"});  // including its length
    }
  }
  read.radius = object.NeedNumber({"radius", "r"}, positive);
  return read;
}

std::optional<PlacedShape> ReadStanding(const char* kind, Mapping& object) {
  const Upright read = ReadUpright(object);
  if (!object.IsGood()) return {};
  const double height = Length(read.axis);
  return PlacedShape{ShapeOf(kind, std::array{0.0, 0.0, 0.0, read.radius, height}),
                     Along(Unit(read.axis), read.base + 0.5 * read.axis)};
}

std::shared_ptr<const R3::Shape> BoxBetween(const R3::Point& a, const R3::Point& b) {
  return ShapeOf("box", std::array{a.x, a.y, a.z, b.x, b.y, b.z});
}

/// Returns a box of given size about a point, rotated by angles in radians.
PlacedShape TurnedBox(const R3::Point& center, const R3::Vector& size, const R3::Vector& turn) {
  const R3::Point half = R3::Point{} + 0.5 * size;
  const R3::Point other{-half.x, -half.y, -half.z};
  return {BoxBetween(other, half), Translation(FromOrigin(center)) * TurnOf(turn)};
}

std::optional<PlacedShape> ReadPlane(Mapping& object) {
  const R3::Vector normal = Direction(object, {"normal", "N", "n"});
  R3::Point point;
  if (const auto distance = object.Find({"distance", "d"}))
    point = R3::Point{} + distance->Number({-largest_coordinate, largest_coordinate}).value_or(0) * Unit(normal);
  else
    point = object.NeedPoint({"position", "center", "O", "a", "point"});
  if (!object.IsGood()) return {};
  return PlacedShape{ShapeOf("plane", std::array{point.x, point.y, point.z, normal.x, normal.y, normal.z})};
}

/// Returns the third edge of a box. If only its length is given, it is perpendicular to the other two: away from a
/// viewer for whom side points right and up points up.
R3::Vector BoxDepth(Mapping& object, const R3::Vector& side, const R3::Vector& up) {
  const auto depth = object.Find({"depth"});
  if (!depth || depth->What().kind != Value::Kind::scalar) return Direction(object, {"depth"});
  const auto length = depth->Number();
  const R3::Vector away = Cross(up, side);
  if (length && away == R3::Vector{}) depth->Error("must be three numbers, since side and up are parallel");
  return length.value_or(0) * Unit(away);
}

std::optional<PlacedShape> ReadBox(Mapping& object) {
  if (object.Has({"dimension"})) {
    const R3::Point center = object.NeedPoint({"position", "center"});
    const R3::Vector size = object.NeedVector({"dimension"});
    const R3::Vector turn = object.Vector({"rotation"}).value_or(R3::Vector{});
    if (!object.IsGood()) return {};
    return TurnedBox(center, size, turn);
  }
  if (object.Has({"depth"})) {
    const R3::Point corner = object.NeedPoint({"position"});
    const R3::Vector up = Direction(object, {"up"}), side = Direction(object, {"side"}),
                     depth = BoxDepth(object, side, up);
    if (!object.IsGood()) return {};
    return PlacedShape{BoxBetween({0, 0, 0}, {1, 1, 1}), Frame(corner, side, up, depth)};
  }
  const R3::Point low = object.NeedPoint({"min"}), high = object.NeedPoint({"max"});
  if (!object.IsGood()) return {};
  return PlacedShape{BoxBetween(low, high)};
}

std::optional<PlacedShape> ReadCube(Mapping& object) {
  const R3::Point center = object.NeedPoint({"position", "center"});
  const double size = object.NeedNumber({"size"}, positive);
  const R3::Vector turn{object.Number({"pitch"}, any_number, 0), object.Number({"yaw"}, any_number, 0),
                        object.Number({"roll"}, any_number, 0)};
  if (!object.IsGood()) return {};
  return TurnedBox(center, {size, size, size}, turn);
}

std::optional<PlacedShape> ReadTorus(Mapping& object) {
  const R3::Point center = object.NeedPoint({"position", "center"});
  const R3::Vector direction = Direction(object, {"direction", "axis"}, R3::Vector{0, 0, 1});
  const double radius = object.NeedNumber({"radius"}, positive);
  const auto field = object.Need({"tube", "alpha"});
  const double tube = field ? field->Number(positive).value_or(0) : 0;
  if (object.IsGood() && !(tube < radius)) field->Error("must be smaller than the radius of the ring");
  if (!object.IsGood()) return {};
  return PlacedShape{ShapeOf("torus", std::array{0.0, 0.0, 0.0, radius, tube}), Along(Unit(direction), center)};
}

std::optional<PlacedShape> ReadDisc(Mapping& object) {
  const R3::Point center = object.NeedPoint({"center", "position"});
  const R3::Vector normal = Direction(object, {"N", "normal", "n"});
  const double radius = object.NeedNumber({"radius", "r"}, positive);
  if (!object.IsGood()) return {};
  return PlacedShape{ShapeOf("disc", std::array{center.x, center.y, center.z, normal.x, normal.y, normal.z, radius})};
}

}  // namespace

extern const std::vector<ObjectKind> solid_kinds{
    {{"plane"}, ReadPlane},
    {{"box"}, ReadBox},
    {{"cube"}, ReadCube},
    {{"cylinder"}, [](Mapping& object) { return ReadStanding("cylinder", object); }},
    {{"cone"}, [](Mapping& object) { return ReadStanding("cone", object); }},
    {{"torus"}, ReadTorus},
    {{"disc", "disk", "circle"}, ReadDisc},
    {{"paraboloid"}, [](Mapping& object) { return ReadStanding("paraboloid", object); }},
};

}  // namespace ray
