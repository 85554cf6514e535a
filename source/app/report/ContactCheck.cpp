#include "source/app/report/Questions.h"

#include <algorithm>
#include <string>
#include <utility>

#include "source/app/report/Check.h"
#include "source/render/SceneFeatures.h"
#include "source/sample/Sampler.h"

namespace ray {
namespace {

/// Two instances.
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns true if both are visible where they lie in one plane: a clear solid, and what it stands on.
bool AreBothSeen(const Instance& a, const Instance& b) {
  return (a.is_medium && a.IsClear()) || (b.is_medium && b.IsClear());
}

/// Adds rays through the image, in a grid of at most `side` times `side`, and at most one per pixel.
void AddCameraRays(const World& world, const RenderSettings& settings, int side, std::vector<R3::Ray>& rays) {
  const Camera camera = settings.view.value_or(world.scene().camera);
  const int columns = std::min(side, settings.width), rows = std::min(side, settings.height);
  for (int i = 0; i < rows * columns; ++i) {
    // Points of the image that do not coincide with the edges of typical models.
    const double x = (i % columns + 0.3719) / columns * settings.width;
    const double y = (i / columns + 0.4142) / rows * settings.height;
    if (const auto ray = camera.RayThrough(x, y, settings.width, settings.height)) rays.push_back(*ray);
  }
}

/// Adds rays that hit lamps made of triangles from both sides: such lamps light the image even if they are out of view.
void AddRaysToLamps(const World& world, std::vector<R3::Ray>& rays) {
  constexpr int most = 64;
  int lamps = 0;
  for (const Instance& instance : world.Instances()) {
    if (!instance.mesh || !instance.Emits()) continue;
    for (int i = 0; i < instance.mesh->Elements() && lamps < most; ++i, ++lamps) {
      const auto [p, q, r] = instance.mesh->Corners(i);
      const R3::Point inside = p + 0.3719 * (q - p) + 0.2618 * (r - p);
      const R3::Vector normal = Cross(q - p, r - p) / std::max(Length(q - p), Length(r - p));
      for (const R3::Vector& way : {normal, -normal}) {
        const R3::Transform& world_from_local = world.Frames()[instance.frame];
        R3::Ray ray{world_from_local * (inside - way), world_from_local * way};
        ray.t_min = 0.999;  // nothing before the lamp matters
        rays.push_back(ray);
      }
    }
  }
}

/// Returns pairs of different materials, the first of which hides the second: equal shapes, and shapes in one plane
/// that the camera or a lamp shows.
///   side   of the grid of camera rays
std::vector<Pair> PairsInOnePlane(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                  int side) {
  constexpr std::size_t most_hits = 1'000'000;  // of all rays: more surfaces in one place add no information
  std::vector<R3::Ray> rays;
  AddCameraRays(world, settings, side, rays);
  AddRaysToLamps(world, rays);
  Workspace workspace;
  std::vector<Pair> pairs;
  std::size_t hits_so_far = 0;
  std::vector<std::optional<WorldHit>> nearest(rays.size());
  constexpr std::size_t packet = 64;
  for (std::size_t i = 0; i < rays.size(); i += packet)
    accelerator.Intersect(std::span(rays).subspan(i, std::min(packet, rays.size() - i)), &nearest[i], workspace);
  for (std::size_t i = 0; i < rays.size() && hits_so_far < most_hits; ++i) {
    if (!nearest[i] || !nearest[i]->is_contested) continue;
    const auto hits = accelerator.Coincident(rays[i], *nearest[i], workspace);
    hits_so_far += hits.size();
    for (const WorldHit& other : hits) {
      const Instance &first = world.Instances()[hits[0].instance], &second = world.Instances()[other.instance];
      if (first.material != second.material && !AreBothSeen(first, second))
        pairs.push_back({hits[0].instance, other.instance});
    }
  }
  for (std::uint32_t i = 0; i < world.Instances().size(); ++i) {
    const Instance& hidden = world.Instances()[i];
    if (hidden.is_repeated && hidden.material != world.Instances()[hidden.repeats].material)
      pairs.push_back({hidden.repeats, i});
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Reports surfaces in one plane. Traces at most 1,152 rays with a render, and 4,224 in -check.
std::vector<std::string> SurfacesInOnePlane(const Inspection& inspection) {
  const World& world = inspection.world;
  const bool is_check = inspection.effort == Effort::check;
  const auto built = inspection.accelerator ? nullptr : FindAcceleratorKind("auto")->Make(world, {});
  const std::vector<Pair> pairs =
      PairsInOnePlane(world, built ? *built : *inspection.accelerator, inspection.settings, is_check ? 64 : 32);
  if (pairs.empty()) return {};
  const Instance &seen = world.Instances()[pairs[0].first], &hidden = world.Instances()[pairs[0].second];
  return {WarningAt(world, hidden) + "this shape " +
          (hidden.is_repeated ? "is the same as" : "lies in one plane with") + " that of " + PlaceOf(world, seen) +
          ", which " + (seen.Emits() && !hidden.Emits() ? "emits" : "comes first in the file") +
          " and hides it; their materials differ" + AndMore(pairs.size())};
}

/// Returns true for solids and closed meshes of few triangles; larger ones would take too long.
bool IsClosed(const Instance& instance) {
  constexpr int most_triangles = 5000;  // three rays are tested against each, 0.5 ms in total
  if (!instance.mesh) return instance.shape->IsSolid();
  return instance.mesh->Elements() <= most_triangles && instance.mesh->IsClosed();
}

/// Reports lights without extent inside a shape; lights with an extent are visible where they stick out.
std::string LightsInSolids(const Inspection& inspection) {
  const auto& [world, settings, accelerator, effort] = inspection;
  std::vector<const Light*> lights;
  for (const Light* light : ShiningLights(world, settings))
    if (!light->IsExtended() && !light->Bound().is_infinite) lights.push_back(light);
  std::vector<const Instance*> solids;  // that block all light, around some light
  for (const Instance& instance : world.Instances()) {
    const auto may_hold = [&instance](const Light* light) { return instance.bounds.Contains(light->Bound().center); };
    if (!instance.IsClear() && std::ranges::any_of(lights, may_hold) && IsClosed(instance)) solids.push_back(&instance);
  }
  const auto is_inside = [&](const R3::Point& place) {
    return std::ranges::any_of(solids, [&](const Instance* solid) { return Holds(world, *solid, place); });
  };
  if (is_inside(settings.view.value_or(world.scene().camera).eye)) return {};  // it may be a room
  std::erase_if(lights, [&](const Light* light) { return !is_inside(light->Bound().center); });
  if (lights.empty()) return {};
  return "the " + lights[0]->Describe() + " is inside a shape that no light leaves" + AndMore(lights.size());
}

bool IsOpenGlass(const Instance& instance, const Inspection&) {
  const Material& m = *instance.material;
  const bool needs_inside = (instance.IsClear() && m.ir != 1) || !IsBlack(m.absorb);
  return instance.TwoSidedMesh() && instance.mesh->Elements() > 3 && needs_inside && !instance.is_repeated &&
         !instance.is_medium;
}

/// Returns true for one-sided materials that need both sides.
bool IsGlassOfOneSide(const Instance& i, const Inspection&) {
  return i.material->one_sided && (i.IsClear() || !IsBlack(i.material->absorb));
}

/// Returns some points of a box, evenly spread.
std::vector<R3::Point> PlacesIn(const R3::Box& box) {
  constexpr std::uint32_t count = 64;
  const Points points(SamplerKind::sobol, RandomKey(1), count);
  std::vector<R3::Point> places;
  for (std::uint32_t i = 0; i < count; ++i) {
    const R2::Point xy = points.Get2D(i);
    const R3::Vector size = box.high - box.low;
    places.push_back(box.low + R3::Vector{xy.x * size.x, xy.y * size.y, (i + 0.5) / count * size.z});
  }
  return places;
}

/// Returns true if a point inside both is found where their boxes overlap.
bool Overlap(const World& world, const Instance& a, const Instance& b) {
  const R3::Box &p = a.bounds, &q = b.bounds;
  const R3::Box both = Common(p, q);
  if (!(both.low.x < both.high.x && both.low.y < both.high.y && both.low.z < both.high.z)) return false;
  return std::ranges::any_of(
      PlacesIn(both), [&](const R3::Point& place) { return Holds(world, a, place) && Holds(world, b, place); });
}

/// Returns true if points inside one are found, all of them inside the other.
bool IsWithin(const World& world, const Instance& inner, const Instance& outer) {
  if (!(outer.bounds.Contains(inner.bounds.low) && outer.bounds.Contains(inner.bounds.high))) return false;
  bool has_inside = false;
  for (const R3::Point& place : PlacesIn(inner.bounds)) {
    if (!Holds(world, inner, place)) continue;
    if (!Holds(world, outer, place)) return false;
    has_inside = true;
  }
  return has_inside;
}

/// Returns the problem with the priorities of two clear solids, given in the order of the file; empty if there is none.
std::string ContradictionOf(const World& world, const Instance& first, const Instance& second) {
  const Material &a = *first.material, &b = *second.material;
  if (a.priority != b.priority) {
    const Instance &lower = a.priority < b.priority ? first : second, &higher = &lower == &first ? second : first;
    if (!IsWithin(world, lower, higher)) return {};
    return WarningAt(world, lower) + "this solid lies inside that of " + PlaceOf(world, higher) +
           ", whose material has a higher priority: it is invisible";
  }
  if (a.ir == b.ir || !Overlap(world, first, second)) return {};
  return WarningAt(world, second) + "this solid and that of " + PlaceOf(world, first) +
         " overlap, refract differently and have the same priority; the one that comes first fills the overlap, "
         "unless a priority says otherwise";
}

/// Reports clear solids that claim the same place: the order of the file decides which of them refracts there, or a
/// priority that hides one of them.
std::vector<std::string> ClaimsOfOnePlace(const Inspection& inspection) {
  std::vector<const Instance*> clear;
  for (const Instance& instance : inspection.world.Instances())
    if (instance.is_medium && instance.IsClear()) clear.push_back(&instance);
  constexpr std::size_t most = 200;  // all pairs of these are tested, in 0.1 s
  if (clear.size() > most) clear.resize(most);
  for (std::size_t i = 0; i < clear.size(); ++i)
    for (std::size_t j = i + 1; j < clear.size(); ++j)
      if (std::string line = ContradictionOf(inspection.world, *clear[i], *clear[j]); !line.empty()) return {line};
  return {};
}

// clang-format would split entries over many lines.
// clang-format off
constexpr Question contact_questions[] = {
    {Effort::hint, PlacedFaults{SurfacesInOnePlane}},
    {Effort::hint, SceneFault{LightsInSolids}},
    {Effort::check, ShapeFault{
      "this mesh refracts or absorbs, but is not closed or is turned inside out: its triangles do not bound a volume, "
      "so other solids in it or around it are not known to be", IsOpenGlass}},
    {Effort::check, ShapeFault{
      "this surface is transparent or absorbing, but one-sided: light that enters never leaves", IsGlassOfOneSide}},
    {Effort::check, PlacedFaults{ClaimsOfOnePlace}},
};
// clang-format on

}  // namespace

std::vector<std::string> ContactMistakes(const Inspection& inspection) { return Ask(contact_questions, inspection); }

}  // namespace ray
