#include "source/parse/Coordinate.h"
#include "source/parse/meshes/Bytes.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"

namespace ray {
namespace {

// Source: 3D Systems, Stereolithography interface specification (1988): 80 bytes of anything, a count, and for each
// triangle a normal, three corners and two bytes of anything; little-endian.
constexpr std::size_t header_bytes = 80, triangle_bytes = 50;

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

R3::MeshData ReadBinary(const Text& file, std::size_t triangles) {
  Bytes bytes(file.bytes, header_bytes + sizeof(std::uint32_t), std::endian::little);
  R3::MeshData mesh;
  mesh.positions.reserve(3 * triangles);
  mesh.triangles.reserve(triangles);
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

/// Reads: facet normal x y z, outer loop, three times vertex x y z, endloop, endfacet.
class AsciiReader {
 public:
  explicit AsciiReader(const Text& file) : words_(file, Tokenizer::Comments::none) {}

  R3::MeshData Read() {
    while (words_.Next()) {
      if (words_.Last().text == "solid" || words_.Last().text == "endsolid") {
        is_open_ = words_.Last().text == "solid";
        words_.SkipLine();  // its name
      } else if (words_.Last().text == "facet") {
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
    for (const char* axis : {"x", "y", "z"}) words_.Number({axis, "the normal of face", i});
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
    if (word.text != wanted) words_.Fail(word, std::string("expected ") + wanted + ", got " + Quoted(word.text));
  }

  MeshWords words_;
  R3::MeshData mesh_;
  bool is_open_ = false;
};

// The two kinds do not say which they are: binary files, too, may begin with "solid". Only a binary one has exactly the
// length that its count asks for.
R3::MeshData ReadStl(const Text& file, Report&) {
  const std::size_t size = file.bytes.size();
  constexpr std::size_t start = header_bytes + sizeof(std::uint32_t);
  const bool begins_with_solid = std::string_view(file.bytes).starts_with("solid");
  if (size < start) {
    if (begins_with_solid) return AsciiReader(file).Read();
    Fail(file, "an .stl file must begin with 'solid', or be binary and have at least 84 bytes; this one has " +
                   std::to_string(size));
  }
  const std::size_t triangles = Bytes(file.bytes, header_bytes, std::endian::little).Next<std::uint32_t>();
  const std::size_t wanted = start + triangle_bytes * triangles;
  if (size == wanted) return ReadBinary(file, triangles);
  if (begins_with_solid) return AsciiReader(file).Read();
  Fail(file, "the header declares " + std::to_string(triangles) + " faces, which need " + std::to_string(wanted) +
                 " bytes, but the file has " + std::to_string(size));
}

}  // namespace

extern const MeshFormat stl_mesh_format{".stl", ReadStl};

}  // namespace ray
