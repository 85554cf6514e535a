#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/parse/courses/objects/ObjectReader.h"

namespace ray {

/// One kind of object.
struct ObjectKind {
  std::vector<std::string_view> names;  // the usual one first
  /// Nothing after a mistake, which is told; may throw R3::ArgumentError.
  std::optional<PlacedShape> (*read)(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
};
std::span<const ObjectKind> ObjectKinds();

/// Turned about x, then y, then z.
R3::Matrix TurnOf(const R3::Vector& radians);
/// A shape of shapes.def.
std::shared_ptr<const R3::Shape> ShapeOf(const char* kind, std::span<const double> numbers);

// The kinds themselves, by what they have in common.
std::optional<PlacedShape> ReadSphere(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadTriangle(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadQuad(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadPolygon(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadMeshFile(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadPlane(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadBox(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadCube(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadCylinder(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadCone(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadTorus(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadDisc(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadParaboloid(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadBlob(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadBezier(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadBspline(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);
std::optional<PlacedShape> ReadImplicit(ObjectReader& reader, Mapping& object, const ObjectReader::Options& options);

}  // namespace ray
