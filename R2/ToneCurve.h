#pragma once

#include <span>

#include "R2/Color.h"

/// Curves that fit light of any strength into [0, 1], each channel on its own. The result is still linear light; the
/// sRGB curve is applied after it.
namespace R2 {

struct ToneCurve {
  const char* name;
  double (*map)(double light);  // light at least 0; NaN stays NaN
  const char* help;             // one line
};

/// none, reinhard, aces, filmic.
std::span<const ToneCurve> ToneCurves();

/// Light below 0 is taken for 0 by all curves but `none`.
Color Apply(const ToneCurve& curve, const Color& light);

}  // namespace R2
