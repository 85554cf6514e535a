#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/meshes/MeshWords.h"

namespace ray {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
/// Bytes of one.
std::size_t SizeOf(PlyType type);

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  Token where;  // the count's word in the header

  /// Index into `properties`, of a list or of a plain number as asked; nothing when there is none.
  std::optional<std::size_t> Find(std::string_view property, bool is_list) const;
  /// "x, y, z", for messages
  std::string PropertyNames() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<Token> textures{};  // names of image files, which VCGlib writes in comments
  std::size_t data_offset = 0;    // of the first byte behind the header
};

/// Reads up to and with the word end_header. Throws SceneError.
///   source   Turk, The PLY polygon file format (1994)
PlyHeader ReadPlyHeader(MeshWords& words);

}  // namespace ray
