#include "source/integrate/Path.h"

#include <algorithm>

#include "R3/Numeric.h"
#include "source/integrate/RussianRoulette.h"

namespace ray {
namespace {

constexpr std::size_t most_paths = R1::batch_size;
constexpr std::int64_t first_bounce_at_risk = 2;  // of Russian roulette

R3_VECTORIZED
void TurnAboutNormals(const VectorOfEach& normals, const PointsOfEach<4>& random, std::size_t count,
                      VectorOfEach& directions) {
  for (std::size_t i = 0; i < count; ++i)
    directions.Set(i, DiffuseDirection(normals[i], {random.coordinates[0][i], random.coordinates[1][i]}));
}

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
  const std::size_t together = state.recorder ? 1 : most_paths;  // a recorder hears of one path after the other
  for (std::size_t i = 0; i < samples.size(); i += together) {
    const std::size_t count = std::min(samples.size() - i, together);
    TraceTogether(samples.subspan(i, count), radiances.subspan(i, count), state);
  }
}

void Path::TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                         TraceState& state) const {
  PathFront fronts[2];
  PathFront *front = &fronts[0], *next = &fronts[1];
  next->points.reserve(samples.size());
  SeeFirstSurfaces(samples, radiances, *front, state);
  const std::vector<std::uint32_t> paths = front->paths;
  std::array<R2::Color, most_paths> gathered{};  // beyond the first surface
  for (bool is_first = true; !front->points.empty(); is_first = false) {
    front->MakeColumns(settings_);
    SampleLights(*front, state);
    for (std::size_t i = 0; i < front->points.size(); ++i)
      (is_first ? radiances[front->paths[i]] : gathered[front->paths[i]]) += state.arrived[i];
    next->Clear();
    TakeStep(*front, gathered, *next, state);
    std::swap(front, next);
  }
  for (const std::uint32_t path : paths) radiances[path] += gathered[path];
}

void Path::SeeFirstSurfaces(std::span<const CameraSample> samples, std::span<R2::Color> radiances, PathFront& front,
                            TraceState& state) const {
  front.points = tracer_.CameraHits(samples, state);
  for (std::uint32_t i = 0, point = 0; i < samples.size(); ++i) {
    if (!state.hits[i]) {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
      continue;
    }
    const ShadingPoint& p = front.points[point++];
    radiances[i] = p.path.throughput * p.EmittedAndAmbient(world_);
    Tracer::RecordHit(p, radiances[i], state);
    front.paths.push_back(i);
  }
}

void Path::SampleLights(PathFront& front, TraceState& state) const {
  state.arrived.assign(front.points.size(), {});
  if (SamplesAllLights()) {
    if (!lights_.IsEmpty() && lights_.SceneLight(0)) front.MakeColumnsOfHighlights();  // those lights come first
    for (int light = 0; light < lights_.Count() && !state.IsStopped(); ++light) SampleLight(light, front, state);
  } else {
    SampleChosenLights(front, state);
  }
  tracer_.TraceShadowRays(state);
}

void Path::SampleLight(int light, const PathFront& front, TraceState& state) const {
  PointsOfEach<2> random;
  if (lights_.IsExtended(light))
    GetOfEach(front.indices, KeyOf(light), settings_.sampler, settings_.samples, random);
  else
    random = {};
  if (lights_.IsLamp(light)) return SampleLamp(light, front, random, state);
  LightSamples samples;
  samples.count = static_cast<std::uint32_t>(front.points.size());
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    samples.SetFrom(i, front.points[i].free_point);
    samples.u[i] = random.coordinates[0][i], samples.v[i] = random.coordinates[1][i];
  }
  if (const Light* of_scene = lights_.SceneLight(light)) {
    of_scene->IlluminateEach(samples);
    ReflectByPhong(front, samples);
  } else {
    alignas(64) LightSamples::Each pdfs;
    lights_.SampleEach(front.points, light, samples, pdfs);
    Reflect(front, pdfs, samples);
  }
  const bool is_infinite = lights_.IsInfinite(light);
  const std::int64_t reached = lights_.Reached(light);
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const R2::Color reflected = samples.Color(i);
    if (IsBlack(reflected)) continue;
    constexpr R2::Color no_more{1, 1, 1};
    tracer_.AddShadowRay(
        front.points[i], i, {.to_light = samples.ToLight(i), .is_infinite = is_infinite, .reaching = reached},
        front.throughputs[i] * reflected, no_more, [&] { return lights_.Describe(light); }, state);
  }
}

