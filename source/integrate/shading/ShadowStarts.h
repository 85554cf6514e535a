#pragma once

#include "R1/Columns.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// How rays towards samples of a light start, in columns.
struct ShadowStarts {
  alignas(64) LightSamples::Each begin, facing;  // their t_min, and N . to_light
};

/// Makes those of rays from points of their own.
///   bias   of all points
void MakeShadowStarts(const R1::Columns<R3::Vector>& N, const LightSamples::Each& clearance, double bias,
                      const LightSamples& samples, ShadowStarts& starts);
/// Makes those of rays that are all from one point.
void MakeShadowStarts(const ShadingPoint& p, const LightSamples& samples, ShadowStarts& starts);

}  // namespace ray
