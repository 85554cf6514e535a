// Nanoseconds a ray among many solids of a kind, with the structure that `auto` takes: rays from anywhere to anywhere,
// one by one, for the nearest hit and for any; and camera rays in packets of sixteen. Turned solids are each in a group
// of its own; rods are cylinders ten times as long as they are thick.
//
//     make bench && build/bench/solids

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"

namespace {

using Random = std::mt19937_64;

double Uniform(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }
R3::Point InsideCube(Random& random) { return {Uniform(random), Uniform(random), Uniform(random)}; }

struct Kind {
  const char* name;
  const char* shape;
  std::function<std::vector<double>(const R3::Point& place, double size)> arguments;
  bool are_turned;
};

std::vector<double> Ball(const R3::Point& p, double r) { return {p.x, p.y, p.z, r}; }
std::vector<double> Cube(const R3::Point& p, double r) {
  return {p.x - r, p.y - r, p.z - r, p.x + r, p.y + r, p.z + r};
}
std::vector<double> Upright(const R3::Point& p, double r) { return {p.x, p.y, p.z, r, 2 * r}; }
std::vector<double> Thin(const R3::Point& p, double r) { return {p.x, p.y, p.z, r / 4, 5 * r}; }

const std::array kinds{
    Kind{"sphere", "sphere", Ball, false},
    Kind{"box", "box", Cube, false},
    Kind{"cylinder", "cylinder", Upright, false},
    Kind{"cone", "cone", Upright, false},
    Kind{"turned_sphere", "sphere", Ball, true},
    Kind{"turned_box", "box", Cube, true},
    Kind{"turned_cylinder", "cylinder", Upright, true},
    Kind{"turned_cone", "cone", Upright, true},
    Kind{"turned_rod", "cylinder", Thin, true},
};

/// To a place, and so that y points along `up`.
R3::Matrix Turned(const R3::Point& place, const R3::Vector& up) {
  const R3::Vector y = Unit(up), x = Unit(Cross(y, {0.5, 0.25, 1})), z = Cross(x, y);
  return {{{{x.x, y.x, z.x, place.x}, {x.y, y.y, z.y, place.y}, {x.z, y.z, z.z, place.z}}}};
}

/// In a cube of side 2; as many as they are, a tenth of it is filled.
ray::Scene RandomSolids(const Kind& kind, std::int64_t count) {
  Random random(5);
  ray::Scene scene;
  for (std::int64_t i = 0; i < count; ++i) {
    const double size = 0.55 / std::cbrt(static_cast<double>(count)) * (1 + 0.5 * Uniform(random));
    const R3::Point place = InsideCube(random), from = kind.are_turned ? R3::Point{} : place;
    ray::Node node;
    node.shape = R3::MakeShape(kind.shape, kind.arguments(from, size));
    SetBounds(node);
    ray::Node group;
    if (kind.are_turned) group.transform = Turned(place, FromOrigin(InsideCube(random)));
    group.children.push_back(std::move(node));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
  }
  SetBounds(scene.root);
  return scene;
}

std::vector<R3::Ray> RandomRays() {
  Random random(6);
  std::vector<R3::Ray> rays;
  while (rays.size() < 4096) {
    const R3::Point from = InsideCube(random);
    rays.push_back({from, InsideCube(random) - from, 0, 1});
  }
  return rays;
}

/// Sixteen neighbors of an image of 64 x 64 after the other.
std::vector<R3::Ray> CameraRays() {
  std::vector<R3::Ray> rays;
  for (int block = 0; block < 256; ++block)
    for (int i = 0; i < 16; ++i) {
      const int x = block % 16 * 4 + i % 4, y = block / 16 * 4 + i / 4;
      rays.push_back({{0, 0, 4}, {(x - 31.5) / 96, (y - 31.5) / 96, -1}});
    }
  return rays;
}

struct Traced {
  Traced(const Kind& kind, std::int64_t count)
      : scene(RandomSolids(kind, count)),
        accelerator(ray::FindAcceleratorKind("auto")->Make(world, {.name = "auto"})) {}

  ray::Scene scene;
  ray::World world{scene};
  std::unique_ptr<ray::Accelerator> accelerator;
  ray::Workspace workspace;
};

template <bool any>
void TraceSingle(benchmark::State& state, const Kind& kind) {
  Traced traced(kind, state.range(0));
  const auto rays = RandomRays();
  std::size_t i = 0;
  for (auto _ : state) {
    const R3::Ray& ray = rays[i++ % rays.size()];
    if constexpr (any)
      benchmark::DoNotOptimize(traced.accelerator->IsOccluded(ray, traced.workspace));
    else
      benchmark::DoNotOptimize(traced.accelerator->Intersect(ray, traced.workspace));
  }
}

void TracePackets(benchmark::State& state, const Kind& kind) {
  Traced traced(kind, state.range(0));
  const auto rays = CameraRays();
  std::array<std::optional<ray::WorldHit>, 16> hits;
  std::size_t i = 0;
  while (state.KeepRunningBatch(16)) {
    traced.accelerator->Intersect(std::span(rays).subspan(i % rays.size(), 16), hits.data(), traced.workspace);
    benchmark::DoNotOptimize(hits);
    i += 16;
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const Kind& kind : kinds) {
    const auto add = [&](const char* what, void (*trace)(benchmark::State&, const Kind&)) {
      benchmark::RegisterBenchmark((std::string(what) + "/" + kind.name).c_str(), trace, std::cref(kind))
          ->Arg(40)
          ->Arg(400)
          ->Arg(100'000);
    };
    add("Nearest", TraceSingle<false>);
    add("Any", TraceSingle<true>);
    add("Packet", TracePackets);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
