#pragma once

#include "R2/Color.h"
#include "R3/Normal.h"
#include "R3/Vector.h"
#include "source/accelerate/World.h"

namespace ray {

/// What is left of light after a distance inside a solid: exp(-absorb * distance), by the law of Bouguer, Lambert and
/// Beer (1729-1852).
R2::Color LeftAfter(const R2::Color& absorb, double distance);

/// What a surface sends to where it is seen from behind.
struct EmissionBehind {
  R2::Color absorb{};         // by what is there
  bool is_one_sided = false;  // nothing: the surface has no back

  bool IsAsFront() const { return IsBlack(absorb) && !is_one_sided; }
};

/// Where an instance is a medium, paths inside lose light on the way, see Media.
inline EmissionBehind EmissionBehindOf(const Instance& instance) {
  const Material& m = *instance.material;
  return {instance.is_medium ? R2::Color{} : m.absorb, m.one_sided};
}

/// What of a surface's emission arrives at the other end of a way to it.
///   normal   of the surface there
inline R2::Color EmittedBackAlong(const R3::Vector& way, const R3::Normal& normal, const R2::Color& emission,
                                  const EmissionBehind& behind) {
  if (behind.IsAsFront() || !(Dot(normal, way) > 0)) return emission;
  return behind.is_one_sided ? R2::Color{} : emission * LeftAfter(behind.absorb, Length(way));
}

}  // namespace ray
