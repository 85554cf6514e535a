#pragma once

#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/EmissiveTriangle.h"
#include "source/integrate/Random.h"
#include "source/integrate/RayCounts.h"
#include "source/integrate/TraceSettings.h"

namespace ray {

/// What one thread needs while tracing.
struct TraceState {
  /// A ray still to be traced, and how much of what it sees counts.
  struct Pending {
    R3::Ray ray;
    R2::Color weight;
    std::int64_t depth = 0;
    RandomKey key{0};
    RayKind kind = RayKind::camera;
  };

  Workspace workspace;
  RayCounts rays;
  std::vector<Pending> pending;

  /// Books a ray and what the workspace has counted since the last.
  void Book(RayKind kind) {
    RayCounts::Kind& account = rays[kind];
    ++account.rays;
    account.cost += workspace.counts;
    workspace.counts = {};
  }
};

/// The course's ray tracer:
///     I = e + ka Ia + sum over lights of S_L (kd (N.L) + ks (V.R)^n) I_L + ks I_R + kt I_T
///   source   Whitted, An improved illumination model for shaded display (1980); the .scn language's surface equation
class Whitted {
 public:
  Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  /// Light coming back along a camera ray, per channel, linear. The key makes its random numbers its own.
  R2::Color Radiance(const R3::Ray& camera_ray, const RandomKey& key, TraceState& state) const;

 private:
  struct Surface;

  R2::Color Shade(const Surface& surface, const RandomKey& key, TraceState& state) const;
  R2::Color FromLight(const Light& light, const Surface& surface, const RandomKey& key, TraceState& state) const;
  R2::Color FromTriangle(const EmissiveTriangle& triangle, const Surface& surface, const RandomKey& key,
                         TraceState& state) const;
  bool IsVisible(const R3::Ray& shadow_ray, TraceState& state) const;
  void Spawn(const Surface& surface, const TraceState::Pending& parent, TraceState& state) const;

  const World& world_;
  const Accelerator& accelerator_;
  TraceSettings settings_;
  std::vector<const Light*> lights_;  // those that are not black
  std::vector<EmissiveTriangle> triangles_;
};

}  // namespace ray
