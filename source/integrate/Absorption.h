#pragma once

#include "R2/Color.h"
#include "R3/Normal.h"
#include "R3/Vector.h"

namespace ray {

/// What is left of light after a distance inside a solid: exp(-absorb * distance), by the law of Bouguer, Lambert and
/// Beer (1729-1852).
R2::Color LeftAfter(const R2::Color& absorb, double distance);

/// What of a surface's emission arrives at the other end of a way to it: from inside a solid that absorbs, less.
///   normal   of the surface there
inline R2::Color EmittedBackAlong(const R3::Vector& way, const R3::Normal& normal, const R2::Color& emission,
                                  const R2::Color& absorb) {
  if (IsBlack(absorb)) return emission;
  const bool is_inside = Dot(normal, way) > 0;
  return is_inside ? emission * LeftAfter(absorb, Length(way)) : emission;
}

}  // namespace ray