void Path::SampleLamp(int lamp, const PathFront& front, const PointsOfEach<2>& random, TraceState& state) const {
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const ShadingPoint& p = front.points[i];
    if (!ReflectsLights(p, settings_)) continue;
    if (const auto sample = lights_.Sample(p, lamp, random.Get2D(i)))
      AddLightSample(p, Reflected(p, Bsdf(p, settings_), *sample), *sample, i, state);
  }
}

void Path::Reflect(const PathFront& front, const LightSamples::Each& pdfs, LightSamples& samples) const {
  if (!sampled_.lights) {
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.SetColor(i, {});
    return;
  }
  front.ReflectDiffusely(sampled_.bsdf ? 1 : 0, pdfs, samples);
  for (std::size_t k = 0; k < front.others.size(); ++k) {
    const std::uint32_t i = front.others[k];
    const LightSample sample{samples.Color(i), samples.ToLight(i), false, pdfs[i]};
    if (!IsBlack(sample.irradiance)) samples.SetColor(i, Reflected(front.points[i], front.bsdfs[k], sample));
  }
}

void Path::ReflectByPhong(const PathFront& front, LightSamples& samples) const {
  front.ReflectByPhong(samples);
  for (const std::uint32_t i : front.others_by_phong) {
    const ShadingPoint& p = front.points[i];
    const bool is_lit = p.HasReflectance() && !IsBlack(samples.Color(i));
    samples.SetColor(i, is_lit ? PhongReflection(p, Unit(samples.ToLight(i)), samples.Color(i)) : R2::Color{});
  }
}

void Path::SampleChosenLights(const PathFront& front, TraceState& state) const {
  auto bsdf = front.bsdfs.begin();
  for (std::size_t i = 0; i < front.points.size(); ++i)
    if (front.are_diffuse[i] != 0)
      SampleChosenLights(front.points[i], Bsdf(front.points[i], settings_), i, state);
    else
      SampleChosenLights(front.points[i], *bsdf++, i, state);
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

void Path::TakeStep(const PathFront& front, std::span<R2::Color> gathered, PathFront& next, TraceState& state) const {
  const std::span<const ShadingPoint> points = front.points;
  if (IsLast(points[0]))  // all have gone as far
    for (const ShadingPoint& p : points) CountCutThroughput(p, state);
  if (!MayContinue(points[0])) return;
  StepsByLobe steps_by_lobe = SampleBsdfs(front);
  std::array<const Step*, most_paths> arriving, escaping;
  std::size_t escaped = 0;
  for (Steps& steps : steps_by_lobe) {
    TraceSteps(steps, state);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      tracer_.Arrive(steps[k].path, state.hits[k], state);
      if (state.hits[k]) {
        arriving[next.points.size()] = &steps[k];
        next.Add(steps[k].path, *state.hits[k], front.paths[steps[k].from]);
      } else {
        escaping[escaped++] = &steps[k];
      }
    }
  }
  AddBackgrounds(front, {escaping.data(), escaped}, gathered, state);
  tracer_.Complete(next.points, state);
  for (std::size_t i = 0; i < next.points.size(); ++i)
    AddEmitted(points[arriving[i]->from], *arriving[i], next.points[i], gathered[next.paths[i]], state);
  if (IsLast(points[0])) next.Clear();
}

