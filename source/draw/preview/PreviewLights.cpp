#include "source/draw/preview/PreviewLights.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "R1/Elementary.h"
#include "source/draw/Drawing.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/TriangleLamp.h"

namespace ray {
namespace {

constexpr double flatness = 1e-6;  // how far off its plane a flat thing may be, of its width

/// Attenuation in the world, of distances in the drawing space.
void SetFalloff(PreviewLight& light, double constant, double linear, double quadratic, double radius) {
  light.constant = constant;
  light.linear = linear * radius;
  light.quadratic = quadratic * radius * radius;
}

/// A light of the scene language by the arguments that would make it again. A kind that is not known here shines as its
/// bound says, everywhere alike.
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
    known.is_disc = is_area && known.radius > 0;
  }
  return known;
}

/// Something that emits, from its middle.
struct Emitter {
  R2::Color emission;
  R3::Point middle;
  double area = 0;                     // as it looks from somewhere
  int lamps = 1;                       // each of which shines with its full color, where emission is no radiance
  std::optional<R3::Vector> normal{};  // unit; where all of it lies in one plane
};

/// The unit normal of the plane that a lamp lies in, if it lies in one.
std::optional<R3::Vector> NormalOf(const TriangleLamp& lamp) {
  const EmissiveTriangle& first = lamp.Triangles().front();
  const R3::Vector normal = Unit(AsVector(first.normal));
  const auto is_in_plane = [&](const EmissiveTriangle& triangle) {
    return std::ranges::all_of(triangle.corners, [&](const R3::Point& corner) {
      const R3::Vector way = corner - first.corners[0];
      return std::abs(Dot(way, normal)) <= flatness * Length(way);
    });
  };
  return std::ranges::all_of(lamp.Triangles(), is_in_plane) ? std::optional(normal) : std::nullopt;
}

/// On the side of the scene's middle, where most of what it lights is.
void SetFlat(PreviewLight& light, const R3::Vector& normal, double radius) {
  const auto& p = light.place;
  const bool is_away = Dot(R3::Vector{p[0], p[1], p[2]}, normal) > 0;
  light.direction = AsFloats(is_away ? -normal : normal);
  light.radius = radius;
  light.is_flat = light.casts_shadows = true;
}

PreviewLight LightOf(const Emitter& emitter, bool is_radiance, const DrawingSpace& space) {
  PreviewLight light;
  light.place = space.At(emitter.middle);
  light.casts_shadows = false;  // it would be in that of its own surface
  if (emitter.normal) SetFlat(light, *emitter.normal, std::sqrt(2 * emitter.area / std::numbers::pi) / space.radius);
  light.color = (is_radiance ? emitter.area / std::numbers::pi : emitter.lamps) * emitter.emission;
  if (is_radiance) SetFalloff(light, 0, 0, 1, space.radius);
  return light;
}

/// The lamps of one instance, which follow each other, are one emitter.
std::vector<Emitter> EmittingMeshes(const World& world, EmissiveMeshes meshes) {
  std::vector<Emitter> emitters;
  const Instance* last = nullptr;
  for (const TriangleLamp& lamp : TriangleLamps(world, meshes)) {
    const R3::Point middle = lamp.Bound().center;
    const double area = lamp.Area() / 2;  // turned this way and that, a triangle looks half as large as it is
    if (lamp.instance() != last) {
      emitters.push_back({lamp.Emission(), middle, area, 1, NormalOf(lamp)});
    } else {
      Emitter& emitter = emitters.back();
      ++emitter.lamps;
      emitter.normal.reset();
      emitter.area += area;
      emitter.middle = emitter.middle + (middle - emitter.middle) / emitter.lamps;
    }
    last = lamp.instance();
  }
  return emitters;
}

/// What arrives at the middle of the scene; no nearer than a tenth of its radius, where every lamp would be the
/// strongest.
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

}  // namespace ray
