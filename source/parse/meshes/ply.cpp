#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "source/parse/Coordinate.h"
#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/PlyFile.h"
#include "source/parse/meshes/VertexColors.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr const char* texcoord = "texcoord";
constexpr std::array<double, 3> unusable_color{-1, -1, -1};  // any color with a negative or NaN channel

/// A reader that makes a mesh of the vertices, faces and triangle strips of a file. Skips all other elements and
/// properties.
class PlyReader {
 public:
  explicit PlyReader(const Text& file) : file_(file) {
    has_texcoords_ = std::ranges::any_of(file_.Elements(), [](const PlyElement& element) {
      return element.name == "face" && element.Find(texcoord, true);
    });
  }

  MeshFile Read(Report& report) {
    try {
      for (const PlyElement& element : file_.Elements()) ReadElement(element);
      file_.CheckEnd(report);
    } catch (SceneError& error) {
      if (error.hint.empty() && file_.IsIrregular())
        error.hint = "there are lines with more numbers than the header declares";
      throw;
    }
    mesh_.colors = colors_.Take(mesh_.positions.size());
    Warn(report);
    if (has_texcoords_) MakeVertices();
    faces_.AddVertices();
    MeshFile read{.data = std::move(mesh_), .has_8_bit_colors = has_8_bit_colors_ || colors_.WereBytes()};
    for (const Token& name : file_.Textures())
      read.textures.push_back({std::string(name.text), Place(file_.Source().name, name.line, name.column)});
    return read;
  }

 private:
  void ReadElement(const PlyElement& element) {
    file_.CheckLength(element);
    if (element.name == "vertex")
      ReadVertices(element);
    else if (element.name == "face")
      ReadFaces(element);
    else if (element.name == "tristrips")
      ReadStrips(element);
    else
      Skip(element);
  }

  void Warn(Report& report) const {
    const Text& file = file_.Source();
    faces_.Warn(file, report);
    file_.Warn(report);
    WarnOfAbsent(absent_normals_, absent_uvs_, file, report);
    colors_.Warn(file, report);
    if (ignores_face_colors_)
      report.Warn(Escaped(file.name), "the colors of faces are ignored; those of vertices are used");
  }

  void ReadVertices(const PlyElement& element) {
    if (!mesh_.positions.empty()) file_.FailAt(element.where, "only one vertex element is supported");
    const auto places = FindAll<3>(element, {"x", "y", "z"});
    if (!places) file_.FailAt(element.where, "the element vertex needs the properties x, y and z");
    const auto normals = FindAll<3>(element, {"nx", "ny", "nz"});
    auto uvs = FindAll<2>(element, {"s", "t"});
    if (!uvs) uvs = FindAll<2>(element, {"u", "v"});
    if (!uvs) uvs = FindAll<2>(element, {"texture_u", "texture_v"});

    const auto colors = FindColors(element);

    const PlyColumns columns{.coordinates{places->begin(), places->end()}};
    R1::ReserveOnHugePages(mesh_.positions, element.count);
    PlyRow row;
    for (std::size_t i = 0; i < element.count; ++i) {
      file_.Read(element, i, columns, row);
      const auto& n = row.numbers;
      mesh_.positions.push_back({n[(*places)[0]], n[(*places)[1]], n[(*places)[2]]});
      if (normals) AddNormal({n[(*normals)[0]], n[(*normals)[1]], n[(*normals)[2]]}, row.unusable);
      if (uvs) mesh_.uvs.push_back(Usable({n[(*uvs)[0]], n[(*uvs)[1]]}, row.unusable));
      if (colors) colors_.Add(i, ColorOf(element, *colors, row), row.unusable);
    }
  }

  static std::optional<std::array<std::size_t, 3>> FindColors(const PlyElement& element) {
    auto colors = FindAll<3>(element, {"red", "green", "blue"});
    if (!colors) colors = FindAll<3>(element, {"diffuse_red", "diffuse_green", "diffuse_blue"});
    return colors ? colors : FindAll<3>(element, {"r", "g", "b"});
  }

  /// Returns a color; integers are shares of the maximum of their type.
  std::array<double, 3> ColorOf(const PlyElement& element, const std::array<std::size_t, 3>& columns,
                                const PlyRow& row) {
    std::array<double, 3> channels{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double white = element.properties[columns[k]].type->white;
      channels[k] = row.numbers[columns[k]] / white;
      has_8_bit_colors_ = has_8_bit_colors_ || white == 255;
    }
    return channels;
  }

