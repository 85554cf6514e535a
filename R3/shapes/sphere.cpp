#include <numbers>

#include "R1/Elementary.h"
#include "R3/GridMesh.h"
#include "R3/ShapeKind.h"
#include "R3/Sphere.h"
#include "R3/Warp.h"

namespace R3 {
namespace {

class Sphere : public Shape {
 public:
  Sphere(const Point& center, double radius) : center_(center), radius_(radius) {}

  Box Bounds(int) const override {
    const Vector r{radius_, radius_, radius_};
    return {center_ - r, center_ + r};
  }

  Profile ProfileInBounds() const override { return Profile::Ball(); }

  std::optional<Hit> Intersect(const Ray& ray, int) const override { return IntersectSphere(ray, {center_, radius_}); }

  Crossings CrossingsAlong(const Ray& ray, int) const override { return CrossSphere(ray, {center_, radius_}); }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    return OnSurface(Unit(ray.At(hit.t) - center_));
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Vector outward = Unit(ray.At(hit.t) - center_);
    Intersection at = OnSurface(outward);  // pushed back onto the surface
    at.uv = TextureCoordinates(outward);
    at.v_ends = {VEnd::pole, VEnd::pole};
    return at;
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override {
    const Vector n = Unit(ray.At(hit.t) - center_);
    const double across = std::sqrt(n.x * n.x + n.y * n.y);
    // dp/du, and dp/dv times `across`: both are 0 at the poles, where they have no direction.
    return {2 * std::numbers::pi * radius_ * Vector{n.y, -n.x, 0},
            std::numbers::pi * radius_ * Vector{-n.z * n.x, -n.z * n.y, across * across},
            {1, 0},
            {0, across}};
  }

  bool CanBeSampled() const override { return !IsDegenerate(); }

  /// Samples the sphere. From outside, a direction is drawn uniformly in the cone that the sphere subtends; from
  /// inside, a point uniformly by area.
  ///   source   Shirley, Wang, Zimmerman, Monte Carlo techniques for direct lighting calculations (1996), section 3.2
  std::optional<SurfaceSample> Sample(const Point& from, const R2::Point& u, int element) const override {
    const Vector from_center = from - center_;
    const double distance = Length(from_center), sine = radius_ / distance;
    if (!(sine < 1)) return Shape::Sample(from, u, element);
    const double one_minus_cosine = OneMinusCosine(distance, sine);
    if (one_minus_cosine == 0) return {};  // too far away for doubles to resolve
    const Vector outward = DrawInCone(Unit(from_center), sine, one_minus_cosine, u);
    return SurfaceSample{OnSurface(Unit(outward)), UniformConePdf(one_minus_cosine)};
  }

  void SampleEach(SurfaceSamples& samples, int element) const override {
    if (!SampleFromOutside(samples)) [[unlikely]]
      Shape::SampleEach(samples, element);
  }

  /// Returns true: from outside, points of the cap that faces `from` are drawn; from inside, all are visible.
  bool DrawsInSight() const override { return true; }

  double Pdf(const Point& from, const Vector& way, const Normal& normal, int element) const override {
    const double distance = Length(from - center_), sine = radius_ / distance;
    if (!(sine < 1)) return Shape::Pdf(from, way, normal, element);
    return UniformConePdf(OneMinusCosine(distance, sine));
  }

  double SampledArea(const Point&, int) const override { return 4 * std::numbers::pi * radius_ * radius_; }
  Intersection DrawPlace(const Point&, const R2::Point& u, int) const override {
    return OnSurface(SampleUniformSphere(u));
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int rows = std::max(2, fineness / 2);
    AddGrid(data, fineness, rows, [&](int column, int row) {
      // Opposite to the direction of u, so that fronts are outside with +z up; the poles and the seam are
      // bit-identical.
      const auto turn = R1::SinCosTurns(-static_cast<double>(column % fineness) / fineness);
      const auto tilt = R1::SinCosTurns(0.5 * row / rows);
      const Vector outward{tilt.sine * turn.sine, tilt.sine * turn.cosine, -tilt.cosine};
      return GridCorner{center_ + radius_ * outward,
                        AsNormal(outward),
                        {1 - static_cast<double>(column) / fineness, static_cast<double>(row) / rows}};
    });
    return data;
  }

