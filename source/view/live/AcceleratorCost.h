#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// What an accelerator costs to build, to keep, and per ray of a picture.
struct AcceleratorCost {
  std::string name;
  double build_seconds = 0, render_seconds = 0;  // of a small picture, on one thread
  std::size_t bytes = 0;                         // besides the world's own
  double boxes = 0, tests = 0;                   // per ray: boxes, nodes and cells; primitives
};

/// Builds every kind of accelerators.def but `auto`, one after another in the background, and renders with it the
/// picture of the settings at one sample per pixel, made so small that trying every primitive for every ray takes
/// seconds at most. Numbers per ray are the same every time, seconds are this machine's.
class AcceleratorComparison {
 public:
  AcceleratorComparison(std::shared_ptr<const LoadedScene> scene, const AcceleratorSettings& how,
                        const RenderSettings& settings);
  /// Stops, and waits for the accelerator that is being built.
  ~AcceleratorComparison();
  AcceleratorComparison(const AcceleratorComparison&) = delete;

  /// Lets no further kind begin, and returns at once.
  void Stop() { stop_.store(true); }
  bool HasEnded() const { return has_ended_.load(std::memory_order_acquire); }
  /// The costs found so far.
  std::vector<AcceleratorCost> Costs() const;
  /// The kind being measured; empty at the end.
  std::string Current() const;
  /// Grows whenever the functions above would return something new.
  int Version() const { return version_.load(std::memory_order_acquire); }

 private:
  void Run();
  void Begin(const std::string& kind);

  const std::shared_ptr<const LoadedScene> scene_;
  const AcceleratorSettings how_;
  const RenderSettings settings_;
  std::atomic<bool> stop_ = false, has_ended_ = false;
  std::atomic<int> version_ = 0;
  mutable std::mutex mutex_;  // guards the two below
  std::vector<AcceleratorCost> costs_;
  std::string current_;
  std::thread thread_;  // the last, so that the other members exist when it starts
};

}  // namespace ray
