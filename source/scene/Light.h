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

/// The direction of a shadow ray.
struct ShadowTarget {
  R3::Vector to_light;
  bool is_infinite = false;
  std::int64_t reaching = -1;
};

/// The light that reaches a point from one point on a light, if nothing is in between.
struct LightSample {
  /// The irradiance on a surface perpendicular to the light; the caller applies the cosine. If there is a pdf, it is an
  /// estimate from this one sample: radiance over pdf. Otherwise it is in the units of the scene language, pi times
  /// smaller than the irradiance in the theory of a diffuse surface.
  R2::Color irradiance{};
  R3::Vector to_light;         // from the point; reaches the light at t = 1 unless the light is infinitely far
  bool is_infinite = false;    // the light has a direction but no position
  double pdf = 0;              // per solid angle, including that of choosing the light; 0: no ray can hit the light
  int light = 0;               // its number, if one of several was chosen
  std::int64_t reaching = -1;  // R3::Ray::reaching of a ray to the light

  ShadowTarget Target() const { return {to_light, is_infinite, reaching}; }
};

/// A source of light, in world coordinates.
class Light {
 public:
  virtual ~Light() = default;

  /// Computes the light at each sample's point from the point on the light that its random numbers select uniformly by
  /// area (point-like lights ignore them). Black if the light does not shine there, or if the two points are the same.
  virtual void IlluminateEach(LightSamples& samples) const = 0;
  /// Returns a batch of one: the light arriving at `p` from the point that `random`, in [0, 1)^2, selects; std::nullopt
  /// if none arrives.
  std::optional<LightSample> Illuminate(const R3::Point& p, const R2::Point& random) const;
  /// Returns false only if no light arrives at `p` from any point of the light.
  virtual bool MayShineOn(const R3::Point& /*p*/) const { return true; }

  /// Returns true if the light has an area, so that several samples are worthwhile.
  virtual bool IsExtended() const { return false; }
  /// Returns the estimated contribution that light selection uses.
  virtual LightBound Bound() const = 0;
  /// Returns true if it emits nothing; such a light still counts as a light of the scene.
  virtual bool IsBlack() const = 0;
  /// Returns a description: "point light at 0 3 0, color 1 1 1".
  virtual std::string Describe() const = 0;
  virtual R3::Recipe MadeFrom() const = 0;
};

/// One line of lights.def.
struct LightKind {
  const char* name;  // the word in a scene file
  const char* about;
  std::vector<R3::Argument> arguments;  // in file order
  /// Makes a light. The number of `arguments` is as above; they are finite with the required signs. May throw
  /// R3::ArgumentError.
  std::unique_ptr<const Light> (*make)(std::span<const double> arguments);
  std::vector<double> example;
};

/// Returns all kinds, in the order of lights.def.
std::span<const LightKind* const> LightKinds();
/// Returns the kind with the given name, or null.
const LightKind* FindLightKind(const std::string& name);

/// Returns the two directional lights of a scene that names none.
std::vector<std::unique_ptr<const Light>> DefaultLights();

}  // namespace ray
