#include "source/integrate/modes/FirstHit.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

/// Shading for technical illustration, from cool away from a light to warm towards it, with Phong's highlight; without
/// shadows and reflections. Summed over the lights of color C, area lights at their middle:
///     cool (1 - N.L) / 2 + warm (1 + N.L) / 2 + ks (V.R)^n C,
///     cool = (0, 0, b) + alpha kd C,  warm = (y, y, 0) + beta kd C
/// Black lights are ignored, as everywhere. So a scene without lights has the same image after conversion to .scn,
/// where a black light replaces the default one.
///   source   A. Gooch, B. Gooch, Shirley, Cohen, A non-photorealistic lighting model for automatic technical
///            illustration (1998), equation 2
class Gooch : public FirstHit {
 public:
  Gooch(const World& world, const Accelerator& accelerator, const GoochTones& tones)
      : FirstHit(world, accelerator), tones_(tones) {}

 private:
  R2::Color Seen(const ShadingPoint& p) const override {
    R2::Color sum;
    for (const auto& light : world().scene().lights) {
      if (light->IsBlack()) continue;
      if (const auto sample = light->Illuminate(p.free_point, {0.5, 0.5})) sum += Shade(p, *sample);
    }
    return sum;
  }
  R2::Color Missed(const R3::Vector& direction) const override { return Background(world().scene(), direction); }

  R2::Color Shade(const ShadingPoint& p, const LightSample& light) const {
    const R3::Vector L = Unit(light.to_light);
    const double cosine = Dot(p.N, L);
    const R2::Color lit = p.kd * light.irradiance;
    const R2::Color cool = R2::Color{0, 0, tones_.blue} + tones_.alpha * lit;
    const R2::Color warm = R2::Color{tones_.yellow, tones_.yellow, 0} + tones_.beta * lit;
    return (1 - cosine) / 2 * cool + (1 + cosine) / 2 * warm + Highlight(p, L) * light.irradiance;
  }

  GoochTones tones_;
};

}  // namespace

extern const IntegratorKind gooch_kind{"shading for illustration, from cool to warm",
                                       [](const World& world, const Accelerator& accelerator,
                                          const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                         return std::make_unique<Gooch>(world, accelerator, settings.gooch);
                                       }};

}  // namespace ray
