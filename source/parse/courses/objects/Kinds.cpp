#include "source/parse/courses/objects/Kinds.h"

namespace ray {

std::span<const ObjectKind> ObjectKinds() {
  static const std::vector<ObjectKind> kinds{
      {{"sphere"}, ReadSphere},
      {{"triangle"}, ReadTriangle},
      {{"quad", "quadrilateral"}, ReadQuad},
      {{"polygon"}, ReadPolygon},
      {{"mesh", "model", "obj", "triangleAggregate"}, ReadMeshFile},
      {{"plane"}, ReadPlane},
      {{"box"}, ReadBox},
      {{"cube"}, ReadCube},
      {{"cylinder"}, ReadCylinder},
      {{"cone"}, ReadCone},
      {{"torus"}, ReadTorus},
      {{"disc", "disk", "circle"}, ReadDisc},
      {{"paraboloid"}, ReadParaboloid},
      {{"blob", "metaball"}, ReadBlob},
      {{"bezier"}, ReadBezier},
      {{"bspline"}, ReadBspline},
      {{"implicit"}, ReadImplicit},
  };
  return kinds;
}

std::shared_ptr<const R3::Shape> ShapeOf(const char* kind, std::span<const double> numbers) {
  return R3::FindShapeKind(kind)->make(numbers);
}

}  // namespace ray