  void AddNormal(const R3::Vector& n, const Token& unusable) {
    const bool is_usable = IsCoordinate(n.x) && IsCoordinate(n.y) && IsCoordinate(n.z);
    if (!is_usable) absent_normals_.Add(unusable);
    mesh_.normals.push_back(is_usable ? AsNormal(n) : R3::Normal{});
  }

  R2::Point Usable(const R2::Point& uv, const Token& unusable) {
    if (IsCoordinate(uv.x) && IsCoordinate(uv.y)) return uv;
    absent_uvs_.Add(unusable);
    return {};
  }

  void ReadFaces(const PlyElement& element) {
    const PlyColumns columns{.corners = FindIndices(element), .uvs = element.Find(texcoord, true)};
    const auto colors = FindColors(element);
    const bool shows_colors = colors && colors_.IsEmpty();
    ignores_face_colors_ = colors && !shows_colors;
    const std::size_t vertices = mesh_.positions.size();
    PlyRow row;
    std::vector<std::uint32_t> corners;
    faces_.Reserve(element.count, file_.BytesLeft());
    for (std::size_t i = 0; i < element.count; ++i) {
      file_.Read(element, i, columns, row);
      corners.clear();
      for (const double value : row.corners) corners.push_back(IndexOf(value, vertices));
      if (shows_colors) Paint(corners, ColorOf(element, *colors, row), row.unusable);
      if (corners.size() < 3 && file_.IsIrregular()) file_.Fail("has fewer than 3 corners");
      AddFace(corners, row.uvs);
    }
  }

  /// Gives the corners a color, duplicating each vertex that already has another color.
  void Paint(std::vector<std::uint32_t>& corners, const std::array<double, 3>& color, const Token& where) {
    const bool is_usable = std::ranges::all_of(color, [](double c) { return c >= 0; });
    const auto next = static_cast<std::uint32_t>(numbers_of_colors_.size());
    const auto [known, is_new] = numbers_of_colors_.try_emplace(is_usable ? color : unusable_color, next);
    for (std::uint32_t& corner : corners) {
      const std::uint64_t vertex_and_color = std::uint64_t{corner} << 32 | known->second;
      const auto copy = static_cast<std::uint32_t>(mesh_.positions.size());
      const auto [painted, is_first] = painted_.try_emplace(vertex_and_color, copy);
      if (is_first && is_painted_.insert(corner).second)
        painted->second = corner;
      else if (is_first)
        CopyVertex(corner);
      if (is_first) colors_.Add(painted->second, color, where);
      corner = painted->second;
    }
  }

  void CopyVertex(std::uint32_t vertex) {
    mesh_.positions.push_back(R3::Point(mesh_.positions[vertex]));
    if (!mesh_.normals.empty()) mesh_.normals.push_back(R3::Normal(mesh_.normals[vertex]));
    if (!mesh_.uvs.empty()) mesh_.uvs.push_back(R2::Point(mesh_.uvs[vertex]));
  }

  /// Reads strips: every three consecutive vertices are a triangle, every second one flipped; -1 starts another strip.
  void ReadStrips(const PlyElement& element) {
    const PlyColumns columns{.corners = FindIndices(element)};
    PlyRow row;
    for (std::size_t i = 0; i < element.count; ++i) {
      file_.Read(element, i, columns, row);
      std::array<std::uint32_t, 3> last{};
      std::size_t length = 0;
      for (const double value : row.corners) {
        if (value == -1) {
          length = 0;
          continue;
        }
        last = {last[1], last[2], IndexOf(value, mesh_.positions.size())};
        if (++length >= 3) AddOfStrip(last, length % 2 == 0);
      }
    }
  }

