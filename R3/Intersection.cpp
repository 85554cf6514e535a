#include "R3/Intersection.h"

#include "R3/Spawn.h"

namespace R3 {

Point SpawnPoint(const Intersection& surface, const Vector& direction) {
  return SpawnedFrom(surface.position, surface.error, AsVector(surface.normal), direction);
}

}  // namespace R3
