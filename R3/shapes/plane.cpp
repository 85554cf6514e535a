#include <cmath>

#include "R1/DoubleDouble.h"
#include "R3/GridMesh.h"
#include "R3/ShapeKind.h"

namespace R3 {
namespace {

/// The infinite half-space on one side of a plane. The normal is used as given, because rounding it to unit length
/// would tilt the plane far from its point.
class Plane : public Shape {
 public:
  Plane(const Point& point, const Vector& normal)
      : point_(point), normal_(normal), unit_(Unit(normal)), across_(AnyPerpendicular(unit_)) {}

  Box Bounds(int) const override { return {}; }
  bool IsBounded() const override { return false; }
  Form FormOfElements() const override { return Form::flat; }
  bool IsSolid() const override { return false; }

  // The distance is exact except for its final rounding, so the error of t is a few u at any distance.
  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    const double towards = -Dot(normal_, ray.direction);
    const double t = DistanceTimesLength(ray.origin) / towards;
    if (!(t > ray.t_min && t < ray.t_max)) return {};  // also if the ray is parallel: infinite, or NaN in the plane
    return Hit{t};
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    Intersection at;
    const Point near = ray.At(hit.t);
    const Vector back = DistanceTimesLength(near) / Dot(normal_, normal_) * normal_;
    at.position = near - back;
    // The step back errs by a few u of itself, the difference by one of the result.
    at.error = Gamma(8) * Abs(back) + Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = at.shading_normal = AsNormal(unit_);
    const Vector off = at.position - point_;
    at.uv = {Fraction(Dot(off, across_)), Fraction(Dot(off, Cross(unit_, across_)))};
    return at;
  }

  UvTangents UvTangentsAt(const Ray&, const Hit&, int) const override { return {across_, Cross(unit_, across_)}; }

  /// Returns the square within 1 of the point, finer near the point; the viewer scales it and its texture coordinates
  /// as needed.
  MeshData Tessellate(int fineness) const override {
    MeshData data;
    const Vector upward = Cross(unit_, across_);
    AddGrid(data, fineness, fineness, [&](int column, int row) {
      const double u = static_cast<double>(column) / fineness, v = static_cast<double>(row) / fineness;
      const auto cube = [](double a) { return a * a * a; };
      const double x = cube(2 * u - 1), y = cube(2 * v - 1);
      return GridCorner{point_ + x * across_ + y * upward, AsNormal(unit_), {x, y}};
    });
    return data;
  }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"plane", {point_.x, point_.y, point_.z, normal_.x, normal_.y, normal_.z}};
  }

 private:
  static double Fraction(double x) { return x - std::floor(x); }
  static Vector AnyPerpendicular(const Vector& n) { return Unit(Cross(LeastAxis(n), n)); }
  /// Returns the distance of a point from the plane along the normal, times the length of the normal.
  double DistanceTimesLength(const Point& p) const {
    DoubleDouble sum;
    for (int i = 0; i < 3; ++i) sum = sum + ExactSum(p[i], -point_[i]) * DoubleDouble(normal_[i]);
    return static_cast<double>(sum);
  }

  Point point_;
  Vector normal_, unit_, across_;
};

}  // namespace

extern const ShapeKind plane_kind{
    "plane",
    "an infinite plane: a point of it and its normal of any length",
    {{"px"}, {"py"}, {"pz"}, {"nx"}, {"ny"}, {"nz"}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      constexpr std::size_t of_normal = 3;
      const Vector normal{a[3], a[4], a[5]};
      if (normal == Vector{}) throw ArgumentError(of_normal, "the normal must not be 0 0 0");
      return std::make_unique<Plane>(Point{a[0], a[1], a[2]}, normal);
    },
    {0.5, -0.25, 1, 1, 2, -0.5},
};

}  // namespace R3
