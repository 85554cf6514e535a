#include "source/integrate/Whitted.h"

#include <algorithm>
#include <numbers>

#include "source/integrate/RussianRoulette.h"
#include "source/integrate/shading/PhongColumns.h"

namespace ray {
namespace {

// The purposes of keys below a surface. Lights follow, with one key each.
enum WhittedKey : std::uint64_t {
  reflection_key,
  transmission_key,
  gloss_direction_key,
  roulette_key,
  environment_key,
  first_light_key
};
// Keys of the rays that share a reflection, and of the choice of lights. No surface has that many lights.
constexpr std::uint64_t gloss_key = camera_key - 1, chosen_lights_key = camera_key - 2;

/// The environment, reflected by kd / pi.
class LightAround : public LightSource {
 public:
  explicit LightAround(const Environment& environment) : environment_(environment) {}

  std::optional<LightSample> Sample(const ShadingPoint&, const R2::Point& u) const override {
    const Environment::Sample drawn = environment_.Draw(u);
    return LightSample{drawn.radiance / (std::numbers::pi * drawn.pdf), drawn.direction, true};
  }
  bool IsInfinite() const override { return true; }
  LightBound Bound() const override { return {.is_infinite = true}; }
  std::string Describe() const override { return "environment"; }

 private:
  const Environment& environment_;
};

/// Copies the departure of waiting paths, which outlive the point that they start from.
void KeepDeparture(const R3::Departure& departure, std::span<PendingPath> spawned, TraceState& state) {
  const R3::Departure& kept = state.departures.Add(departure);
  for (PendingPath& path : spawned)
    if (path.ray.departure == &departure) path.ray.departure = &kept;
}

}  // namespace

Whitted::Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world),
      tracer_(world, accelerator, settings.shadows),
      settings_(settings),
      has_roulette_(settings.roulette == Roulette::on),
      scene_lights_(LightsOfWhitted(world, settings)),
      lights_(LightSourcesOfWhitted(world, settings)) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
  const auto& environment = world.scene().environment;
  if (environment && !environment->IsBlack()) environment_ = std::make_unique<LightAround>(*environment);
  if (settings_.lights <= 0) return;
  std::vector<LightBound> bounds;
  for (const auto& light : lights_) bounds.push_back(light->Bound());
  tree_.emplace(std::move(bounds));
}

void Whitted::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  std::vector<ShadingPoint> points = tracer_.CameraHits(samples, state);
  std::vector<R2::Color>& sent_back = state.sent_back;
  sent_back.resize(points.size());
  Shade(points, sent_back, state);
  for (std::size_t i = 0, point = 0; i < samples.size(); ++i)
    if (state.hits[i]) {
      radiances[i] = Follow(points[point], sent_back[point], state);
      ++point;
    } else {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
    }
}

// Follows the recursion on a stack of paths that carry their throughput: depth first, the mirrored ray before the
// transmitted one.
R2::Color Whitted::Follow(const ShadingPoint& first, const R2::Color& radiance, TraceState& state) const {
  R2::Color sum = first.path.throughput * radiance;
  state.pending.clear();
  const std::size_t departures = state.departures.Count();
  int descendants = PushSpawned(first, most_descendants, state);
  while (!state.pending.empty() && !state.IsStopped()) {
    auto [ray, path] = state.pending.back();
    state.pending.pop_back();
    const auto hit = tracer_.Intersect(ray, path, state);
    if (!hit) {
      const R2::Color seen = path.throughput * Background(world_.scene(), ray.direction);
      Tracer::RecordMiss(path.record, seen, state);
      sum += seen;
      continue;
    }
    ShadingPoint p = tracer_.PointAt(ray, path, *hit, state);
    R2::Color sent_back;
    Shade({&p, 1}, {&sent_back, 1}, state);
    sum += p.path.throughput * sent_back;
    descendants += PushSpawned(p, most_descendants - descendants, state);
  }
  state.departures.Shrink(departures);
  return sum;
}