  Form FormOfElements() const override { return Form::convex; }
  bool IsDegenerate() const override { return !(radius_ > 0); }

  std::optional<SphereData> AsSphere() const override { return SphereData{center_, radius_}; }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"sphere", {center_.x, center_.y, center_.z, radius_}};
  }

 private:
  /// Returns the point in a unit direction from the center.
  Intersection OnSurface(const Vector& outward) const {
    const SurfacePlace place = PlaceOnSphere(center_, radius_, outward);
    Intersection at;
    at.position = place.position, at.error = place.error;
    at.normal = at.shading_normal = AsNormal(outward);
    return at;
  }

  /// Returns 1 - cos of half the angle that the sphere subtends from outside, whose sine is radius / D. It is factored,
  /// so it is accurate both for narrow cones and close to the surface.
  double OneMinusCosine(double D, double sine) const {
    return sine * sine / (1 + std::sqrt((D - radius_) / D * (1 + sine)));
  }
  /// Returns the point, from the center, where a random direction of that cone meets the sphere; `axis` points from the
  /// center to the observer. The result has length 1 up to rounding. There the angle s to the normal has sin s = sin a
  /// / sine, a being the angle off the cone's axis, and seen from the center the point is s - a off the axis.
  static Vector DrawInCone(const Vector& axis, double sine, double one_minus_cosine, const R2::Point& u) {
    const Vector w = SampleUniformCone(u, one_minus_cosine);
    const double sine_squared = w.x * w.x + w.y * w.y;
    const double cosine_of_s = std::sqrt(std::max(0.0, 1 - sine_squared / sine / sine));
    const double aside = w.z / sine - cosine_of_s, ahead = w.z * cosine_of_s + sine_squared / sine;
    return FromTangents({aside * w.x, aside * w.y, ahead}, axis);
  }

  /// Implements SampleEach; returns false, with unspecified output, if a point is inside, or so far away that the
  /// sphere has no size.
  R3_VECTORIZED bool SampleFromOutside(SurfaceSamples& samples) const {
    std::uint64_t all_outside = 1;
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const Vector from_center = samples.from[i] - center_;
      const double distance = BranchlessLength(from_center), sine = radius_ / distance;
      const double one_minus_cosine = OneMinusCosine(distance, sine);
      all_outside &= sine < 1;
      all_outside &= one_minus_cosine > 0;
      const Vector outward =
          BranchlessUnit(DrawInCone(BranchlessUnit(from_center), sine, one_minus_cosine, samples.random[i]));
      const SurfacePlace place = PlaceOnSphere(center_, radius_, outward);
      samples.Set(i, place.position, place.error, AsNormal(outward), UniformConePdf(one_minus_cosine));
    }
    return all_outside != 0;
  }

  // Matches the viewer's utility sphere: poles on z, v from -z to +z, u = 0 at +y and 0.25 at +x.
  static R2::Point TextureCoordinates(const Vector& outward) {
    const double u = R1::Atan2(outward.x, outward.y) / (2 * std::numbers::pi);
    // The arc tangent of both legs, since the arc cosine of z loses half of the digits near a pole.
    const double across = std::sqrt(outward.x * outward.x + outward.y * outward.y);
    const double v = 1 - R1::Atan2(across, outward.z) / std::numbers::pi;
    return {u < 0 ? u + 1 : u, v};
  }

  Point center_;
  double radius_;
};

}  // namespace

extern const ShapeKind sphere_kind{
    "sphere",
    "a sphere: center and radius",
    {{"cx"}, {"cy"}, {"cz"}, {"radius", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      return std::make_unique<Sphere>(Point{a[0], a[1], a[2]}, a[3]);
    },
    {0.5, -0.25, 1, 1.5},
};

}  // namespace R3
