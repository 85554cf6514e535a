#include "source/scene/Light.h"
#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

class DirLight : public Light {
 public:
  DirLight(const R2::Color& color, const R3::Vector& direction)
      : color_(color), given_direction_(direction), direction_(Unit(direction)) {}

  void IlluminateEach(LightSamples& samples) const override {
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.Set(i, -direction_, color_);
  }

  LightBound Bound() const override { return {.power = Luminance(color_), .is_infinite = true}; }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override {
    return "directional light along " + Words(direction_) + ", color " + Words(color_);
  }
  R3::Recipe MadeFrom() const override {
    return {"dir_light", {color_.r, color_.g, color_.b, given_direction_.x, given_direction_.y, given_direction_.z}};
  }

 private:
  R2::Color color_;
  R3::Vector given_direction_;  // of any length
  R3::Vector direction_;        // the direction in which the light travels; unit
};

}  // namespace

extern const LightKind dir_light_kind{
    "dir_light",
    "light from infinitely far: color and the direction it travels",
    ColorArguments() + DirectionArguments(),
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      return std::make_unique<DirLight>(ColorAt(a, 0), DirectionAt(a, 3));
    },
    {1, 0.9, 0.8, -3, -4, -5},
};

}  // namespace ray
