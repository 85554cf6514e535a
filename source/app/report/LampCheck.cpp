#include "source/app/report/Questions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/app/report/Check.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/LightSource.h"
#include "source/integrate/lights/TriangleLamp.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

using Places = std::vector<R3::Point>;

bool IsToBeLit(const Instance& instance) {
  const Material& m = *instance.material;
  return !instance.Emits() && !(IsBlack(m.kd) && IsBlack(m.ks));
}

/// Adds the centers of the eight parts of a box.
void AddMiddles(const R3::Box& box, Places& places) {
  for (int k = 0; k < 8 && !box.IsEmpty(); ++k) places.push_back(box.Center() + 0.5 * (box.Corner(k) - box.Center()));
}

/// Returns the points at which light is compared: in a few of the shapes that reflect it, the centers of the eight
/// parts of the box around each, since the center of the whole may lie in the plane of a lamp. Empty if nothing
/// reflects light.
Places PlacesToCompare(const World& world) {
  std::vector<R3::Box> lit;
  for (const Instance& instance : world.Instances())
    if (instance.is_bounded && IsToBeLit(instance)) lit.push_back(WorldBounds(world, instance));
  // Planes have no center, but objects standing on them are as far from the lamps.
  if (lit.empty() && std::ranges::any_of(world.Instances(), IsToBeLit)) lit.push_back(world.scene().root.bounds);
  constexpr std::size_t most_boxes = 8;  // 64 points, times 1 s per ten million lamps
  const std::size_t step = (lit.size() + most_boxes - 1) / most_boxes;
  Places places;
  for (std::size_t i = 0; i < lit.size(); i += step) AddMiddles(lit[i], places);
  return places;
}

/// Returns the solid angle of a triangle as seen from a point, in [0, 2 pi].
///   source   Van Oosterom, Strackee, The solid angle of a plane triangle (1983), eq. 8
double SolidAngle(const EmissiveTriangle& triangle, const R3::Point& from) {
  const auto& [p, q, r] = triangle.corners;
  const R3::Vector a = Unit(p - from), b = Unit(q - from), c = Unit(r - from);
  return 2 * R1::Atan2(std::abs(Dot(a, Cross(b, c))), 1 + Dot(a, b) + Dot(b, c) + Dot(c, a));
}

/// Returns the solid angle of a shape as seen from a point: the mean of 1 / pdf over points sampled on it, which is
/// exact for a sphere.
double SolidAngle(const EmissiveShape& shape, const R3::Point& from) {
  constexpr int strata = 8;
  double sum = 0;
  for (int i = 0; i < strata; ++i)
    for (int k = 0; k < strata; ++k)
      if (const auto drawn = shape.SampleTowards(from, {(i + 0.5) / strata, (k + 0.5) / strata}, 0.5))
        sum += 1 / drawn->pdf;
  return sum / (strata * strata);
}

/// Returns the share of a radiance that a white diffuse surface reflects: W / pi for a small solid angle W around its
/// normal, and all of it if it comes from the whole hemisphere.
double ShownOfRadiance(double solid_angle) { return std::min(1.0, solid_angle / pi); }

R2::Color EmissionOf(const EmissiveTriangle& triangle) { return triangle.emission; }
R2::Color EmissionOf(const EmissiveShape& shape) { return shape.Emission(); }

template <typename Emitter>
double ShownOf(const std::vector<Emitter>& emitters, const Places& places) {
  double sum = 0;
  for (const Emitter& emitter : emitters)
    for (const R3::Point& place : places)
      sum += Luminance(EmissionOf(emitter)) * ShownOfRadiance(SolidAngle(emitter, place));
  return sum / static_cast<double>(places.size());
}

/// Returns the light of all lamps in mode path, or of those made of triangles.
double LampsOfPath(const World& world, const Places& places, bool counts_solids) {
  const double triangles = ShownOf(EmissiveTriangles(world), places);
  if (!counts_solids) return triangles;
  double planes = 0;  // which fill half of the view
  for (const Instance& instance : world.Instances())
    if (instance.Emits() && !instance.is_bounded) planes += Luminance(instance.material->emission);
  return triangles + ShownOf(EmissiveShapes(world), places) + planes;
}

/// Returns the light of lamps in mode whitted, independent of their positions.
double LampsOfWhitted(const World& world, const TraceSettings& settings) {
  double sum = 0;
  for (const TriangleLamp& lamp : TriangleLamps(world, settings.emissive_meshes)) sum += Luminance(lamp.Emission());
  if (!settings.emissive_solids_light) return sum;
  for (const EmissiveShape& shape : EmissiveShapes(world)) sum += Luminance(shape.Emission());
  return sum;
}

double LightOf(const std::vector<const Light*>& lights, const Places& places) {
  double sum = 0;
  for (const Light* light : lights)
    for (const R3::Point& place : places) {
      const LightBound bound = light->Bound();
      const double d = Length(bound.center - place), falloff = bound.ca + bound.la * d + bound.qa * d * d;
      sum += bound.is_infinite || !(falloff > 0) ? bound.power : bound.power / falloff;
    }
  return sum / static_cast<double>(places.size());
}

/// Returns the mean radiance of the environment.
double RadianceAround(const Scene& scene) {
  if (!scene.environment || scene.environment->IsBlack()) return 0;
  const Environment::Sample any = scene.environment->Draw({0.5, 0.5});  // luminance over pdf is the same for all
  return Luminance(any.radiance) / any.pdf / (4 * pi);
}

