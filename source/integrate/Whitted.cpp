#include "source/integrate/Whitted.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "source/integrate/Features.h"
#include "source/integrate/Phong.h"
#include "source/integrate/Refract.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/sample/Warp.h"

namespace ray {
namespace {

// What the places beneath a surface are for. Lights follow, one each.
enum KeyUse : std::uint64_t {
  reflection_key,
  transmission_key,
  choice_key,
  roulette_key,
  environment_key,
  first_light_key
};

constexpr std::size_t most_shadow_rays = 64;  // traced at once

bool IsExtended(const Light& light) { return light.IsExtended(); }
bool IsExtended(const EmissiveTriangle&) { return true; }
bool IsExtended(const Environment&) { return true; }

/// Whether a surface is itself the light.
bool IsOn(const ShadingPoint& s, const EmissiveTriangle& triangle, const World& world) {
  return triangle.primitive == world.PrimitiveId(s.hit);
}
template <typename Other>
bool IsOn(const ShadingPoint&, const Other&, const World&) {
  return false;
}

/// What arrives from a random place on the light, if nothing is in between.
std::optional<Illumination> LitBy(const ShadingPoint& s, const Light& light, const R2::Point& random) {
  return light.Illuminate(s.shadow_origin, random);
}
std::optional<Illumination> LitBy(const ShadingPoint& s, const EmissiveTriangle& triangle, const R2::Point& random) {
  return Illumination{triangle.emission,
                      triangle.PointTowards(s.shadow_origin, random, s.path.ray.time) - s.shadow_origin};
}
std::optional<Illumination> LitBy(const ShadingPoint&, const Environment& environment, const R2::Point& random) {
  const Environment::Sample drawn = environment.Draw(random);
  return Illumination{drawn.radiance / (std::numbers::pi * drawn.pdf), drawn.direction, true};
}

/// What the surface makes of it.
template <typename AnyLight>
R2::Color Reflection(const AnyLight&, const ShadingPoint& s, const Illumination& lit) {
  return PhongReflection(*s.material, s.kd, s.N, Unit(lit.to_light), s.wo, lit.irradiance);
}
R2::Color Reflection(const Environment&, const ShadingPoint& s, const Illumination& lit) {
  return std::max(0.0, Dot(s.N, lit.to_light)) * s.kd * lit.irradiance;
}

/// What a recording calls it.
std::string Described(const Light& light) { return light.Describe(); }
std::string Described(const EmissiveTriangle& triangle) { return triangle.Describe(); }
std::string Described(const Environment&) { return "environment"; }

bool Scatters(const ShadingPoint& s) { return !IsBlack(s.kd) || !IsBlack(s.material->ks); }

}  // namespace

Whitted::Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world),
      accelerator_(accelerator),
      settings_(settings),
      sampler_(settings.sampler),
      has_roulette_(features::roulette && settings.roulette == Roulette::on),
      triangles_(EmissiveTriangles(world)) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
  const Scene& scene = world.scene();
  for (const auto& light : scene.lights)
    if (!light->IsBlack()) lights_.push_back(light.get());
  if (scene.environment && !scene.environment->IsBlack()) environment_ = scene.environment.get();
  if (settings_.lights <= 0) return;
  std::vector<LightBound> bounds;
  for (const Light* light : lights_) bounds.push_back(light->Bound());
  for (const EmissiveTriangle& triangle : triangles_) bounds.push_back(triangle.Bound());
  tree_.emplace(std::move(bounds));
}

void Whitted::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator_.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Book(RayKind::camera, samples.size());

  std::vector<ShadingPoint> surfaces;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    PathState first{.ray = samples[i].ray, .index = samples[i].index};
    if (state.recorder) first.record = state.recorder->Begin(first);
    if (state.hits[i])
      surfaces.push_back(ShadingPointAt(world_, first, *state.hits[i]));
    else if (state.recorder)
      state.recorder->Misses(first.record, Background(world_.scene(), first.ray.direction));
  }
  Shade(surfaces, state);
  auto surface = surfaces.begin();
  for (std::size_t i = 0; i < samples.size(); ++i)
    radiances[i] = state.hits[i] ? Follow(*surface++, state) : Background(world_.scene(), samples[i].ray.direction);
}

