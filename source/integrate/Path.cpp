#include "source/integrate/Path.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "source/integrate/Phong.h"
#include "source/integrate/Refract.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/sample/Warp.h"

namespace ray {
namespace {

// What the places beneath a surface are for.
enum KeyUse : std::uint64_t { bounce_key, scatter_key, first_light_key };

// Before so many bounces nothing is left to chance: what is saved there is not worth its noise.
constexpr std::int64_t first_bounce_at_risk = 2;

}  // namespace

/// How a surface scatters, and with what probability each way is chosen.
struct Path::Lobes {
  SpecularWeights specular;
  double diffuse = 0, reflection = 0, transmission = 0;  // probabilities; their sum is 1, or 0 where nothing scatters
  bool is_glossy = false;
  R3::Vector mirrored;  // unit; the middle of the lobe

  /// Of a direction by the diffuse part and the lobe together, per solid angle.
  double Pdf(const ShadingPoint& s, const R3::Vector& L) const {
    const double by_lobe = is_glossy ? reflection * PowerPdf(Dot(L, mirrored), s.material->n) : 0;
    return diffuse * CosinePdf(Dot(s.N, L)) + by_lobe;
  }
  /// Radiance scattered to the viewer per radiance from unit L, the cosine included.
  R2::Color Scattered(const ShadingPoint& s, const R3::Vector& L) const {
    const double cosine = Dot(s.N, L);
    if (!(cosine > 0)) return {};
    R2::Color sum = CosinePdf(cosine) * s.kd;
    if (is_glossy) sum += PowerPdf(Dot(L, mirrored), s.material->n) * specular.reflected;
    return sum;
  }
};

/// A way that light may come from.
struct Path::Bounce {
  PathState next;
  double pdf = 0;  // of its direction, per solid angle; 0 where there was no choice
};

Path::Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world),
      accelerator_(accelerator),
      settings_(settings),
      sampler_(settings.sampler),
      lights_(world, settings),
      has_roulette_(settings.roulette != Roulette::off),
      finds_lights_(settings.strategy != LightStrategy::bsdf),
      finds_by_scattering_(settings.strategy == LightStrategy::mis || settings.strategy == LightStrategy::bsdf),
      lights_at_once_(settings.lights < 0 ? 1 : settings.lights) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
}

void Path::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator_.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Book(RayKind::camera, samples.size());

  std::vector<ShadingPoint> surfaces;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    PathState first{.ray = samples[i].ray, .index = samples[i].index};
    if (state.recorder) first.record = state.recorder->Begin(first);
    if (state.hits[i]) {
      surfaces.push_back(ShadingPointAt(world_, first, *state.hits[i]));
      if (state.recorder) state.recorder->Hits(surfaces.back(), Shining(surfaces.back()));
    } else if (state.recorder) {
      state.recorder->Misses(first.record, Background(world_.scene(), first.ray.direction));
    }
  }
  state.arrived.assign(surfaces.size(), {});
  for (std::size_t i = 0; i < surfaces.size(); ++i) AddLight(surfaces[i], i, state);
  TraceShadowRays(state, true);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ShadingPoint& s = surfaces[i];
    surfaces[i].radiance = Shining(s) + state.arrived[i];
  }
  auto surface = surfaces.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (state.hits[i]) {
      radiances[i] = surface->radiance;
      radiances[i] += Continue(*surface++, state);
    } else {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
    }
  }
}

/// What a surface seen by a camera ray sends back by itself.
R2::Color Path::Shining(const ShadingPoint& s) const {
  return s.path.throughput * (s.material->emission + s.material->ka * world_.scene().ambient);
}

/// All that comes to a surface over further bounces, its weight included.
R2::Color Path::Continue(ShadingPoint surface, TraceState& state) const {
  R2::Color sum;
  while (true) {
    auto bounce = Scatter(surface);
    if (!bounce) return sum;
    if (state.recorder) bounce->next.record = state.recorder->Begin(bounce->next);
    const auto hit = accelerator_.Intersect(bounce->next.ray, state.workspace);
    state.Book(bounce->next.kind, 1);
    if (!hit) {
      const R2::Color seen = EmittedByEnvironment(surface, *bounce);
      if (state.recorder) state.recorder->Misses(bounce->next.record, seen);
      return sum += seen;
    }
    const ShadingPoint next = ShadingPointAt(world_, bounce->next, *hit);
    const R2::Color emitted = Emitted(surface, *bounce, next);
    sum += emitted;
    const bool is_last = next.path.depth > settings_.max_depth;
    const R2::Color ambient = next.path.throughput * next.material->ka * world_.scene().ambient;
    if (state.recorder) state.recorder->Hits(next, is_last ? emitted : emitted + ambient);
    if (is_last) return sum;
    sum += ambient;
    state.arrived.assign(1, {});
    AddLight(next, 0, state);
    TraceShadowRays(state, false);
    sum += state.arrived[0];
    surface = next;
  }
}

