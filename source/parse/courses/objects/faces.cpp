#include <algorithm>

#include "R3/Mesh.h"
#include "R3/Placement.h"
#include "R3/Polygon.h"
#include "source/parse/courses/objects/Kinds.h"

namespace ray {
namespace {

using Corners = std::vector<R3::Point>;
using CornerNormals = std::vector<R3::Normal>;
using Spellings = std::vector<std::vector<std::string_view>>;  // each with one key per corner

/// Reads the corners by the spelling with the most keys present, the first of equals, and reports the missing ones.
std::optional<Corners> ReadCorners(Mapping& object, const Spellings& spellings) {
  const auto present = [&](const std::vector<std::string_view>& spelling) {
    return std::count_if(spelling.begin(), spelling.end(), [&](std::string_view key) { return object.Has({key}); });
  };
  const auto used = std::max_element(spellings.begin(), spellings.end(),
                                     [&](const auto& a, const auto& b) { return present(a) < present(b); });
  Corners corners;
  for (const std::string_view key : *used) corners.push_back(object.NeedPoint({key}));
  if (!object.IsGood()) return {};
  return corners;
}

/// Makes a flat mesh of corners, with a texture from corner to corner, and normals if it has any.
std::optional<PlacedShape> MeshOf(Mapping& object, const Corners& corners, std::vector<R2::Point> uvs,
                                  CornerNormals normals = {}) {
  if (const char* const fault = R3::FaultOfPolygon(corners))
    object.Reporter().Warn(object.What().extent, std::string("this shape ") + fault);
  const auto cuts = R3::Triangulate(corners);
  if (!cuts || (corners.size() > R3::max_concave_corners && cuts != R3::Fan(corners.size()))) {
    object.Reporter().Error(object.What(),
                            "has more than " + std::to_string(R3::max_concave_corners) + " corners and is not convex");
    return {};
  }
  R3::MeshData data;
  data.positions = corners;
  data.triangles.assign(cuts->begin(), cuts->end());
  data.uvs = std::move(uvs);
  data.normals = std::move(normals);
  data.is_one_polygon = true;
  const bool is_smooth = !data.normals.empty();
  auto mesh = std::make_shared<const R3::Mesh>(std::move(data), is_smooth);
  if (mesh->IsDegenerate()) {
    object.Reporter().Error(object.What(), "has no area: its corners are on one line");
    return {};
  }
  return PlacedShape{std::move(mesh)};
}

/// Reads texture coordinates by the object's own keys: UV1, UV2...
std::optional<std::vector<R2::Point>> ReadUvs(Mapping& object) {
  if (!object.Has({"UV1"})) return {};
  std::vector<R2::Point> uvs;
  for (const std::string_view key : {"UV1", "UV2", "UV3"}) {
    const auto field = object.Need({key});
    const auto pair = field ? field->ListOf(2, "a list of two numbers") : std::nullopt;
    if (!pair) continue;
    const auto u = (*pair)[0].Number(), v = (*pair)[1].Number();
    uvs.push_back({u.value_or(0), v.value_or(0)});
  }
  return uvs;
}

/// Returns the normals of a triangle's corners, of any length; empty if it names none.
CornerNormals ReadNormals(Mapping& object) {
  static const Spellings spellings{{"n0", "n1", "n2"}, {"n1", "n2", "n3"}};
  if (!object.Has({"n0", "n1", "n2", "n3"})) return {};
  CornerNormals normals;
  for (const R3::Point& n : ReadCorners(object, spellings).value_or(Corners{})) normals.push_back({n.x, n.y, n.z});
  return normals;
}

/// Returns true if the corners are given row by row instead of around: the sides from the second to the third and from
/// the fourth to the first cross.
bool IsRowByRow(const Corners& c) {
  const R3::Vector normal = Cross(c[1] - c[0], c[2] - c[0]);
  const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
    return Dot(normal, Cross(c[j] - c[i], c[k] - c[i]));
  };
  return turn(1, 2, 3) * turn(1, 2, 0) < 0 && turn(3, 0, 1) * turn(3, 0, 2) < 0;
}

std::optional<PlacedShape> ParallelogramOf(Mapping& object) {
  const R3::Point position = object.NeedPoint({"position"});
  const R3::Vector up = object.NeedVector({"up"}), side = object.NeedVector({"side"});
  if (!object.IsGood()) return {};
  return MeshOf(object, {position, position + side, position + side + up, position + up}, R3::QuadUvs());
}

/// Returns the field of the file. Some scenes use `name` for it; if another key names the file, `name` is the object's
/// name.
std::optional<Field> NeedFile(Mapping& object) {
  if (auto file = object.Find({"file", "filename", "fileName", "path", "model", "modelPath"})) {
    object.Ignore({"name"});
    return file;
  }
  return object.Need({"file", "name"});
}

Assets::Shading ReadShading(Mapping& object) {
  using Normals = Assets::Shading::Normals;
  const bool is_smooth = object.Bool({"smooth"}, false);
  constexpr Range angles{0, 180, true};
  if (const auto angle = object.Find({"smooth_angle"})) return {Normals::by_angle, angle->Number(angles).value_or(0)};
  return {is_smooth ? Normals::wanted : Normals::of_triangles};
}

/// Reads one positive number, or three numbers.
R3::Vector FactorsOf(const std::optional<Field>& field) {
  const R3::Vector none{1, 1, 1};
  if (!field) return none;
  if (field->IsList()) return field->Vector().value_or(none);
  const double all = field->Number(positive).value_or(1);
  return {all, all, all};
}

/// Returns the transform that moves a box to the origin and makes its longest side 2, as the library GLM of Nate Robins
/// does with models.
R3::Matrix Unitizing(const R3::Box& box) {
  if (box.IsEmpty() || !(MaxComponent(box.Size()) > 0)) return {};
  const double factor = 2 / MaxComponent(box.Size());
  return R3::Scaling({factor, factor, factor}) * Translation(R3::Point{} - box.Center());
}

/// Reads a named mesh; without bounds after a mistake.
PlacedShape NamedMesh(ObjectReader& reader, const Field& file, const Assets::Shading& shading, bool has_materials) {
  if (!has_materials) {
    const Assets::BoxedMesh boxed = reader.MeshNamed(file, shading);
    if (!boxed.mesh) return {};
    return {.shape = boxed.mesh, .bounds = boxed.bounds};
  }
  const auto model = reader.ModelNamed(file, shading);
  if (!model) return {};
  R3::Box bounds;
  for (const Assets::Model::Part& part : model->parts) bounds.Extend(part.mesh.bounds);
  return {.shape = nullptr, .bounds = bounds, .model = model};
}

std::optional<PlacedShape> ReadTriangle(Mapping& object) {
  static const Spellings spellings{{"v0", "v1", "v2"},
                                   {"v1", "v2", "v3"},
                                   {"a", "b", "c"},
                                   {"p1", "p2", "p3"},
                                   {"p0", "p1", "p2"},
                                   {"position1", "position2", "position3"},
                                   {"point1", "point2", "point3"},
                                   {"point_1", "point_2", "point_3"},
                                   {"corner1", "corner2", "corner3"}};
  const auto uvs = ReadUvs(object);
  const auto corners = ReadCorners(object, spellings);
  CornerNormals normals = ReadNormals(object);
  if (!corners || !object.IsGood()) return {};
  return MeshOf(object, *corners, uvs.value_or(std::vector<R2::Point>{{0, 0}, {1, 0}, {0, 1}}), std::move(normals));
}

std::optional<PlacedShape> ReadQuad(Mapping& object) {
  static const Spellings spellings{{"v0", "v1", "v2", "v3"},
                                   {"a", "b", "c", "d"},
                                   {"p1", "p2", "p3", "p4"},
                                   {"p0", "p1", "p2", "p3"},
                                   {"point1", "point2", "point3", "point4"}};
  if (object.Has({"side"})) return ParallelogramOf(object);
  auto corners = ReadCorners(object, spellings);
  if (!corners) return {};
  if (IsRowByRow(*corners)) {
    object.Reporter().Warn(object.What().extent, "the sides of this quad cross; its last two corners are swapped");
    std::swap((*corners)[2], (*corners)[3]);
  }
  return MeshOf(object, *corners, R3::QuadUvs());
}

std::optional<PlacedShape> ReadPolygon(Mapping& object) {
  const auto field = object.Need({"vertices", "points", "corners"});
  const auto list = field ? field->List() : std::nullopt;
  if (!list) return {};
  if (list->size() < 3) field->Error("must be a list of three corners or more, got " + std::to_string(list->size()));
  Corners corners;
  for (const Field& corner : *list) corners.push_back(R3::Point{} + corner.Vector().value_or(R3::Vector{}));
  if (!object.IsGood()) return {};
  return MeshOf(object, corners, {});
}

std::optional<PlacedShape> ReadMeshFile(ObjectReader& reader, Mapping& object, bool) {
  const auto file = NeedFile(object);
  const Assets::Shading shading = ReadShading(object);
  const bool has_materials = object.Bool({"materials"}, false);
  const R3::Vector position = object.Vector({"position", "offset"}).value_or(R3::Vector{});
  const R3::Vector turn = object.Vector({"rotation"}).value_or(R3::Vector{});
  const R3::Vector scale = FactorsOf(object.Find({"scale", "scalefactor", "scaleFactor"}));
  const auto size = object.Find({"size"});
  const R3::Vector half_size = FactorsOf(size);
  if (!file) return {};
  PlacedShape placed =
      NamedMesh(reader, *file, shading, has_materials);  // despite other mistakes, to report all missing files
  if (!placed.bounds || !object.IsGood()) return {};
  const R3::Matrix placement = Translation(position) * TurnOf(turn) * Scaling(scale);
  placed.placement = size ? placement * Scaling(half_size) * Unitizing(*placed.bounds) : placement;
  return placed;
}

}  // namespace

extern const std::vector<ObjectKind> flat_kinds{
    {{"triangle"}, ReadTriangle},
    {{"quad", "quadrilateral"}, ReadQuad},
    {{"polygon"}, ReadPolygon},
    {{"mesh", "model", "obj", "triangleAggregate"}, nullptr, ReadMeshFile},
};

}  // namespace ray
