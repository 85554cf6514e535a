#include <cmath>

#include "source/integrate/modes/FirstHit.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

/// Light in a few even tones, as in cartoons. For each light of color C, without shadows and with area lights at their
/// middle:
///     kd C ceil(bands N.L) / bands,   and ks C where Phong's highlight (V.R)^n is above a half,
/// plus the usual emission and ambient light.
///   source   Lake, Marshall, Harris, Blackstein, Stylized rendering techniques for scalable real-time 3D animation
///            (2000), section 4, whose two tones are a number of bands here
class Toon : public FirstHit {
 public:
  Toon(const World& world, const Accelerator& accelerator, int bands) : FirstHit(world, accelerator), bands_(bands) {}

 private:
  R2::Color Seen(const ShadingPoint& p) const override {
    R2::Color sum = p.EmittedAndAmbient(world());
    for (const auto& light : world().scene().lights)
      if (const auto sample = light->Illuminate(p.free_point, {0.5, 0.5})) sum += Shade(p, *sample);
    return sum;
  }
  R2::Color Missed(const R3::Vector& direction) const override { return Background(world().scene(), direction); }

  R2::Color Shade(const ShadingPoint& p, const LightSample& light) const {
    constexpr double bright = 0.5;
    const R3::Vector L = Unit(light.to_light);
    const double cosine = Dot(p.N, L), lobe = LobeCosine(p, L);
    if (!(cosine > 0)) return {};
    const double tone = std::ceil(bands_ * std::min(cosine, 1.0)) / bands_;
    const bool shines = lobe > 0 && R1::CosinePower(lobe, p.material->n) > bright;
    return (tone * p.kd + (shines ? p.Mapped(p.material->ks) : R2::Color{})) * light.irradiance;
  }

  int bands_;
};

}  // namespace

extern const IntegratorKind toon_kind{"cel shading: light quantized to a few tones",
                                      [](const World& world, const Accelerator& accelerator,
                                         const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                        return std::make_unique<Toon>(world, accelerator, settings.toon_bands);
                                      }};

}  // namespace ray
