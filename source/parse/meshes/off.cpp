#include <algorithm>

#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"

namespace ray {
namespace {

/// What the header says each vertex holds behind its place: [ST][C][N][4][n]OFF.
/// Source: the manual of Geomview, OFF files.
struct Header {
  bool has_uv = false, has_color = false, has_normal = false;
};

Header ReadHeader(MeshWords& words) {
  const Token word = words.Need({"OFF"});
  std::string_view rest = word.text;
  const auto takes = [&](std::string_view prefix) {
    const bool found = rest.starts_with(prefix) && rest != "OFF";
    if (found) rest.remove_prefix(prefix.size());
    return found;
  };
  Header header;
  header.has_uv = takes("ST");
  header.has_color = takes("C");
  header.has_normal = takes("N");
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF")
    words.Fail(word, "vertices of four or more dimensions are not supported");
  if (rest != "OFF") words.Fail(word, "an .off file must begin with 'OFF', got " + Quoted(word.text));
  return header;
}

std::size_t ReadCount(MeshWords& words, const char* what) {
  const std::int64_t count = words.Whole({what});
  if (count < 0) words.Fail(words.Last(), std::string(what) + " must not be negative");
  return static_cast<std::size_t>(count);
}

void CheckPromise(const MeshWords& words, std::size_t count, const char* what, std::size_t least_bytes) {
  if (count <= words.BytesLeft() / least_bytes + 1) return;
  words.Fail(words.Last(), "the header declares " + std::to_string(count) + " " + what + ", but only " +
                               BytesThatFollow(words.BytesLeft()));
}

class OffReader {
 public:
  OffReader(const Text& file, Report& report) : words_(file, Tokenizer::Comments::hash), report_(report) {}

  R3::MeshData Read() {
    const Header header = ReadHeader(words_);
    const std::size_t vertices = ReadCount(words_, "the number of vertices");
    CheckPromise(words_, vertices, "vertices", 6);  // "0 0 0\n"
    const std::size_t faces = ReadCount(words_, "the number of faces");
    CheckPromise(words_, faces, "faces", 2);  // "0\n"
    PassOverEdges();
    for (std::size_t i = 0; i < vertices; ++i) ReadVertex(header, i);
    ReadFaces(faces);
    Warn();
    return std::move(mesh_);
  }

 private:
  /// Their number, which many files get wrong and some leave out, is on the line of the other two or alone on the next.
  void PassOverEdges() {
    if (words_.SkipLine() > 0) return;
    MeshWords ahead = words_;
    if (ahead.Next() && !ahead.HasMoreOnLine()) words_.Next();
  }

  void ReadVertex(const Header& header, std::size_t i) {
    mesh_.positions.push_back(words_.Place("vertex", i));
    if (header.has_normal) {
      const R3::Vector n = words_.Place("the normal of vertex", i) - R3::Point{};
      mesh_.normals.push_back(AsNormal(n));
    }
    if (header.has_uv) {
      if (header.has_color)
        for (const char* channel : {"red", "green", "blue", "alpha"}) words_.Number({channel, "vertex", i});
      const double u = words_.Coordinate({"s", "vertex", i});
      mesh_.uvs.push_back({u, words_.Coordinate({"t", "vertex", i})});
    }
    // Colors; and in files whose header does not speak of them, anything.
    if (words_.SkipLine() > 0 && !header.has_color) ++long_vertices_;
  }

  void ReadFaces(std::size_t promised) {
    Faces faces(mesh_);
    std::vector<std::uint32_t> corners;
    std::size_t i = 0;
    for (; i < promised && !words_.AtEnd(); ++i) {
      const std::int64_t count = words_.Whole({"number of corners", "face", i});
      const Token start = words_.Last();
      if (count < 0 || static_cast<std::uint64_t>(count) > words_.BytesLeft() / 2 + 1)
        words_.Fail(start, "face " + std::to_string(i) + " cannot have " + Escaped(start.text) + " corners");
      corners.clear();
      for (std::int64_t k = 0; k < count; ++k)
        corners.push_back(words_.Index({"a corner", "face", i}, mesh_.positions.size()));
      words_.SkipLine();  // a color
      if (const char* problem = faces.Add(corners, start)) words_.Fail(start, problem);
    }
    if (i < promised)
      WarnOf("the header declares " + std::to_string(promised) + " faces, but the file has " + std::to_string(i));
    else if (!words_.AtEnd())
      WarnOf("the file has more data than the header declares");
    faces.Warn(words_.Source(), report_);
  }

  void Warn() {
    if (long_vertices_ > 0)
      WarnOf(std::to_string(long_vertices_) + (long_vertices_ == 1 ? " vertex has" : " vertices have") +
             " more numbers than the header declares; the rest is ignored");
  }
  void WarnOf(const std::string& message) { report_.Warn(Escaped(words_.Source().name), message); }

  MeshWords words_;
  Report& report_;
  R3::MeshData mesh_;
  std::size_t long_vertices_ = 0;
};

R3::MeshData ReadOff(const Text& file, Report& report) { return OffReader(file, report).Read(); }

}  // namespace

extern const MeshFormat off_mesh_format{".off", ReadOff};

}  // namespace ray
