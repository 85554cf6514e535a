#include <array>

#include "R3/Segment.h"
#include "R3/ShapeKind.h"
#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

void ReadShape(const R3::ShapeKind& kind, ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const Arguments read = statement.Coordinates(kind.arguments);
  if (!statement.IsGood()) return;
  try {
    reader.AddShape(statement, material, kind.make(read.values));
  } catch (const R3::ArgumentError& error) {
    statement.Error(read.words[error.index], error.what());
  }
}

void ReadMesh(ScnReader& reader, Statement& statement) {
  Node node;
  node.material = reader.ReadMaterial(statement);
  const Token name = statement.Word("file name");
  const bool smooth = statement.Takes("smooth");
  reader.WithFile(statement, name, [&] {
    const auto boxed = reader.Library().Mesh(std::string(name.text), reader.CurrentFile(), smooth);
    node.shape = boxed.mesh;
    node.bounds = boxed.bounds;  // not SetBounds, which would walk over all triangles again at each use
  });
  if (node.shape && statement.IsGood()) reader.AddNode(statement, std::move(node));
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
  return {kind.name, std::string(kind.name) + " mat_id" + ArgumentNames(kind.arguments), kind.about,
          [&kind](ScnReader& reader, Statement& statement) { ReadShape(kind, reader, statement); }};
}

extern const Command mesh_command{"mesh", "mesh mat_id file [smooth]",
                                  "the triangles of a file, flat-shaded, or smooth with the vertex normals of the file",
                                  ReadMesh};
extern const Command line_command{"line", "line mat_id" + ArgumentNames(line_arguments),
                                  "a line segment that the viewer draws and no ray hits", ReadLine};

}  // namespace ray