  // Strips repeat a vertex to turn a corner; those degenerate triangles are not meant to be visible.
  void AddOfStrip(std::array<std::uint32_t, 3> t, bool is_turned) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    if (is_turned) std::swap(t[0], t[1]);
    AddFace(t, {});
  }

  void AddFace(std::span<const std::uint32_t> places, std::span<const double> uvs) {
    const auto names = has_texcoords_ ? AddCorners(places, uvs) : places;
    if (const char* problem = faces_.Add(places, names, file_.Last())) file_.Fail(problem);
  }

  /// Returns the indices of the corners. A face may have its own texture coordinates, as written by VCGlib: two per
  /// corner, or none.
  std::span<const std::uint32_t> AddCorners(std::span<const std::uint32_t> places, std::span<const double> uvs) {
    if (!uvs.empty() && uvs.size() != 2 * places.size())
      file_.Fail("texcoord must have two numbers for each of the " + std::to_string(places.size()) + " corners, got " +
                 std::to_string(uvs.size()));
    names_.clear();
    for (std::size_t k = 0; k < places.size(); ++k) {
      names_.push_back(static_cast<std::uint32_t>(corners_.size()));
      corners_.push_back({places[k]});
      if (uvs.empty()) continue;
      corners_.back().uv = static_cast<std::uint32_t>(uvs_.size());
      uvs_.push_back(Usable({uvs[2 * k], uvs[2 * k + 1]}, file_.Last()));
    }
    return names_;
  }

  void MakeVertices() {
    UniteUvs();
    const auto first = static_cast<std::uint32_t>(uvs_.size());
    uvs_.insert(uvs_.end(), mesh_.uvs.begin(), mesh_.uvs.end());
    for (Corner& corner : corners_) {
      if (corner.uv == Corner::none && !mesh_.uvs.empty()) corner.uv = first + corner.place;
      if (!mesh_.normals.empty()) corner.normal = corner.place;
    }
    mesh_.uvs.clear();
    ray::MakeVertices(mesh_, corners_, faces_.Added(), uvs_, std::exchange(mesh_.normals, {}));
  }

  /// Gives equal texture coordinates one index, so that faces with the same coordinates share vertices.
  void UniteUvs() {
    const auto less = [](const R2::Point& a, const R2::Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::vector<R2::Point> different = uvs_;
    std::ranges::sort(different, less);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    for (Corner& corner : corners_)
      if (corner.uv != Corner::none)
        corner.uv =
            static_cast<std::uint32_t>(std::ranges::lower_bound(different, uvs_[corner.uv], less) - different.begin());
    uvs_ = std::move(different);
  }

  void Skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // only its count is present
    PlyRow row;
    for (std::size_t i = 0; i < element.count; ++i) file_.Read(element, i, {}, row);
  }

  std::uint32_t IndexOf(double value, std::size_t known) {
    if (!(value >= 0 && value < static_cast<double>(known) && value == std::floor(value)))
      file_.Fail("a corner must be an index below " + std::to_string(known) + ", got " + ToText(value));
    return static_cast<std::uint32_t>(value);
  }

  std::size_t FindIndices(const PlyElement& element) const {
    for (const char* name : {"vertex_indices", "vertex_index"})
      if (const auto found = element.Find(name, true)) return *found;
    file_.FailAt(element.where, Quoted(element.name) + " needs the property list vertex_indices");
  }

  template <std::size_t n>
  static std::optional<std::array<std::size_t, n>> FindAll(const PlyElement& element,
                                                           const std::array<const char*, n>& names) {
    std::array<std::size_t, n> found{};
    for (std::size_t i = 0; i < n; ++i) {
      const auto property = element.Find(names[i], false);
      if (!property) return {};
      found[i] = *property;
    }
    return found;
  }

  PlyFile file_;
  R3::MeshData mesh_;
  Faces faces_{mesh_};
  Tally absent_normals_, absent_uvs_;
  VertexColors colors_;
  bool has_8_bit_colors_ = false, ignores_face_colors_ = false;
  // For files with face colors and no vertex colors:
  std::map<std::array<double, 3>, std::uint32_t> numbers_of_colors_;
  std::unordered_map<std::uint64_t, std::uint32_t> painted_;  // from a vertex and the number of a color
  std::unordered_set<std::uint32_t> is_painted_;
  // If faces have their own texture coordinates, triangles are first made of corners.
  bool has_texcoords_ = false;
  std::vector<Corner> corners_;
  std::vector<R2::Point> uvs_;
  std::vector<std::uint32_t> names_;
};

MeshFile ReadPly(const Text& file, Report& report) { return PlyReader(file).Read(report); }

}  // namespace

extern const MeshFormat ply_mesh_format{".ply", ReadPly};

}  // namespace ray
