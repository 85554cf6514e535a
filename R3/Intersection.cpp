#include "R3/Intersection.h"

#include "R3/Numeric.h"

namespace R3 {
namespace {

/// Returns the next double after x in the direction of `way`; x itself if `way` is 0.
double NextAlong(double x, double way) { return way < 0 ? NextDown(x) : way > 0 ? NextUp(x) : x; }

}  // namespace

Point SpawnPoint(const Intersection& surface, const Vector& direction) {
  const Vector n = AsVector(surface.normal);
  const double reach = Dot(Abs(n), surface.error);  // the largest extent of the error box along the normal
  const Vector way = (Dot(n, direction) < 0 ? -reach : reach) * n;
  const Point to = surface.position + way;
  return {NextAlong(to.x, way.x), NextAlong(to.y, way.y), NextAlong(to.z, way.z)};
}

}  // namespace R3
