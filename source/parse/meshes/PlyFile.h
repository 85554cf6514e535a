#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/meshes/Bytes.h"
#include "source/parse/meshes/MeshWords.h"

namespace ray {

/// A type of the numbers of a .ply file. Every number of every type fits a double exactly.
struct PlyType {
  const char *name, *later_name;  // Turk's, and that of later libraries
  std::size_t bytes;
  double white;  // what the greatest channel of a color has
  bool is_whole;
  double (*next)(Bytes& bytes);
};

struct PlyProperty {
  std::string name;
  const PlyType* type;
  const PlyType* count_type;  // of a list; null if the property is one number
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  Token where;  // the count's word in the header

  /// Returns the index of a list or of a plain number in `properties`, if there is one of that name.
  std::optional<std::size_t> Find(std::string_view property, bool is_list) const;
};

/// The properties that a reader uses, as indices.
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

/// The header and the rows of a .ply file, text or binary. In text files a row should have a line, but its numbers
/// count and not the lines, unless that would take numbers beyond those that the header declares for the next row.
/// Everything throws SceneError.
///   source   Turk, The PLY polygon file format (1994)
class PlyFile {
 public:
  /// Reads the header.
  explicit PlyFile(const Text& file);

  const std::vector<PlyElement>& Elements() const { return elements_; }
  /// The names of image files, which VCGlib writes in comments.
  const std::vector<Token>& Textures() const { return textures_; }
  const Text& Source() const { return words_.Source(); }

  /// Throws if the rest of the file is too short for all rows of the element.
  void CheckLength(const PlyElement& element) const;
  /// Reads a row of the element. Overwrites `row`, so that its memory is used again.
  void Read(const PlyElement& element, std::size_t number, const PlyColumns& columns, PlyRow& row);
  /// Warns of what follows the last row; throws if rows did not end with their lines.
  void CheckEnd(Report& report);
  /// Warns of faces with more numbers than declared.
  void Warn(Report& report) const;

  std::size_t BytesLeft() const { return is_text_ ? words_.BytesLeft() : bytes_.Left(); }
  /// Returns true if a row did not end with its line. Numbers may then be counted wrong, and what is odd is an error.
  bool IsIrregular() const { return has_line_each_.has_value(); }
  /// The number that was read last; of no line in a binary file.
  Token Last() const { return is_text_ ? words_.Last() : Token{}; }
  /// Throws an error about the last number of the row that was read last.
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailAt(const Token& word, const std::string& message) const { words_.Fail(word, message); }

 private:
  void ReadHeaderLine(const Token& keyword);
  void ReadComment();
  void ReadFormat();
  void ReadElement();
  void ReadProperty();
  const PlyType& TypeAt(const Token& word) const;
  std::size_t OffsetBehindHeader() const;

  double Next(const PlyType& type, const PlyProperty& property);
  void ReadList(const PlyProperty& property, std::vector<double>* list);
  void EndRow(const PlyColumns& columns, const PlyRow& row);
  std::size_t RowsBehind() const;
  std::size_t LeastBytes(const PlyType& type) const { return is_text_ ? 2 : type.bytes; }

  MeshWords words_;
  Bytes bytes_;
  bool is_text_ = true;
  std::vector<PlyElement> elements_;
  std::vector<Token> textures_;
  std::size_t properties_ = 0;
  // The row being read:
  const PlyElement* element_ = nullptr;
  std::size_t number_ = 0, last_offset_ = 0;
  std::optional<bool> has_line_each_;  // rows of a text file; known once one of them does not end with its line
  Tally long_faces_;
};

}  // namespace ray
