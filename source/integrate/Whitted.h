#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "source/integrate/Integrator.h"
#include "source/integrate/Tracer.h"
#include "source/integrate/lights/LightSource.h"
#include "source/integrate/lights/LightTree.h"

namespace ray {

/// The course's ray tracer:
///     I = e + ka Ia + sum over lights of S_L (kd (N.L) + ks (V.R)^n) I_L + ks I_R + kt I_T
/// Light from an environment is added to the sum as kd / pi times the light that arrives, weighted by the cosine;
/// mirrors see the environment directly.
///   source   Whitted, An improved illumination model for shaded display (1980); the .scn language's surface equation;
///            glossy reflections after Cook, Porter, Carpenter, Distributed ray tracing (1984)
class Whitted : public Integrator {
 public:
  Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 protected:
  const World& world() const { return world_; }
  /// The lights of the scene that are not black.
  std::span<const Light* const> Lights() const { return scene_lights_; }

 private:
  /// Returns the radiance along a path whose first point and radiance there are known.
  R2::Color Follow(const ShadingPoint& first, const R2::Color& radiance, TraceState& state) const;
  /// Sets the radiance of each point to its emission and the light that it reflects of the lights.
  virtual void Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const;
  /// Adds the reflected light of one light; `which` is its key below a surface.
  void AddLight(const LightSource& light, std::uint64_t which, std::span<const ShadingPoint> points,
                std::span<R2::Color> radiances, TraceState& state) const;
  /// Adds the reflected light of a few lights, chosen by importance sampling, that represent all.
  void AddChosenLights(std::span<const ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const;
  void AddSample(const LightSource& light, const ShadingPoint& p, std::size_t index, const R2::Point& u, double weight,
                 TraceState& state) const;
  /// Calls AddSample for the numbers of `random` from `first` on, at most LightSamples::most of them.
  void AddSamples(const LightSource& light, const ShadingPoint& p, std::size_t index, const Points& random,
                  std::uint64_t first, std::uint32_t count, double weight, TraceState& state) const;
  void AddArrived(std::span<R2::Color> radiances, TraceState& state) const;
  /// Pushes the rays that a surface reflects and transmits onto state.pending, unless the path ends here or `room`, the
  /// number of descendants that the camera ray may still have, is used up. Returns the number of pushed rays.
  int PushSpawned(const ShadingPoint& p, int room, TraceState& state) const;
  /// Implements PushSpawned for a surface that may reflect or transmit.
  int PushSpecular(const ShadingPoint& p, int room, TraceState& state) const;
  /// Pushes the rays that a surface reflects and transmits.
  void Spawn(const ShadingPoint& p, TraceState& state) const;
  void SpawnGlossy(const ShadingPoint& p, const R2::Color& throughput, const SampleIndex& back,
                   std::vector<PendingPath>& pending) const;
  /// Returns the throughput of a child ray; std::nullopt if it is not followed because it is faint and does not
  /// survive.
  std::optional<R2::Color> Continued(const R2::Color& throughput, const SampleIndex& index, TraceState& state) const;

  const World& world_;
  Tracer tracer_;
  TraceSettings settings_;
  bool has_roulette_;
  std::vector<const Light*> scene_lights_;          // those that are not black
  LightSources lights_;                             // all except the environment
  std::unique_ptr<const LightSource> environment_;  // if it shines
  std::optional<LightTree> tree_;                   // over lights_, if lights are chosen by importance
};

}  // namespace ray
