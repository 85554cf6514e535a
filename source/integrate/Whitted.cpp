#include "source/integrate/Whitted.h"

#include <algorithm>
#include <array>

#include "source/integrate/Bend.h"
#include "source/integrate/Phong.h"

namespace ray {
namespace {

// What the children of a random key are for. Lights follow, one each.
enum KeyUse : std::uint64_t { reflection_key, transmission_key, first_light_key };

constexpr std::size_t most_shadow_rays = 64;  // traced at once

bool IsExtended(const Light& light) { return light.IsExtended(); }
bool IsExtended(const EmissiveTriangle&) { return true; }

R3::Vector Facing(const R3::Normal& n, bool from_outside) { return from_outside ? AsVector(n) : -AsVector(n); }

}  // namespace

/// A point being shaded.
struct Whitted::Surface {
  TraceState::Pending found_by;
  WorldHit hit;
  R3::Intersection at;
  const Material* material;
  R2::Color kd;               // the material's, times its texture
  R3::Vector towards_viewer;  // unit
  bool from_outside;          // whether the ray came from the side of the outward normal
  R3::Vector N;               // unit shading normal on the viewer's side
  R3::Point lit_from;         // where shadow rays and reflections start: off the surface, on the viewer's side
  R2::Color radiance;         // back along the ray, as far as it is known

  /// Whether it is itself the light.
  static bool IsOn(const Light&, const World&) { return false; }
  bool IsOn(const EmissiveTriangle& triangle, const World& world) const {
    return triangle.primitive == world.PrimitiveId(hit);
  }

  /// What arrives from a random place on the light, if nothing is in between.
  std::optional<Illumination> LitBy(const Light& light, const R2::Point& random) const {
    return light.Illuminate(lit_from, random);
  }
  std::optional<Illumination> LitBy(const EmissiveTriangle& triangle, const R2::Point& random) const {
    return Illumination{triangle.emission, triangle.PointTowards(lit_from, random) - lit_from};
  }
};

Whitted::Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world), accelerator_(accelerator), settings_(settings), triangles_(EmissiveTriangles(world)) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
  for (const auto& light : world.TheScene().lights)
    if (!light->IsBlack()) lights_.push_back(light.get());
}

void Whitted::Radiance(std::span<const Sample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  std::vector<R3::Ray> rays;
  for (const Sample& sample : samples) rays.push_back(sample.ray);
  std::vector<std::optional<WorldHit>> hits(rays.size());
  accelerator_.Intersect(rays, hits.data(), state.workspace);
  state.Book(RayKind::camera, rays.size());

  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (hits[i])
      surfaces.push_back(SurfaceAt({samples[i].ray, {1, 1, 1}, 0, samples[i].key, RayKind::camera}, *hits[i]));
  Shade(surfaces, state);
  auto surface = surfaces.begin();
  for (std::size_t i = 0; i < samples.size(); ++i)
    radiances[i] = hits[i] ? Follow(*surface++, state) : world_.TheScene().background;
}

// The recursion is unrolled onto a stack of rays that carry the product of the weights above them: depth first, the
// mirrored ray before the transmitted one.
R2::Color Whitted::Follow(const Surface& first, TraceState& state) const {
  R2::Color sum = first.radiance;
  int descendants = 0;
  state.pending.clear();
  const auto spawn = [&](const Surface& surface) {
    if (surface.found_by.depth >= settings_.max_depth) return;
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
    const TraceState::Pending current = state.pending.back();
    state.pending.pop_back();
    const auto hit = accelerator_.Intersect(current.ray, state.workspace);
    state.Book(current.kind, 1);
    if (!hit) {
      sum += current.weight * world_.TheScene().background;
      continue;
    }
    Surface surface = SurfaceAt(current, *hit);
    Shade({&surface, 1}, state);
    sum += current.weight * surface.radiance;
    spawn(surface);
  }
  return sum;
}

Whitted::Surface Whitted::SurfaceAt(const TraceState::Pending& ray, const WorldHit& hit) const {
  Surface s{ray, hit, world_.At(ray.ray, hit), &world_.MaterialAt(hit), {}, {}, true, {}, {}, {}};
  s.kd = s.material->texture ? s.material->kd * s.material->texture->At(s.at.uv) : s.material->kd;
  s.towards_viewer = -Unit(ray.ray.direction);
  s.from_outside = Dot(s.at.normal, ray.ray.direction) <= 0;
  s.N = Facing(s.at.shading_normal, s.from_outside);
  s.lit_from = SpawnPoint(s.at, s.towards_viewer);
  return s;
}

