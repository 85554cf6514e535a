#pragma once

#include <optional>
#include <span>
#include <unordered_map>

#include "source/integrate/TraceSettings.h"
#include "source/integrate/lights/EmissionBounds.h"
#include "source/integrate/lights/LightSource.h"
#include "source/integrate/lights/LightTree.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Next-event estimation: all lights as path tracing sees them. A point chooses among them by importance sampling, or
/// uniformly with the strategy of that name.
class LightSampler {
 public:
  LightSampler(const World& world, const TraceSettings& settings);

  bool IsEmpty() const { return lights_.empty(); }
  int Count() const { return static_cast<int>(lights_.size()); }
  const LightSource& operator[](int light) const { return *lights_[static_cast<std::size_t>(light)]; }
  /// Returns true if scattered rays can also find some light; with a ray, if that ray can.
  bool CanBeHit() const {
    return environment_ || has_background_ || has_unsampled_emission_ || !light_of_primitive_.empty();
  }
  bool MayBeHitBy(const R3::Ray& ray) const {
    return environment_ || has_background_ || emission_bounds_.MayBeHitBy(ray);
  }

  /// Returns true if emission is a color, as in mode whitted: rays that a surface scatters diffusely ignore it.
  bool EmitsColor() const { return settings_.emission == Emission::color; }
  /// Samples one light at random, and a point on it; pdf and irradiance include both choices.
  std::optional<LightSample> SampleOne(const ShadingPoint& p, const R2::Point& u, double choice) const;
  /// Samples a point on light number `light`.
  std::optional<LightSample> Sample(const ShadingPoint& p, int light, const R2::Point& u) const;

  /// Calls LightSource::SampleEach for a light with pdfs, from all of the points.
  void SampleEach(std::span<const ShadingPoint> points, int light, LightSamples& samples,
                  LightSamples::Each& pdfs) const;

  /// Returns the environment; null if it does not shine.
  const Environment* environment() const { return environment_; }
  /// Returns the pdf with which a point would have chosen a direction to the environment that is seen, or to the light
  /// that a ray from it hit; std::nullopt if the latter is not a light. `choosing`: by SampleOne, otherwise by Sample.
  double PdfOfEnvironment(const ShadingPoint& from, const Environment::Seen& seen, bool choosing) const;
  std::optional<double> PdfOfHit(const ShadingPoint& from, const ShadingPoint& hit, const World& world,
                                 bool choosing) const;

 private:
  /// Returns true if lights, and directions to the environment, are chosen uniformly.
  bool IsUniform() const { return settings_.strategy == LightStrategy::uniform; }
  /// Chooses one of several lights, with its probability.
  std::optional<LightTree::Choice> Choose(const ShadingPoint& p, double choice) const;
  double ProbabilityOf(const ShadingPoint& p, int light) const;

  TraceSettings settings_;
  LightSources lights_;
  std::unordered_map<std::int64_t, int> light_of_primitive_;
  EmissionBounds emission_bounds_;
  const Environment* environment_ = nullptr;
  bool has_background_ = false;  // and is not black
  bool has_unsampled_emission_;
  std::optional<LightTree> tree_;
};

}  // namespace ray
