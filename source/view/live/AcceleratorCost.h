#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/inspect/LoadedScene.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The cost of an accelerator: to build, to keep, and per ray of an image.
struct AcceleratorCost {
  std::string name;
  double build_seconds = 0, render_seconds = 0;  // of a small image, on one thread
  std::size_t bytes = 0;                         // besides the world's own
  double boxes = 0, tests = 0;                   // per ray: boxes, nodes and cells; primitives
};

/// Builds every kind of accelerators.def but `auto`, one after another in the background, and renders with it the
/// image of the settings at one sample per pixel, made so small that trying every primitive for every ray takes
/// seconds at most. Numbers per ray are the same every time, seconds are this machine's.
class AcceleratorComparison {
 public:
  AcceleratorComparison(std::shared_ptr<const LoadedScene> scene, const AcceleratorSettings& how,
                        const RenderSettings& settings);
  /// Stops, and waits for the accelerator that is being built.
  ~AcceleratorComparison();
  AcceleratorComparison(const AcceleratorComparison&) = delete;

  /// Prevents that further kinds begin, and returns at once.
  void Stop() { stop_.store(true); }
  bool HasEnded() const { return has_ended_.load(std::memory_order_acquire); }
  /// The costs found so far.
  std::vector<AcceleratorCost> Costs() const;
  /// The kind being measured; empty at the end.
  std::string Current() const;
  /// Grows whenever results of the functions above change.
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

/// The last comparison of accelerators, and earlier ones of other scenes that have not ended.
class AcceleratorComparisons {
 public:
  void Begin(std::shared_ptr<const LoadedScene> scene, const AcceleratorSettings& how, const RenderSettings& settings) {
    Forget();
    current_ = std::make_unique<AcceleratorComparison>(std::move(scene), how, settings);
    seen_ = 0;
  }
  void Stop() {
    if (current_) current_->Stop();
  }
  /// Another scene is shown.
  void Forget() {
    Stop();
    if (current_) ending_.push_back(std::move(current_));
  }

  /// Null before the first, and for another scene.
  const AcceleratorComparison* Current() const { return current_.get(); }
  bool IsBusy() const { return current_ && !current_->HasEnded(); }
  /// Returns true if there are more results since the last call; to be called regularly.
  bool HasNews() {
    std::erase_if(ending_, [](const auto& comparison) { return comparison->HasEnded(); });
    const int seen = seen_;
    if (current_) seen_ = current_->Version();
    return seen_ != seen;
  }

 private:
  std::unique_ptr<AcceleratorComparison> current_;
  std::vector<std::unique_ptr<AcceleratorComparison>> ending_;
  int seen_ = 0;  // version of the current one
};

}  // namespace ray
