#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "R1/BatchSize.h"
#include "R2/Color.h"
#include "R3/Departure.h"
#include "R3/Ray.h"
#include "R3/SearchLimit.h"
#include "source/accelerate/Workspace.h"
#include "source/accelerate/World.h"
#include "source/integrate/Arena.h"
#include "source/integrate/RayCounts.h"
#include "source/integrate/media/MediumSets.h"
#include "source/sample/Sampler.h"

namespace ray {

/// A path as far as it is known, but for its last ray.
struct PathState {
  R2::Color throughput{1, 1, 1};  // of what the ray sees
  std::int64_t depth = 0;         // bounces before it
  SampleIndex index{};
  RayKind kind = RayKind::camera;
  bool is_scattered = false;     // by some surface, not only mirrored and refracted
  MediumSets::Number media = 0;  // what it is inside of
  int record = -1;  // where rays are recorded: its number; until it is traced that of the ray it comes from
};

/// A path that waits to be traced.
struct PendingPath {
  R3::Ray ray;
  PathState path;
};

/// Shadow rays still to be traced together, and which of the points being shaded reflects how much unless its ray is
/// stopped.
struct ShadowRays {
  static constexpr std::size_t capacity = R1::batch_size;

  std::size_t count = 0;
  std::array<R3::Ray, capacity> rays;
  std::array<std::size_t, capacity> point;
  std::array<R2::Color, capacity> reflected;

  bool IsFull() const { return count == capacity; }
  R3::Ray& Next() { return rays[count]; }
  std::span<const R3::Ray> Rays() const { return std::span(rays).first(count); }
};

class RayRecorder;

/// What one thread needs while tracing.
struct TraceState {
  Workspace workspace;
  RayCounts rays;
  std::vector<R3::Ray> batch;  // camera rays
  std::vector<std::optional<WorldHit>> hits;
  std::vector<std::uint32_t> ray_of;  // which of the camera rays led to each point
  std::vector<R2::Color> sent_back;   // by each of their points
  std::vector<PendingPath> pending;
  // What rays point to that wait, or that have gone through a surface.
  Arena<R3::Departure> departures;
  Arena<R3::Crossed> crossings;
  MediumSets media;
  struct CameraRay {
    R3::Point origin;
    double time;
    MediumSets::Number media;
  };
  std::optional<CameraRay> last_camera_ray;  // whose media are known
  ShadowRays shadows;
  std::vector<R2::Color> arrived;           // at each point
  RayRecorder* recorder = nullptr;          // told of every ray; null for none
  const std::atomic<bool>* stop = nullptr;  // looked at before each few rays; null for none
  std::optional<R3::SearchLimit::Clock::time_point> deadline;  // likewise

  /// Before camera rays are traced, all before being done.
  void Begin() {
    departures.Shrink(0), crossings.Shrink(0);
    media.Clear();
    last_camera_ray.reset();
  }

  /// Then what is being traced is of no use to anybody, and loops may end early.
  bool IsStopped() const { return R3::SearchLimit::IsReached(stop, deadline); }

  /// Counts rays of one kind and what the workspace has counted since the last.
  void Count(RayKind kind, std::size_t count) {
    RayCounts::Kind& of_kind = rays[kind];
    of_kind.rays += count;
    of_kind.cost += workspace.counts;
    workspace.counts = {};
  }
};

}  // namespace ray