void Whitted::Shade(std::span<Surface> surfaces, TraceState& state) const {
  for (Surface& s : surfaces) s.radiance = s.material->emission + s.material->ka * world_.TheScene().ambient;
  std::uint64_t which = first_light_key;
  for (const Light* light : lights_) AddLight(*light, which++, surfaces, state);
  for (const EmissiveTriangle& triangle : triangles_) AddLight(triangle, which++, surfaces, state);
}

template <typename AnyLight>
void Whitted::AddLight(const AnyLight& light, std::uint64_t which, std::span<Surface> surfaces,
                       TraceState& state) const {
  const int samples = IsExtended(light) ? settings_.shadow_samples : 1;
  state.arrived.assign(surfaces.size(), {});
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& s = surfaces[i];
    if ((IsBlack(s.kd) && IsBlack(s.material->ks)) || s.IsOn(light, world_)) continue;
    const Stratified places(static_cast<std::uint32_t>(samples), s.found_by.key.Child(which));
    for (int k = 0; k < samples; ++k) {
      const R2::Point random = IsExtended(light) ? places[static_cast<std::uint32_t>(k)] : R2::Point{};
      const auto lit = s.LitBy(light, random);
      if (!lit) continue;
      const R2::Color reflected =
          PhongReflection(*s.material, s.kd, s.N, Unit(lit->to_light), s.towards_viewer, lit->irradiance);
      if (IsBlack(reflected)) continue;
      state.shadow_rays.push_back({s.lit_from, lit->to_light, 0, lit->is_infinite ? R3::infinity : 1});
      state.shadows.push_back({i, reflected});
      if (state.shadows.size() == most_shadow_rays) TraceShadowRays(state);
    }
  }
  TraceShadowRays(state);
  for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i].radiance += state.arrived[i] / samples;
}

void Whitted::TraceShadowRays(TraceState& state) const {
  std::array<bool, most_shadow_rays> are_occluded{};
  if (settings_.shadows && !state.shadow_rays.empty()) {
    accelerator_.IsOccluded(state.shadow_rays, are_occluded.data(), state.workspace);
    state.Book(RayKind::shadow, state.shadow_rays.size());
  }
  for (std::size_t i = 0; i < state.shadows.size(); ++i)
    if (!are_occluded[i]) state.arrived[state.shadows[i].surface] += state.shadows[i].reflected;
  state.shadow_rays.clear();
  state.shadows.clear();
}

void Whitted::Spawn(const Surface& s, TraceState& state) const {
  const TraceState::Pending& parent = s.found_by;
  const auto is_wanted = [&](const R2::Color& weight) {
    const double luminance = Luminance(weight);
    return luminance >= settings_.min_luminance && luminance > 0;
  };
  const R3::Vector d = -s.towards_viewer;
  // Pushed first, traced last.
  const R2::Color transmitted = parent.weight * s.material->kt;
  if (is_wanted(transmitted)) {
    const RandomKey key = parent.key.Child(transmission_key);
    if (s.material->ir == 1) {
      // Not bent: the same ray goes on beyond its hit. It asks every shape the same question as before and so gets the
      // same answers, of which the first is now outside the interval: nothing moves, nothing is hit twice.
      R3::Ray onward = parent.ray;
      onward.t_min = s.hit.hit.t;
      state.pending.push_back({onward, transmitted, parent.depth + 1, key, RayKind::transmission});
    } else if (const auto bent = Refracted(d, s.N, s.from_outside ? 1 / s.material->ir : s.material->ir)) {
      state.pending.push_back(
          {{SpawnPoint(s.at, *bent), *bent}, transmitted, parent.depth + 1, key, RayKind::transmission});
    }
  }
  const R2::Color reflected = parent.weight * s.material->ks;
  if (is_wanted(reflected)) {
    const R3::Vector mirrored = Unit(Reflected(d, s.N));
    state.pending.push_back({{SpawnPoint(s.at, mirrored), mirrored},
                             reflected,
                             parent.depth + 1,
                             parent.key.Child(reflection_key),
                             RayKind::reflection});
  }
}

}  // namespace ray
