#include <array>
#include <cmath>

#include "R3/Mesh.h"
#include "source/parse/meshes/Polygon.h"
#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

constexpr std::size_t most_corners = max_concave_corners;

const std::array<R3::Argument, 1> corner_count{{{"n"}}};

/// So many corners, three numbers each; none after a mistake.
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

/// Triangles of the corners' own, which face where the corners are counter-clockwise.
void AddFlat(ScnReader& reader, Statement& statement, int material, const std::vector<R3::Point>& corners,
             std::vector<R2::Point> uvs) {
  if (const char* const fault = FaultOfPolygon(corners))
    reader.Warn(statement, "this " + statement.What().name + " " + fault);
  const auto cuts = Triangulate(corners);
  R3::MeshData data;
  data.positions = corners;
  data.triangles.assign(cuts->begin(), cuts->end());
  data.uvs = std::move(uvs);
  data.is_one_polygon = true;
  reader.AddShape(statement, material, std::make_unique<const R3::Mesh>(std::move(data)));
}

/// An extension: two triangles, their texture from corner to corner.
void ReadQuad(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const std::vector<R3::Point> corners = ReadCorners(statement, 4);
  if (statement.IsGood()) AddFlat(reader, statement, material, corners, QuadUvs());
}

/// An extension: as many triangles as it takes.
void ReadPolygon(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  const Arguments read = statement.Numbers(corner_count);
  const double n = read.values[0];
  if (!(n >= 3 && n <= most_corners && n == std::floor(n))) {
    statement.RestOfLine();  // corners of which nobody knows how many they should be
    return statement.Error(read.words[0], "n must be a whole number of corners from 3 to " +
                                              std::to_string(most_corners) + ", got " + Escaped(read.words[0].text));
  }
  const std::vector<R3::Point> corners = ReadCorners(statement, static_cast<std::size_t>(n));
  if (statement.IsGood()) AddFlat(reader, statement, material, corners, {});
}

}  // namespace

extern const Command quad_command{"quad", "quad mat_id x1 y1 z1 x2 y2 z2 x3 y3 z3 x4 y4 z4",
                                  "a quadrilateral, its corners counter-clockwise seen from its front", ReadQuad};
extern const Command polygon_command{
    "polygon", "polygon mat_id n x1 y1 z1 ... xn yn zn",
    "a flat polygon of n corners, concave ones too, counter-clockwise seen from its front", ReadPolygon};

}  // namespace ray
