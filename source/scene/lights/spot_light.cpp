#include <algorithm>
#include <numbers>

#include "R1/Elementary.h"
#include "source/scene/Light.h"
#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

class SpotLight : public Light {
 public:
  SpotLight(const R2::Color& color, const R3::Point& place, const R3::Vector& direction, const Falloff& falloff,
            double cut_off, double exponent)
      : color_(color),
        place_(place),
        given_direction_(direction),
        direction_(Unit(direction)),
        falloff_(falloff),
        cut_off_(cut_off),
        cut_off_cosine_(R1::Cos(cut_off)),
        exponent_(exponent) {}

  void IlluminateEach(LightSamples& samples) const override {
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const R3::Vector to_light = place_ - samples.from[i];
      samples.Set(i, to_light, Reaching(to_light));
    }
  }

  LightBound Bound() const override { return falloff_.BoundOf(color_, place_, 0); }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override {
    return "spot light at " + Words(place_) + " along " + Words(direction_) + ", color " + Words(color_);
  }
  R3::Recipe MadeFrom() const override {
    return {"spot_light",
            {color_.r, color_.g, color_.b, place_.x, place_.y, place_.z, given_direction_.x, given_direction_.y,
             given_direction_.z, falloff_.constant, falloff_.linear, falloff_.quadratic, cut_off_, exponent_}};
  }

 private:
  R2::Color Reaching(const R3::Vector& to_light) const {
    const double distance = Length(to_light);
    if (!(distance > 0)) return {};
    // Rounding may push the cosine above 1, and also that of a cut-off angle of 0, which lights the axis alone.
    const double cosine = std::min(1.0, -Dot(direction_, Unit(to_light)));
    if (!(cosine > 0 && cosine >= cut_off_cosine_)) return {};
    return R1::Pow(cosine, exponent_) * falloff_(color_, distance);
  }

  R2::Color color_;
  R3::Point place_;
  R3::Vector given_direction_;  // of any length
  R3::Vector direction_;        // the axis of the cone; unit
  Falloff falloff_;
  double cut_off_;  // radians
  double cut_off_cosine_;
  double exponent_;
};

}  // namespace

extern const LightKind spot_light_kind{
    "spot_light",
    "a cone of light: color, place, direction, attenuation, half angle in radians, exponent of its fading",
    ColorArguments() + PlaceArguments() + DirectionArguments() + FalloffArguments() +
        ArgumentList{{"sc", false}, {"sd", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      const R3::Vector direction = DirectionAt(a, 6);
      // Beyond pi/2 nothing changes, since the cosine law ends there; beyond pi it is not a half angle but perhaps in
      // degrees.
      if (!(a[12] <= std::numbers::pi))
        throw R3::ArgumentError(12, "sc, half an angle in radians, must not exceed pi, got " + Words(a[12]));
      return std::make_unique<SpotLight>(ColorAt(a, 0), PlaceAt(a, 3), direction, FalloffAt(a, 9), a[12], a[13]);
    },
    {1, 0.5, 0.25, 0.5, 3, -1, 0, -1, 0.25, 0.5, 0.25, 0.125, 0.75, 2},
};

}  // namespace ray
