#include "source/parse/courses/comp30019/Reader.h"

namespace ray::comp30019 {
namespace {

/// A plane has no end to be sampled.
void WarnOfEmission(Reader& reader, const Line& plane, int material) {
  if (!IsBlack(reader.MaterialAt(material).emission))
    reader.Warn(plane.Command(), "an emissive Plane is seen but gives no light");
}

}  // namespace

void ReadPointLight(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::light, line);
  const R3::Point p = Mirrored(reader.ReadPoint(line, "position"));
  const R2::Color c = ColorOf(reader.ReadColor(line, "color"));
  if (line.IsGood()) reader.AddLight("point_light", {c.r, c.g, c.b, p.x, p.y, p.z, 1, 0, 0});
}

void ReadPlane(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point p = Mirrored(reader.ReadPoint(line, "point"));
  const Triple normal = reader.ReadPoint(line, "normal");
  const R3::Point n = Mirrored(normal);
  const int material = reader.ReadMaterial(line);
  if (!line.IsGood()) return;
  if (n == R3::Point{}) return line.Error(normal[0].token, "normal must not be 0 0 0");
  WarnOfEmission(reader, line, material);
  reader.AddShape(line, "plane", {p.x, p.y, p.z, n.x, n.y, n.z}, material);
}

void ReadSphere(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point c = Mirrored(reader.ReadPoint(line, "center"));
  const Number radius = reader.ReadCoordinate(line, "radius");
  const int material = reader.ReadMaterial(line);
  if (!line.IsGood()) return;
  if (!(radius.value > 0))
    return line.Error(radius.token, "radius must be positive, got " + Escaped(radius.token.text));
  reader.AddShape(line, "sphere", {c.x, c.y, c.z, radius.value}, material);
}

// The mirror image of corners that are clockwise is counter-clockwise when two of them change places.
void ReadTriangle(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point a = Mirrored(reader.ReadPoint(line, "first corner"));
  const R3::Point b = Mirrored(reader.ReadPoint(line, "second corner"));
  const R3::Point c = Mirrored(reader.ReadPoint(line, "third corner"));
  const int material = reader.ReadMaterial(line);
  if (line.IsGood()) reader.AddShape(line, "tri", {a.x, a.y, a.z, c.x, c.y, c.z, b.x, b.y, b.z}, material);
}

void ReadObjModel(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const Token file = line.Name("file");
  const R3::Point offset = Mirrored(reader.ReadPoint(line, "offset"));
  const Number scale = reader.ReadCoordinate(line, "scale");
  const int material = reader.ReadMaterial(line);
  if (line.IsGood() && scale.value == 0) line.Error(scale.token, "scale must not be 0");
  reader.AddModel(line, file, offset, scale.value, material);
}

}  // namespace ray::comp30019
