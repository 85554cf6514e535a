#include "R3/Numeric.h"
#include "source/scene/Light.h"
#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

class PointLight : public Light {
 public:
  PointLight(const R2::Color& color, const R3::Point& place, const Falloff& falloff)
      : color_(color), place_(place), falloff_(falloff) {}

  void IlluminateEach(LightSamples& samples) const override { ReachEach(samples); }

  LightBound Bound() const override { return falloff_.BoundOf(color_, place_, 0); }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override { return "point light at " + Words(place_) + ", color " + Words(color_); }
  R3::Recipe MadeFrom() const override {
    return {"point_light",
            {color_.r, color_.g, color_.b, place_.x, place_.y, place_.z, falloff_.constant, falloff_.linear,
             falloff_.quadratic}};
  }

 private:
  // Compiled for each instruction set, which is not possible for a virtual function.
  R3_VECTORIZED void ReachEach(LightSamples& samples) const {
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const R3::Vector to_light = place_ - samples.from[i];
      samples.Set(i, to_light, falloff_(color_, BranchlessLength(to_light)));
    }
    // None exactly at the light, in a loop without other branches.
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const R2::Color reaching = samples.color[i];
      samples.color.Set(i, MaxComponent(Abs(samples.to_light[i])) > 0 ? reaching : R2::Color{});
    }
  }

  R2::Color color_;
  R3::Point place_;
  Falloff falloff_;
};

}  // namespace

extern const LightKind point_light_kind{
    "point_light",
    "light from a point: color, place, constant, linear and quadratic attenuation",
    ColorArguments() + PlaceArguments() + FalloffArguments(),
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      return std::make_unique<PointLight>(ColorAt(a, 0), PlaceAt(a, 3), FalloffAt(a, 6));
    },
    {1, 0.5, 0.25, 0.5, 3, -1, 0.5, 0.25, 0.125},
};

}  // namespace ray
