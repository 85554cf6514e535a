#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/twolevel/PrimitiveSet.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr std::int64_t few_primitives = 3;  // tested in the time that it takes to find out which to test
constexpr double thin_from = 12;            // box over triangle area from which a grid is worth a try; 3 is compact
constexpr double pays_from = 20;            // rays per primitive from which building a second structure is forgotten

/// Area of the boxes of triangles over that of the triangles themselves, both sides: what a ray that enters a box
/// has against it. About 3 for compact triangles in any position, over 100 for slanted hairs.
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

/// A few hundred of the rays that the render will trace: through the camera, and on from where those hit.
std::vector<R3::Ray> RaysOf(const World& world, const Accelerator& accelerator) {
  constexpr int side = 20;
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
      // Directions all around, turned by the golden angle from one to the next.
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

/// By name, and why.
std::unique_ptr<Accelerator> Take(const std::string& name, const std::string& reason, const World& world,
                                  const AcceleratorSettings& settings) {
  auto accelerator = FindAcceleratorKind(name)->Make(world, settings);
  accelerator->reasons.push_back("auto chose " + name + ": " + reason);
  return accelerator;
}

/// The faster of a tree and a grid.
std::unique_ptr<Accelerator> Try(const std::string& shown, const World& world, const AcceleratorSettings& settings) {
  auto bvh = FindAcceleratorKind("bvh")->Make(world, settings),
       grid = FindAcceleratorKind("grid")->Make(world, settings);
  const std::vector<R3::Ray> rays = RaysOf(world, *bvh);
  double bvh_seconds = R3::infinity, grid_seconds = R3::infinity;
  constexpr int rounds = 5;  // the least of them is the least disturbed
  for (int i = 0; i < rounds; ++i) {
    bvh_seconds = std::min(bvh_seconds, SecondsFor(*bvh, rays));
    grid_seconds = std::min(grid_seconds, SecondsFor(*grid, rays));
  }
  const double per_ray = 1e9 / static_cast<double>(rays.size());
  auto faster = std::move(grid_seconds < bvh_seconds ? grid : bvh);
  faster->reasons = {"auto tried " + std::to_string(rays.size()) + " rays: bvh " + Fixed(bvh_seconds * per_ray, 0) +
                         " ns, grid " + Fixed(grid_seconds * per_ray, 0) + " ns per ray",
                     "auto chose " + faster->kind + ": the faster one; both were tried because " + shown};
  return faster;
}

/// By what the scene is made of, and between two that may both be right by trying them.
std::unique_ptr<Accelerator> Choose(const World& world, const AcceleratorSettings& settings) {
  const auto take = [&](const char* name, const std::string& reason) { return Take(name, reason, world, settings); };
  if (world.Primitives() <= few_primitives)
    return take("none", "few primitives (" + std::to_string(world.Primitives()) + "): testing all is faster");
  const PrimitiveSet primitives(world);
  const double thinness = Thinness(primitives);
  const std::string shown = "bounding boxes have " + Fixed(thinness, 1) + " times the triangles' area";
  if (thinness < thin_from)
    return take("bvh",
                "more than " + std::to_string(few_primitives) + " primitives, and " +
                    (thinness > 0 ? shown + " (thin from " + Fixed(thin_from, 1) + ")" : "no triangles in the world"));
  if (settings.expected_rays < pays_from * static_cast<double>(primitives.Size()))
    return take("grid", shown + ": too thin for a BVH; too few rays to try both");
  return Try(shown, world, settings);
}

}  // namespace

extern const AcceleratorKind auto_kind{"auto", "chooses one for the scene; -explain says which and why", Choose};

}  // namespace ray