Path::Lobes Path::LobesOf(const ShadingPoint& s) const {
  Lobes lobes;
  lobes.specular = SpecularWeightsOf(s, settings_.fresnel);
  const double d = Luminance(s.kd), r = Luminance(lobes.specular.reflected), t = Luminance(lobes.specular.transmitted);
  const double sum = d + r + t;
  if (sum > 0) {
    lobes.diffuse = d / sum;
    lobes.reflection = r / sum;
    lobes.transmission = t / sum;
  }
  lobes.is_glossy = settings_.glossy && r > 0;
  if (r > 0) lobes.mirrored = Unit(Reflect(-s.wo, s.N));
  return lobes;
}

void Path::AddLight(const ShadingPoint& s, std::size_t index, TraceState& state) const {
  if (lights_.IsEmpty() || (IsBlack(s.kd) && IsBlack(s.material->ks))) return;
  const Lobes lobes = LobesOf(s);
  const std::uint32_t i = s.path.index.sample;
  if (lights_at_once_ == 0) {
    for (int light = 0; light < lights_.Count(); ++light) {
      const std::uint64_t which = first_light_key + static_cast<std::uint64_t>(light);
      const Points points = s.path.index.PointsFor(which, sampler_, settings_.samples);
      if (const auto sample = lights_.Sample(s, light, points.Get2D(i)))
        AddLightSample(s, lobes, *sample, index, state);
    }
    return;
  }
  const auto count = static_cast<std::uint32_t>(lights_at_once_);
  const Points points = s.path.index.PointsFor(first_light_key, sampler_, settings_.samples, count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto random = points.Get<3>(i * count + k);
    auto sample = lights_.SampleOne(s, {random[0], random[1]}, random[2]);
    if (!sample) continue;
    sample->arriving = sample->arriving / count;
    sample->pdf *= count;
    AddLightSample(s, lobes, *sample, index, state);
  }
}

void Path::AddLightSample(const ShadingPoint& s, const Lobes& lobes, const PathLightSample& light, std::size_t index,
                          TraceState& state) const {
  const R3::Vector L = Unit(light.to_light);
  R2::Color reflected;
  if (light.pdf == 0) {
    reflected = PhongReflection(*s.material, s.kd, s.N, L, s.wo, light.arriving);
  } else {
    if (!finds_lights_) return;
    const double share = 1 - MisWeight(lobes.Pdf(s, L), light.pdf);
    reflected = share * lobes.Scattered(s, L) * light.arriving;
  }
  if (IsBlack(reflected)) return;
  state.shadow_rays.push_back(ShadowRay(s, light.to_light, light.is_infinite));
  state.shadows.push_back({index, s.path.throughput * reflected});
  if (state.recorder) [[unlikely]]
    state.recorder->BeginShadow(s, state.shadow_rays.back(), state.shadows.back().reflected,
                                lights_.Describe(light.light));
}

void Path::TraceShadowRays(TraceState& state, bool together) const {
  const std::size_t count = state.shadow_rays.size();
  state.are_occluded.assign(count, 0);
  if (settings_.shadows && count > 0) {
    if (together) {
      constexpr std::size_t most = 64;
      std::array<bool, most> are{};
      for (std::size_t i = 0; i < count; i += most) {
        const std::size_t n = std::min(most, count - i);
        accelerator_.IsOccluded(std::span(state.shadow_rays).subspan(i, n), are.data(), state.workspace);
        std::copy_n(are.begin(), n, state.are_occluded.begin() + static_cast<std::ptrdiff_t>(i));
      }
    } else {
      for (std::size_t i = 0; i < count; ++i)
        state.are_occluded[i] = accelerator_.IsOccluded(state.shadow_rays[i], state.workspace);
    }
    state.Book(RayKind::shadow, count);
  }
  if (state.recorder) [[unlikely]]
    state.recorder->EndShadows([&](std::size_t i) { return state.are_occluded[i] != 0; }, world_, accelerator_,
                               state.workspace);
  for (std::size_t i = 0; i < count; ++i)
    if (!state.are_occluded[i]) state.arrived[state.shadows[i].surface] += state.shadows[i].reflected;
  state.shadow_rays.clear();
  state.shadows.clear();
}

