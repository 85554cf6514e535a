#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/meshes/Bytes.h"
#include "source/parse/meshes/MeshWords.h"

namespace ray {

/// A number type of .ply files. Every number of every type fits a double exactly.
struct PlyType {
  const char *name, *later_name;  // Turk's name, and that of later libraries
  std::size_t bytes;
  double white;  // the maximum of a color channel
  bool is_whole;
  double (*next)(Bytes& bytes);
};

struct PlyProperty {
  std::string name;
  const PlyType* type;
  const PlyType* count_type;  // of a list; null for a single number
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  Token where;  // the position of the count in the header

  /// Returns the index of a list or of a single number in `properties`, if there is one with that name.
  std::optional<std::size_t> Find(std::string_view property, bool is_list) const;
};

/// The properties that a reader uses, as indices.
struct PlyColumns {
  std::vector<std::size_t> coordinates{};       // numbers that must be finite
  std::optional<std::size_t> corners{}, uvs{};  // lists
};

/// The numbers of one vertex, face or strip: single ones by property, and the lists that are used.
struct PlyRow {
  std::vector<double> numbers;
  std::vector<double> corners, uvs;
  Token unusable;  // the last number that is not finite; without a line in a binary file
};

/// The header and the rows of a .ply file, text or binary. In text files a row should be a line, but rows are delimited
/// by the count of numbers, not by lines, unless that would use numbers beyond those that the header declares for the
/// next row. All functions throw SceneError.
///   source   Turk, The PLY polygon file format (1994)
class PlyFile {
 public:
  /// Reads the header.
  explicit PlyFile(const Text& file);

  const std::vector<PlyElement>& Elements() const { return elements_; }
  /// Returns the names of image files, which VCGlib writes in comments.
  const std::vector<Token>& Textures() const { return textures_; }
  const Text& Source() const { return words_.Source(); }

  /// Throws if the rest of the file is too short for all rows of the element.
  void CheckLength(const PlyElement& element) const;
  /// Reads a row of the element. Overwrites `row`, so that its memory is reused.
  void Read(const PlyElement& element, std::size_t number, const PlyColumns& columns, PlyRow& row);
  /// Warns about data after the last row; throws if rows did not end with their lines.
  void CheckEnd(Report& report);
  /// Warns about faces with more numbers than declared.
  void Warn(Report& report) const;

  std::size_t BytesLeft() const { return is_text_ ? words_.BytesLeft() : bytes_.Left(); }
  /// Returns true if a row did not end with its line. Numbers may then be miscounted, so oddities are errors.
  bool IsIrregular() const { return has_line_each_.has_value(); }
  /// Returns the number that was read last; without a line in a binary file.
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
  std::optional<bool> has_line_each_;  // rows of a text file; known once a row does not end with its line
  Tally long_faces_;
};

}  // namespace ray
