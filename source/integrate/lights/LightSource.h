#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/integrate/TraceSettings.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "source/scene/Light.h"

namespace ray {

/// A light as integrators sample it, whatever it is in the scene: a light of the scene language, a shape that emits, or
/// the environment.
class LightSource {
 public:
  virtual ~LightSource() = default;

  /// What arrives at a point from the place on the light that `u`, in [0, 1)^2, picks, if nothing is in between.
  /// Nothing where the light does not shine, or lies on the same primitive and does not light itself.
  virtual std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const = 0;
  /// Returns false only if Sample gives the point nothing, or black, for all `u`.
  virtual bool MayShineOn(const ShadingPoint& /*p*/) const { return true; }
  /// Makes Sample, bit for bit, of many points at once: the ways to the light, the irradiance, black where there is
  /// none, and the pdfs.
  ///   returns   false, with nothing made, where the light has no loops for that
  virtual bool SampleEach(LightSamples&, LightSamples::Each& /*pdfs*/) const { return false; }

  /// Whether scattered rays find the light as well, so that Sample has a pdf.
  virtual bool HasPdf() const { return false; }
  /// The pdf with which Sample, at `from`, gives the direction in which a ray from there has hit the light, of a light
  /// that is a primitive.
  virtual double Pdf(const ShadingPoint& /*from*/, const ShadingPoint& /*hit*/) const { return 0; }
  /// The primitive that it is to those rays; -1 for none.
  virtual std::int64_t Primitive() const { return -1; }
  /// R3::Ray::reaching of rays to samples that have a pdf.
  virtual std::int64_t Reached() const { return -1; }

  /// The light of the scene language that it is; null for others.
  virtual const Light* OfScene() const { return nullptr; }
  /// Whether it matters which place on it is sampled.
  virtual bool IsExtended() const { return true; }
  /// Whether it has a direction but no place.
  virtual bool IsInfinite() const { return false; }
  /// What choosing among lights goes by.
  virtual LightBound Bound() const = 0;
  /// The light in words.
  virtual std::string Describe() const = 0;
};

using LightSources = std::vector<std::unique_ptr<const LightSource>>;

/// The scene's lights that shine in mode path, none of them black: the default ones only if nothing else emits.
std::vector<const Light*> LightsOfPath(const World& world);
/// The scene's lights that shine in mode whitted, none of them black: the default ones too, unless solids that emit are
/// lights by -emissive_solids.
std::vector<const Light*> LightsOfWhitted(const World& world, const TraceSettings& settings);

/// All lights of mode path: those of the scene language, which no ray can hit; shapes that emit, triangles first; and
/// the environment.
LightSources LightSourcesOfPath(const World& world, const TraceSettings& settings);
/// All lights of mode whitted but the environment, whose light is reflected by kd alone.
LightSources LightSourcesOfWhitted(const World& world, const TraceSettings& settings);

}  // namespace ray