std::optional<Path::Bounce> Path::Scatter(const ShadingPoint& s) const {
  // Beyond the last bounce a ray is still of use where it may find a light that scattering is to find.
  const bool is_last = s.path.depth >= settings_.max_depth;
  if (is_last && !lights_.CanBeHit()) return {};
  const Lobes lobes = LobesOf(s);
  const Points points(sampler_, s.path.index.key.Child(scatter_key), settings_.samples);
  const auto random = points.Get<4>(s.path.index.sample);
  const R2::Point place{random[0], random[1]};
  const double way = random[2];
  std::optional<Bounce> bounce;
  if (way < lobes.diffuse) {
    bounce = ScatterMatte(s, lobes, place, false);
  } else if (way < lobes.diffuse + lobes.reflection && lobes.is_glossy) {
    bounce = ScatterMatte(s, lobes, place, true);
  } else if (is_last) {
    return {};
  } else if (way < lobes.diffuse + lobes.reflection) {
    bounce.emplace();
    bounce->next.ray = SpawnRay(s, lobes.mirrored);
    bounce->next.throughput = s.path.throughput * lobes.specular.reflected / lobes.reflection;
    bounce->next.kind = RayKind::reflection;
  } else if (lobes.transmission > 0) {
    bounce.emplace();
    bounce->next.throughput = s.path.throughput * lobes.specular.transmitted / lobes.transmission;
    bounce->next.kind = RayKind::transmission;
    if (s.material->ir == 1) {
      bounce->next.ray = s.path.ray;
      bounce->next.ray.t_min = s.hit.t;
    } else if (const auto bent = Refract(-s.wo, s.N, s.entering ? 1 / s.material->ir : s.material->ir)) {
      bounce->next.ray = SpawnRay(s, *bent);
    } else {
      return {};
    }
  }
  if (!bounce) return {};
  bounce->next.depth = s.path.depth + 1;
  bounce->next.record = s.path.record;
  bounce->next.index = s.path.index.Child(bounce_key);
  if (!Survives(bounce->next, random[3])) return {};
  return bounce;
}

std::optional<Path::Bounce> Path::ScatterMatte(const ShadingPoint& s, const Lobes& lobes, const R2::Point& random,
                                               bool by_lobe) const {
  const R3::Vector L = by_lobe ? FromTangents(OnPowerLobe(random, s.material->n), lobes.mirrored)
                               : FromTangents(OnCosineHemisphere(random), s.N);
  const double pdf = lobes.Pdf(s, L);
  const R3::Vector outward = s.entering ? AsVector(s.at.normal) : -AsVector(s.at.normal);
  // What heads into the surface, by the lobe or by a smoothed normal, is lost there.
  if (!(pdf > 0) || !(Dot(outward, L) > 0)) return {};
  Bounce bounce;
  bounce.pdf = pdf;
  bounce.next.ray = SpawnRay(s, L);
  bounce.next.throughput = s.path.throughput * lobes.Scattered(s, L) / pdf;
  bounce.next.kind = by_lobe ? RayKind::reflection : RayKind::scattering;
  if (IsBlack(bounce.next.throughput)) return {};
  return bounce;
}

bool Path::Survives(PathState& ray, double random) const {
  if (!has_roulette_ || ray.depth < first_bounce_at_risk) return true;
  const double chance = std::min(1.0, std::max({ray.throughput.r, ray.throughput.g, ray.throughput.b}));
  if (!(random < chance)) return false;
  ray.throughput = ray.throughput / chance;
  return true;
}

double Path::MisWeight(double density_of_scattering, double density_of_light) const {
  if (!finds_by_scattering_) return 0;
  if (!finds_lights_) return 1;
  return density_of_scattering / (density_of_scattering + density_of_light);
}

R2::Color Path::Emitted(const ShadingPoint& from, const Bounce& bounce, const ShadingPoint& hit) const {
  if (IsBlack(hit.material->emission)) return {};
  const R2::Color seen = hit.path.throughput * hit.material->emission;
  if (bounce.pdf == 0) return seen;
  const double by_light = lights_.PdfOfHit(from, bounce.next.ray, hit, world_, lights_at_once_ > 0);
  if (by_light == 0) return {};  // it is seen but lights nothing
  return MisWeight(bounce.pdf, by_light * std::max(1, lights_at_once_)) * seen;
}

R2::Color Path::EmittedByEnvironment(const ShadingPoint& from, const Bounce& bounce) const {
  const R3::Vector& direction = bounce.next.ray.direction;
  const R2::Color seen = bounce.next.throughput * Background(world_.scene(), direction);
  if (bounce.pdf == 0) return seen;
  const double by_light = lights_.PdfOfEnvironment(from, direction, lights_at_once_ > 0);
  if (by_light == 0) return seen;  // a background is found by scattering alone
  return MisWeight(bounce.pdf, by_light * std::max(1, lights_at_once_)) * seen;
}

}  // namespace ray