inline int Whitted::PushSpawned(const ShadingPoint& p, int room, TraceState& state) const {
  return IsDiffuse(*p.material) ? 0 : PushSpecular(p, room, state);
}

int Whitted::PushSpecular(const ShadingPoint& p, int room, TraceState& state) const {
  if (p.path.depth >= settings_.max_depth) {
    state.rays.EndAt(Luminance(p.path.throughput * SpecularReflectance(p, settings_)));
    return 0;
  }
  const std::size_t before = state.pending.size();
  Spawn(p, state);
  const std::size_t spawned = state.pending.size() - before;
  if (spawned > 0) KeepDeparture(p.departure, std::span(state.pending).last(spawned), state);
  if (room > 0) return static_cast<int>(spawned);
  state.rays.cut += spawned;
  state.pending.resize(before);
  return 0;
}

void Whitted::Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    radiances[i] = points[i].EmittedAndAmbient(world_);
    Tracer::RecordHit(points[i], points[i].path.throughput * radiances[i], state);
  }
  if (tree_) {
    AddChosenLights(points, radiances, state);
  } else {
    std::uint64_t which = first_light_key;
    for (const auto& light : lights_) AddLight(*light, which++, points, radiances, state);
  }
  if (environment_) AddLight(*environment_, environment_key, points, radiances, state);
}

void Whitted::AddLight(const LightSource& light, std::uint64_t which, std::span<const ShadingPoint> points,
                       std::span<R2::Color> radiances, TraceState& state) const {
  const bool is_extended = light.IsExtended();
  const auto count = static_cast<std::uint32_t>(is_extended ? settings_.shadow_samples : 1);
  state.arrived.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ShadingPoint& p = points[i];
    if (!p.HasReflectance()) continue;
    if (!is_extended) {
      AddSample(light, p, i, {}, 1, state);
      continue;
    }
    if (!light.MayShineOn(p)) continue;
    // The samples of a light from all of a pixel's camera rays are one set of points.
    const Points random = p.path.index.PointsFor(which, settings_.sampler, settings_.samples, count);
    for (std::uint32_t k = 0; k < count && !state.IsStopped(); k += LightSamples::most)
      AddSamples(light, p, i, random, p.path.index.FirstOf(count) + k, std::min(count - k, LightSamples::most),
                 1.0 / count, state);
  }
  AddArrived(radiances, state);
}

void Whitted::AddChosenLights(std::span<const ShadingPoint> points, std::span<R2::Color> radiances,
                              TraceState& state) const {
  const auto count = static_cast<std::uint32_t>(settings_.lights);
  state.arrived.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ShadingPoint& p = points[i];
    if (!p.HasReflectance()) continue;
    const Points random_points = p.path.index.PointsFor(chosen_lights_key, settings_.sampler, settings_.samples, count);
    for (std::uint32_t k = 0; k < count && !state.IsStopped(); ++k) {
      const auto random = random_points.Get<3>(p.path.index.FirstOf(count) + k);
      const auto choice = tree_->Choose(p.free_point, p.N, random[2]);
      if (!choice) continue;
      AddSample(*lights_[static_cast<std::size_t>(choice->light)], p, i, {random[0], random[1]},
                1 / (choice->probability * count), state);
    }
  }
  AddArrived(radiances, state);
}

void Whitted::AddSample(const LightSource& light, const ShadingPoint& p, std::size_t index, const R2::Point& u,
                        double weight, TraceState& state) const {
  const auto sample = light.Sample(p, u);
  if (!sample) return;
  const bool is_around = &light == environment_.get();
  const R2::Color unweighted = is_around ? DiffuseReflection(p, sample->to_light) * sample->irradiance
                                         : PhongReflection(p, Unit(sample->to_light), sample->irradiance);
  if (IsBlack(unweighted)) return;
  const R2::Color reflected = weight * unweighted;
  tracer_.AddShadowRay(
      p, index, sample->Target(), reflected, p.path.throughput, [&] { return light.Describe(); }, state);
}