// The recursion is unrolled onto a stack of rays that carry the product of the weights above them: depth first, the
// mirrored ray before the transmitted one.
R2::Color Whitted::Follow(const ShadingPoint& first, TraceState& state) const {
  R2::Color sum = first.path.throughput * first.radiance;
  int descendants = 0;
  state.pending.clear();
  const auto spawn = [&](const ShadingPoint& surface) {
    if (surface.path.depth >= settings_.max_depth) return;
    if (descendants >= most_descendants) {
      ++state.rays.cut;
      return;
    }
    const std::size_t before = state.pending.size();
    Spawn(surface, state);
    descendants += static_cast<int>(state.pending.size() - before);
  };
  spawn(first);
  while (!state.pending.empty()) {
    PathState current = state.pending.back();
    state.pending.pop_back();
    if (state.recorder) current.record = state.recorder->Begin(current);
    const auto hit = accelerator_.Intersect(current.ray, state.workspace);
    state.Book(current.kind, 1);
    if (!hit) {
      const R2::Color seen = current.throughput * Background(world_.scene(), current.ray.direction);
      if (state.recorder) state.recorder->Misses(current.record, seen);
      sum += seen;
      continue;
    }
    ShadingPoint surface = ShadingPointAt(world_, current, *hit);
    Shade({&surface, 1}, state);
    sum += surface.path.throughput * surface.radiance;
    spawn(surface);
  }
  return sum;
}

void Whitted::Shade(std::span<ShadingPoint> surfaces, TraceState& state) const {
  for (ShadingPoint& s : surfaces) {
    s.radiance = s.material->emission + s.material->ka * world_.scene().ambient;
    if (state.recorder) state.recorder->Hits(s, s.path.throughput * s.radiance);
  }
  if (features::choice_of_lights && tree_) {
    AddChosenLights(surfaces, state);
  } else {
    std::uint64_t which = first_light_key;
    for (const Light* light : lights_) AddLight(*light, which++, surfaces, state);
    for (const EmissiveTriangle& triangle : triangles_) AddLight(triangle, which++, surfaces, state);
  }
  if (features::environment && environment_) AddLight(*environment_, environment_key, surfaces, state);
}

template <typename AnyLight>
void Whitted::AddLight(const AnyLight& light, std::uint64_t which, std::span<ShadingPoint> surfaces,
                       TraceState& state) const {
  const auto count = static_cast<std::uint32_t>(IsExtended(light) ? settings_.shadow_samples : 1);
  state.arrived.assign(surfaces.size(), {});
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ShadingPoint& s = surfaces[i];
    if (!Scatters(s) || IsOn(s, light, world_)) continue;
    // One light's samples from all of a pixel's camera rays are one set of points.
    std::optional<Points> places;
    if (IsExtended(light)) places.emplace(s.path.index.PointsFor(which, sampler_, settings_.samples, count));
    for (std::uint32_t k = 0; k < count; ++k)
      AddSample(light, s, i, places ? places->Get2D(s.path.index.sample * count + k) : R2::Point{}, 1.0 / count, state);
  }
  AddArrived(surfaces, state);
}

void Whitted::AddChosenLights(std::span<ShadingPoint> surfaces, TraceState& state) const {
  const auto count = static_cast<std::uint32_t>(settings_.lights);
  state.arrived.assign(surfaces.size(), {});
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ShadingPoint& s = surfaces[i];
    if (!Scatters(s)) continue;
    const Points places = s.path.index.PointsFor(choice_key, sampler_, settings_.samples, count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto random = places.Get<3>(s.path.index.sample * count + k);
      const auto choice = tree_->Choose(s.shadow_origin, s.N, random[2]);
      if (!choice) continue;
      const auto which = static_cast<std::size_t>(choice->light);
      const double weight = 1 / (choice->probability * count);
      const R2::Point place{random[0], random[1]};
      if (which < lights_.size())
        AddSample(*lights_[which], s, i, place, weight, state);
      else if (!IsOn(s, triangles_[which - lights_.size()], world_))
        AddSample(triangles_[which - lights_.size()], s, i, place, weight, state);
    }
  }
  AddArrived(surfaces, state);
}

