#include <algorithm>
#include <array>
#include <numeric>

#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/text/Number.h"

namespace ray {
namespace {

/// A corner of a face as the file gives it: where it is, its texture coordinates, its normal.
struct Corner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t place, uv = none, normal = none;

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// Reads v, vt, vn and f; every other statement is passed over.
/// Source: Wavefront, Advanced Visualizer manual, appendix B1: object files.
class ObjReader {
 public:
  explicit ObjReader(const Text& file) : words_(file, Tokenizer::Comments::hash) {}

  R3::MeshData Read(Report& report) {
    while (const auto word = words_.Next()) {
      if (word->text == "v") ReadPlace();
      if (word->text == "vt") ReadUv();
      if (word->text == "vn") ReadNormal();
      if (word->text == "f") ReadFace();
      SkipStatement();
    }
    faces_.Warn(words_.Source(), report);
    const auto is_plain = [](const Corner& c) { return c.uv == Corner::none && c.normal == Corner::none; };
    if (std::all_of(corners_.begin(), corners_.end(), is_plain))
      NameByPlace();
    else
      NameByCorner();
    return std::move(mesh_);
  }

 private:
  void ReadPlace() { mesh_.positions.push_back(PlaceOf("vertex", mesh_.positions.size() + 1)); }

  void ReadUv() {
    const std::size_t number = uvs_.size() + 1;
    const double u = Coordinate({"u", "texture vertex", number});
    uvs_.push_back({u, ContinuesStatement() ? words_.Coordinate({"v", "texture vertex", number}) : 0});
  }

  void ReadNormal() { normals_.push_back(AsNormal(PlaceOf("normal", normals_.size() + 1) - R3::Point{})); }

  R3::Point PlaceOf(const char* of, std::size_t number) {
    const double x = Coordinate({"x", of, number});
    const double y = Coordinate({"y", of, number});
    const double z = Coordinate({"z", of, number});
    return {x, y, z};
  }

  /// Unlike words elsewhere, those of a statement end with its line.
  double Coordinate(const Part& part) {
    if (!ContinuesStatement()) words_.Fail(words_.Last(), part.Words() + " is missing");
    return words_.Coordinate(part);
  }

  void ReadFace() {
    const Token command = words_.Last();
    const std::size_t first = corners_.size();
    places_.clear();
    names_.clear();
    while (ContinuesStatement()) {
      corners_.push_back(ReadCorner(*words_.Next()));
      places_.push_back(corners_.back().place);
    }
    names_.resize(places_.size());
    std::iota(names_.begin(), names_.end(), static_cast<std::uint32_t>(first));
    if (const char* problem = faces_.Add(places_, names_, command)) words_.Fail(command, problem);
  }

  /// place, place/uv, place//normal or place/uv/normal
  Corner ReadCorner(const Token& word) const {
    std::string_view rest = word.text;
    const auto next = [&] {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view part = rest.substr(0, slash);
      rest.remove_prefix(std::min(slash + 1, rest.size()));
      return part;
    };
    const std::string_view place = next(), uv = next(), normal = next();
    if (!rest.empty()) words_.Fail(word, "a corner must be vertex/texture/normal, got " + Quoted(word.text));
    Corner corner{IndexOf(word, place, mesh_.positions.size(), "vertex")};
    if (!uv.empty()) corner.uv = IndexOf(word, uv, uvs_.size(), "texture vertex");
    if (!normal.empty()) corner.normal = IndexOf(word, normal, normals_.size(), "normal");
    return corner;
  }

  /// From 1; negative ones count back from the last so far.
  std::uint32_t IndexOf(const Token& word, std::string_view text, std::size_t count, const char* what) const {
    const auto [number, problem] = ParseWhole(text);
    if (problem) words_.Fail(word, std::string("a ") + what + " " + problem + ", got " + Quoted(word.text));
    const auto known = static_cast<std::int64_t>(count);
    if (number == 0 || number > known || number < -known)
      words_.Fail(word, std::string("no ") + what + " " + Escaped(text),
                  std::to_string(count) + " defined before this line, numbered from 1");
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : known + number);
  }

  // A backslash at the end of a line joins the next one to it.
  bool ContinuesStatement() {
    bool is_joined = words_.Last().text == "\\";
    while (!words_.AtEnd() && (words_.HasMoreOnLine() || is_joined)) {
      if (!words_.NextIs("\\")) return true;
      words_.Next();
      is_joined = true;
    }
    return false;
  }

  void SkipStatement() {
    while (ContinuesStatement()) words_.Next();
  }

  void NameByPlace() {
    for (auto& triangle : mesh_.triangles)
      for (std::uint32_t& name : triangle) name = corners_[name].place;
  }

  // A vertex of a mesh has one normal and one pair of texture coordinates; where a file gives a place several of them,
  // it becomes several vertices. Sorting finds the different corners in n log n time whatever the file.
  void NameByCorner() {
    std::vector<Corner> different = corners_;
    std::sort(different.begin(), different.end());
    different.erase(std::unique(different.begin(), different.end()), different.end());
    for (auto& triangle : mesh_.triangles)
      for (std::uint32_t& name : triangle)
        name = static_cast<std::uint32_t>(std::lower_bound(different.begin(), different.end(), corners_[name]) -
                                          different.begin());

    std::vector<R3::Point> positions;
    for (const Corner& corner : different) {
      positions.push_back(mesh_.positions[corner.place]);
      if (!uvs_.empty()) mesh_.uvs.push_back(corner.uv == Corner::none ? R2::Point{} : uvs_[corner.uv]);
      if (!normals_.empty())
        mesh_.normals.push_back(corner.normal == Corner::none ? R3::Normal{} : normals_[corner.normal]);
    }
    mesh_.positions = std::move(positions);
  }

  MeshWords words_;
  R3::MeshData mesh_;
  std::vector<R2::Point> uvs_;
  std::vector<R3::Normal> normals_;
  std::vector<Corner> corners_;
  Faces faces_{mesh_};
  std::vector<std::uint32_t> places_, names_;
};

R3::MeshData ReadObj(const Text& file, Report& report) { return ObjReader(file).Read(report); }

}  // namespace

extern const MeshFormat obj_mesh_format{".obj", ReadObj};

}  // namespace ray
