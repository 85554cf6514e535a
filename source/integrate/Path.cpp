#include "source/integrate/Path.h"

#include <algorithm>
#include <new>

#include "source/integrate/RussianRoulette.h"
#include "source/integrate/SharedPaths.h"

namespace ray {
namespace {

constexpr std::size_t most_paths = R1::batch_size;
constexpr R2::Color no_more{1, 1, 1};             // of light that has its full throughput
constexpr std::int64_t first_bounce_at_risk = 2;  // of ending by Russian roulette

}  // namespace

Path::Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world),
      tracer_(world, accelerator, settings.shadows),
      settings_(settings),
      lights_(world, settings),
      caustics_(CausticsOf(world, settings)),
      traits_(world.scene().materials),
      sampled_{settings.strategy != LightStrategy::bsdf,
               settings.strategy == LightStrategy::mis || settings.strategy == LightStrategy::bsdf},
      has_roulette_(settings.roulette != Roulette::off),
      has_ambient_(!IsBlack(world.scene().ambient)),
      lights_at_once_(LightsChosenByPath(settings, lights_.Count())) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
}

void Path::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  const std::size_t together = state.recorder ? 1 : most_paths;  // a recorder receives one path at a time
  for (std::size_t i = 0; i < samples.size(); i += together) {
    const std::size_t count = std::min(samples.size() - i, together);
    TraceTogether(samples.subspan(i, count), radiances.subspan(i, count), i, state);
  }
}

void Path::AddShared(std::span<R2::Color> radiances, TraceState& state) const {
  state.shared->Distribute(tracer_, radiances, state);
}

void Path::TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                         std::size_t first_sample, TraceState& state) const {
  PathFront fronts[2];
  PathFront *front = &fronts[0], *next = &fronts[1];
  next->points.reserve(samples.size());
  SeeFirstSurfaces(samples, radiances, *front, state);
  const auto paths = front->paths;
  const std::size_t count = front->points.size();
  std::array<R2::Color, most_paths> gathered{};  // beyond the first surface
  for (bool is_first = true; !front->points.empty(); is_first = false) {
    front->MakeColumns(traits_, settings_);
    SampleLights(*front, state);
    for (std::size_t i = 0; i < front->points.size(); ++i)
      (is_first ? radiances[front->paths[i]] : gathered[front->paths[i]]) += state.arrived[i];
    next->Clear();
    TakeStep(*front, gathered, *next, state);
    if (is_first && state.shared) Share(*front, *next, first_sample, gathered, state);
    std::swap(front, next);
  }
  if (state.shared) state.shared->TakeLight(gathered);
  for (std::size_t i = 0; i < count; ++i) radiances[paths[i]] += gathered[paths[i]];
}

void Path::SeeFirstSurfaces(std::span<const CameraSample> samples, std::span<R2::Color> radiances, PathFront& front,
                            TraceState& state) const {
  front.points = tracer_.CameraHits(samples, state);
  for (std::uint32_t i = 0, point = 0; i < samples.size(); ++i) {
    if (!state.hits[i]) {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
      continue;
    }
    const ShadingPoint& p = front.points[point];
    radiances[i] = p.path.throughput * p.EmittedAndAmbient(world_);
    Tracer::RecordHit(p, radiances[i], state);
    front.paths[point++] = i;
  }
}

void Path::SampleLights(PathFront& front, TraceState& state) const {
  state.arrived.assign(front.points.size(), {});
  if (SamplesAllLights()) {
    if (!lights_.IsEmpty() && lights_[0].OfScene()) front.MakeColumnsOfHighlights(traits_);  // those lights come first
    for (int light = 0; light < lights_.Count() && !state.IsStopped(); ++light) SampleLight(light, front, state);
  } else {
    SampleChosenLights(front, state);
  }
  tracer_.TraceShadowRays(state);
}

