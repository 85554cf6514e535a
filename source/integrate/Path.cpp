#include "source/integrate/Path.h"

#include <algorithm>
#include <utility>

#include "source/integrate/Bsdf.h"
#include "source/integrate/RussianRoulette.h"

namespace ray {
namespace {

// Russian roulette begins after so many bounces.
constexpr std::int64_t first_bounce_at_risk = 2;

}  // namespace

Path::Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world),
      tracer_(world, accelerator, settings.shadows),
      settings_(settings),
      lights_(world, settings),
      caustics_(CausticsOf(world, settings)),
      sampled_{settings.strategy != LightStrategy::bsdf,
               settings.strategy == LightStrategy::mis || settings.strategy == LightStrategy::bsdf},
      has_roulette_(settings.roulette != Roulette::off),
      lights_at_once_(LightsChosenByPath(settings, lights_.Count())) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
}

void Path::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  std::vector<ShadingPoint> points = tracer_.CameraHits(samples, state);
  auto point = points.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!state.hits[i]) {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
      continue;
    }
    radiances[i] = EmittedAndAmbient(*point, state);
    radiances[i] += DirectLight(*point, Bsdf(*point, settings_), state);
    radiances[i] += IndirectLight(std::move(*point++), state);
  }
}

R2::Color Path::EmittedAndAmbient(const ShadingPoint& p, TraceState& state) const {
  const R2::Color seen = p.path.throughput * p.EmittedAndAmbient(world_);
  Tracer::RecordHit(p, seen, state);
  return seen;
}

/// The loop of path tracing.
R2::Color Path::IndirectLight(ShadingPoint&& p, TraceState& state) const {
  R2::Color radiance;
  for (bool is_first = true;; is_first = false) {
    const Bsdf bsdf(p, settings_);
    if (!is_first) radiance += DirectLight(p, bsdf, state);
    if (IsLast(p)) CountCutThroughput(p, state);
    if (!MayContinue(p)) return radiance;
    const Points points(settings_.sampler, p.path.index.key.Child(scatter_key), settings_.samples);
    const Choices choices = points.Get<4>(p.path.index.sample);
    auto step = SampleBsdf(p, bsdf, choices, DiffuseDirection(p.N, {choices[0], choices[1]}));
    if (!step) return radiance;
    const auto hit = tracer_.Intersect(step->path, state);
    if (!hit) return radiance + BackgroundSeen(p, *step, state);
    ShadingPoint next = tracer_.PointAt(step->path, *hit, state);
    AddEmitted(p, *step, next, radiance, state);
    if (IsLast(p)) return radiance;
    p = std::move(next);
  }
}

void Path::CountCutThroughput(const ShadingPoint& p, TraceState& state) const {
  state.rays.EndAt(Luminance(p.path.throughput * (p.kd + SpecularReflectance(p, settings_))));
}

std::optional<Path::Step> Path::SampleBsdf(const ShadingPoint& p, const Bsdf& bsdf, const Choices& choices,
                                           const R3::Vector& diffuse) const {
  const auto scattered = bsdf.Sample({choices[0], choices[1]}, choices[2], diffuse);
  if (!scattered || (IsLast(p) && IsSpecular(scattered->lobe))) return {};
  const R2::Color throughput = p.path.throughput * scattered->value / scattered->pdf;
  const auto surviving =
      RussianRoulette(throughput, std::max(LeastSurvival(p.path.depth), SurvivalProbability(throughput)), choices[3]);
  if (!surviving || IsBlack(*surviving)) return {};
  const Step step = ExtendPath(p, scattered->wi, scattered->lobe, scattered->pdf, *surviving);
  if (!MayFindLight(p, step)) return {};
  return step;
}

R2::Color Path::BackgroundSeen(const ShadingPoint& from, const Step& step, TraceState& state) const {
  const R3::Vector& direction = step.path.ray.direction;
  const Environment* environment = lights_.environment();
  const R2::Color emitted = environment ? EnvironmentSeen(environment->SeenTowards(direction), from, step, state)
                                        : step.path.throughput * Background(world_.scene(), direction);
  Tracer::RecordMiss(step.path, emitted, state);
  return emitted;
}

R2::Color Path::EnvironmentSeen(const Environment::Seen& seen, const ShadingPoint& from, const Step& step,
                                TraceState& state) const {
  CountCaustic(step, seen.radiance, state);
  const R2::Color reaching = step.path.throughput * seen.radiance;
  if (IsSpecular(step.lobe)) return reaching;
  const double light_pdf = lights_.PdfOfEnvironment(from, seen, lights_at_once_ > 0);
  if (light_pdf == 0) return reaching;  // found by scattering alone
  return sampled_.WeightOfBsdf(step.pdf, light_pdf * std::max(1, lights_at_once_)) * reaching;
}

