#include "source/integrate/lights/LightSampler.h"

#include <algorithm>

#include "R3/Warp.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {

LightSampler::LightSampler(const World& world, const TraceSettings& settings)
    : settings_(settings),
      lights_(LightSourcesOfPath(world, settings)),
      emission_bounds_(world),
      has_unsampled_emission_(!EmitsColor() && HasUnsampledEmission(world)) {
  std::vector<LightBound> bounds;
  for (const auto& light : lights_) {
    if (light->Primitive() >= 0) light_of_primitive_.emplace(light->Primitive(), static_cast<int>(bounds.size()));
    bounds.push_back(light->Bound());
  }
  const Scene& scene = world.scene();
  if (scene.environment && !scene.environment->IsBlack()) environment_ = scene.environment.get();
  has_background_ = !scene.environment && !IsBlack(scene.background);
  if (Count() > 1 && !IsUniform()) tree_.emplace(std::move(bounds));
}

std::optional<LightSample> LightSampler::SampleOne(const ShadingPoint& p, const R2::Point& u, double choice) const {
  if (Count() == 1) return Sample(p, 0, u);
  const auto chosen = Choose(p, choice);
  if (!chosen) return {};
  auto sample = Sample(p, chosen->light, u);
  if (!sample) return {};
  sample->irradiance = sample->irradiance / chosen->probability;
  sample->pdf *= chosen->probability;
  return sample;
}

std::optional<LightTree::Choice> LightSampler::Choose(const ShadingPoint& p, double choice) const {
  if (IsUniform()) return LightTree::Choice{std::min(Count() - 1, static_cast<int>(choice * Count())), 1.0 / Count()};
  return tree_->Choose(p.free_point, p.N, choice);
}

double LightSampler::ProbabilityOf(const ShadingPoint& p, int light) const {
  if (Count() == 1) return 1;
  return IsUniform() ? 1.0 / Count() : tree_->Probability(p.free_point, p.N, light);
}

std::optional<LightSample> LightSampler::Sample(const ShadingPoint& p, int light, const R2::Point& u) const {
  auto sample = (*this)[light].Sample(p, u);
  if (sample) sample->light = light;
  return sample;
}

void LightSampler::SampleEach(std::span<const ShadingPoint> points, int light, LightSamples& samples,
                              LightSamples::Each& pdfs) const {
  if ((*this)[light].SampleEach(samples, pdfs)) return;
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const auto sample =
        ReflectsLights(points[i], settings_) ? Sample(points[i], light, samples.random[i]) : std::nullopt;
    pdfs[i] = sample ? sample->pdf : 0;
    samples.Set(i, sample ? sample->to_light : R3::Vector{}, sample ? sample->irradiance : R2::Color{});
  }
}

double LightSampler::PdfOfEnvironment(const ShadingPoint& from, const Environment::Seen& seen, bool choosing) const {
  const double pdf = IsUniform() ? R3::uniform_sphere_pdf : seen.pdf;
  return choosing ? pdf * ProbabilityOf(from, Count() - 1) : pdf;
}

std::optional<double> LightSampler::PdfOfHit(const ShadingPoint& from, const ShadingPoint& hit, const World& world,
                                             bool choosing) const {
  const auto found = light_of_primitive_.find(world.PrimitiveId(hit.hit));
  if (found == light_of_primitive_.end()) return {};
  const double pdf = (*this)[found->second].Pdf(from, hit);
  return choosing ? pdf * ProbabilityOf(from, found->second) : pdf;
}

}  // namespace ray
