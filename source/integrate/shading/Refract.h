#pragma once

#include <optional>

#include "R3/Vector.h"

namespace ray {

/// Returns the mirror image of the unit direction d in the plane with unit normal N.
inline R3::Vector Reflect(const R3::Vector& d, const R3::Vector& N) { return d - 2 * Dot(d, N) * N; }

/// Returns the refracted direction, by Snell's law, of a ray along unit d that hits a surface on the side of unit N
/// (d.N <= 0); `eta` is the index on this side over the index on the other. Unit within 8 u.
///   returns   std::nullopt on total internal reflection; at the critical angle itself the ray leaves along the surface
///   source    Heckbert, in: Glassner (ed.), An introduction to ray tracing (1989), ch. 7. The sine squared is computed
///             from the cross product: 1 - cos^2 has no accurate digits near the normal.
std::optional<R3::Vector> Refract(const R3::Vector& d, const R3::Vector& N, double eta);

}  // namespace ray
