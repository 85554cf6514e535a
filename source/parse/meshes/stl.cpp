#include <algorithm>

#include "source/parse/Coordinate.h"
#include "source/parse/meshes/Bytes.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/text/LowerCase.h"
#include "source/text/Words.h"

namespace ray {
namespace {

// Source: 3D Systems, Stereolithography interface specification (1988): 80 arbitrary bytes, a count, and for each
// triangle a normal, three corners and two arbitrary bytes; little-endian.
constexpr std::size_t header_bytes = 80, first_triangle = header_bytes + sizeof(std::uint32_t), triangle_bytes = 50;

void AddTriangle(R3::MeshData& mesh) {
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  mesh.triangles.push_back({last - 2, last - 1, last});
}

[[noreturn]] void Fail(const Text& file, const std::string& message) { throw ErrorIn(file.name, message); }

double ReadCoordinate(Bytes& bytes, const Text& file, const char* axis, std::size_t triangle) {
  const std::size_t offset = bytes.Offset();
  const double value = bytes.Next<float>();
  if (!IsCoordinate(value))
    Fail(file, std::string(axis) + " of a corner of face " + std::to_string(triangle) + " (byte " +
                   std::to_string(offset) + ") is not a finite number");
  return value;
}

R3::MeshData ReadTriangles(const Text& file, std::size_t triangles) {
  Bytes bytes(file.bytes, first_triangle, std::endian::little);
  R3::MeshData mesh;
  R1::ReserveOnHugePages(mesh.positions, 3 * triangles);
  R1::ReserveOnHugePages(mesh.triangles, triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    bytes.Skip(3 * sizeof(float));  // the normal follows from the corners
    for (int corner = 0; corner < 3; ++corner) {
      const double x = ReadCoordinate(bytes, file, "x", i);
      const double y = ReadCoordinate(bytes, file, "y", i);
      mesh.positions.push_back({x, y, ReadCoordinate(bytes, file, "z", i)});
    }
    bytes.Skip(2);
    AddTriangle(mesh);
  }
  return mesh;
}

std::size_t DeclaredTriangles(const Text& file) {
  return Bytes(file.bytes, header_bytes, std::endian::little).Next<std::uint32_t>();
}

R3::MeshData ReadBinary(const Text& file, Report& report) {
  const std::size_t size = file.bytes.size();
  if (size < first_triangle)
    Fail(file, "an .stl file must begin with 'solid', or be binary and have at least 84 bytes; this one has " +
                   std::to_string(size));
  const std::size_t triangles = DeclaredTriangles(file), end = first_triangle + triangle_bytes * triangles;
  const std::string declared = "the header declares " + Counted(triangles, "face");
  if (size < end)
    Fail(file, declared + ", which need " + std::to_string(end) + " bytes, but the file has " + std::to_string(size));
  const std::size_t surplus = size - end;
  if (surplus > 0 && surplus % triangle_bytes == 0)
    Fail(file, declared + ", but the file has " + std::to_string(surplus / triangle_bytes) + " more");
  if (surplus > 0 && triangles == 0) Fail(file, declared + ", but " + Counted(surplus, "byte") + " follow");
  if (surplus > 0)
    report.Warn(Escaped(file.name), Counted(surplus, "byte") + " after the last face ignored; " + declared);
  return ReadTriangles(file, triangles);
}

/// A reader of: facet normal x y z, outer loop, three times vertex x y z, endloop, endfacet.
class AsciiReader {
 public:
  explicit AsciiReader(const Text& file) : words_(file, Tokenizer::Comments::none) {}

  R3::MeshData Read() {
    if (const auto& first = words_.Peek(); first && !IsInAnyCase(first->text, "solid"))
      words_.Fail(*first, "an .stl file in text form must begin with 'solid', got " + Quoted(first->text));
    while (words_.Next()) {
      if (IsLast("solid")) {
        is_open_ = true;
        words_.SkipLine();  // its name
      } else if (IsLast("endsolid")) {
        is_open_ = false;
        words_.SkipLine();
      } else if (IsLast("facet")) {
        ReadFacet();
      } else {
        words_.Fail(words_.Last(), "expected facet, solid or endsolid, got " + Quoted(words_.Last().text));
      }
    }
    if (is_open_) words_.Fail(words_.Last(), "the file ends before endsolid");
    return std::move(mesh_);
  }

 private:
  void ReadFacet() {
    const std::size_t i = mesh_.triangles.size();
    Expect("normal", i);
    for (const char* axis : {"x", "y", "z"}) words_.AnyNumber({axis, "the normal of face", i});
    Expect("outer", i);
    Expect("loop", i);
    for (int corner = 0; corner < 3; ++corner) {
      Expect("vertex", i);
      mesh_.positions.push_back(words_.Place("a corner of face", i));
    }
    Expect("endloop", i);
    Expect("endfacet", i);
    AddTriangle(mesh_);
  }

  void Expect(const char* wanted, std::size_t face) {
    const Token word = words_.Need({wanted, "face", face});
    if (!IsLast(wanted)) words_.Fail(word, std::string("expected ") + wanted + ", got " + Quoted(word.text));
  }

  /// Returns true if the last word is this one, in any letter case. "end solid" counts as "endsolid", in which case its
  /// second word has been read as well.
  bool IsLast(std::string_view wanted) {
    if (IsInAnyCase(words_.Last().text, wanted)) return true;
    if (!wanted.starts_with("end") || !IsInAnyCase(words_.Last().text, "end")) return false;
    const auto& next = words_.Peek();
    if (!next || !IsInAnyCase(next->text, wanted.substr(3))) return false;
    words_.Next();
    return true;
  }

  MeshWords words_;
  R3::MeshData mesh_;
  bool is_open_ = false;
};

bool IsAsciiText(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
}

bool BeginsWithSolid(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // or a byte order mark
  return first != std::string_view::npos && BeginsInAnyCase(bytes.substr(first), "solid");
}

/// Returns true if the file is text. The two kinds are not marked, since binary files may also begin with "solid". A
/// file with exactly the length that its count implies is binary. Otherwise text has no NUL byte, but the count of a
/// binary file of up to 800 MB has one.
bool IsText(const Text& file) {
  const std::string_view bytes = file.bytes, head = bytes.substr(0, first_triangle);
  if (head.size() < first_triangle) return BeginsWithSolid(bytes);
  if (bytes.size() == first_triangle + triangle_bytes * DeclaredTriangles(file)) return false;
  return BeginsWithSolid(bytes) ? head.find('\0') == std::string_view::npos : IsAsciiText(head);
}

MeshFile ReadStl(const Text& file, Report& report) {
  return {IsText(file) ? AsciiReader(file).Read() : ReadBinary(file, report)};
}

}  // namespace

extern const MeshFormat stl_mesh_format{".stl", ReadStl};

}  // namespace ray
