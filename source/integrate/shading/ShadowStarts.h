#pragma once

#include "R1/Columns.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// The starts of shadow rays towards the samples of a light, in columns.
struct ShadowStarts {
  alignas(64) LightSamples::Each begin, facing;  // their t_min, and N . to_light
};

/// Computes the starts of rays that each leave another point.
///   bias   the same for all points
void MakeShadowStarts(const R1::Columns<R3::Vector>& N, const LightSamples::Each& clearance, double bias,
                      const LightSamples& samples, ShadowStarts& starts);
/// Computes the starts of rays that all leave one point.
void MakeShadowStarts(const ShadingPoint& p, const LightSamples& samples, ShadowStarts& starts);

}  // namespace ray
