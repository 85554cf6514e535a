#include <algorithm>
#include <cmath>
#include <numbers>

#include "source/scene/Light.h"
#include "source/scene/lights/Falloff.h"
#include "source/scene/lights/Words.h"

namespace ray {
namespace {

/// Two unit vectors that are perpendicular to a third and to each other.
struct Tangents {
  R3::Vector first, second;
};

/// Source: Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin, Building an orthonormal basis, revisited (2017).
Tangents TangentsOf(const R3::Vector& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// A point of the unit disc from one of the unit square, keeping shares of area.
/// Source: Shirley, Chiu, A low distortion map between disk and square (1997).
R2::Point OnDisc(const R2::Point& square) {
  const double a = 2 * square.x - 1, b = 2 * square.y - 1;
  if (a == 0 && b == 0) return {};
  const bool is_wide = std::abs(a) > std::abs(b);
  const double radius = is_wide ? a : b;
  const double angle = is_wide ? std::numbers::pi / 4 * (b / a) : std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

class AreaLight : public Light {
 public:
  AreaLight(const R2::Color& color, const R3::Point& center, const R3::Vector& direction, double radius,
            const Falloff& falloff)
      : color_(color),
        center_(center),
        direction_(Unit(direction)),
        tangents_(TangentsOf(direction_)),
        radius_(radius),
        falloff_(falloff) {}

  std::optional<Illumination> Illuminate(const R3::Point& p, const R2::Point& random) const override {
    const R2::Point on_disc = OnDisc(random);
    const R3::Vector from_center = radius_ * on_disc.x * tangents_.first + radius_ * on_disc.y * tangents_.second;
    const R3::Vector to_light = center_ + from_center - p;
    const double distance = Length(to_light);
    if (!(distance > 0)) return {};
    const double cosine = std::min(1.0, -Dot(direction_, Unit(to_light)));
    if (!(cosine > 0)) return {};  // it shines to one side only
    return Illumination{cosine * falloff_(color_, distance), to_light};
  }

  bool IsExtended() const override { return radius_ > 0; }
  bool IsBlack() const override { return R2::IsBlack(color_); }
  std::string Describe() const override {
    return "area light at " + Words(center_) + " along " + Words(direction_) + ", radius " + Words(radius_) +
           ", colour " + Words(color_);
  }

 private:
  R2::Color color_;
  R3::Point center_;
  R3::Vector direction_;  // the side it shines to; unit
  Tangents tangents_;
  double radius_;
  Falloff falloff_;
};

}  // namespace

extern const LightKind area_light_kind{
    "area_light",
    "a disc that shines to one side: colour, centre, direction, radius, attenuation",
    {{"r", false},
     {"g", false},
     {"b", false},
     {"px"},
     {"py"},
     {"pz"},
     {"dx"},
     {"dy"},
     {"dz"},
     {"radius", false},
     {"ca", false},
     {"la", false},
     {"qa", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Light> {
      const R3::Vector direction{a[6], a[7], a[8]};
      if (direction == R3::Vector{}) throw R3::ArgumentError(6, "the light's direction must not be 0 0 0");
      return std::make_unique<AreaLight>(R2::Color{a[0], a[1], a[2]}, R3::Point{a[3], a[4], a[5]}, direction, a[9],
                                         Falloff{a[10], a[11], a[12]});
    },
    {1, 0.5, 0.25, 0.5, 3, -1, 0, -1, 0.25, 0.75, 0.5, 0.25, 0.125},
};

}  // namespace ray