/// Returns "about 6.3 times" or "about 630 times".
std::string Times(double factor) {
  if (!(factor < 1e6)) return "more than a million times";
  double unit = 1;
  while (factor / unit >= 100) unit *= 10;
  return "about " + (unit == 1 ? Rounded(factor, 2) : Fixed(unit * std::round(factor / unit), 0)) + " times";
}

/// The light that arrives in one of the modes, in the units of the scene language.
struct ModeLight {
  double lamps, all;  // from emissive shapes; from these and everything else

  /// Returns true if lamps are more than twice as strong, and most of the light, which is twice as strong too.
  bool IsTwice(const ModeLight& other) const {
    return lamps > 2 * other.lamps && 2 * lamps > all && all > 2 * other.all;
  }
};

ModeLight LightOfPath(const World& world, const Places& places, double around, bool counts_solids) {
  const Scene& scene = world.scene();
  const double lamps = LampsOfPath(world, places, counts_solids);
  const double background = scene.environment ? 0 : Luminance(scene.background);  // lights like an environment
  return {lamps, lamps + LightOf(LightsOfPath(world), places) + around + background};
}

ModeLight LightOfWhitted(const World& world, const Places& places, double around, const TraceSettings& settings) {
  const double lamps = LampsOfWhitted(world, settings);
  return {lamps, lamps + LightOf(LightsOfWhitted(world, settings), places) + around};
}

/// Returns how the modes whitted and path differ, if the lamps of one give more than twice the light of the other;
/// otherwise an empty text.
std::string DifferenceOfModes(const World& world, const RenderSettings& settings) {
  const Scene& scene = world.scene();
  Places places = PlacesToCompare(world);
  if (places.empty()) return {};
  if (LampsOfPath(world, places, true) == 0) {  // all points lie in the plane of a lamp, such as a ceiling around it
    R3::Box seen = scene.root.bounds;
    seen.Extend(settings.view.value_or(scene.camera).eye);
    places.clear();
    AddMiddles(seen, places);
  }
  // Solids that light nothing in mode whitted are reported there one by one.
  const bool counts_solids =
      settings.trace.emissive_solids_light || settings.mode == RenderMode::path || scene.has_default_lights;
  const double around = Luminance(scene.ambient) + RadianceAround(scene);
  const ModeLight path = LightOfPath(world, places, around, counts_solids),
                  whitted = LightOfWhitted(world, places, around, settings.trace);
  const bool has_defaults = scene.has_default_lights && !LightsOfWhitted(world, settings.trace).empty();
  if (has_defaults && whitted.all > 2 * path.all)
    return "the scene has no lights: in mode whitted two default lights make it " + Times(whitted.all / path.all) +
           " as bright as in mode path, where only its emissive surfaces light it";
  if (whitted.IsTwice(path))
    return "lamps light the scene " + Times(whitted.lamps / path.lamps) +
           " as strongly in mode whitted, where each has its full color at any size and distance, as in mode path, "
           "where emission is a radiance; -emission color makes mode path agree with whitted";
  if (path.IsTwice(whitted) && whitted.lamps == 0)
    return "emissive solids light the scene in mode path only; with -emissive_solids on they do in mode whitted, too";
  if (path.IsTwice(whitted))
    return "lamps light the scene " + Times(path.lamps / whitted.lamps) +
           " as strongly in mode path, where every emissive surface is a lamp, as in mode whitted; -emissive_solids on "
           "adds the lamps that mode whitted ignores";
  return {};
}

/// Reports meshes that are as many lamps as they have triangles.
std::vector<std::string> MeshesOfLamps(const World& world, const RenderSettings& settings) {
  if (EmitsRadiance(settings)) return {};
  std::vector<const Instance*> many;
  for (const Instance& i : world.Instances())
    if (i.mesh && i.Emits() && i.mesh->Elements() > 1 && !IsOneLamp(i, settings.trace.emissive_meshes))
      many.push_back(&i);
  if (many.empty()) return {};
  const std::string triangles = std::to_string(many[0]->mesh->Elements());
  return {WarningAt(world, *many[0]) + "each of the " + triangles +
          " triangles of this mesh is a lamp, and all together light up to " + triangles +
          " times as strongly as one: a finer mesh would be brighter; -emissive_meshes whole makes the mesh one lamp" +
          AndMore(many.size())};
}

/// Returns true if comparing the light of lamps takes no more than some milliseconds.
bool HasFewLamps(const World& world) {
  constexpr std::int64_t many = 64;       // 13 ms, since 64 points are sampled on each for 64 lit points
  constexpr std::int64_t triangles = 64;  // that take as long as another shape
  std::int64_t lamps = 0;
  for (const Instance& instance : world.Instances())
    if (instance.Emits()) lamps += instance.mesh ? instance.mesh->Elements() : triangles;
  return lamps <= many * triangles;
}

}  // namespace

std::vector<std::string> LampMistakes(const Inspection& inspection) {
  const auto& [world, settings, accelerator, effort] = inspection;
  const bool is_quick = settings.mode == RenderMode::whitted && HasFewLamps(world);
  if (effort != Effort::check && !is_quick) return {};
  const bool is_of_light = settings.mode == RenderMode::whitted || settings.mode == RenderMode::path;
  const auto lamp = std::ranges::find_if(world.Instances(), &Instance::Emits);
  if (!is_of_light || lamp == world.Instances().end()) return {};
  std::vector<std::string> mistakes = MeshesOfLamps(world, settings);
  if (settings.trace.emission == Emission::color) return mistakes;  // the modes are then equivalent
  if (const std::string difference = DifferenceOfModes(world, settings); !difference.empty())
    mistakes.push_back(WarningAt(world, *lamp) + difference);
  return mistakes;
}

}  // namespace ray
