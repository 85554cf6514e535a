#pragma once

#include "source/integrate/Integrator.h"
#include "source/integrate/lights/PathLights.h"

namespace ray {

/// Distributed ray tracing: light arrives over every number of bounces up to max_depth, each bounce going one way,
/// chosen at random among diffuse scattering, the reflection (a mirror's, or over Phong's lobe with `glossy`) and
/// transmission. Units are the course's: kd and ks are the shares that are scattered, so an emission or an environment
/// L is a radiance and is scattered as
///
///     kd / pi * cosine + ks (n + 1) / (2 pi) (V.R)^n      (the second term only with `glossy`)
///
/// while lights of the scene language scatter by Phong's formula as they do in Whitted. Shapes that emit and are no
/// triangles are seen, directly and in mirrors, and light nothing, as the language has it.
///   source   Cook, Porter, Carpenter, Distributed ray tracing (1984); Kajiya, The rendering equation (1986); lights
///            and scattering combined by the balance heuristic of Veach and Guibas, Optimally combining sampling
///            techniques (1995); roulette of Arvo and Kirk, Particle transport and image synthesis (1990)
class Path : public Integrator {
 public:
  Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  struct Bounce;
  struct Lobes;

  R2::Color Shining(const ShadingPoint& surface) const;
  R2::Color Continue(ShadingPoint surface, TraceState& state) const;
  /// Shadow rays to lights, with what they bring to `surface`, its weight included; `index` is where it arrives.
  void AddLight(const ShadingPoint& surface, std::size_t index, TraceState& state) const;
  void AddLightSample(const ShadingPoint& surface, const Lobes& lobes, const PathLightSample& light, std::size_t index,
                      TraceState& state) const;
  void TraceShadowRays(TraceState& state, bool together) const;
  std::optional<Bounce> Scatter(const ShadingPoint& surface) const;
  std::optional<Bounce> ScatterMatte(const ShadingPoint& surface, const Lobes& lobes, const R2::Point& random,
                                     bool by_lobe) const;
  bool Survives(PathState& ray, double random) const;
  R2::Color Emitted(const ShadingPoint& from, const Bounce& bounce, const ShadingPoint& hit) const;
  R2::Color EmittedByEnvironment(const ShadingPoint& from, const Bounce& bounce) const;
  Lobes LobesOf(const ShadingPoint& surface) const;
  double MisWeight(double density_of_scattering, double density_of_light) const;

  const World& world_;
  const Accelerator& accelerator_;
  TraceSettings settings_;
  SamplerKind sampler_;
  PathLights lights_;
  bool has_roulette_, finds_lights_, finds_by_scattering_;
  int lights_at_once_;  // 0: all
};

}  // namespace ray
