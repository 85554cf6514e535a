#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "source/parse/scn/ScnPlaces.h"

namespace ray {

/// Numbers of a statement that are edited together, such as the three of a color.
struct ScnField {
  enum class Kind { color, point, direction, number };

  std::string name;  // "diffuse (kd)"
  Kind kind = Kind::number;
  std::vector<std::size_t> words;  // where its numbers are among the statement's words; one, or three
  std::vector<double> values;      // as the file has them; 0 where a word is no number
  std::string problem;             // why it cannot be edited; empty where it can
};

/// The fields of a material, its mirror and gloss, light, shape, line, group, camera, background or ambient light, in
/// the order of the file; none of other statements. A group has its position, if its matrix or a first translation
/// gives it.
std::vector<ScnField> FieldsOf(const ScnPlaces& places, std::uint32_t statement);

/// Returns the reason why a word is not edited, if it stands for a value defined elsewhere: "$t is a variable; ...".
/// Empty for other words.
std::string WhyComputed(const std::string& word);

/// The name of the statement's command.
std::string CommandOf(const ScnPlaces& places, std::uint32_t statement);

/// "sphere, line 16"
std::string NameOf(const ScnPlaces& places, std::uint32_t statement);

/// The comment after the statement on its last line, without # and surrounding blanks; empty if there is none. Scenes
/// name their materials in such comments.
std::string CommentOf(const ScnPlaces& places, std::uint32_t statement);

}  // namespace ray
