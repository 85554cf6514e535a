#include "source/integrate/lights/LightSampler.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "R3/Warp.h"
#include "source/integrate/lights/LampSample.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

/// A surface as path tracing weighs it: radiance times area, falling off with the square of the distance.
LightBound RadiantBound(LightBound bound, double area) {
  bound.power *= area / pi;
  bound.ca = 0;
  bound.qa = 1;
  return bound;
}

LightBound RadiantBound(const Environment& environment) {
  const Environment::Sample any = environment.Draw({0.5, 0.5});  // luminance over pdf is alike for all
  return {.power = Luminance(any.radiance) / any.pdf / pi, .is_infinite = true};
}

double Pdf(const EmissiveTriangle& triangle, const R3::Vector& towards, double t) {
  return SolidAnglePdf(triangle.normal, towards, t, triangle.area);
}

}  // namespace

std::vector<const Light*> LightsOfPath(const World& world) {
  const Scene& scene = world.scene();
  const bool has_environment = scene.environment && !scene.environment->IsBlack();
  const bool emits = has_environment || std::ranges::any_of(world.Instances(), &Instance::Emits);
  return scene.has_default_lights && emits ? std::vector<const Light*>() : LightsOf(scene);
}

LightSampler::LightSampler(const World& world, const TraceSettings& settings)
    : world_(world),
      settings_(settings),
      emission_bounds_(world),
      has_unsampled_emission_(!EmitsColor() && HasUnsampledEmission(world)) {
  if (!EmitsColor()) triangles_ = EmissiveTriangles(world);
  if (EmitsColor()) lamps_ = TriangleLamps(world, settings.emissive_meshes);
  if (!EmitsColor() || settings.emissive_solids_light) shapes_ = EmissiveShapes(world);
  const Scene& scene = world.scene();
  std::vector<LightBound> bounds;
  for (const Light* light : LightsOfPath(world)) {
    lights_.push_back(light);
    bounds.push_back(light->Bound());
  }
  for (const EmissiveTriangle& triangle : triangles_) {
    light_of_primitive_.emplace(triangle.primitive, static_cast<int>(bounds.size()));
    bounds.push_back(RadiantBound(triangle.Bound(), triangle.area));
  }
  for (const TriangleLamp& lamp : lamps_) bounds.push_back(lamp.Bound());
  for (const EmissiveShape& shape : shapes_) {
    if (!EmitsColor()) light_of_primitive_.emplace(shape.Primitive(), static_cast<int>(bounds.size()));
    bounds.push_back(EmitsColor() ? shape.Bound() : RadiantBound(shape.Bound(), shape.ProjectedAreaOfBounds()));
  }
  if (scene.environment && !scene.environment->IsBlack()) {
    environment_ = scene.environment.get();
    bounds.push_back(RadiantBound(*environment_));
  }
  has_background_ = !scene.environment && !IsBlack(scene.background);
  count_ = static_cast<int>(bounds.size());
  if (count_ > 1 && !IsUniform()) tree_.emplace(std::move(bounds));
}

std::optional<LightSample> LightSampler::SampleOne(const ShadingPoint& p, const R2::Point& u, double choice) const {
  if (count_ == 1) return Sample(p, 0, u);
  const auto chosen = Choose(p, choice);
  if (!chosen) return {};
  auto sample = Sample(p, chosen->light, u);
  if (!sample) return {};
  sample->irradiance = sample->irradiance / chosen->probability;
  sample->pdf *= chosen->probability;
  return sample;
}

std::string LightSampler::Describe(int light) const {
  auto i = static_cast<std::size_t>(light);
  if (i < lights_.size()) return lights_[i]->Describe();
  i -= lights_.size();
  if (i < triangles_.size()) return triangles_[i].Describe();
  i -= triangles_.size();
  if (i < lamps_.size()) return lamps_[i].Describe();
  i -= lamps_.size();
  return i < shapes_.size() ? shapes_[i].Describe() : "environment";
}

std::int64_t LightSampler::Reached(int light) const {
  assert(!IsLamp(light));
  auto i = static_cast<std::size_t>(light);
  if (i < lights_.size()) return -1;
  i -= lights_.size();
  if (i < triangles_.size()) return triangles_[i].primitive;
  i -= triangles_.size();
  return i < shapes_.size() ? shapes_[i].Reached() : -1;
}

std::optional<LightTree::Choice> LightSampler::Choose(const ShadingPoint& p, double choice) const {
  if (IsUniform()) return LightTree::Choice{std::min(count_ - 1, static_cast<int>(choice * count_)), 1.0 / count_};
  return tree_->Choose(p.free_point, p.N, choice);
}

