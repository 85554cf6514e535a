#pragma once

#include <optional>
#include <span>
#include <vector>

#include "source/integrate/Integrator.h"
#include "source/integrate/ShadingPoint.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/integrate/lights/LightTree.h"

namespace ray {

/// The course's ray tracer:
///     I = e + ka Ia + sum over lights of S_L (kd (N.L) + ks (V.R)^n) I_L + ks I_R + kt I_T
/// Light from an environment is added to the sum as kd / pi times what comes through the cosine; a mirror sees it
/// anyway.
///   source   Whitted, An improved illumination model for shaded display (1980); the .scn language's surface equation;
///            glossy reflections after Cook, Porter, Carpenter, Distributed ray tracing (1984)
class Whitted : public Integrator {
 public:
  Whitted(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  R2::Color Follow(const ShadingPoint& first, TraceState& state) const;
  /// Adds to each surface's radiance what it shines and scatters by itself.
  void Shade(std::span<ShadingPoint> surfaces, TraceState& state) const;
  /// One light's share of that; `which` is its number among places beneath a surface.
  template <typename AnyLight>
  void AddLight(const AnyLight& light, std::uint64_t which, std::span<ShadingPoint> surfaces, TraceState& state) const;
  /// The share of a few lights, chosen by importance, that stand for all.
  void AddChosenLights(std::span<ShadingPoint> surfaces, TraceState& state) const;
  template <typename AnyLight>
  void AddSample(const AnyLight& light, const ShadingPoint& surface, std::size_t index, const R2::Point& random,
                 double weight, TraceState& state) const;
  void AddArrived(std::span<ShadingPoint> surfaces, TraceState& state) const;
  void TraceShadowRays(TraceState& state) const;
  void Spawn(const ShadingPoint& surface, TraceState& state) const;
  std::optional<R3::Vector> ReflectionOf(const ShadingPoint& surface, const SampleIndex& index) const;
  /// The weight of a child ray, if it is followed. `which`: its key beneath its parent's place.
  std::optional<R2::Color> Wanted(const R2::Color& weight, const SampleIndex& parent, std::uint64_t which) const;
  /// The weight of a faint one, if chance lets it live.
  std::optional<R2::Color> Spared(const R2::Color& weight, double luminance, const SampleIndex& parent,
                                  std::uint64_t which) const;

  const World& world_;
  const Accelerator& accelerator_;
  TraceSettings settings_;
  SamplerKind sampler_;
  bool has_roulette_;
  std::vector<const Light*> lights_;  // those that are not black
  std::vector<EmissiveTriangle> triangles_;
  const Environment* environment_ = nullptr;  // if it shines
  std::optional<LightTree> tree_;             // over lights, then triangles, if they are chosen among
};

}  // namespace ray
