#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "R3/Implicit.h"
#include "R3/Mesh.h"
#include "R3/Polygon.h"
#include "R3/Segment.h"
#include "R3/ShapeKind.h"
#include "source/parse/scn/ScnReader.h"
#include "source/text/Number.h"

namespace ray {
namespace {

/// Reads arguments; those that may be repeated, up to the next statement.
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

/// Reads "smooth", "smooth 30" or neither.
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

/// Reads a model with the materials of its file for the parts that have some.
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
    node.bounds = boxed.bounds;  // not SetBounds, which would visit all triangles at each use
    has_look = boxed.has_look;
  });
  if (!node.shape || !statement.IsGood()) return;
  if (has_look && reader.IsDefaultGray(node.material))
    reader.Warn(statement, "the mesh is gray; 'materials' after its name uses those of its file");
  reader.AddNode(statement, std::move(node));
}

constexpr auto line_arguments = R3::ArgumentsNamed("x1", "y1", "z1", "x2", "y2", "z2");

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

constexpr std::size_t most_corners = R3::max_concave_corners;

constexpr auto corner_count = R3::ArgumentsNamed("n");

/// Reads `count` corners, three numbers each; empty after a mistake.
std::vector<R3::Point> ReadCorners(Statement& statement, std::size_t count) {
  std::vector<R3::Argument> names;
  for (std::size_t i = 0; i < count; ++i) names.insert(names.end(), {{"x"}, {"y"}, {"z"}});
  const Arguments read = statement.Coordinates(names);
  if (!statement.IsGood()) return {};
  std::vector<R3::Point> corners;
  for (std::size_t i = 0; i < count; ++i)
    corners.push_back({read.values[3 * i], read.values[3 * i + 1], read.values[3 * i + 2]});
  return corners;
}

/// Adds a flat polygon as triangles of its own corners; its front is where they are counter-clockwise.
void AddFlat(ScnReader& reader, Statement& statement, int material, const std::vector<R3::Point>& corners,
             std::vector<R2::Point> uvs) {
  if (const char* const fault = R3::FaultOfPolygon(corners))
    reader.Warn(statement, "this " + statement.What().name + " " + fault);
  const auto cuts = R3::Triangulate(corners);
  R3::MeshData data;
  data.positions = corners;
  data.triangles.assign(cuts->begin(), cuts->end());
  data.uvs = std::move(uvs);
  data.is_one_polygon = true;
  reader.AddShape(statement, material, std::make_unique<const R3::Mesh>(std::move(data)));
}

/// Reads an extension: two triangles, with a texture from corner to corner.
void ReadQuad(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const std::vector<R3::Point> corners = ReadCorners(statement, 4);
  if (statement.IsGood()) AddFlat(reader, statement, material, corners, R3::QuadUvs());
}

/// Reads an extension: a polygon of as many triangles as necessary.
void ReadPolygon(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const Arguments read = statement.Numbers(corner_count);
  const double n = read.values[0];
  if (!(n >= 3 && n <= most_corners && n == std::floor(n))) {
    statement.RestOfLine();  // an unknown number of corners
    return statement.Error(read.words[0], "n must be a whole number of corners from 3 to " +
                                              std::to_string(most_corners) + ", got " + Escaped(read.words[0].text));
  }
  const std::vector<R3::Point> corners = ReadCorners(statement, static_cast<std::size_t>(n));
  if (statement.IsGood()) AddFlat(reader, statement, material, corners, {});
}

constexpr auto box_corners = R3::ArgumentsNamed("x", "y", "z", "X", "Y", "Z");

/// Returns the text between the quotes, if there are any.
Token InnerOf(Token word) {
  if (word.text.size() < 2 || word.text.front() != '"' || word.text.back() != '"') return word;
  word.text = word.text.substr(1, word.text.size() - 2);
  ++word.column;
  return word;
}

/// Reads a formula; std::nullopt after a mistake, which is reported at its position.
std::optional<R3::Expression> ReadFormula(Statement& statement) {
  const Token text = InnerOf(statement.Word("formula"));
  try {
    return R3::Expression(text.text);
  } catch (const R3::ExpressionError& error) {
    Token part = text;
    part.text = text.text.substr(std::min(error.at, text.text.size()), error.length);
    part.column += error.at;  // the text before it is ASCII
    statement.Error(part, error.what(), error.hint);
    return {};
  }
}

/// Reads an extension: the solid where a formula of x, y and z is not above 0, within a box.
void ReadImplicit(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  auto formula = ReadFormula(statement);
  const Arguments read = statement.Coordinates(box_corners);
  if (!formula || !statement.IsGood()) return;
  R3::Box box;
  box.Extend(R3::Point{read.values[0], read.values[1], read.values[2]});
  box.Extend(R3::Point{read.values[3], read.values[4], read.values[5]});
  reader.AddShape(statement, material, std::make_shared<const R3::Implicit>(std::move(*formula), box));
}

void ReadLight(const LightKind& kind, ScnReader& reader, Statement& statement) {
  reader.Builder().has_light = true;
  const Arguments read = statement.Numbers(kind.arguments);
  if (!statement.IsGood()) return;
  try {
    reader.Builder().scene.lights.push_back(kind.make(read.values));
  } catch (const R3::ArgumentError& error) {
    statement.Error(read.words[error.index], error.what());
  }
}

}  // namespace

Command ShapeCommand(const R3::ShapeKind& kind) {
  return {kind.name, std::string(kind.name) + " mat_id" + ArgumentNames(kind), kind.about,
          [&kind](ScnReader& reader, Statement& statement) { ReadShape(kind, reader, statement); }};
}

extern const Command mesh_command{"mesh", "mesh mat_id file [smooth [degrees]] [materials]",
                                  "the triangles of a file, flat-shaded; smooth with the file's vertex normals or "
                                  "smoothing groups, or with normals averaged over triangles that differ by up to "
                                  "that many degrees; with the file's own materials and vertex colors, mat_id for "
                                  "the rest",
                                  ReadMesh};
extern const Command line_command{"line", "line mat_id" + ArgumentNames(line_arguments),
                                  "a line segment that the viewer draws and no ray hits", ReadLine};

extern const Command quad_command{"quad", "quad mat_id x1 y1 z1 x2 y2 z2 x3 y3 z3 x4 y4 z4",
                                  "a quadrilateral, its corners counter-clockwise seen from its front", ReadQuad};
extern const Command polygon_command{
    "polygon", "polygon mat_id n x1 y1 z1 ... xn yn zn",
    "a flat polygon of n corners, concave ones too, counter-clockwise seen from its front", ReadPolygon};

extern const Command implicit_command{
    "implicit", "implicit mat_id \"formula\"" + ArgumentNames(box_corners),
    "the solid where a formula of x, y and z is not above 0, within a box of two opposite corners", ReadImplicit};

Command LightCommand(const LightKind& kind) {
  return {kind.name, kind.name + ArgumentNames(kind.arguments), kind.about,
          [&kind](ScnReader& reader, Statement& statement) { ReadLight(kind, reader, statement); }};
}

}  // namespace ray
