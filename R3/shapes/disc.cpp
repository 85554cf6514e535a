#include <numbers>

#include "R3/Numeric.h"
#include "R3/ShapeKind.h"
#include "R3/Warp.h"

namespace R3 {
namespace {

/// A flat disc, visible from both sides; its front is the side of the normal.
class Disc : public Shape {
 public:
  Disc(const Point& center, const Vector& normal, double radius)
      : center_(center), normal_(normal), unit_(Unit(normal)), across_(TangentsOf(unit_)), radius_(radius) {}

  /// Returns the box; along an axis it extends by the sine of the normal's angle with that axis.
  Box Bounds(int) const override {
    const Vector reach{radius_ * Length({0, unit_.y, unit_.z}), radius_ * Length({unit_.x, 0, unit_.z}),
                       radius_ * Length({unit_.x, unit_.y, 0})};
    return {center_ - reach, center_ + reach};
  }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    const double t = Dot(center_ - ray.origin, unit_) / Dot(ray.direction, unit_);  // infinite or NaN along the disc
    if (!(t > ray.t_min && t < ray.t_max)) return {};
    if (!(Length(ray.At(t) - center_) < radius_)) return {};
    return Hit{t};
  }

  // Returns the intersection in the plane of the disc, up to the rounding of the step back to it and of the sum.
  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Vector off = ray.At(hit.t) - center_;
    return InPlane(off - Dot(off, unit_) * unit_, Gamma(8) * Length(off));
  }

  UvTangents UvTangentsAt(const Ray&, const Hit&, int) const override {
    return {2 * radius_ * across_.first, 2 * radius_ * across_.second};
  }

  bool CanBeSampled() const override { return true; }
  double SampledArea(const Point&, int) const override { return std::numbers::pi * radius_ * radius_; }
  Intersection DrawPlace(const Point&, const R2::Point& u, int) const override {
    const R2::Point on_disc = SampleUniformDiskConcentric(u);
    const Vector off = radius_ * (on_disc.x * across_.first + on_disc.y * across_.second);
    return InPlane(off, Gamma(8) * radius_);
  }

  Form FormOfElements() const override { return Form::flat; }
  bool IsSolid() const override { return false; }
  bool IsDegenerate() const override { return !(radius_ > 0); }
  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"disc", {center_.x, center_.y, center_.z, normal_.x, normal_.y, normal_.z, radius_}};
  }

 private:
  Intersection InPlane(const Vector& off, double error) const {
    Intersection at;
    at.position = center_ + off;
    at.error = Vector{error, error, error} + Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = at.shading_normal = AsNormal(unit_);
    at.uv = {0.5 + Dot(off, across_.first) / (2 * radius_), 0.5 + Dot(off, across_.second) / (2 * radius_)};
    return at;
  }

  Point center_;
  Vector normal_, unit_;
  Tangents across_;
  double radius_;
};

}  // namespace

extern const ShapeKind disc_kind{
    "disc",
    "a flat disc: center, normal of any length, radius",
    {{"cx"}, {"cy"}, {"cz"}, {"nx"}, {"ny"}, {"nz"}, {"radius", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      constexpr std::size_t of_normal = 3;
      const Vector normal{a[3], a[4], a[5]};
      if (normal == Vector{}) throw ArgumentError(of_normal, "the normal must not be 0 0 0");
      return std::make_unique<Disc>(Point{a[0], a[1], a[2]}, normal, a[6]);
    },
    {0.5, -0.25, 1, 0.4, 1, 0.3, 0.75},
};

}  // namespace R3
