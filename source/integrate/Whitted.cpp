#include "source/integrate/Whitted.h"

#include <algorithm>

#include "source/integrate/Bend.h"
#include "source/integrate/Phong.h"

namespace ray {
namespace {

// What the children of a random key are for. Lights follow, one each.
enum KeyUse : std::uint64_t { reflection_key, transmission_key, first_light_key };

R3::Vector Facing(const R3::Normal& n, bool from_outside) { return from_outside ? AsVector(n) : -AsVector(n); }

}  // namespace

/// A point being shaded.
struct Whitted::Surface {
  R3::Ray ray;             // that found it
  WorldHit hit;
  R3::Intersection at;
  const Material* material;
  R2::Color kd;            // the material's, times its texture
  R3::Vector towards_viewer;  // unit
  bool from_outside;       // whether the ray came from the side of the outward normal
  R3::Vector N;            // unit shading normal on the viewer's side
  R3::Point lit_from;      // where shadow rays and reflections start: off the surface, on the viewer's side
};

Whitted::Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings)
    : world_(world), accelerator_(accelerator), settings_(settings), triangles_(EmissiveTriangles(world)) {
  settings_.max_depth = std::min<std::int64_t>(settings_.max_depth, most_bounces);
  for (const auto& light : world.TheScene().lights)
    if (!light->IsBlack()) lights_.push_back(light.get());
}

// The recursion is unrolled onto a stack of rays that carry the product of the weights above them: depth first, the
// mirrored ray before the transmitted one.
R2::Color Whitted::Radiance(const R3::Ray& camera_ray, const RandomKey& key, TraceState& state) const {
  const Scene& scene = world_.TheScene();
  R2::Color sum;
  int descendants = 0;
  state.pending.clear();
  state.pending.push_back({camera_ray, {1, 1, 1}, 0, key, RayKind::camera});
  while (!state.pending.empty()) {
    const TraceState::Pending current = state.pending.back();
    state.pending.pop_back();
    const auto hit = accelerator_.Intersect(current.ray, state.workspace);
    state.Book(current.kind);
    if (!hit) {
      sum += current.weight * scene.background;
      continue;
    }
    Surface s{current.ray, *hit, world_.At(current.ray, *hit), &world_.MaterialAt(*hit), {}, {}, true, {}, {}};
    s.kd = s.material->texture ? s.material->kd * s.material->texture->At(s.at.uv) : s.material->kd;
    s.towards_viewer = -Unit(current.ray.direction);
    s.from_outside = Dot(s.at.normal, current.ray.direction) <= 0;
    s.N = Facing(s.at.shading_normal, s.from_outside);
    s.lit_from = SpawnPoint(s.at, s.towards_viewer);

    sum += current.weight * Shade(s, current.key, state);
    if (current.depth >= settings_.max_depth) continue;
    if (descendants >= most_descendants) {
      ++state.rays.cut;
      continue;
    }
    const std::size_t before = state.pending.size();
    Spawn(s, current, state);
    descendants += static_cast<int>(state.pending.size() - before);
  }
  return sum;
}

R2::Color Whitted::Shade(const Surface& s, const RandomKey& key, TraceState& state) const {
  R2::Color sum = s.material->emission + s.material->ka * world_.TheScene().ambient;
  if (IsBlack(s.kd) && IsBlack(s.material->ks)) return sum;
  std::uint64_t which = first_light_key;
  for (const Light* light : lights_) sum += FromLight(*light, s, key.Child(which++), state);
  for (const EmissiveTriangle& triangle : triangles_) sum += FromTriangle(triangle, s, key.Child(which++), state);
  return sum;
}

R2::Color Whitted::FromLight(const Light& light, const Surface& s, const RandomKey& key, TraceState& state) const {
  const int samples = light.IsExtended() ? settings_.shadow_samples : 1;
  R2::Color sum;
  for (int i = 0; i < samples; ++i) {
    const R2::Point random = light.IsExtended() ? Stratified(static_cast<std::uint32_t>(i),
                                                             static_cast<std::uint32_t>(samples), key)
                                                : R2::Point{};
    const auto lit = light.Illuminate(s.lit_from, random);
    if (!lit) continue;
    const R2::Color reflected =
        PhongReflection(*s.material, s.kd, s.N, Unit(lit->to_light), s.towards_viewer, lit->irradiance);
    if (IsBlack(reflected)) continue;
    if (IsVisible({s.lit_from, lit->to_light, 0, lit->is_infinite ? R3::infinity : 1}, state)) sum += reflected;
  }
  return sum / samples;
}

R2::Color Whitted::FromTriangle(const EmissiveTriangle& triangle, const Surface& s, const RandomKey& key,
                                TraceState& state) const {
  if (triangle.primitive == world_.PrimitiveId(s.hit)) return {};
  const int samples = settings_.shadow_samples;
  R2::Color sum;
  for (int i = 0; i < samples; ++i) {
    const R2::Point random = Stratified(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(samples), key);
    const R3::Vector to_light = triangle.PointTowards(s.lit_from, random) - s.lit_from;
    const R2::Color reflected =
        PhongReflection(*s.material, s.kd, s.N, Unit(to_light), s.towards_viewer, triangle.emission);
    if (IsBlack(reflected)) continue;
    if (IsVisible({s.lit_from, to_light, 0, 1}, state)) sum += reflected;
  }
  return sum / samples;
}

bool Whitted::IsVisible(const R3::Ray& shadow_ray, TraceState& state) const {
  if (!settings_.shadows) return true;
  const bool is_occluded = accelerator_.IsOccluded(shadow_ray, state.workspace);
  state.Book(RayKind::shadow);
  return !is_occluded;
}

void Whitted::Spawn(const Surface& s, const TraceState::Pending& parent, TraceState& state) const {
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
      R3::Ray onward = s.ray;
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
    state.pending.push_back({{SpawnPoint(s.at, mirrored), mirrored}, reflected, parent.depth + 1,
                             parent.key.Child(reflection_key), RayKind::reflection});
  }
}

}  // namespace ray
