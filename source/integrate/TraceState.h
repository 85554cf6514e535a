#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "R2/Color.h"
#include "R3/Ray.h"
#include "source/accelerate/Workspace.h"
#include "source/accelerate/World.h"
#include "source/integrate/RayCounts.h"
#include "source/sample/Sampler.h"

namespace ray {

/// A path as far as it is known: its last ray, and the throughput of what that sees.
struct PathState {
  R3::Ray ray;
  R2::Color throughput{1, 1, 1};
  std::int64_t depth = 0;  // bounces before it
  SampleIndex index;
  RayKind kind = RayKind::camera;
  int record = -1;  // where rays are recorded: its number; until it is traced that of the ray it comes from
};

/// A shadow ray still to be traced, and which of the points being shaded reflects how much unless it is stopped.
struct Shadow {
  std::size_t point = 0;
  R2::Color reflected;
};

class RayRecorder;

/// What one thread needs while tracing.
struct TraceState {
  Workspace workspace;
  RayCounts rays;
  std::vector<R3::Ray> batch;  // camera rays
  std::vector<std::optional<WorldHit>> hits;
  std::vector<PathState> pending;
  std::vector<R3::Ray> shadow_rays;
  std::vector<Shadow> shadows;              // one for each of them
  std::vector<R2::Color> arrived;           // at each point
  RayRecorder* recorder = nullptr;          // told of every ray; null for none
  const std::atomic<bool>* stop = nullptr;  // looked at before each few rays; null for none

  /// Then what is being traced is of no use to anybody, and loops may end early.
  bool IsStopped() const { return stop && stop->load(std::memory_order_relaxed); }

  /// Books rays of one kind and what the workspace has counted since the last.
  void Book(RayKind kind, std::size_t count) {
    RayCounts::Kind& account = rays[kind];
    account.rays += count;
    account.cost += workspace.counts;
    workspace.counts = {};
  }
};

}  // namespace ray
