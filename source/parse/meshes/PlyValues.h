#pragma once

#include <string>

#include "source/parse/meshes/Bytes.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/parse/meshes/PlyHeader.h"

namespace ray {

/// Which element of a .ply file is being read: "vertex 12".
struct PlyPlace {
  const std::string& element;
  std::size_t number;

  std::string Words() const { return element + " " + std::to_string(number); }
};

/// The numbers behind the header of a .ply file, one after the other, text or binary. Every number of every type fits
/// a double exactly.
class PlyValues {
 public:
  /// `words` must have just read the header.
  PlyValues(MeshWords& words, const PlyHeader& header);

  /// NaN and infinities where the file has them. Throws SceneError when there is none left.
  double Next(PlyType type, const PlyPlace& place, const std::string& property);

  bool AtEnd();
  /// Whether the file is text and has more on the line of the last number.
  bool HasMoreOnLine() { return is_text_ && words_.HasMoreOnLine(); }
  std::size_t BytesLeft() const { return is_text_ ? words_.BytesLeft() : bytes_.Left(); }
  /// The fewest bytes that one number can take.
  std::size_t LeastBytes(PlyType type) const { return is_text_ ? 2 : SizeOf(type); }

  /// The number that was read last; of no line in a binary file.
  Token Last() const { return is_text_ ? words_.Last() : Token{}; }
  /// About the number that was read last.
  [[noreturn]] void Fail(const PlyPlace& place, const std::string& message) const;

 private:
  double NextBinary(PlyType type);

  MeshWords& words_;
  Bytes bytes_;
  bool is_text_;
  std::size_t last_offset_ = 0;
};

}  // namespace ray
