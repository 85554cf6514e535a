#include <array>

#include "R3/Segment.h"
#include "R3/ShapeKind.h"
#include "source/parse/scn/ScnReader.h"
#include "source/text/Number.h"

namespace ray {
namespace {

/// What may be repeated is, up to the next statement.
Arguments ReadArguments(const R3::ShapeKind& kind, Statement& statement) {
  Arguments all = statement.Coordinates(kind.arguments);
  const auto again = std::span(kind.arguments).last(kind.repeated);
  while (!again.empty() && statement.Peek() && !BeginsStatement(*statement.Peek())) {
    const Arguments more = statement.Coordinates(again);
    all.values.insert(all.values.end(), more.values.begin(), more.values.end());
    all.words.insert(all.words.end(), more.words.begin(), more.words.end());
  }
  return all;
}

void ReadShape(const R3::ShapeKind& kind, ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const Arguments read = ReadArguments(kind, statement);
  if (!statement.IsGood()) return;
  try {
    reader.AddShape(statement, material, kind.make(read.values));
  } catch (const R3::ArgumentError& error) {
    statement.Error(read.words[error.index], error.what());
  }
}

/// "smooth", "smooth 30" or neither.
Assets::Shading ReadShading(Statement& statement) {
  using Normals = Assets::Shading::Normals;
  if (!statement.Takes("smooth")) return {Normals::of_triangles};
  const auto number = statement.TakesNumber();
  if (!number) return {Normals::wanted};
  const auto [degrees, problem] = ParseNumber(number->text);
  if (problem || !(degrees > 0 && degrees <= 180))
    statement.Error(*number, "smooth must be followed by degrees above 0, up to 180, got " + Quoted(number->text));
  return {Normals::by_angle, degrees};
}

/// With the materials of the file for what it gives some to.
void ReadModel(ScnReader& reader, Statement& statement, int material, const FileWord& file,
               const Assets::Shading& shading) {
  std::shared_ptr<const Assets::Model> model;
  reader.WithFile(statement, file.word,
                  [&] { model = reader.Library().ModelNamed(file.name, reader.CurrentFile(), shading); });
  if (!model || !statement.IsGood()) return;
  for (Node& node : reader.Builder().NodesOf(model, material)) reader.AddNode(statement, std::move(node));
}

void ReadMesh(ScnReader& reader, Statement& statement) {
  Node node;
  node.material = reader.ReadMaterial(statement);
  const FileWord file = statement.FileName();
  const Assets::Shading shading = ReadShading(statement);
  if (statement.Takes("materials")) return ReadModel(reader, statement, node.material, file, shading);
  bool has_look = false;
  reader.WithFile(statement, file.word, [&] {
    const auto boxed = reader.Library().Mesh(file.name, reader.CurrentFile(), shading);
    node.shape = boxed.mesh;
    node.bounds = boxed.bounds;  // not SetBounds, which would walk over all triangles again at each use
    has_look = boxed.has_look;
  });
  if (!node.shape || !statement.IsGood()) return;
  if (has_look && reader.IsDefaultGray(node.material))
    reader.Warn(statement, "the mesh is gray; 'materials' behind its name shows those of its file");
  reader.AddNode(statement, std::move(node));
}

const std::array<R3::Argument, 6> line_arguments{{{"x1"}, {"y1"}, {"z1"}, {"x2"}, {"y2"}, {"z2"}}};

void ReadLine(ScnReader& reader, Statement& statement) {
  Node node;
  node.material = reader.ReadMaterial(statement);
  const Arguments read = statement.Coordinates(line_arguments);
  if (!statement.IsGood()) return;
  const auto& a = read.values;
  node.line = std::make_unique<const R3::Segment>(R3::Segment{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}});
  SetBounds(node);
  reader.AddNode(statement, std::move(node));
}

}  // namespace

Command ShapeCommand(const R3::ShapeKind& kind) {
  return {kind.name, std::string(kind.name) + " mat_id" + ArgumentNames(kind), kind.about,
          [&kind](ScnReader& reader, Statement& statement) { ReadShape(kind, reader, statement); }};
}

extern const Command mesh_command{"mesh", "mesh mat_id file [smooth [degrees]] [materials]",
                                  "the triangles of a file, flat-shaded; smooth with the file's vertex normals or "
                                  "smoothing groups, or with normals made "
                                  "of triangles that differ by up to so many degrees; with the file's own materials "
                                  "and vertex colors, mat_id for the "
                                  "rest",
                                  ReadMesh};
extern const Command line_command{"line", "line mat_id" + ArgumentNames(line_arguments),
                                  "a line segment that the viewer draws and no ray hits", ReadLine};

}  // namespace ray