void Whitted::AddSamples(const LightSource& light, const ShadingPoint& p, std::size_t index, const Points& random,
                         std::uint64_t first, std::uint32_t count, double weight, TraceState& state) const {
  const Light* of_scene = light.OfScene();
  if (!of_scene) {
    for (std::uint32_t k = 0; k < count; ++k) AddSample(light, p, index, random.Get2D(first + k), weight, state);
    return;
  }
  LightSamples samples;
  samples.count = count;
  random.GetEach2D(first, count, samples.random.column[0], samples.random.column[1]);
  for (std::uint32_t i = 0; i < count; ++i) samples.from.Set(i, p.free_point);
  of_scene->IlluminateEach(samples);
  ReflectByPhong(p, weight, samples);
  ShadowStarts starts;
  MakeShadowStarts(p, samples, starts);
  const ShadowOrigin origin(p);
  tracer_.AddShadowRays([&](std::uint32_t) -> const ShadowOrigin& { return origin; },
                        [=](std::uint32_t) { return index; }, samples, starts, {}, p.path.throughput,
                        [&] { return light.Describe(); }, state);
}

void Whitted::AddArrived(std::span<R2::Color> radiances, TraceState& state) const {
  tracer_.TraceShadowRays(state);
  for (std::size_t i = 0; i < radiances.size(); ++i) radiances[i] += state.arrived[i];
}

void Whitted::Spawn(const ShadingPoint& p, TraceState& state) const {
  const SpecularWeights weights = SpecularWeightsOf(p, settings_);
  // Pushed first, traced last.
  const SampleIndex through = p.path.index.Child(transmission_key), back = p.path.index.Child(reflection_key);
  if (const auto throughput = Continued(p.path.throughput * weights.transmitted, through, state))
    if (const auto wi = Refraction(p))
      state.pending.push_back({SpawnRay(p, *wi), Extend(p, Lobe::transmission, *throughput, through)});
  if (const auto throughput = Continued(p.path.throughput * weights.reflected, back, state)) {
    if (p.material->gloss_samples > 1) return SpawnGlossy(p, *throughput, back, state.pending);
    const bool glossy = IsGlossy(*p.material, settings_);
    const Points points(settings_.sampler, back.key.Child(gloss_direction_key), settings_.samples);
    if (const auto wi = SampleReflection(p, glossy, glossy ? points.Get2D(back.sample) : R2::Point{}))
      state.pending.push_back({SpawnRay(p, *wi), Extend(p, Lobe::mirror, *throughput, back)});
  }
}

/// Spawns several rays that share a reflection.
void Whitted::SpawnGlossy(const ShadingPoint& p, const R2::Color& throughput, const SampleIndex& back,
                          std::vector<PendingPath>& pending) const {
  const auto count = static_cast<std::uint32_t>(p.material->gloss_samples);
  const Points points = back.PointsFor(gloss_direction_key, settings_.sampler, settings_.samples, count);
  const SampleIndex each = back.Child(gloss_key);
  for (std::uint32_t k = 0; k < count; ++k)
    if (const auto wi = SampleReflection(p, true, points.Get2D(back.FirstOf(count) + k)))
      pending.push_back({SpawnRay(p, *wi), Extend(p, Lobe::mirror, throughput / count, each.Child(k))});
}

inline std::optional<R2::Color> Whitted::Continued(const R2::Color& throughput, const SampleIndex& index,
                                                   TraceState& state) const {
  const double luminance = Luminance(throughput);
  if (!(luminance > 0)) return {};
  if (luminance >= settings_.min_luminance) return throughput;
  if (!has_roulette_) {
    state.rays.EndAt(luminance);
    return {};
  }
  const Points points(settings_.sampler, index.key.Child(roulette_key), settings_.samples);
  return RussianRoulette(throughput, luminance / settings_.min_luminance, points.Get2D(index.sample).x);
}

extern const IntegratorKind whitted_kind{"Whitted ray tracing: direct light, mirror reflection, refraction",
                                         [](const World& world, const Accelerator& accelerator,
                                            const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                           return std::make_unique<Whitted>(world, accelerator, settings);
                                         }};

}  // namespace ray