double LightSampler::ProbabilityOf(const ShadingPoint& p, int light) const {
  if (count_ == 1) return 1;
  return IsUniform() ? 1.0 / count_ : tree_->Probability(p.free_point, p.N, light);
}

std::optional<LightSample> LightSampler::Sample(const ShadingPoint& p, int light, const R2::Point& u) const {
  auto i = static_cast<std::size_t>(light);
  if (i < lights_.size()) {
    auto sample = lights_[i]->Illuminate(p.free_point, u);
    if (sample) sample->light = light;
    return sample;
  }
  i -= lights_.size();
  if (IsLamp(light)) {
    auto sample = SampleLamp(p, i, u);
    if (sample) sample->light = light;
    return sample;
  }
  if (i < triangles_.size()) {
    const EmissiveTriangle& triangle = triangles_[i];
    const R3::Vector towards = triangle.PointTowards(p.free_point, u, p.path.ray.time) - p.free_point;
    const double pdf = Pdf(triangle, towards, 1);
    if (!(pdf > 0)) return {};
    return LightSample{triangle.RadianceAlong(towards) / pdf, towards, false, pdf, light, triangle.primitive};
  }
  i -= triangles_.size();
  if (i < shapes_.size()) {
    const auto drawn = shapes_[i].SampleTowards(p.free_point, u, p.path.ray.time);
    if (!drawn) return {};
    return LightSample{drawn->radiance / drawn->pdf, drawn->towards, false, drawn->pdf, light, shapes_[i].Reached()};
  }
  if (IsUniform()) {
    const R3::Vector direction = R3::SampleUniformSphere(u);
    return LightSample{environment_->Radiance(direction) / R3::uniform_sphere_pdf, direction, true,
                       R3::uniform_sphere_pdf, light};
  }
  const Environment::Sample drawn = environment_->Draw(u);
  return LightSample{drawn.radiance / drawn.pdf, drawn.direction, true, drawn.pdf, light};
}

std::optional<LightSample> LightSampler::SampleLamp(const ShadingPoint& p, std::size_t lamp, const R2::Point& u) const {
  const auto sample = [&](const auto& light) {
    return IsOn(p, light, world_) ? std::nullopt : SampleLight(p, light, u);
  };
  return lamp < lamps_.size() ? sample(lamps_[lamp]) : sample(shapes_[lamp - lamps_.size()]);
}

void LightSampler::SampleEach(std::span<const ShadingPoint> points, int light, LightSamples& samples,
                              LightSamples::Each& pdfs) const {
  assert(!IsLamp(light));
  const std::size_t shape = static_cast<std::size_t>(light) - lights_.size() - triangles_.size();
  if (shape < shapes_.size() && shapes_[shape].CanSampleEach()) return shapes_[shape].SampleEach(samples, pdfs);
  if (IsInfinite(light) && !IsUniform()) return environment_->DrawEach(samples, pdfs);
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const auto sample =
        ReflectsLights(points[i], settings_) ? Sample(points[i], light, {samples.u[i], samples.v[i]}) : std::nullopt;
    pdfs[i] = sample ? sample->pdf : 0;
    samples.Set(i, sample ? sample->to_light : R3::Vector{}, sample ? sample->irradiance : R2::Color{});
  }
}

double LightSampler::PdfOfEnvironment(const ShadingPoint& from, const Environment::Seen& seen, bool choosing) const {
  const double pdf = IsUniform() ? R3::uniform_sphere_pdf : seen.pdf;
  return choosing ? pdf * ProbabilityOf(from, count_ - 1) : pdf;
}

std::optional<double> LightSampler::PdfOfHit(const ShadingPoint& from, const R3::Ray& ray, const ShadingPoint& hit,
                                             const World& world, bool choosing) const {
  const auto found = light_of_primitive_.find(world.PrimitiveId(hit.hit));
  if (found == light_of_primitive_.end()) return {};
  const auto [primitive, light] = *found;
  const std::size_t i = static_cast<std::size_t>(light) - lights_.size();
  const double pdf = i < triangles_.size() ? Pdf(triangles_[i], ray.direction, hit.hit.t)
                                           : shapes_[i - triangles_.size()].Pdf(
                                                 from.free_point, hit.hit.t * ray.direction, hit.at.normal, ray.time);
  return choosing ? pdf * ProbabilityOf(from, light) : pdf;
}

}  // namespace ray
