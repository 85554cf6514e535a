#include <algorithm>
#include <cmath>

#include "R3/Warp.h"
#include "source/scene/Light.h"
#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

/// A sphere that shines equally in all directions and is itself invisible. From afar it equals a point light of its
/// color.
class SphereLight : public Light {
 public:
  SphereLight(const R2::Color& color, const R3::Point& center, double radius, const Falloff& falloff)
      : color_(color), center_(center), radius_(radius), falloff_(falloff) {}

  void IlluminateEach(LightSamples& samples) const override {
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const auto [to_light, reaching] = From(samples.from[i], samples.random[i]);
      samples.Set(i, to_light, reaching);
    }
  }

  bool MayShineOn(const R3::Point& p) const override { return Length(center_ - p) > radius_; }

  bool IsExtended() const override { return radius_ > 0; }
  LightBound Bound() const override { return falloff_.BoundOf(color_, center_, radius_); }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override {
    return "sphere light at " + Words(center_) + ", radius " + Words(radius_) + ", color " + Words(color_);
  }
  R3::Recipe MadeFrom() const override {
    return {"sphere_light",
            {color_.r, color_.g, color_.b, center_.x, center_.y, center_.z, radius_, falloff_.constant, falloff_.linear,
             falloff_.quadratic}};
  }

 private:
  /// Samples a direction uniformly in the cone of solid angle W that the sphere subtends at p; it meets the sphere at
  /// S. The light I0 spread over the whole sphere, 4 I0 cos / falloff from each share of its area, becomes
  ///     I0 W d^2 / (pi r^2 falloff(d)),   d the distance to S,
  /// which hardly varies over the cone.
  std::pair<R3::Vector, R2::Color> From(const R3::Point& p, const R2::Point& random) const {
    const R3::Vector to_center = center_ - p;
    const double D = Length(to_center);
    if (!(D > radius_)) return {};  // it shines outward only
    const double sine_squared = radius_ / D * (radius_ / D);
    if (sine_squared == 0) return {to_center, falloff_(color_, D)};
    const double one_minus_cosine = sine_squared / (1 + std::sqrt(1 - sine_squared));
    const R3::Vector direction = R3::FromTangents(R3::SampleUniformCone(random, one_minus_cosine), to_center / D);
    const double aside = Length(Cross(to_center, direction)), ahead = Dot(to_center, direction);
    const double distance = ahead - std::sqrt(std::max(0.0, (radius_ - aside) * (radius_ + aside)));
    if (!(distance > 0)) return {};
    const double relative = distance / radius_;
    return {distance * direction, 2 * one_minus_cosine * relative * relative * falloff_(color_, distance)};
  }

  R2::Color color_;
  R3::Point center_;
  double radius_;
  Falloff falloff_;
};

}  // namespace

extern const LightKind sphere_light_kind{
    "sphere_light",
    "a sphere that shines to all sides: color, center, radius, attenuation (an extension of ours)",
    ColorArguments() + PlaceArguments() + ArgumentList{{"radius", false}} + FalloffArguments(),
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      return std::make_unique<SphereLight>(ColorAt(a, 0), PlaceAt(a, 3), a[6], FalloffAt(a, 7));
    },
    {1, 0.5, 0.25, 0.5, 3, -1, 0.25, 0.75, 0.5, 0.25},
};

}  // namespace ray
