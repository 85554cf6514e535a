#include "R2/ToneCurve.h"

#include <algorithm>
#include <array>

namespace R2 {
namespace {

// More light than any screen can distinguish from its limit. Beyond it, quotients of infinities would be NaN.
constexpr double blinding = 1e30;

/// Clamps light to [0, blinding]. NaN stays NaN, since both comparisons are false.
double Bounded(double light) { return light < 0 ? 0 : light > blinding ? blinding : light; }

double Unchanged(double light) { return light; }

/// source: Reinhard, Stark, Shirley, Ferwerda, Photographic Tone Reproduction for Digital Images (2002), eq. 3. Theirs
/// maps luminance and leaves channels above 1; ours maps each channel and desaturates bright light instead.
double Reinhard(double light) {
  const double x = Bounded(light);
  return x / (1 + x);
}

/// source: Narkowicz, ACES Filmic Tone Mapping Curve (2015), knarkowicz.wordpress.com; as published, where light of 1
/// maps to 0.80. He recommends multiplying by 0.6 first to match the brightness of ACES: -exposure -0.74.
double Aces(double light) {
  const double x = Bounded(light);
  return std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
}

/// source: Hable, Filmic Tonemapping Operators (2010), filmicworlds.com; with his constants, including the exposure
/// bias of 2 and the white point of 11.2, which applies after the bias.
double Filmic(double light) {
  const auto curve = [](double x) {
    constexpr double a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
    return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
  };
  constexpr double bias = 2, white = 11.2;
  return std::min(curve(bias * Bounded(light)) / curve(white), 1.0);
}

}  // namespace

std::span<const ToneCurve> ToneCurves() {
  static constexpr std::array curves{
      ToneCurve{"none", Unchanged, "the values as they are"},
      ToneCurve{"reinhard", Reinhard, "x/(1+x)"},
      ToneCurve{"aces", Aces, "Narkowicz' fit of the ACES curve"},
      ToneCurve{"filmic", Filmic, "Hable's curve"},
  };
  return curves;
}

Color Apply(const ToneCurve& curve, const Color& light) {
  return {curve.map(light.r), curve.map(light.g), curve.map(light.b)};
}

}  // namespace R2
