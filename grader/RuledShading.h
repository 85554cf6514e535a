#pragma once

#include <optional>
#include <vector>

#include "grader/ShadingRules.h"
#include "source/integrate/Whitted.h"

namespace ray::grade {

/// The ray tracer of mode whitted, with the surface equation as a student may have implemented it wrongly. It supports
/// only the light sources in Scene::lights; see CanShade.
class RuledShading : public Whitted {
 public:
  RuledShading(const World& world, const Accelerator& accelerator, const TraceSettings& settings,
               const ShadingRules& rules);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

  /// Returns true if the scene has only lights to which the rules apply: no environment and no lamps.
  static bool CanShade(const World& world, const TraceSettings& settings);

 private:
  void Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const override;
  void ApplyToNormal(ShadingPoint& p) const;
  void AddLight(std::size_t which, std::span<ShadingPoint> points, std::span<R2::Color> radiances,
                TraceState& state) const;
  void AddSample(std::size_t which, ShadingPoint& p, std::size_t index, const R2::Point& u, double weight,
                 R2::Color& radiance, TraceState& state) const;
  double CosineOf(const ShadingPoint& p, const R3::Vector& L) const;
  bool IsLitFromBehind(const ShadingPoint& p, const R3::Vector& L) const;
  R2::Color HighlightOf(const ShadingPoint& p, const R3::Vector& L) const;
  R3::Vector ShadowDirection(std::size_t which, const ShadingPoint& p, const LightSample& sample) const;

  /// Returns the factor of a light's irradiance for wrong attenuation.
  double FadingOf(std::size_t which, const R3::Vector& to_light) const;
  void ApplyToMirror(ShadingPoint& p) const;

  /// The attenuation of a light: its coefficients, and those of a spot light.
  struct Fading {
    double constant = 1, linear = 0, quadratic = 0;
    std::optional<R3::Vector> axis;  // unit
    double cutoff = 0, exponent = 0;
  };
  static Fading FadingOf(const Light& light);

  std::vector<Fading> fading_;  // of each light
  Tracer tracer_;
  TraceSettings settings_;
  ShadingRules rules_;
  std::vector<const R3::Transform*> transforms_;  // world from the group that each instance is in
};

}  // namespace ray::grade
