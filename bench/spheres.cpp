// Nanoseconds a ray among many spheres, with the structure that `auto` takes: rays from anywhere to anywhere, for the
// nearest hit and for any.
//
//     make bench && build/bench/spheres

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"

namespace {

/// In a cube of side 2; as many as they are, a tenth of it is filled.
ray::Scene RandomSpheres(std::int64_t count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  ray::Scene scene;
  for (std::int64_t i = 0; i < count; ++i) {
    const double radius = 0.55 / std::cbrt(static_cast<double>(count)) * (1 + 0.5 * number(random));
    ray::Node node;
    node.shape = R3::MakeShape("sphere", {number(random), number(random), number(random), radius});
    SetBounds(node);
    scene.root.children.push_back(std::move(node));
  }
  SetBounds(scene.root);
  return scene;
}

std::vector<R3::Ray> RandomRays() {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto inside = [&] { return R3::Point{number(random), number(random), number(random)}; };
  std::vector<R3::Ray> rays;
  while (rays.size() < 4096) {
    const R3::Point from = inside();
    rays.push_back({from, inside() - from, 0, 1});
  }
  return rays;
}

template <bool any>
void Trace(benchmark::State& state) {
  const ray::Scene scene = RandomSpheres(state.range(0));
  const ray::World world(scene);
  const auto accelerator = ray::FindAcceleratorKind("auto")->Make(world, {.name = "auto"});
  const auto rays = RandomRays();
  ray::Workspace workspace;
  std::size_t i = 0;
  for (auto _ : state) {
    const R3::Ray& ray = rays[i++ % rays.size()];
    if constexpr (any)
      benchmark::DoNotOptimize(accelerator->IsOccluded(ray, workspace));
    else
      benchmark::DoNotOptimize(accelerator->Intersect(ray, workspace));
  }
}

BENCHMARK(Trace<false>)->Name("Nearest")->Arg(40)->Arg(400)->Arg(100'000);
BENCHMARK(Trace<true>)->Name("Any")->Arg(40)->Arg(400)->Arg(100'000);

}  // namespace

BENCHMARK_MAIN();
