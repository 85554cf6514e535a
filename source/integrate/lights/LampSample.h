#pragma once

#include <optional>

#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/TriangleLamp.h"
#include "source/integrate/shading/ShadingPoint.h"

/// Lamps whose emission is read as a color, which mode whitted does and -emission color asks for: each of their points
/// shines like a point light without fall-off. The samples have no pdf, since light from a lamp is then no integral
/// over directions, which scattered rays could find too.
namespace ray {

/// Whether a surface is part of the lamp, which does not light it.
inline bool IsOn(const ShadingPoint& p, const TriangleLamp& lamp, const World& world) {
  return lamp.Holds(world.PrimitiveId(p.hit));
}
inline bool IsOn(const ShadingPoint& p, const EmissiveShape& lamp, const World& world) {
  return lamp.Primitive() == world.PrimitiveId(p.hit);
}

/// What arrives from the point of the lamp that `u`, in [0, 1)^2, picks.
inline std::optional<LightSample> SampleLight(const ShadingPoint& p, const TriangleLamp& lamp, const R2::Point& u) {
  return lamp.SampleTowards(p.free_point, u, p.path.ray.time);
}
/// Nothing where no point of the lamp is found that the lamp itself does not hide.
std::optional<LightSample> SampleLight(const ShadingPoint& p, const EmissiveShape& lamp, const R2::Point& u);

}  // namespace ray
