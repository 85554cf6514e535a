#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "source/inspect/LoadedScene.h"
#include "tests/Project.h"

namespace ray::testing {

/// An accelerator that does as another does, once it may.
class Gate : public Accelerator {
 public:
  explicit Gate(const World& world, std::unique_ptr<const Accelerator> inner, std::int64_t open_for = 0)
      : Accelerator(world), inner_(std::move(inner)), left_(open_for) {}
  void Open(std::int64_t rays) const { left_ += rays; }
  bool IsShut() const { return left_ <= 0; }
  std::int64_t Waiting() const { return waiting_; }

 private:
  void Pass() const {
    ++waiting_;
    while (left_.fetch_sub(1) <= 0) {
      ++left_;
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    --waiting_;
  }
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override {
    Pass();
    if (const auto hit = inner_->Intersect(ray, workspace)) nearest.Offer(*hit);
  }
  bool Any(const R3::Ray& ray, Workspace& workspace) const override { return inner_->IsOccluded(ray, workspace); }

  std::unique_ptr<const Accelerator> inner_;
  mutable std::atomic<std::int64_t> left_, waiting_ = 0;
};

/// A scene without mirrors, whose camera rays wait at a gate.
struct Gated {
  explicit Gated(std::int64_t open_for, const std::string& file = project::Root() / "scenes/area_light.scn")
      : scene(std::make_shared<LoadedScene>(file, ParseOptions{}, AcceleratorSettings{})) {
    auto held = std::make_unique<Gate>(scene->world, std::move(scene->accelerator), open_for);
    gate = held.get();
    scene->accelerator = std::move(held);
  }
  std::shared_ptr<LoadedScene> scene;
  const Gate* gate;
};

}  // namespace ray::testing
