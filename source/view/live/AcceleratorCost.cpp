#include "source/view/live/AcceleratorCost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

#include "source/render/Render.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

/// The settings of a small image of the view, with its longer side as long as time allows.
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

/// Returns std::nullopt if it was stopped.
std::optional<AcceleratorCost> CostOf(const AcceleratorKind& kind, const World& world, const AcceleratorSettings& how,
                                      const RenderSettings& small, const std::atomic<bool>& stop) {
  AcceleratorCost cost{.name = kind.name};
  auto start = std::chrono::steady_clock::now();
  const auto accelerator = kind.Make(world, how);
  cost.build_seconds = SecondsSince(start);
  cost.bytes = accelerator->Bytes();
  start = std::chrono::steady_clock::now();
  RenderMonitor monitor;
  monitor.stop = &stop;
  const RenderResult result = Render(world, *accelerator, small, monitor);
  if (!result.IsComplete()) return {};
  cost.render_seconds = SecondsSince(start);
  const RayCounts& rays = result.rays;
  const auto total = static_cast<double>(std::max<std::uint64_t>(rays.Total(), 1));
  cost.boxes = static_cast<double>(rays.Cost().box_tests + rays.Cost().node_visits) / total;
  cost.tests = static_cast<double>(rays.Cost().primitive_tests) / total;
  return cost;
}

}  // namespace

AcceleratorComparison::AcceleratorComparison(std::shared_ptr<const LoadedScene> scene, const AcceleratorSettings& how,
                                             const RenderSettings& settings)
    : scene_(std::move(scene)), how_(how), settings_(Small(settings, scene_->world)), thread_([this] { Run(); }) {}

AcceleratorComparison::~AcceleratorComparison() {
  Stop();
  thread_.join();
}

std::vector<AcceleratorCost> AcceleratorComparison::Costs() const {
  const std::lock_guard lock(mutex_);
  return costs_;
}

std::string AcceleratorComparison::Current() const {
  const std::lock_guard lock(mutex_);
  return current_;
}

void AcceleratorComparison::Begin(const std::string& kind) {
  const std::lock_guard lock(mutex_);
  current_ = kind;
  ++version_;
}

void AcceleratorComparison::Run() {
  for (const AcceleratorKind* kind : AcceleratorKinds()) {
    if (std::string(kind->name) == "auto") continue;
    if (stop_) break;
    Begin(kind->name);
    try {
      auto cost = CostOf(*kind, scene_->world, how_, settings_, stop_);
      if (!cost) break;
      const std::lock_guard lock(mutex_);
      costs_.push_back(std::move(*cost));
    } catch (const std::bad_alloc&) {
      continue;  // for this one there is no memory
    }
  }
  Begin({});
  has_ended_.store(true, std::memory_order_release);
}

}  // namespace ray
