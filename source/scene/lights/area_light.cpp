#include <cmath>

#include "R3/Warp.h"
#include "source/scene/Light.h"
#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

class AreaLight : public Light {
 public:
  AreaLight(const R2::Color& color, const R3::Point& center, const R3::Vector& direction, double radius,
            const Falloff& falloff)
      : color_(color),
        center_(center),
        given_direction_(direction),
        direction_(Unit(direction)),
        tangents_(R3::TangentsOf(direction_)),
        radius_(radius),
        falloff_(falloff) {}

  void IlluminateEach(LightSamples& samples) const override { ReachEach(samples); }

  /// Compares p with the plane of the disc. The cosine at a point differs from that of the plane by the rounding of
  /// ToPlace and Cosine, some ten operations on terms no larger than these.
  bool MayShineOn(const R3::Point& p) const override {
    const double ahead = Dot(direction_, p - center_);
    const double rounding = R3::Gamma(16) * (Sum(center_) + Sum(p) + 4 * radius_);
    return !(ahead < -rounding);
  }

  bool IsExtended() const override { return radius_ > 0; }
  LightBound Bound() const override { return falloff_.BoundOf(color_, center_, radius_); }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override {
    return "area light at " + Words(center_) + " along " + Words(direction_) + ", radius " + Words(radius_) +
           ", color " + Words(color_);
  }
  R3::Recipe MadeFrom() const override {
    return {"area_light",
            {color_.r, color_.g, color_.b, center_.x, center_.y, center_.z, given_direction_.x, given_direction_.y,
             given_direction_.z, radius_, falloff_.constant, falloff_.linear, falloff_.quadratic}};
  }

 private:
  static double Sum(const R3::Point& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }
  // Compiled for each instruction set, which is not possible for a virtual function.
  R3_VECTORIZED void ReachEach(LightSamples& samples) const {
    const std::uint32_t count = samples.count;
    R1::Columns<R2::Point> on_disc;
    for (std::uint32_t i = 0; i < count; ++i) on_disc.Set(i, R3::SampleUniformDiskConcentric(samples.random[i]));
    for (std::uint32_t i = 0; i < count; ++i) {
      const R3::Vector to_light = ToPlace(on_disc[i], samples.from[i]);
      const double distance = BranchlessLength(to_light), cosine = Cosine(to_light / distance);
      const R2::Color reaching = cosine * falloff_(color_, distance);
      samples.Set(i, to_light, cosine > 0 ? reaching : R2::Color{});  // it shines to one side only
    }
  }
  /// Returns the vector from p to a point given on the unit disc.
  R3::Vector ToPlace(const R2::Point& on_disc, const R3::Point& p) const {
    return center_ + (radius_ * on_disc.x * tangents_.first + radius_ * on_disc.y * tangents_.second) - p;
  }
  /// Returns the cosine; NaN for a zero direction.
  double Cosine(const R3::Vector& unit_to_light) const {
    const double cosine = -Dot(direction_, unit_to_light);
    return cosine > 1 ? 1 : cosine;
  }

  R2::Color color_;
  R3::Point center_;
  R3::Vector given_direction_;  // of any length
  R3::Vector direction_;        // the side to which it shines; unit
  R3::Tangents tangents_;
  double radius_;
  Falloff falloff_;
};

}  // namespace

extern const LightKind area_light_kind{
    "area_light",
    "a disc that shines to one side: color, center, direction, radius, attenuation",
    ColorArguments() + PlaceArguments() + DirectionArguments() + ArgumentList{{"radius", false}} + FalloffArguments(),
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      return std::make_unique<AreaLight>(ColorAt(a, 0), PlaceAt(a, 3), DirectionAt(a, 6), a[9], FalloffAt(a, 10));
    },
    {1, 0.5, 0.25, 0.5, 3, -1, 0, -1, 0.25, 0.75, 0.5, 0.25, 0.125},
};

}  // namespace ray
