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

/// A light as integrators sample it: a light of the scene language, an emissive shape, or the environment.
class LightSource {
 public:
  virtual ~LightSource() = default;

  /// Returns the light that arrives at a point from the place on the light that `u`, in [0, 1)^2, picks, if it is
  /// unoccluded. Returns std::nullopt if the light does not shine, or is on the same primitive and does not light
  /// itself.
  virtual std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const = 0;
  /// Returns false only if Sample gives the point nothing, or black, for all `u`.
  virtual bool MayShineOn(const ShadingPoint& /*p*/) const { return true; }
  /// Computes Sample, bit for bit, for many points at once: the ways to the light, the irradiance, black if there is
  /// none, and the pdfs.
  ///   returns   false, with no result, if the light has no loops for that
  virtual bool SampleEach(LightSamples&, LightSamples::Each& /*pdfs*/) const { return false; }

  /// Returns true if scattered rays can also find the light, so that Sample has a pdf.
  virtual bool HasPdf() const { return false; }
  /// Returns the pdf with which Sample, at `from`, gives the direction in which a ray from there has hit the light. For
  /// lights that are primitives.
  virtual double Pdf(const ShadingPoint& /*from*/, const ShadingPoint& /*hit*/) const { return 0; }
  /// Returns the light's primitive, as those rays hit it; -1 for none.
  virtual std::int64_t Primitive() const { return -1; }
  /// Returns R3::Ray::reaching for rays to samples with a pdf.
  virtual std::int64_t Reached() const { return -1; }

  /// Returns the light of the scene language; null for others.
  virtual const Light* OfScene() const { return nullptr; }
  /// Returns true if the result depends on the sampled place.
  virtual bool IsExtended() const { return true; }
  /// Returns true if it has a direction but no position.
  virtual bool IsInfinite() const { return false; }
  /// Returns the estimated contribution that light selection uses.
  virtual LightBound Bound() const = 0;
  /// Returns a description for users.
  virtual std::string Describe() const = 0;
};

using LightSources = std::vector<std::unique_ptr<const LightSource>>;

/// Returns the scene's lights that shine in mode path and are not black: the default ones only if nothing else emits.
std::vector<const Light*> LightsOfPath(const World& world);
/// Returns the scene's lights that shine in mode whitted and are not black: including the default ones, unless emissive
/// solids are lights by -emissive_solids.
std::vector<const Light*> LightsOfWhitted(const World& world, const TraceSettings& settings);

/// Returns all lights of mode path: those of the scene language, which rays cannot hit; emissive shapes, triangles
/// first; and the environment.
LightSources LightSourcesOfPath(const World& world, const TraceSettings& settings);
/// Returns all lights of mode whitted except the environment, whose light is reflected by kd alone.
LightSources LightSourcesOfWhitted(const World& world, const TraceSettings& settings);

}  // namespace ray
