#pragma once

#include <optional>
#include <vector>

#include "source/parse/meshes/PlyValues.h"
#include "source/parse/meshes/Tally.h"

namespace ray {

/// What is used of the rows of an element, as indices of its properties.
struct PlyColumns {
  std::vector<std::size_t> coordinates{};       // numbers that must be finite
  std::optional<std::size_t> corners{}, uvs{};  // lists
};

/// The numbers of one vertex, face or strip: plain ones by property, and the lists that are used.
struct PlyRow {
  std::vector<double> numbers;
  std::vector<double> corners, uvs;
  Token unusable;  // the last number that is not finite; of no line in a binary file
};

/// Reads the rows of a .ply file one after the other. In text files a row should have a line, but its numbers count and
/// not the lines, unless that would take numbers beyond those that the header declares for the next row.
class PlyRows {
 public:
  PlyRows(MeshWords& words, const PlyHeader& header) : words_(words), header_(header), values_(words, header) {}

  /// Row `number` of the element. Overwrites `row`, so that its memory is used again.
  void Read(const PlyElement& element, std::size_t number, const PlyColumns& columns, PlyRow& row);

  PlyValues& Values() { return values_; }
  /// Faces that had more numbers than declared.
  const Tally& LongFaces() const { return long_faces_; }
  /// Whether a row did not end with its line: then numbers may be counted wrong, and what is odd is an error.
  bool IsIrregular() const { return has_line_each_.has_value(); }
  /// What probably is wrong where something is, or nothing.
  const char* Hint() const { return IsIrregular() ? "there are lines with more numbers than the header declares" : ""; }

 private:
  void ReadList(const PlyProperty& property, const PlyPlace& place, std::vector<double>* list);
  void EndRow(const PlyElement& element, std::size_t number, const PlyColumns& columns, const PlyRow& row);
  std::size_t RowsBehind(const PlyElement& element, std::size_t number) const;

  MeshWords& words_;
  const PlyHeader& header_;
  PlyValues values_;
  std::optional<bool> has_line_each_;  // rows of a text file; known once one of them does not end with its line
  Tally long_faces_;
};

}  // namespace ray
