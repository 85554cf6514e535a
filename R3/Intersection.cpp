#include "R3/Intersection.h"

namespace R3 {

Point SpawnPoint(const Intersection& surface, const Vector& direction) {
  const Vector n = AsVector(surface.normal);
  // How far the corners of the error box reach along the normal.
  const double reach = Dot(Abs(n), surface.error);
  const double side = Dot(n, direction) < 0 ? -1 : 1;
  const auto step = [&](double from, double component) {
    const double offset = side * reach * component;
    const double to = from + offset;
    return offset > 0 ? NextUp(to) : offset < 0 ? NextDown(to) : to;
  };
  return {step(surface.position.x, n.x), step(surface.position.y, n.y), step(surface.position.z, n.z)};
}

}  // namespace R3
