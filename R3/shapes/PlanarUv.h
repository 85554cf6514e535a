#pragma once

#include <algorithm>

#include "R3/Intersection.h"
#include "R3/UvTangents.h"
#include "R3/Warp.h"

/// Texture coordinates for shapes of any form: the relative position in a box along x and along y, as if the image were
/// projected through the shape from its +z side.
namespace R3 {

inline void SetPlanarUv(Intersection& at, const Box& box) {
  const Vector size = box.Size();
  at.uv = {std::clamp((at.position.x - box.low.x) / size.x, 0.0, 1.0),
           std::clamp((at.position.y - box.low.y) / size.y, 0.0, 1.0)};
  at.v_ends = {VEnd::rim, VEnd::rim};
}

/// Returns the tangents of these coordinates on a surface with this normal.
inline UvTangents PlanarUvTangents(const Normal& normal, const Box& box) {
  const Tangents tangents = TangentsOf(AsVector(normal));
  const Vector size = box.Size();
  const auto gain = [&](const Vector& tangent) { return R2::Vector{tangent.x / size.x, tangent.y / size.y}; };
  return {tangents.first, tangents.second, gain(tangents.first), gain(tangents.second)};
}

}  // namespace R3
