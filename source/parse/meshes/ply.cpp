#include <array>
#include <cmath>

#include "source/parse/Coordinate.h"
#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/PlyValues.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

/// The numbers of one vertex, face or strip: plain ones by property, and the list that was asked for.
struct Row {
  std::vector<double> numbers;
  std::vector<double> list;
};

/// The vertices, faces and triangle strips of a file of any scalar types; all other elements and properties are passed
/// over.
class PlyReader {
 public:
  explicit PlyReader(const Text& file)
      : words_(file, Tokenizer::Comments::none), header_(ReadPlyHeader(words_)), values_(words_, header_) {}

  R3::MeshData Read(Report& report) {
    for (const PlyElement& element : header_.elements) {
      CheckPromise(element);
      if (element.name == "vertex")
        ReadVertices(element);
      else if (element.name == "face")
        ReadFaces(element);
      else if (element.name == "tristrips")
        ReadStrips(element);
      else
        Skip(element);
    }
    if (!values_.AtEnd()) report.Warn(Escaped(words_.Source().name), "the file has more data than the header declares");
    faces_.Warn(words_.Source(), report);
    return std::move(mesh_);
  }

 private:
  void CheckPromise(const PlyElement& element) {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += values_.LeastBytes(property.count_type.value_or(property.type));
    if (least == 0 || element.count <= (values_.BytesLeft() + 1) / least) return;
    words_.Fail(element.where, "the header declares " + std::to_string(element.count) + " elements, but only " +
                                   BytesThatFollow(values_.BytesLeft()));
  }

  void ReadVertices(const PlyElement& element) {
    if (!mesh_.positions.empty()) words_.Fail(element.where, "only one vertex element is supported");
    const auto places = FindAll<3>(element, {"x", "y", "z"});
    if (!places) words_.Fail(element.where, "the element vertex needs the properties x, y and z");
    const auto normals = FindAll<3>(element, {"nx", "ny", "nz"});
    auto uvs = FindAll<2>(element, {"s", "t"});
    if (!uvs) uvs = FindAll<2>(element, {"u", "v"});
    if (!uvs) uvs = FindAll<2>(element, {"texture_u", "texture_v"});

    Row row;
    for (std::size_t i = 0; i < element.count; ++i) {
      ReadRow(element, i, {}, row);
      const auto& n = row.numbers;
      mesh_.positions.push_back({n[(*places)[0]], n[(*places)[1]], n[(*places)[2]]});
      if (normals) mesh_.normals.push_back({n[(*normals)[0]], n[(*normals)[1]], n[(*normals)[2]]});
      if (uvs) mesh_.uvs.push_back({n[(*uvs)[0]], n[(*uvs)[1]]});
    }
  }

  void ReadFaces(const PlyElement& element) {
    const std::size_t list = FindIndices(element);
    Row row;
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < element.count; ++i) {
      ReadRow(element, i, list, row);
      corners.clear();
      for (const double value : row.list) corners.push_back(IndexOf(value, {element.name, i}));
      AddFace(corners, {element.name, i});
    }
  }

  /// Every three neighbors of a strip are a triangle, every second one turned over; -1 begins another strip.
  void ReadStrips(const PlyElement& element) {
    const std::size_t list = FindIndices(element);
    Row row;
    for (std::size_t i = 0; i < element.count; ++i) {
      ReadRow(element, i, list, row);
      std::array<std::uint32_t, 3> last{};
      std::size_t length = 0;
      for (const double value : row.list) {
        if (value == -1) {
          length = 0;
          continue;
        }
        last = {last[1], last[2], IndexOf(value, {element.name, i})};
        if (++length >= 3) AddOfStrip(last, length % 2 == 0, {element.name, i});
      }
    }
  }

  // Strips repeat a vertex to turn a corner; those triangles are not meant to be seen.
  void AddOfStrip(std::array<std::uint32_t, 3> t, bool is_turned, const PlyPlace& place) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    if (is_turned) std::swap(t[0], t[1]);
    AddFace(t, place);
  }

  void AddFace(std::span<const std::uint32_t> corners, const PlyPlace& place) {
    if (const char* problem = faces_.Add(corners, values_.Last())) values_.Fail(place, problem);
  }

  void Skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // its count is then only a number
    Row row;
    for (std::size_t i = 0; i < element.count; ++i) ReadRow(element, i, {}, row);
  }

  void ReadRow(const PlyElement& element, std::size_t number, std::optional<std::size_t> wanted_list, Row& row) {
    const PlyPlace place{element.name, number};
    row.numbers.assign(element.properties.size(), 0);
    row.list.clear();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.count_type) {
        ReadList(property, place, p == wanted_list ? &row.list : nullptr);
        continue;
      }
      row.numbers[p] = values_.Next(property.type, place);
      if (!IsCoordinate(row.numbers[p]))
        values_.Fail(place, Escaped(property.name) + " must be finite and must not exceed 1e150 in magnitude");
    }
  }

  void ReadList(const PlyProperty& property, const PlyPlace& place, std::vector<double>* list) {
    const double count = values_.Next(*property.count_type, place);
    const std::size_t least = values_.LeastBytes(property.type);
    const auto most = static_cast<double>((values_.BytesLeft() + 1) / least);
    if (!(count >= 0 && count <= most && count == std::floor(count)))
      values_.Fail(place, "a list of " + ToText(count) + " numbers does not fit in the remaining " +
                              std::to_string(values_.BytesLeft()) + " bytes");
    for (auto left = static_cast<std::size_t>(count); left > 0; --left) {
      const double value = values_.Next(property.type, place);
      if (list) list->push_back(value);
    }
  }

  std::uint32_t IndexOf(double value, const PlyPlace& place) const {
    const std::size_t known = mesh_.positions.size();
    if (!(value >= 0 && value < static_cast<double>(known) && value == std::floor(value)))
      values_.Fail(place, "a corner must be an index below " + std::to_string(known) + ", got " + ToText(value));
    return static_cast<std::uint32_t>(value);
  }

  std::size_t FindIndices(const PlyElement& element) const {
    for (const char* name : {"vertex_indices", "vertex_index"})
      if (const auto found = element.Find(name, true)) return *found;
    words_.Fail(element.where, Quoted(element.name) + " needs the property list vertex_indices");
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

  MeshWords words_;
  PlyHeader header_;
  PlyValues values_;
  R3::MeshData mesh_;
  Faces faces_{mesh_};
};

R3::MeshData ReadPly(const Text& file, Report& report) { return PlyReader(file).Read(report); }

}  // namespace

extern const MeshFormat ply_mesh_format{".ply", ReadPly};

}  // namespace ray
