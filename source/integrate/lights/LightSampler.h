#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "source/integrate/TraceSettings.h"
#include "source/integrate/lights/EmissionBounds.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/integrate/lights/LightTree.h"
#include "source/integrate/lights/TriangleLamp.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// The scene's lights that shine in mode path, none of them black: the default ones only where nothing else emits.
std::vector<const Light*> LightsOfPath(const World& world);

/// Next-event estimation: all lights as path tracing sees them: those of the scene language, which no ray can hit;
/// emissive triangles and other shapes, whose emission is a radiance, or lamps of a color if the settings say so; and
/// the environment. A point chooses among them by importance sampling, or uniformly with the strategy of that name.
class LightSampler {
 public:
  LightSampler(const World& world, const TraceSettings& settings);

  bool IsEmpty() const { return count_ == 0; }
  int Count() const { return count_; }
  /// Whether some light can be found by following scattered rays as well, and whether by this one.
  bool CanBeHit() const {
    return environment_ || has_background_ || has_unsampled_emission_ || !light_of_primitive_.empty();
  }
  bool MayBeHitBy(const R3::Ray& ray) const {
    return environment_ || has_background_ || emission_bounds_.MayBeHitBy(ray);
  }

  /// Whether emission is a color, as in mode whitted: no ray that a surface scatters diffusely counts it.
  bool EmitsColor() const { return settings_.emission == Emission::color; }
  /// Whether it is such a lamp, whose samples have no pdf.
  bool IsLamp(int light) const {
    const std::size_t i = static_cast<std::size_t>(light);
    return EmitsColor() && i >= lights_.size() && i < lights_.size() + lamps_.size() + shapes_.size();
  }
  /// Of the scene language's; null for other lights.
  const Light* SceneLight(int light) const {
    return static_cast<std::size_t>(light) < lights_.size() ? lights_[static_cast<std::size_t>(light)] : nullptr;
  }
  /// Whether it matters which point on it is sampled.
  bool IsExtended(int light) const { return !SceneLight(light) || SceneLight(light)->IsExtended(); }

  /// A light in words.
  std::string Describe(int light) const;

  /// One light at random, and a point on it; pdf and irradiance account for both choices.
  std::optional<LightSample> SampleOne(const ShadingPoint& p, const R2::Point& u, double choice) const;
  /// A point on light number `light`.
  std::optional<LightSample> Sample(const ShadingPoint& p, int light, const R2::Point& u) const;

  /// The same, bit for bit, from each of the points by the samples' u and v, of a light that rays can hit and that is
  /// no lamp: the ways to it, the irradiance, black where there is none, and the pdfs.
  void SampleEach(std::span<const ShadingPoint> points, int light, LightSamples& samples,
                  LightSamples::Each& pdfs) const;
  /// R3::Ray::reaching of rays to a light, which is no lamp.
  std::int64_t Reached(int light) const;
  bool IsInfinite(int light) const {
    const Light* of_scene = SceneLight(light);
    return of_scene ? of_scene->Bound().is_infinite : environment_ && light == count_ - 1;
  }

  /// Null where it does not shine.
  const Environment* environment() const { return environment_; }
  /// The pdf with which a point would have chosen a direction to the environment, where this is seen, or to the light
  /// that a ray from it hit, nothing for what is no light. `choosing`: by SampleOne, else by Sample.
  double PdfOfEnvironment(const ShadingPoint& from, const Environment::Seen& seen, bool choosing) const;
  std::optional<double> PdfOfHit(const ShadingPoint& from, const R3::Ray& ray, const ShadingPoint& hit,
                                 const World& world, bool choosing) const;

 private:
  /// Whether it chooses uniformly among lights, and from the environment.
  bool IsUniform() const { return settings_.strategy == LightStrategy::uniform; }
  /// One of several lights, and with what probability.
  std::optional<LightTree::Choice> Choose(const ShadingPoint& p, double choice) const;
  double ProbabilityOf(const ShadingPoint& p, int light) const;

  /// From a lamp by its number among the lamps and shapes.
  std::optional<LightSample> SampleLamp(const ShadingPoint& p, std::size_t lamp, const R2::Point& u) const;

  const World& world_;
  TraceSettings settings_;
  std::vector<const Light*> lights_;
  std::vector<EmissiveTriangle> triangles_;  // where emission is a radiance
  std::vector<TriangleLamp> lamps_;          // where it is a color
  std::vector<EmissiveShape> shapes_;
  std::unordered_map<std::int64_t, int> light_of_primitive_;
  EmissionBounds emission_bounds_;
  const Environment* environment_ = nullptr;
  bool has_background_ = false;  // that is not black
  bool has_unsampled_emission_;
  int count_ = 0;
  std::optional<LightTree> tree_;
};

}  // namespace ray