void Path::SampleLight(int light, const PathFront& front, TraceState& state) const {
  const LightSource& source = lights_[light];
  PointBatch<2> random;
  if (source.IsExtended())
    GetBatch(front.Of(front.indices), KeyOf(light), settings_.sampler, settings_.samples, random);
  else
    random = {};
  const Light* of_scene = source.OfScene();
  if (!of_scene && !source.HasPdf()) return SampleLamp(light, front, random, state);
  LightSamples samples;
  samples.count = static_cast<std::uint32_t>(front.points.size());
  for (std::uint32_t i = 0; i < samples.count; ++i) samples.from.Set(i, front.points[i].free_point);
  for (std::size_t k = 0; k < 2; ++k)
    std::copy_n(random.coordinates[k].data(), samples.count, samples.random.column[k]);
  if (of_scene) {
    of_scene->IlluminateEach(samples);
    ReflectByPhong(front, samples);
  } else {
    alignas(64) LightSamples::Each pdfs;
    lights_.SampleEach(front.points, light, samples, pdfs);
    Reflect(front, pdfs, samples);
  }
  for (std::uint32_t i = 0; i < samples.count; ++i) samples.color.Set(i, front.throughputs[i] * samples.color[i]);
  ShadowStarts starts;
  MakeShadowStarts(front.normals, front.clearances, world_.scene().shadow_bias, samples, starts);
  tracer_.AddShadowRays([&](std::uint32_t i) { return ShadowOrigin(front.points[i]); },
                        [](std::uint32_t i) { return i; }, samples, starts,
                        {.to_light = {}, .is_infinite = source.IsInfinite(), .reaching = source.Reached()}, no_more,
                        [&] { return source.Describe(); }, state);
}

void Path::SampleLamp(int lamp, const PathFront& front, const PointBatch<2>& random, TraceState& state) const {
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const ShadingPoint& p = front.points[i];
    if (!ReflectsLights(p, settings_)) continue;
    if (const auto sample = lights_.Sample(p, lamp, random.Get2D(i)))
      AddLightSample(p, Reflected(p, Bsdf(p, settings_), *sample), *sample, i, state);
  }
}

void Path::Reflect(const PathFront& front, const LightSamples::Each& pdfs, LightSamples& samples) const {
  if (!sampled_.lights) {
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.color.Set(i, {});
    return;
  }
  front.ReflectDiffusely(sampled_.bsdf ? 1 : 0, pdfs, samples);
  for (std::size_t k = 0; k < front.others.size(); ++k) {
    const std::uint32_t i = front.others[k];
    const LightSample sample{samples.color[i], samples.to_light[i], false, pdfs[i]};
    if (!IsBlack(sample.irradiance)) samples.color.Set(i, Reflected(front.points[i], front.bsdfs[k], sample));
  }
}

void Path::ReflectByPhong(const PathFront& front, LightSamples& samples) const {
  std::vector<R2::Color> others;
  for (const std::uint32_t i : front.others_by_phong) {
    const ShadingPoint& p = front.points[i];
    const bool is_lit = p.HasReflectance() && !IsBlack(samples.color[i]);
    others.push_back(is_lit ? PhongReflection(p, Unit(samples.to_light[i]), samples.color[i]) : R2::Color{});
  }
  front.ReflectByPhong(samples);
  for (std::size_t k = 0; k < others.size(); ++k) samples.color.Set(front.others_by_phong[k], others[k]);
}

void Path::SampleChosenLights(const PathFront& front, TraceState& state) const {
  auto bsdf = front.bsdfs.begin();
  for (std::size_t i = 0; i < front.points.size(); ++i)
    if (front.diffuse_flags[i] != 0)
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
  tracer_.AddShadowRay(
      p, index, light.Target(), p.path.throughput * reflected, no_more, [&] { return lights_[light.light].Describe(); },
      state);
}

void Path::TakeStep(const PathFront& front, std::span<R2::Color> gathered, PathFront& next, TraceState& state) const {
  const std::span<const ShadingPoint> points = front.points;
  if (IsLast(points[0]))  // all have the same depth
    for (const ShadingPoint& p : points) CountCutThroughput(p, state);
  if (!MayContinue(points[0])) return;
  const PathFront::Scattered scattered = SampleBsdfs(front);
  std::vector<Escaping> escaping;
  escaping.reserve(points.size());
  std::uint32_t rays = 0;
  for (std::size_t lobe = 0; lobe < lobes; ++lobe)
    rays += Follow(front, scattered, static_cast<Lobe>(lobe), rays, next, escaping, state);
  AddBackgrounds(front, scattered, escaping, gathered, state);
  tracer_.Complete(next.Of(next.rays), next.points, state);
  AddEmitted(front, scattered, next, gathered, state);
  if (IsLast(points[0])) next.Clear();
}

