#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "source/parse/scn/ScnPlaces.h"

namespace ray {

/// Numbers of a statement that are edited together, as the three of a color are.
struct ScnField {
  enum class Kind { color, point, direction, number };

  std::string name;  // "diffuse (kd)"
  Kind kind = Kind::number;
  std::vector<std::size_t> words;  // where its numbers are among the statement's words; one, or three
  std::vector<double> values;      // as the file has them; 0 where a word is no number
  std::string problem;             // why it cannot be edited; empty where it can
};

/// The fields of a material, its mirror and gloss, light, shape, line, group, camera, background or ambient light, in
/// the order of the file; none of other statements. Those of a group are its position, where its matrix or a first
/// translation says it.
std::vector<ScnField> FieldsOf(const ScnPlaces& places, std::uint32_t statement);

/// Returns why a word is not edited that stands for a value given elsewhere: "$t is a variable; ...". Empty for others.
std::string WhyComputed(const std::string& word);

/// The name of the statement's command.
std::string CommandOf(const ScnPlaces& places, std::uint32_t statement);

/// "sphere, line 16"
std::string NameOf(const ScnPlaces& places, std::uint32_t statement);

/// The comment behind the statement on the line where it ends, without the # and blanks around; empty where there is
/// none. Scenes name their materials so.
std::string CommentOf(const ScnPlaces& places, std::uint32_t statement);

}  // namespace ray