void Path::AddEmitted(const ShadingPoint& from, const Step& step, const ShadingPoint& hit, R2::Color& radiance,
                      TraceState& state) const {
  CountCaustic(step, hit.material->emission, state);
  const R2::Color emitted = Emitted(from, step, hit);
  const R2::Color ambient =
      IsLast(from) ? R2::Color{} : hit.path.throughput * hit.AmbientReflectance(world_) * world_.scene().ambient;
  Tracer::RecordHit(hit, emitted + ambient, state);
  radiance += emitted;
  radiance += ambient;
}

double Path::LeastSurvival(std::int64_t depth) const {
  return has_roulette_ && depth + 1 >= first_bounce_at_risk ? 0 : 1;
}

R2::Color Path::DirectLight(const ShadingPoint& p, const Bsdf& bsdf, TraceState& state) const {
  state.arrived.assign(1, {});
  SampleLights(p, bsdf, 0, state);
  tracer_.TraceShadowRays(state);
  return state.arrived[0];
}

void Path::SampleLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const {
  if (!SamplesAllLights()) return SampleChosenLights(p, bsdf, index, state);
  if (!ReflectsLights(p, settings_)) return;
  for (int light = 0; light < lights_.Count() && !state.IsStopped(); ++light) {
    const Points points = p.path.index.PointsFor(KeyOf(light), settings_.sampler, settings_.samples);
    if (const auto sample = lights_.Sample(p, light, points.Get2D(p.path.index.sample)))
      AddLightSample(p, Reflected(p, bsdf, *sample), *sample, index, state);
  }
}

void Path::SampleChosenLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const {
  if (lights_.IsEmpty() || !ReflectsLights(p, settings_)) return;
  const auto count = static_cast<std::uint32_t>(lights_at_once_);
  const Points points = p.path.index.PointsFor(next_event_key, settings_.sampler, settings_.samples, count);
  for (std::uint32_t k = 0; k < count && !state.IsStopped(); ++k) {
    const auto random = points.Get<3>(p.path.index.FirstOf(count) + k);
    auto sample = lights_.SampleOne(p, {random[0], random[1]}, random[2]);
    if (!sample) continue;
    sample->irradiance = sample->irradiance / count;
    sample->pdf *= count;
    AddLightSample(p, Reflected(p, bsdf, *sample), *sample, index, state);
  }
}

R2::Color Path::Reflected(const ShadingPoint& p, const Bsdf& bsdf, const LightSample& light) const {
  const R3::Vector wi = Unit(light.to_light);
  if (light.pdf == 0) return p.HasReflectance() ? PhongReflection(p, wi, light.irradiance) : R2::Color{};
  if (!sampled_.lights) return {};
  const auto [value, pdf] = bsdf.EvalWithPdf(wi);
  return (1 - sampled_.WeightOfBsdf(pdf, light.pdf)) * value * light.irradiance;
}

void Path::AddLightSample(const ShadingPoint& p, const R2::Color& reflected, const LightSample& light,
                          std::size_t index, TraceState& state) const {
  if (IsBlack(reflected)) return;
  constexpr R2::Color no_more{1, 1, 1};
  tracer_.AddShadowRay(
      p, index, light.Target(), p.path.throughput * reflected, no_more, [&] { return lights_.Describe(light.light); },
      state);
}

R2::Color Path::Emitted(const ShadingPoint& from, const Step& step, const ShadingPoint& hit) const {
  if (IsBlack(hit.material->emission)) return {};
  const R2::Color seen = hit.path.throughput * hit.material->emission;
  // A lamp of a color is found by its samples, and shown in mirrors, which as in mode whitted go no deeper than others.
  if (lights_.EmitsColor()) return step.lobe == Lobe::diffuse || IsLast(from) ? R2::Color{} : seen;
  if (IsSpecular(step.lobe)) return seen;
  const auto light_pdf = lights_.PdfOfHit(from, hit.path.ray, hit, world_, lights_at_once_ > 0);
  if (!light_pdf) return seen;  // found by scattering alone
  return sampled_.WeightOfBsdf(step.pdf, *light_pdf * std::max(1, lights_at_once_)) * seen;
}

}  // namespace ray