PathFront::Scattered Path::SampleBsdfs(const PathFront& front) const {
  PointBatch<4> random;
  GetSeparateBatch(front.Of(front.indices), scatter_key, settings_.sampler, settings_.samples, random);
  const std::int64_t depth = front.points[0].path.depth;  // all have the same depth
  PathFront::Scattered scattered = front.ScatterDiffusely(LeastSurvival(depth), random);
  for (std::uint32_t i = 0; i < front.points.size(); ++i)
    if (!IsBlack(scattered.throughputs[i]) && !front.points[i].IsBehindSurface(scattered.directions[i]))
      scattered.Add(i, Lobe::diffuse);
  const auto& u = random.coordinates;
  for (std::size_t k = 0; k < front.others.size(); ++k) {
    const std::uint32_t i = front.others[k];
    SampleBsdf(front.points[i], i, front.bsdfs[k], {u[0][i], u[1][i], u[2][i], u[3][i]}, scattered);
  }
  return scattered;
}

void Path::SampleBsdf(const ShadingPoint& p, std::uint32_t i, const Bsdf& bsdf, const std::array<double, 4>& choices,
                      PathFront::Scattered& scattered) const {
  const auto sample = bsdf.Sample({choices[0], choices[1]}, choices[2], scattered.directions[i]);
  if (!sample || (IsLast(p) && IsSpecular(sample->lobe))) return;
  const R2::Color throughput = p.path.throughput * sample->value / sample->pdf;
  const auto surviving =
      RussianRoulette(throughput, std::max(LeastSurvival(p.path.depth), SurvivalProbability(throughput)), choices[3]);
  if (!surviving || IsBlack(*surviving)) return;
  scattered.directions.Set(i, sample->wi), scattered.throughputs.Set(i, *surviving), scattered.pdfs[i] = sample->pdf;
  scattered.Add(i, sample->lobe);
}

std::uint32_t Path::Follow(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe,
                           std::uint32_t first, PathFront& next, std::vector<Escaping>& escaping,
                           TraceState& state) const {
  const std::vector<std::uint32_t> from = TraceFrom(front, scattered, lobe, first, state);
  for (std::uint32_t k = 0; k < from.size(); ++k) {
    const std::uint32_t i = from[k], number = first + k;
    const ShadingPoint& p = front.points[i];
    R3::Ray& ray = state.batch[number];
    PathState path = Extend(p, lobe, scattered.throughputs[i], p.path.index.Child(bounce_key));
    Tracer::RecordRay(ray, path, state);
    if (state.hits[number]) {
      ShadingPoint& arriving = next.Add(ray, path, *state.hits[number], front.paths[i], i, number);
      if (tracer_.Arrive(ray, arriving, state)) continue;
      path = arriving.path;
      next.points.pop_back();
    }
    escaping.push_back({i, ray.direction, path.throughput, path.record});
  }
  return static_cast<std::uint32_t>(from.size());
}

std::vector<std::uint32_t> Path::TraceFrom(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe,
                                           std::uint32_t first, TraceState& state) const {
  std::vector<std::uint32_t> from = scattered.by_lobe[static_cast<std::size_t>(lobe)];
  if (from.empty()) return from;
  const std::size_t most = first + from.size();
  state.batch.resize(std::max(state.batch.size(), most)), state.hits.resize(std::max(state.hits.size(), most));
  const std::span<R3::Ray> rays = std::span(state.batch).subspan(first);
  std::size_t count = 0;
  for (const std::uint32_t i : from) {
    const ShadingPoint& p = front.points[i];
    new (&rays[count]) R3::Ray(SpawnRay(p, scattered.directions[i]));  // constructed in place
    if (MayFindLight(p, rays[count])) from[count++] = i;
  }
  from.resize(count);
  if (count > 0) tracer_.IntersectEach(KindOf(lobe), rays.first(count), state.hits.data() + first, state);
  return from;
}

void Path::AddBackgrounds(const PathFront& front, const PathFront::Scattered& scattered,
                          std::span<const Escaping> escaping, std::span<R2::Color> gathered, TraceState& state) const {
  const auto add = [&](const Escaping& ray, const R2::Color& seen) {
    gathered[front.paths[ray.from]] += seen;
    Tracer::RecordMiss(ray.record, seen, state);
  };
  const Environment* environment = lights_.environment();
  if (!environment) {
    for (const Escaping& ray : escaping) add(ray, ray.throughput * Background(world_.scene(), ray.direction));
    return;
  }
  LightSamples seen;
  alignas(64) LightSamples::Each pdfs;
  seen.count = static_cast<std::uint32_t>(escaping.size());
  for (std::uint32_t i = 0; i < seen.count; ++i) seen.Set(i, escaping[i].direction, {});
  environment->SeeEach(seen, pdfs);
  for (std::uint32_t i = 0; i < seen.count; ++i) {
    const Step step = StepFrom(front, scattered, escaping[i].from);
    add(escaping[i], EnvironmentSeen({seen.color[i], pdfs[i]}, step, escaping[i].throughput, state));
  }
}

