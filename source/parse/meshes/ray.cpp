#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/text/Number.h"

namespace ray {
namespace {

// Commands begin with #, so there are no comments. Only vertices and faces matter here; the words of other commands are
// skipped one at a time, as in the course's reader.
class RayReader {
 public:
  explicit RayReader(const Text& file) : words_(file, Tokenizer::Comments::none) {}

  R3::MeshData Read(Report& report) {
    const std::optional<Token> first = words_.Peek();
    bool has_command = false;
    while (const auto word = words_.Next()) {
      has_command = has_command || word->text[0] == '#';
      if (word->text == "#vertex") ReadVertex();
      if (word->text == "#shape_triangle") ReadFace(3);
      if (word->text == "#shape_polygon") ReadPolygon();
    }
    if (first && !has_command)
      words_.Fail(*first, "a .ray file contains commands such as #vertex; this one begins with " + Quoted(first->text));
    faces_.AddVertices();
    faces_.Warn(words_.Source(), report);
    WarnOfAbsent(absent_normals_, absent_uvs_, words_.Source(), report);
    return std::move(mesh_);
  }

 private:
  void ReadVertex() {
    const std::size_t i = mesh_.positions.size();
    mesh_.positions.push_back(words_.Place("vertex", i));
    const auto normal = words_.VectorIfUsable("the normal of vertex", i);
    if (!normal) absent_normals_.Add(words_.Last());
    mesh_.normals.push_back(AsNormal(normal.value_or(R3::Vector{})));
    const auto s = words_.NumberIfUsable({"s", "vertex", i}), t = words_.NumberIfUsable({"t", "vertex", i});
    if (!s || !t) absent_uvs_.Add(words_.Last());
    mesh_.uvs.push_back(s && t ? R2::Point{*s, *t} : R2::Point{});
    RefuseNumberBehind("a vertex has 8 numbers");
  }

  void ReadFace(std::size_t corner_count) {
    const Token command = words_.Last();
    words_.Whole({"the material", "face", face_number_});
    ReadCorners(command, corner_count);
    RefuseNumberBehind("a triangle has a material and 3 corners");
  }

  void ReadPolygon() {
    const Token command = words_.Last();
    words_.Whole({"the material", "face", face_number_});
    const std::int64_t count = words_.Whole({"number of corners", "face", face_number_});
    if (count < 0 || static_cast<std::uint64_t>(count) > words_.BytesLeft() / 2 + 1)
      words_.Fail(words_.Last(),
                  "face " + std::to_string(face_number_) + " cannot have " + Escaped(words_.Last().text) + " corners");
    ReadCorners(command, static_cast<std::size_t>(count));
    RefuseNumberBehind("a polygon has a material, the number of its corners, and its corners");
  }

  void ReadCorners(const Token& command, std::size_t count) {
    corners_.clear();
    for (std::size_t k = 0; k < count; ++k)
      corners_.push_back(words_.Index({"a corner", "face", face_number_}, mesh_.positions.size()));
    if (const char* problem = faces_.Add(corners_, command)) words_.Fail(command, problem);
    ++face_number_;
  }

  /// Rejects an extra number: ignoring it could display a miscounted face.
  void RefuseNumberBehind(const char* hint) {
    const auto& next = words_.Peek();
    if (!next || next->text[0] == '#') return;
    if (!ParseNumber(next->text).problem || SaysNanOrInfinity(next->text))
      words_.Fail(*next, "unexpected number " + Quoted(next->text), hint);
  }

  MeshWords words_;
  Tally absent_normals_, absent_uvs_;
  R3::MeshData mesh_;
  Faces faces_{mesh_};
  std::vector<std::uint32_t> corners_;
  std::size_t face_number_ = 0;
};

MeshFile ReadRay(const Text& file, Report& report) { return {RayReader(file).Read(report)}; }

}  // namespace

extern const MeshFormat ray_mesh_format{".ray", ReadRay};

}  // namespace ray
