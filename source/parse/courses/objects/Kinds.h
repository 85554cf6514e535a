#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/parse/courses/objects/ObjectReader.h"

namespace ray {

/// One kind of object. Its function returns std::nullopt after a mistake, which it reports; it may throw
/// R3::ArgumentError.
struct ObjectKind {
  std::vector<std::string_view> names;  // the usual one first
  std::optional<PlacedShape> (*read)(Mapping& object);
  /// Replaces `read` for kinds that open files or depend on textures.
  std::optional<PlacedShape> (*read_with)(ObjectReader& reader, Mapping& object, bool has_texture) = nullptr;
};
extern const std::vector<ObjectKind> sphere_kinds, flat_kinds, solid_kinds, surface_kinds;

/// Makes a shape of shapes.def.
std::shared_ptr<const R3::Shape> ShapeOf(const char* kind, std::span<const double> numbers);

}  // namespace ray