R2::Color Path::EnvironmentSeen(const Environment::Seen& seen, const Step& step, const R2::Color& throughput,
                                TraceState& state) const {
  CountCaustic(step, seen.radiance, state);
  const R2::Color reaching = throughput * seen.radiance;
  if (IsSpecular(step.lobe)) return reaching;
  const double light_pdf = lights_.PdfOfEnvironment(step.from, seen, lights_at_once_ > 0);
  if (light_pdf == 0) return reaching;  // only scattering finds it
  return sampled_.WeightOfBsdf(step.pdf, light_pdf * std::max(1, lights_at_once_)) * reaching;
}

void Path::AddEmitted(const PathFront& front, const PathFront::Scattered& scattered, const PathFront& next,
                      std::span<R2::Color> gathered, TraceState& state) const {
  for (std::size_t i = 0; i < next.points.size(); ++i) {
    const ShadingPoint& hit = next.points[i];
    const Step step = StepFrom(front, scattered, next.from[i]);
    const bool has_ambient = has_ambient_ && !IsLast(step.from), emits = !IsBlack(hit.material->emission);
    R2::Color& of_path = gathered[next.paths[i]];
    R2::Color emitted, ambient;
    if (emits) {
      CountCaustic(step, hit.material->emission, state);
      emitted = Emitted(step, hit);
      of_path += emitted;
    }
    if (has_ambient) {
      ambient = hit.path.throughput * hit.AmbientReflectance(world_) * world_.scene().ambient;
      of_path += ambient;
    }
    Tracer::RecordHit(hit, emitted + ambient, state);
  }
}

R2::Color Path::Emitted(const Step& step, const ShadingPoint& hit) const {
  const R2::Color seen = hit.path.throughput * hit.material->emission;
  // A light with a color is found by its samples, and shown in mirrors, which as in mode whitted are no deeper than
  // others.
  if (lights_.EmitsColor()) return step.lobe == Lobe::diffuse || IsLast(step.from) ? R2::Color{} : seen;
  if (IsSpecular(step.lobe)) return seen;
  const auto light_pdf = lights_.PdfOfHit(step.from, hit, world_, lights_at_once_ > 0);
  if (!light_pdf) return seen;  // only scattering finds it
  return sampled_.WeightOfBsdf(step.pdf, *light_pdf * std::max(1, lights_at_once_)) * seen;
}

/// Returns true if the point scatters with a cosine density alone, and rays from it depend on nothing else. Paths in
/// solids do not share, nor where surfaces move, since each path has its own time.
bool Path::SharesAsFirst(const PathFront& front, std::uint32_t point) const {
  const ShadingPoint& x = front.points[point];
  return front.diffuse_flags[point] > 0 && Luminance(x.kd) > 0 && x.path.media == 0 && !x.departure.crossed;
}

void Path::Share(const PathFront& front, PathFront& next, std::size_t first_sample, std::span<R2::Color> gathered,
                 TraceState& state) const {
  if (world_.Moves() || !settings_.shadows || state.recorder) return;
  PathFront::PerPoint<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < front.points.size(); ++i)
    numbers[i] = SharesAsFirst(front, i) ? state.shared->AddFirst(front.points[i], first_sample + front.paths[i])
                                         : SharedPaths::none;
  for (std::uint32_t i = 0; i < next.points.size(); ++i) {
    ShadingPoint& y = next.points[i];
    const std::uint32_t first = numbers[next.from[i]], path = next.paths[i];
    // Shadow rays end at surfaces that the path may have passed, as inside a solid that meets another.
    const bool is_seen = y.path.media == 0 && state.hits[next.rays[i]]->t == y.hit.t;
    if (first == SharedPaths::none || !traits_[*y.material].is_diffuse || !is_seen) continue;
    const double throughput = Luminance(y.path.throughput);
    state.shared->AddSecond(y, first, path, throughput, gathered[path]);
    gathered[path] = {};
    y.path.throughput = {throughput, throughput, throughput};
  }
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
