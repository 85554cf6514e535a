#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "R2/Point.h"
#include "R3/Point.h"
#include "R3/ShapeKind.h"
#include "source/scene/LightBound.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// Where a shadow ray goes.
struct ShadowTarget {
  R3::Vector to_light;
  bool is_infinite = false;
  std::int64_t reaching = -1;
};

/// What reaches a point from one point on a light, if nothing is in between.
struct LightSample {
  /// On a surface that faces the light: its own cosine is still to come. Where there is a pdf, an estimate from this
  /// one sample, which is radiance over pdf. Else what the scene language says arrives, pi times smaller than the
  /// irradiance in the theory of a diffuse surface.
  R2::Color irradiance{};
  R3::Vector to_light;         // from the point; reaches the light at t = 1 unless the light is infinitely far
  bool is_infinite = false;    // the light has a direction but no place
  double pdf = 0;              // per solid angle, that of choosing the light included; 0 for lights that no ray can hit
  int light = 0;               // its number, where one of several was chosen
  std::int64_t reaching = -1;  // R3::Ray::reaching of a ray to the light

  ShadowTarget Target() const { return {to_light, is_infinite, reaching}; }
};

/// A source of light, in world coordinates.
class Light {
 public:
  virtual ~Light() = default;

  /// Light arriving at `p` from the place on the light that `random`, in [0, 1)^2, picks uniformly by area (point-like
  /// lights ignore it). Nothing where the light does not shine, and where p lies on the very place picked.
  virtual std::optional<LightSample> Illuminate(const R3::Point& p, const R2::Point& random) const = 0;
  /// Illuminate for many points at once, with bit-identical results: fills in what each sample's point gets from the
  /// place that its u and v pick.
  virtual void IlluminateEach(LightSamples& samples) const;
  /// Returns false only if Illuminate gives `p` nothing, or black, whatever place is picked.
  virtual bool MayShineOn(const R3::Point& /*p*/) const { return true; }

  /// Whether it has an area, so that several samples are worth their rays.
  virtual bool IsExtended() const { return false; }
  /// What a choice among many lights goes by.
  virtual LightBound Bound() const = 0;
  /// Whether it gives no light at all; such a light still counts as a light of the scene.
  virtual bool IsBlack() const = 0;
  /// "point light at 0 3 0, color 1 1 1"
  virtual std::string Describe() const = 0;
  virtual R3::Recipe MadeFrom() const = 0;
};

/// One line of lights.def.
struct LightKind {
  const char* name;  // the word in a scene file
  const char* about;
  std::vector<R3::Argument> arguments;  // in file order
  /// `arguments` are as many as above, finite, their signs checked; may throw R3::ArgumentError.
  std::unique_ptr<const Light> (*make)(std::span<const double> arguments);
  std::vector<double> example;
};

/// Every kind, in the order of lights.def.
std::span<const LightKind* const> LightKinds();
/// Null when no kind has the name.
const LightKind* FindLightKind(const std::string& name);

/// The two directional lights of a scene that names none.
std::vector<std::unique_ptr<const Light>> DefaultLights();

}  // namespace ray
