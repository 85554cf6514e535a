#include "source/integrate/Guide.h"

#include <algorithm>
#include <cassert>

#include "source/integrate/modes/FirstHit.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

// With more lights than this, evaluating each is too expensive: surfaces then show their kd, as if lit evenly.
constexpr std::size_t most_lights = 16;
// Four doublings above the maximum of a screen: a light in a pixel's corner must not hide everything else in the pixel.
constexpr double most_light = 16;

// Mirrored and refracted rays with a smaller throughput are skipped. In glass, where this saves half of the rays, the
// error on the scenes of script/denoise_table.sh stayed within 1%.
constexpr double least_luminance = 0.1;

TraceSettings WithoutNoise(TraceSettings settings) {
  settings.shadows = false;
  settings.lights = 0;
  settings.roulette = Roulette::off;
  settings.min_luminance = std::max(settings.min_luminance, least_luminance);
  return settings;
}

double Bounded(double light) { return light < most_light ? light : most_light; }

}  // namespace

void GuideTracer::Unshadowed::Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances,
                                    TraceState&) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ShadingPoint& p = points[i];
    radiances[i] = p.EmittedAndAmbient(world());
    if (Lights().empty() || Lights().size() > most_lights) {
      radiances[i] += p.kd;
      continue;
    }
    for (const Light* light : Lights())
      if (const auto sample = light->Illuminate(p.free_point, {0.5, 0.5}))
        radiances[i] += PhongReflection(p, Unit(sample->to_light), sample->irradiance);
  }
}

GuideTracer::GuideTracer(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world), unshadowed_(world, accelerator, WithoutNoise(settings)) {}

void GuideTracer::Trace(std::span<const CameraSample> samples, std::span<Guide> guides, TraceState& state) const {
  assert(samples.size() <= most_at_once);
  std::array<R2::Color, most_at_once> light;
  unshadowed_.Li(samples, std::span(light).first(samples.size()), state);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Guide& guide = guides[i];
    guide = {Bounded(light[i].r), Bounded(light[i].g), Bounded(light[i].b)};
    R2::Color albedo = Background(world_.scene(), samples[i].ray.direction);
    if (state.hits[i]) {
      const ShadingPoint p = ShadingPointAt(world_, samples[i].ray, {.index = samples[i].index}, *state.hits[i]);
      albedo = p.Albedo();
      guide[6] = p.N.x, guide[7] = p.N.y, guide[8] = p.N.z;
      guide[9] = 1 / (1 + DistanceFromEye(p));
    }
    guide[3] = albedo.r, guide[4] = albedo.g, guide[5] = albedo.b;
  }
}

}  // namespace ray
