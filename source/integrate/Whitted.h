#pragma once

#include <span>
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

  /// A shadow ray still to be traced, and which of the surfaces being shaded reflects how much unless it is stopped.
  struct Shadow {
    std::size_t surface = 0;
    R2::Color reflected;
  };

  Workspace workspace;
  RayCounts rays;
  std::vector<Pending> pending;
  std::vector<R3::Ray> shadow_rays;
  std::vector<Shadow> shadows;     // one for each of them
  std::vector<R2::Color> arrived;  // at each surface

  /// Books rays of one kind and what the workspace has counted since the last.
  void Book(RayKind kind, std::size_t count) {
    RayCounts::Kind& account = rays[kind];
    account.rays += count;
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

  /// A camera ray, and the key that makes its random numbers its own.
  struct Sample {
    R3::Ray ray;
    RandomKey key;
  };

  /// Light coming back along each of some camera rays, per channel, linear. Rays of neighbouring pixels are best given
  /// together, since they and their shadow rays then are traced together; what each brings back is the same.
  void Radiance(std::span<const Sample> samples, std::span<R2::Color> radiances, TraceState& state) const;

 private:
  struct Surface;

  R2::Color Follow(const Surface& first, TraceState& state) const;
  Surface SurfaceAt(const TraceState::Pending& ray, const WorldHit& hit) const;
  /// Adds to each surface's radiance what it shines and scatters by itself.
  void Shade(std::span<Surface> surfaces, TraceState& state) const;
  /// One light's share of that; `which` is its number among random keys.
  template <typename AnyLight>
  void AddLight(const AnyLight& light, std::uint64_t which, std::span<Surface> surfaces, TraceState& state) const;
  void TraceShadowRays(TraceState& state) const;
  void Spawn(const Surface& surface, TraceState& state) const;

  const World& world_;
  const Accelerator& accelerator_;
  TraceSettings settings_;
  std::vector<const Light*> lights_;  // those that are not black
  std::vector<EmissiveTriangle> triangles_;
};

}  // namespace ray