Path::StepsByLobe Path::SampleBsdfs(const PathFront& front) const {
  PointsOfEach<4> random;
  GetOfEachAlone(front.indices, scatter_key, settings_.sampler, settings_.samples, random);
  const auto& u = random.coordinates;
  VectorOfEach directions;
  TurnAboutNormals(front.normals, random, front.points.size(), directions);
  const std::int64_t depth = front.points[0].path.depth;  // all have gone as far
  const PathFront::Scattered scattered = front.ScatterDiffusely(LeastSurvival(depth), u[3], directions);
  StepsByLobe steps;
  for (Steps& of_lobe : steps) of_lobe.reserve(front.others.size());
  Steps& diffuse = steps[static_cast<std::size_t>(Lobe::diffuse)];
  diffuse.reserve(front.points.size());
  for (std::uint32_t i = 0; i < front.points.size(); ++i) {
    const ShadingPoint& p = front.points[i];
    const R2::Color throughput = scattered.throughputs[i];
    if (IsBlack(throughput) || p.IsBehindSurface(directions[i])) continue;
    diffuse.push_back(ExtendPath(p, directions[i], Lobe::diffuse, scattered.pdfs[i], throughput, i));
    if (!MayFindLight(p, diffuse.back())) diffuse.pop_back();
  }
  for (std::size_t k = 0; k < front.others.size(); ++k) {
    const std::uint32_t i = front.others[k];
    const auto step =
        SampleBsdf(front.points[i], front.bsdfs[k], {u[0][i], u[1][i], u[2][i], u[3][i]}, directions[i], i);
    if (step) steps[static_cast<std::size_t>(step->lobe)].push_back(*step);
  }
  return steps;
}

std::optional<Path::Step> Path::SampleBsdf(const ShadingPoint& p, const Bsdf& bsdf,
                                           const std::array<double, 4>& choices, const R3::Vector& diffuse,
                                           std::uint32_t from) const {
  const auto scattered = bsdf.Sample({choices[0], choices[1]}, choices[2], diffuse);
  if (!scattered || (IsLast(p) && IsSpecular(scattered->lobe))) return {};
  const R2::Color throughput = p.path.throughput * scattered->value / scattered->pdf;
  const auto surviving =
      RussianRoulette(throughput, std::max(LeastSurvival(p.path.depth), SurvivalProbability(throughput)), choices[3]);
  if (!surviving || IsBlack(*surviving)) return {};
  const Step step = ExtendPath(p, scattered->wi, scattered->lobe, scattered->pdf, *surviving, from);
  if (!MayFindLight(p, step)) return {};
  return step;
}

void Path::TraceSteps(Steps& steps, TraceState& state) const {
  state.hits.resize(steps.size());
  if (steps.empty()) return;
  state.batch.clear();
  for (Step& step : steps) {
    Tracer::RecordRay(step.path, state);
    state.batch.push_back(step.path.ray);
  }
  tracer_.IntersectEach(steps[0].path.kind, state.batch, state.hits.data(), state);
}

void Path::AddBackgrounds(const PathFront& front, std::span<const Step* const> steps, std::span<R2::Color> gathered,
                          TraceState& state) const {
  const auto add = [&](const Step& step, const R2::Color& seen) {
    gathered[front.paths[step.from]] += seen;
    Tracer::RecordMiss(step.path, seen, state);
  };
  const Environment* environment = lights_.environment();
  if (!environment) {
    for (const Step* step : steps)
      add(*step, step->path.throughput * Background(world_.scene(), step->path.ray.direction));
    return;
  }
  LightSamples seen;
  alignas(64) LightSamples::Each pdfs;
  seen.count = static_cast<std::uint32_t>(steps.size());
  for (std::uint32_t i = 0; i < seen.count; ++i) seen.Set(i, steps[i]->path.ray.direction, {});
  environment->SeeEach(seen, pdfs);
  for (std::uint32_t i = 0; i < seen.count; ++i)
    add(*steps[i], EnvironmentSeen({seen.Color(i), pdfs[i]}, front.points[steps[i]->from], *steps[i], state));
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

double Path::LeastSurvival(std::int64_t depth) const {
  return has_roulette_ && depth + 1 >= first_bounce_at_risk ? 0 : 1;
}

void Path::CountCutThroughput(const ShadingPoint& p, TraceState& state) const {
  state.rays.EndAt(Luminance(p.path.throughput * (p.kd + SpecularReflectance(p, settings_))));
}

extern const IntegratorKind path_kind{"path tracing: light over many bounces",
                                      [](const World& world, const Accelerator& accelerator,
                                         const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                        return std::make_unique<Path>(world, accelerator, settings);
                                      }};

}  // namespace ray
