#include "source/app/report/ContactCheck.h"

#include <algorithm>
#include <string>
#include <utility>

#include "source/accelerate/Accelerator.h"
#include "source/app/report/Check.h"
#include "source/integrate/lights/LightSampler.h"
#include "source/sample/Sampler.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

std::string AndMore(std::size_t count) { return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : ""; }

/// Two instances, the first of the file first.
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Whether both are seen where they lie in one plane: a clear solid, and what it stands on.
bool AreBothSeen(const Instance& a, const Instance& b) {
  return (a.is_medium && a.IsClear()) || (b.is_medium && b.IsClear());
}

/// Pairs of different materials, one of which hides the other where the camera sees both in one plane.
std::vector<Pair> PairsInOnePlane(const World& world, const RenderSettings& settings) {
  constexpr int side = 64;  // of the grid of rays
  const Camera camera = settings.view.value_or(world.scene().camera);
  const auto accelerator = FindAcceleratorKind("auto")->Make(world, {});
  Workspace workspace;
  std::vector<Pair> pairs;
  for (int i = 0; i < side * side; ++i) {
    // Places of the image that no model has its edges at.
    const double x = (i % side + 0.3719) / side * settings.width, y = (i / side + 0.4142) / side * settings.height;
    const auto ray = camera.RayThrough(x, y, settings.width, settings.height);
    const auto hit = ray ? accelerator->Intersect(*ray, workspace) : std::nullopt;
    if (!hit || !hit->is_contested) continue;
    const auto hits = accelerator->Coincident(*ray, *hit, workspace);
    for (const WorldHit& other : hits) {
      const Instance &first = world.Instances()[hits[0].instance], &second = world.Instances()[other.instance];
      if (first.material != second.material && !AreBothSeen(first, second))
        pairs.push_back({hits[0].instance, other.instance});
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void AddPairsInOnePlane(std::vector<std::string>& mistakes, const World& world, const RenderSettings& settings) {
  const std::vector<Pair> pairs = PairsInOnePlane(world, settings);
  if (pairs.empty()) return;
  const auto& [first, second] = pairs[0];
  mistakes.push_back(PlaceOf(world, world.Instances()[second]) +
                     ": warning: this shape lies in one plane with that of " +
                     PlaceOf(world, world.Instances()[first]) +
                     ", which comes first and hides it; they have different materials" + AndMore(pairs.size()));
}

/// Reports lights that only the inside of a shape sees: those without extent, since others are seen where they stick
/// out.
void AddLightsInSolids(std::vector<std::string>& mistakes, const World& world) {
  const auto is_closed_to_light = [](const Instance& i) { return i.shape->IsSolid() && IsBlack(i.material->kt); };
  if (SolidsAround(world, world.scene().camera.eye, is_closed_to_light) > 0) return;  // it may be a room
  std::string first;
  std::size_t count = 0;
  for (const Light* light : LightsOf(world.scene())) {
    const LightBound bound = light->Bound();
    if (bound.is_infinite || light->IsExtended()) continue;
    if (SolidsAround(world, bound.center, is_closed_to_light) == 0) continue;
    if (++count == 1) first = light->Describe();
  }
  if (count == 0) return;
  mistakes.push_back((world.scene().files.empty() ? "scene" : Escaped(world.scene().files[0])) + ": warning: the " +
                     first + " is inside of a shape that light does not leave" + AndMore(count));
}

bool IsOpenGlass(const Instance& instance) {
  const Material& m = *instance.material;
  const bool needs_inside = (instance.IsClear() && m.ir != 1) || !IsBlack(m.absorb);
  return instance.TwoSidedMesh() && instance.mesh->Elements() > 3 && needs_inside && !instance.is_repeated &&
         !instance.is_medium;
}

/// Reports materials that need both sides and have one.
void AddGlassOfOneSide(std::vector<std::string>& mistakes, const World& world) {
  const auto is_glass = [](const Instance& i) {
    return i.material->one_sided && (i.IsClear() || !IsBlack(i.material->absorb));
  };
  const auto& instances = world.Instances();
  const auto first = std::ranges::find_if(instances, is_glass);
  if (first == instances.end()) return;
  mistakes.push_back(PlaceOf(world, *first) +
                     ": warning: this surface is clear or absorbs, but has one side: what enters it does not leave" +
                     AndMore(static_cast<std::size_t>(std::ranges::count_if(instances, is_glass))));
}

void AddOpenGlass(std::vector<std::string>& mistakes, const World& world) {
  const auto& instances = world.Instances();
  const auto first = std::ranges::find_if(instances, IsOpenGlass);
  if (first == instances.end()) return;
  mistakes.push_back(PlaceOf(world, *first) +
                     ": warning: this mesh refracts or absorbs, but is not closed or is turned inside out: its "
                     "triangles do not bound a volume, so other solids in it or around it are not known to be" +
                     AndMore(static_cast<std::size_t>(std::ranges::count_if(instances, IsOpenGlass))));
}

/// Whether a place inside of both is found where their boxes overlap.
bool Overlap(const World& world, const Instance& a, const Instance& b) {
  constexpr std::uint32_t tries = 64;
  const R3::Box &p = a.bounds, &q = b.bounds;
  const R3::Point low{std::max(p.low.x, q.low.x), std::max(p.low.y, q.low.y), std::max(p.low.z, q.low.z)};
  const R3::Point high{std::min(p.high.x, q.high.x), std::min(p.high.y, q.high.y), std::min(p.high.z, q.high.z)};
  if (!(low.x < high.x && low.y < high.y && low.z < high.z)) return false;
  const auto is_one = [&](const Instance& i) { return &i == &a || &i == &b; };
  const Points points(SamplerKind::sobol, RandomKey(1), tries);
  for (std::uint32_t i = 0; i < tries; ++i) {
    const R2::Point xy = points.Get2D(i);
    const R3::Vector size = high - low;
    const R3::Point place = low + R3::Vector{xy.x * size.x, xy.y * size.y, (i + 0.5) / tries * size.z};
    if (SolidsAround(world, place, is_one) == 2) return true;
  }
  return false;
}

/// Reports clear solids that overlap: which of them refracts there is decided by the order of the file.
void AddClaims(std::vector<std::string>& mistakes, const World& world) {
  std::vector<const Instance*> clear;
  for (const Instance& instance : world.Instances())
    if (instance.is_medium && instance.IsClear()) clear.push_back(&instance);
  constexpr std::size_t most = 200;  // all pairs of these are looked at, in 0.1 s
  if (clear.size() > most) clear.resize(most);
  for (const Instance* a : clear)
    for (const Instance* b : clear) {
      const Material &of_a = *a->material, &of_b = *b->material;
      if (a >= b || of_a.ir == of_b.ir || of_a.priority != of_b.priority || !Overlap(world, *a, *b)) continue;
      mistakes.push_back(PlaceOf(world, *b) + ": warning: this solid and that of " + PlaceOf(world, *a) +
                         " overlap, refract differently and have the same priority; the one that comes first fills "
                         "the place, unless a priority says otherwise");
      return;
    }
}

}  // namespace

std::vector<std::string> ContactMistakes(const World& world, const RenderSettings& settings) {
  std::vector<std::string> mistakes;
  AddPairsInOnePlane(mistakes, world, settings);
  AddLightsInSolids(mistakes, world);
  AddOpenGlass(mistakes, world);
  AddGlassOfOneSide(mistakes, world);
  AddClaims(mistakes, world);
  return mistakes;
}

}  // namespace ray
