#include "source/draw/preview/PreviewLights.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Warp.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/TriangleLamp.h"

namespace ray {
namespace {

/// Sets the attenuation in the world for distances in the drawing space.
void SetFalloff(PreviewLight& light, double constant, double linear, double quadratic, double radius) {
  light.constant = constant;
  light.linear = linear * radius;
  light.quadratic = quadratic * radius * radius;
}

/// Returns a light of the scene language, from the arguments that would create it again. An unknown kind shines
/// uniformly, as its bound says.
PreviewLight Known(const Light& light, const DrawingSpace& space) {
  const R3::Recipe recipe = light.MadeFrom();
  const std::vector<double>& a = recipe.arguments;
  const auto is = [&](const char* kind) { return std::strcmp(recipe.kind, kind) == 0; };
  const auto vector = [&](std::size_t i) { return R3::Vector{a[i], a[i + 1], a[i + 2]}; };
  PreviewLight known;
  if (is("dir_light")) {
    known.color = {a[0], a[1], a[2]};
    known.place = AsFloats(-Unit(vector(3)));
    known.is_infinite = true;
    return known;
  }
  const LightBound bound = light.Bound();
  known.color = {bound.power, bound.power, bound.power};
  known.place = space.At(bound.center);
  known.is_infinite = bound.is_infinite;
  known.radius = bound.radius / space.radius;
  SetFalloff(known, bound.ca, bound.la, bound.qa, space.radius);
  const bool is_spot = is("spot_light"), is_area = is("area_light");
  if (is_spot || is_area || is("point_light") || is("sphere_light")) known.color = {a[0], a[1], a[2]};
  if (is_spot || is_area) {
    known.direction = AsFloats(Unit(vector(6)));
    known.least_cosine = is_spot ? R1::Cos(a[12]) : 0;
    known.exponent = is_spot ? a[13] : 1;
  }
  return known;
}

/// An emitter, represented by its middle.
struct Emitter {
  R2::Color emission;
  R3::Point middle;
  double area = 0;  // as seen from the middle of the scene
  int lamps = 1;    // number of lights, each with the full color if emission is not a radiance
};

PreviewLight LightOf(const Emitter& emitter, bool is_radiance, const DrawingSpace& space) {
  PreviewLight light;
  light.place = space.At(emitter.middle);
  light.radius = std::sqrt(emitter.area / std::numbers::pi) / space.radius;
  light.color = (is_radiance ? emitter.area / std::numbers::pi : emitter.lamps) * emitter.emission;
  if (is_radiance) SetFalloff(light, 0, 0, 1, space.radius);
  return light;
}

/// Returns the emitters of meshes. The lights of one instance, which follow each other, are one emitter.
std::vector<Emitter> EmittingMeshes(const World& world, EmissiveMeshes meshes) {
  std::vector<Emitter> emitters;
  const Instance* last = nullptr;
  for (const TriangleLamp& lamp : TriangleLamps(world, meshes)) {
    const R3::Point middle = lamp.Bound().center;
    const double area = lamp.Area() / 2;  // on average over orientations, a triangle's visible area is half of its own
    if (lamp.instance() != last) {
      emitters.push_back({lamp.Emission(), middle, area, 1});
    } else {
      Emitter& emitter = emitters.back();
      ++emitter.lamps;
      emitter.area += area;
      emitter.middle = emitter.middle + (middle - emitter.middle) / emitter.lamps;
    }
    last = lamp.instance();
  }
  return emitters;
}

/// Returns the light that arrives at the middle of the scene. Distances are at least a tenth of its radius, where any
/// light would be the strongest.
double Strength(const PreviewLight& light) {
  constexpr double nearest = 0.1;
  const double power = Luminance(light.color);
  if (light.is_infinite) return power;
  const auto& p = light.place;
  const double d = std::max(nearest, R3::Length({p[0], p[1], p[2]}));
  const double falloff = light.constant + light.linear * d + light.quadratic * d * d;
  return falloff > 0 ? power / falloff : power;
}

bool Shines(const Instance& instance) { return !IsBlack(instance.material->emission); }

}  // namespace

PreviewLights PreviewLightsOf(const World& world, const RenderSettings& settings, const DrawingSpace& space) {
  const Scene& scene = world.scene();
  const bool is_radiance = EmitsRadiance(settings);
  PreviewLights found;
  auto& lights = found.lights;
  for (const auto& light : scene.lights)
    if (!light->IsBlack()) lights.push_back(Known(*light, space));
  for (const Emitter& emitter : EmittingMeshes(world, settings.trace.emissive_meshes))
    lights.push_back(LightOf(emitter, is_radiance, space));
  if (is_radiance || settings.trace.emissive_solids_light)
    for (const EmissiveShape& shape : EmissiveShapes(world))
      lights.push_back(
          LightOf({shape.Emission(), shape.Bound().center, shape.ProjectedAreaOfBounds()}, is_radiance, space));

  std::stable_sort(lights.begin(), lights.end(),
                   [](const PreviewLight& a, const PreviewLight& b) { return Strength(a) > Strength(b); });
  if (lights.size() > most_preview_lights) {
    found.left_out = static_cast<int>(lights.size() - most_preview_lights);
    lights.resize(most_preview_lights);
  }
  const bool has_environment = scene.environment && !scene.environment->IsBlack();
  const bool is_lit_by_background = settings.mode == RenderMode::path && !IsBlack(scene.background);
  found.head_light = lights.empty() && !has_environment && !is_lit_by_background && IsBlack(scene.ambient) &&
                     std::ranges::none_of(world.Instances(), Shines);
  return found;
}

ClipMatrix ShadowViewOf(const PreviewLight& light) {
  constexpr double reach = 1.02;  // distance from the scene's middle, in its radii, with a margin
  constexpr double widest = 75 * std::numbers::pi / 180;  // from the middle of a view to its edge
  constexpr double nearest_of_farthest = 1e-3;            // with 24 bits of depth
  const auto as_vector = [](const std::array<float, 3>& v) { return R3::Vector{v[0], v[1], v[2]}; };
  const R3::Vector eye = as_vector(light.place);
  if (light.is_infinite) {
    const R3::Tangents across = R3::TangentsOf(-eye);
    return FromRows({Row(across.first / reach, 0), Row(across.second / reach, 0), Row(-eye / reach, 0), Row({}, 1)});
  }
  const double distance = Length(eye), farthest = distance + reach;
  double half_angle = distance > reach ? std::min(widest, R1::Asin(reach / distance)) : widest;
  R3::Vector towards = distance > 0 ? -eye / distance : R3::Vector{0, -1, 0};
  if (light.least_cosine >= -1 && distance <= reach / R1::Sin(widest)) towards = as_vector(light.direction);
  if (const double spot = 1.01 * R1::Acos(std::clamp(light.least_cosine, -1.0, 1.0)) + 1e-3; spot < half_angle) {
    half_angle = spot;
    towards = as_vector(light.direction);
  }
  const double nearest = std::max({1.01 * light.radius, distance - reach, nearest_of_farthest * farthest});
  const double scale = 1 / R1::Tan(half_angle);
  const R3::Tangents across = R3::TangentsOf(towards);
  return Perspective(eye, towards, scale * across.first, scale * across.second, std::min(nearest, farthest / 2),
                     farthest);
}

}  // namespace ray
