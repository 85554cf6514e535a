#pragma once

#include <span>

#include "R2/Color.h"

/// Curves that map light of any intensity into [0, 1], each channel independently. The result is still linear light;
/// the sRGB curve is applied afterwards.
namespace R2 {

struct ToneCurve {
  const char* name;
  double (*map)(double light);  // light at least 0; NaN stays NaN
  const char* help;             // one line
};

/// Returns the curves none, reinhard, aces and filmic.
std::span<const ToneCurve> ToneCurves();

/// Applies the curve to each channel. All curves except `none` treat light below 0 as 0.
Color Apply(const ToneCurve& curve, const Color& light);

}  // namespace R2
