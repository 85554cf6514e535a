#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/twolevel/PrimitiveSet.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {
namespace {

// The ratio of box area to triangle area above which a grid may be faster; 3 is compact.
constexpr double thin_from = 12;
// The share of the time that rays would take in a tree that may be spent on building a grid. The fastest known grid
// takes three tenths of a tree's time (hair). So an abandoned build makes a render at most 1.4 times as long, and
// choosing the tree takes at most 1 / (0.4 + 0.3) times as long as the grid with its build would have.
constexpr double share_for_build = 0.4;
// The minimum build time of a grid, in seconds per primitive; the quickest of unusual scenes took 3.3e-6.
constexpr double least_build_per_primitive = 2e-6;
// The maximum number of rays traced to measure their time, as a share of the expected rays.
constexpr double share_for_trial = 0.05;

/// Returns the area of the triangles' boxes over that of the triangles themselves, both sides: the number of box
/// entries per hit. About 3 for compact triangles in any position, over 100 for slanted hairs.
double Thinness(const PrimitiveSet& primitives) {
  constexpr std::uint32_t sample = 4096;
  const std::uint32_t step = std::max(1u, primitives.Size() / sample);
  double boxes = 0, triangles = 0;
  for (std::uint32_t i = 0; i < primitives.Size(); i += step) {
    const R3::Mesh* mesh = primitives.MeshOf(i);
    if (!mesh) continue;
    const auto corners = mesh->Corners(primitives[i].element);
    const R3::Vector size = mesh->Bounds(primitives[i].element).Size();
    boxes += size.x * size.y + size.y * size.z + size.z * size.x;
    triangles += Length(Cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
  }
  return triangles > 0 && std::isfinite(boxes) ? boxes / triangles : 0;
}

/// Returns some of the rays that the render will trace: through side x side points of the camera's image, and onward
/// from their hits.
std::vector<R3::Ray> RaysOf(const World& world, const Accelerator& accelerator, int side) {
  std::vector<R3::Ray> rays;
  Workspace workspace;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto seen = world.scene().camera.RayThrough(x + 0.5, y + 0.5, side, side);
      if (!seen) continue;
      const R3::Ray ray = *seen;
      rays.push_back(ray);
      const auto hit = accelerator.Intersect(ray, workspace);
      if (!hit) continue;
      // Directions all around, rotated by the golden angle from one to the next.
      const auto turn = R1::SinCosTurns((2 - std::numbers::phi) * static_cast<double>(rays.size()));
      const double up = 1 - 2 * std::fmod(0.618033988749895 * static_cast<double>(rays.size()), 1.0);
      const double out = std::sqrt(std::max(0.0, 1 - up * up));
      const R3::Vector direction{out * turn.cosine, up, out * turn.sine};
      rays.push_back({SpawnPoint(world.At(ray, *hit), direction), direction});
    }
  return rays;
}

double SecondsFor(const Accelerator& accelerator, const std::vector<R3::Ray>& rays) {
  Workspace workspace;
  const auto start = std::chrono::steady_clock::now();
  for (const R3::Ray& ray : rays) accelerator.Intersect(ray, workspace);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Makes the named accelerator and records the reason.
std::unique_ptr<Accelerator> Take(const std::string& name, const std::string& reason, const World& world,
                                  const AcceleratorSettings& settings) {
  auto accelerator = FindAcceleratorKind(name)->Make(world, settings);
  accelerator->reasons.push_back("auto chose " + name + ": " + reason);
  return accelerator;
}

/// Returns true if there is at most one primitive, and testing it takes no longer than testing its box.
bool IsCheap(const World& world) {
  if (world.Primitives() == 0) return true;
  const auto is_cheap = [](const Instance& i) { return i.is_repeated || i.form != R3::Form::other; };
  return world.Primitives() == 1 && std::ranges::all_of(world.Instances(), is_cheap);
}

/// Returns the shortest time of several rounds, which is the least disturbed one.
double LeastSecondsFor(const Accelerator& accelerator, const std::vector<R3::Ray>& rays, int rounds) {
  double seconds = R3::infinity;
  for (int i = 0; i < rounds; ++i) seconds = std::min(seconds, SecondsFor(accelerator, rays));
  return seconds;
}

std::string Nanoseconds(double seconds) { return Fixed(1e9 * seconds, 0) + " ns per ray"; }

/// Returns the faster of a tree and a grid, whose build may take no longer than it can save.
std::unique_ptr<Accelerator> Try(const std::string& shown, const World& world, const AcceleratorSettings& settings) {
  auto bvh = FindAcceleratorKind("bvh")->Make(world, settings);
  const auto take_bvh = [&](const std::string& reason) {
    bvh->reasons = {"auto chose bvh: " + reason};
    return std::move(bvh);
  };
  constexpr int most_on_a_side = 20, first_rounds = 2, rounds = 5;
  constexpr double rays_per_place = 2 * (first_rounds + 2 * rounds);  // through the camera, and onward from its hits
  const double places = share_for_trial * settings.expected_rays / rays_per_place;
  const int side = static_cast<int>(std::sqrt(std::clamp(places, 0.0, 1.0 * most_on_a_side * most_on_a_side)));
  if (side == 0) return take_bvh("too few rays to try a grid, though " + shown);
  const std::vector<R3::Ray> rays = RaysOf(world, *bvh, side);
  if (rays.empty()) return take_bvh("the camera has no rays to try a grid with, though " + shown);
  const auto count = static_cast<double>(rays.size());
  const double in_bvh = LeastSecondsFor(*bvh, rays, first_rounds) / count;
  constexpr auto most_threads = tbb::global_control::max_allowed_parallelism;
  const auto threads = static_cast<double>(tbb::global_control::active_value(most_threads));
  AcceleratorSettings within = settings;
  // Two of three expected rays start where a camera ray hits.
  const double hits_per_place = std::max(0.0, count / (side * side) - 1);
  const double rays_left = settings.expected_rays * (1 + 2 * hits_per_place) / 3;
  within.most_build_seconds = share_for_build * rays_left * in_bvh / threads;
  const std::string tried = "auto tried " + std::to_string(rays.size()) + " rays: bvh " + Nanoseconds(in_bvh);
  std::unique_ptr<Accelerator> grid;
  try {
    if (within.most_build_seconds > least_build_per_primitive * static_cast<double>(world.Primitives()))
      grid = FindAcceleratorKind("grid")->Make(world, within);
  } catch (const BuildTookTooLong&) {
  }
  if (!grid) {
    auto chosen = take_bvh("a grid would take more than " + Fixed(within.most_build_seconds, 3) +
                           " s to build, too long for its rays; considered because " + shown);
    chosen->reasons.insert(chosen->reasons.begin(), tried);
    return chosen;
  }
  const double in_grid = LeastSecondsFor(*grid, rays, rounds) / count;
  const double again = std::min(in_bvh, LeastSecondsFor(*bvh, rays, rounds) / count);
  auto faster = std::move(in_grid < again ? grid : bvh);
  faster->reasons = {"auto tried " + std::to_string(rays.size()) + " rays: bvh " + Nanoseconds(again) + ", grid " +
                         Nanoseconds(in_grid),
                     "auto chose " + faster->kind + ": the faster one; both were tried because " + shown};
  return faster;
}

/// Chooses by the composition of the scene, and tries both candidates if either may be faster.
std::unique_ptr<Accelerator> Choose(const World& world, const AcceleratorSettings& settings) {
  const auto take = [&](const char* name, const std::string& reason) { return Take(name, reason, world, settings); };
  const std::string primitives = Counted(static_cast<std::uint64_t>(world.Primitives()), "primitive");
  if (IsCheap(world)) return take("none", primitives + ": testing it is faster");
  const double thinness = Thinness(PrimitiveSet(world));
  if (thinness == 0) return take("bvh", "more than one primitive, or one that takes long to test, and no triangles");
  const std::string shown = "bounding boxes have " + Fixed(thinness, 1) + " times the triangles' area";
  if (thinness < thin_from) return take("bvh", shown + " (thin from " + Fixed(thin_from, 1) + ")");
  return Try(shown, world, settings);
}

}  // namespace

extern const AcceleratorKind auto_kind{"auto", "chooses one for the scene; -explain says which and why", Choose};

}  // namespace ray
