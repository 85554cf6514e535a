#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "R1/Columns.h"
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

/// The state of a path before its last ray.
struct PathState {
  R2::Color throughput{1, 1, 1};  // of the light at the ray's end
  std::int64_t depth = 0;         // bounces before it
  SampleIndex index{};
  RayKind kind = RayKind::camera;
  bool is_scattered = false;     // by any surface, not only mirrored and refracted
  MediumSets::Number media = 0;  // the solids that it is inside of
  // number of the ray, if rays are recorded; until it is traced that of its parent
  int record = -1;
};

/// A path that waits to be traced.
struct PendingPath {
  R3::Ray ray;
  PathState path;
};

/// Shadow rays to be traced together. For each, the point being shaded that it starts from, and the light that the
/// point reflects unless the ray is occluded.
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
class SharedPaths;

/// The state of one thread while tracing.
struct TraceState {
  Workspace workspace;
  RayCounts rays;
  std::vector<R3::Ray> batch;  // camera rays
  std::vector<std::optional<WorldHit>> hits;
  std::vector<std::uint32_t> ray_of;  // the camera ray that led to each point
  std::vector<R2::Color> sent_back;   // by each of their points
  std::vector<PendingPath> pending;
  // Referenced by rays that wait, or that have crossed a surface.
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
  RayRecorder* recorder = nullptr;          // receives every ray; null for none
  SharedPaths* shared = nullptr;            // receives paths that share light; null for none
  const std::atomic<bool>* stop = nullptr;  // checked before every few rays; null for none
  std::optional<R3::SearchLimit::Clock::time_point> deadline;  // checked like `stop`

  /// Resets the state before camera rays are traced, which must all be done.
  void Begin() {
    departures.Shrink(0), crossings.Shrink(0);
    media.Clear();
    last_camera_ray.reset();
  }

  /// Returns true if the results are no longer needed, so that loops may end early.
  bool IsStopped() const { return R3::SearchLimit::IsReached(stop, deadline); }

  /// Counts rays of one kind and the costs in the workspace since the last call.
  void Count(RayKind kind, std::size_t count) {
    RayCounts::Kind& of_kind = rays[kind];
    of_kind.rays += count;
    of_kind.cost += workspace.counts;
    workspace.counts = {};
  }
};

}  // namespace ray
