#pragma once

#include "R2/Color.h"
#include "R3/Normal.h"
#include "R3/Vector.h"
#include "source/accelerate/World.h"

namespace ray {

/// Returns the remaining light after a distance inside a solid: exp(-absorb * distance), by the law of Bouguer, Lambert
/// and Beer (1729-1852).
R2::Color LeftAfter(const R2::Color& absorb, double distance);

/// The emission of a surface seen from behind.
struct EmissionBehind {
  R2::Color absorb{};         // of the medium there
  bool is_one_sided = false;  // the surface has no back

  bool IsAsFront() const { return IsBlack(absorb) && !is_one_sided; }
};

/// Returns the emission behind an instance. If it is a medium, paths inside lose light on the way, see Media.
inline EmissionBehind EmissionBehindOf(const Instance& instance) {
  const Material& m = *instance.material;
  return {instance.is_medium ? R2::Color{} : m.absorb, m.one_sided};
}

/// Returns the part of a surface's emission that arrives at the other end of a way to it.
///   normal   of the surface there
inline R2::Color EmittedBackAlong(const R3::Vector& way, const R3::Normal& normal, const R2::Color& emission,
                                  const EmissionBehind& behind) {
  if (behind.IsAsFront() || !(Dot(normal, way) > 0)) return emission;
  return behind.is_one_sided ? R2::Color{} : emission * LeftAfter(behind.absorb, Length(way));
}

}  // namespace ray
