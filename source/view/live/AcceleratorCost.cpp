#include "source/view/live/AcceleratorCost.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "source/render/Render.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

/// The same view, with its longer side as long as time allows.
RenderSettings Small(RenderSettings settings, const World& world) {
  constexpr double most_tests = 3e8;  // about a second of them on one core
  constexpr double longest = 96;      // pixels: enough rays for means of three digits
  settings.samples = 1;
  settings.budget = {};
  settings.crop.reset();
  settings.replay.reset();
  settings.denoise = settings.wants_passes = false;
  settings.threads = 1;
  const double pixels = static_cast<double>(settings.width) * settings.height;
  const double rays_per_pixel = std::max(1.0, ExpectedRays(settings) / pixels);
  const double affordable = most_tests / rays_per_pixel / std::max(1.0, static_cast<double>(world.Primitives()));
  const double shrink =
      std::min({1.0, longest / std::max(settings.width, settings.height), std::sqrt(affordable / pixels)});
  settings.width = std::max(1, static_cast<int>(settings.width * shrink));
  settings.height = std::max(1, static_cast<int>(settings.height * shrink));
  return settings;
}

}  // namespace

std::vector<AcceleratorCost> CostsOfAccelerators(const World& world, const AcceleratorSettings& how,
                                                 const RenderSettings& settings) {
  const RenderSettings small = Small(settings, world);
  std::vector<AcceleratorCost> costs;
  for (const AcceleratorKind* kind : AcceleratorKinds()) {
    if (std::string(kind->name) == "auto") continue;
    AcceleratorCost cost{.name = kind->name};
    auto start = std::chrono::steady_clock::now();
    const auto accelerator = kind->Make(world, how);
    cost.build_seconds = SecondsSince(start);
    cost.bytes = accelerator->Bytes();
    start = std::chrono::steady_clock::now();
    const RayCounts rays = Render(world, *accelerator, small).rays;
    cost.render_seconds = SecondsSince(start);
    const auto total = static_cast<double>(std::max<std::uint64_t>(rays.Total(), 1));
    cost.boxes = static_cast<double>(rays.Cost().box_tests + rays.Cost().node_visits) / total;
    cost.tests = static_cast<double>(rays.Cost().primitive_tests) / total;
    costs.push_back(std::move(cost));
  }
  return costs;
}

}  // namespace ray
