// Nanoseconds a ray of each shape's intersection, hits and misses in about equal parts. Every line of shapes.def has a
// row, so a new shape is measured the day it is listed.
//
//     make bench && build/bench/shapes

#include <benchmark/benchmark.h>

#include <random>
#include <string>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"

namespace {

/// Rays from a sphere around the shape towards points in a box somewhat larger than it.
std::vector<R3::Ray> RaysAt(const R3::Box& box) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const R3::Point center = box.Center();
  const double radius = box.Radius();
  const auto inside_cube = [&] { return R3::Vector{number(random), number(random), number(random)}; };
  std::vector<R3::Ray> rays;
  while (rays.size() < 4096) {
    const R3::Point origin = center + 5 * radius * Unit(inside_cube());
    const R3::Vector half = box.Size() * 0.6, r = inside_cube();
    const R3::Point target = center + R3::Vector{half.x * r.x, half.y * r.y, half.z * r.z};
    rays.push_back({origin, target - origin});
  }
  return rays;
}

void Intersect(benchmark::State& state, const R3::ShapeKind& kind) {
  const auto shape = kind.make(kind.example);
  const auto rays = RaysAt(Bounds(*shape));
  std::size_t i = 0;
  std::int64_t hits = 0;
  for (auto _ : state) {
    const auto hit = shape->Intersect(rays[i++ % rays.size()], 0);
    hits += hit.has_value();
    benchmark::DoNotOptimize(hit);
  }
  state.counters["hits"] = benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
}

void IntersectAndShade(benchmark::State& state, const R3::ShapeKind& kind) {
  const auto shape = kind.make(kind.example);
  const auto rays = RaysAt(Bounds(*shape));
  std::size_t i = 0;
  for (auto _ : state) {
    const R3::Ray& ray = rays[i++ % rays.size()];
    if (const auto hit = shape->Intersect(ray, 0)) benchmark::DoNotOptimize(shape->At(ray, *hit, 0));
  }
}

void BoxEntry(benchmark::State& state) {
  const R3::Box box{{-1, -0.5, -2}, {1.5, 1, 0.5}};
  const auto rays = RaysAt(box);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(Entry(box, R3::BoxRay(rays[i++ % rays.size()]), 0));
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto* kind : BoundedShapeKinds()) {
    benchmark::RegisterBenchmark((std::string("Intersect/") + kind->name).c_str(), Intersect, *kind);
    benchmark::RegisterBenchmark((std::string("IntersectAndShade/") + kind->name).c_str(), IntersectAndShade, *kind);
  }
  benchmark::RegisterBenchmark("BoxEntry", BoxEntry);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
