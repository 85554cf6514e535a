#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "source/integrate/ShadingPoint.h"
#include "source/integrate/TraceSettings.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/integrate/lights/LightTree.h"

namespace ray {

/// Light at a point from one place on a light, if nothing is in between.
struct PathLightSample {
  /// Of lights that rays can hit: radiance, over the pdf of choosing the direction. Of others: what the scene
  /// language says arrives, pi times smaller than the irradiance of a diffuse surface's theory.
  R2::Color arriving;
  R3::Vector to_light;
  bool is_infinite = false;
  double pdf = 0;  // per solid angle, times the probability of choosing the light; 0 for lights no ray can hit
  int light = 0;   // its number
};

/// All lights as path tracing sees them: those of the scene language, which no ray can hit; emissive triangles, whose
/// emission is a radiance; and the environment. A point chooses among them by importance, or evenly with the strategy
/// "uniform".
class PathLights {
 public:
  PathLights(const World& world, const TraceSettings& settings);

  bool IsEmpty() const { return count_ == 0; }
  int Count() const { return count_; }
  /// Whether some light can be found by following scattered rays as well.
  bool CanBeHit() const { return environment_ || has_background_ || !triangles_.empty(); }

  /// A light in words.
  std::string Describe(int light) const;

  /// One light by chance, and a place on it.
  std::optional<PathLightSample> SampleOne(const ShadingPoint& surface, const R2::Point& place, double choice) const;
  /// Light number `light`, for sure.
  std::optional<PathLightSample> Sample(const ShadingPoint& surface, int light, const R2::Point& place) const;

  /// The pdf with which a point would have chosen this direction to the environment, or to the emissive triangle
  /// that a ray from it hit; 0 for things that are no light. `choosing`: by SampleOne, else by Sample.
  double PdfOfEnvironment(const ShadingPoint& from, const R3::Vector& direction, bool choosing) const;
  double PdfOfHit(const ShadingPoint& from, const R3::Ray& ray, const ShadingPoint& hit, const World& world,
                  bool choosing) const;

 private:
  /// One of several lights, and with what probability.
  std::optional<LightTree::Choice> Choose(const ShadingPoint& surface, double choice) const;
  double ProbabilityOf(const ShadingPoint& surface, int light) const;

  std::vector<const Light*> lights_;
  std::vector<EmissiveTriangle> triangles_;
  std::unordered_map<std::int64_t, int> triangle_of_primitive_;
  const Environment* environment_ = nullptr;
  bool has_background_ = false;  // that is not black
  bool draws_evenly_ = false;    // among lights, and from the environment
  int count_ = 0;
  std::optional<LightTree> tree_;
};

}  // namespace ray