template <typename AnyLight>
void Whitted::AddSample(const AnyLight& light, const ShadingPoint& s, std::size_t index, const R2::Point& random,
                        double weight, TraceState& state) const {
  const auto lit = LitBy(s, light, random);
  if (!lit) return;
  const R2::Color reflected = Reflection(light, s, *lit);
  if (IsBlack(reflected)) return;
  state.shadow_rays.push_back(ShadowRay(s, lit->to_light, lit->is_infinite));
  state.shadows.push_back({index, weight * reflected});
  if (state.recorder) [[unlikely]]
    state.recorder->BeginShadow(s, state.shadow_rays.back(), s.path.throughput * (weight * reflected),
                                Described(light));
  if (state.shadows.size() == most_shadow_rays) TraceShadowRays(state);
}

void Whitted::AddArrived(std::span<ShadingPoint> surfaces, TraceState& state) const {
  TraceShadowRays(state);
  for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i].radiance += state.arrived[i];
}

void Whitted::TraceShadowRays(TraceState& state) const {
  std::array<bool, most_shadow_rays> are_occluded{};
  if (settings_.shadows && !state.shadow_rays.empty()) {
    accelerator_.IsOccluded(state.shadow_rays, are_occluded.data(), state.workspace);
    state.Book(RayKind::shadow, state.shadow_rays.size());
  }
  if (state.recorder) [[unlikely]]
    state.recorder->EndShadows([&](std::size_t i) { return are_occluded[i]; }, world_, accelerator_, state.workspace);
  for (std::size_t i = 0; i < state.shadows.size(); ++i)
    if (!are_occluded[i]) state.arrived[state.shadows[i].surface] += state.shadows[i].reflected;
  state.shadow_rays.clear();
  state.shadows.clear();
}

inline std::optional<R2::Color> Whitted::Wanted(const R2::Color& weight, const SampleIndex& parent,
                                                std::uint64_t which) const {
  const double luminance = Luminance(weight);
  if (!(luminance > 0)) return {};
  if (luminance >= settings_.min_luminance) return weight;
  if (!features::roulette || !has_roulette_) return {};
  return Spared(weight, luminance, parent, which);
}

std::optional<R2::Color> Whitted::Spared(const R2::Color& weight, double luminance, const SampleIndex& parent,
                                         std::uint64_t which) const {
  const SampleIndex index = parent.Child(which);
  const double chance = luminance / settings_.min_luminance;
  const Points points(sampler_, index.key.Child(roulette_key), settings_.samples);
  if (!(points.Get2D(index.sample).x < chance)) return {};
  return weight / chance;
}

std::optional<R3::Vector> Whitted::ReflectionOf(const ShadingPoint& s, const SampleIndex& index) const {
  const R3::Vector mirrored = Unit(Reflect(-s.wo, s.N));
  if (!features::glossy || !settings_.glossy) return mirrored;
  const Points points(sampler_, index.key.Child(choice_key), settings_.samples);
  const R3::Vector direction = FromTangents(OnPowerLobe(points.Get2D(index.sample), s.material->n), mirrored);
  if (!(Dot(direction, s.N) > 0)) return {};  // that part of the lobe is lost in the surface
  return direction;
}

void Whitted::Spawn(const ShadingPoint& s, TraceState& state) const {
  const PathState& parent = s.path;
  const SpecularWeights weights = SpecularWeightsOf(s, settings_.fresnel);
  // Pushed first, traced last.
  if (const auto weight = Wanted(parent.throughput * weights.transmitted, parent.index, transmission_key)) {
    const SampleIndex through = parent.index.Child(transmission_key);
    if (s.material->ir == 1) {
      // Not bent: the same ray goes on beyond its hit. It asks every shape the same question as before and so gets the
      // same answers, of which the first is now outside the interval: nothing moves, nothing is hit twice.
      R3::Ray onward = parent.ray;
      onward.t_min = s.hit.t;
      state.pending.push_back({onward, *weight, parent.depth + 1, through, RayKind::transmission, parent.record});
    } else if (const auto bent = Refract(-s.wo, s.N, s.entering ? 1 / s.material->ir : s.material->ir)) {
      state.pending.push_back(
          {SpawnRay(s, *bent), *weight, parent.depth + 1, through, RayKind::transmission, parent.record});
    }
  }
  if (const auto weight = Wanted(parent.throughput * weights.reflected, parent.index, reflection_key)) {
    const SampleIndex back = parent.index.Child(reflection_key);
    if (const auto direction = ReflectionOf(s, back))
      state.pending.push_back(
          {SpawnRay(s, *direction), *weight, parent.depth + 1, back, RayKind::reflection, parent.record});
  }
}

}  // namespace ray
