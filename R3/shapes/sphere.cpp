#include <numbers>

#include "R3/GridMesh.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Quadric.h"
#include "R3/shapes/Span.h"

namespace R3 {
namespace {

class Sphere : public Shape {
 public:
  Sphere(const Point& center, double radius) : center_(center), radius_(radius) {}

  Box Bounds(int) const override {
    const Vector r{radius_, radius_, radius_};
    return {center_ - r, center_ + r};
  }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (IsDegenerate()) return {};
    const auto roots = QuadricRoots(ray.origin, ray.direction, center_, radius_);
    if (!roots) return {};
    return Span{roots->first, roots->second, 0, 0}.First(ray);
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Vector outward = Unit(ray.At(hit.t) - center_);
    Intersection at;
    at.position = center_ + radius_ * outward;  // pushed back onto the surface
    // Unit errs by 4 u, the product by one more, the sum by one of the result.
    at.error = Gamma(6) * radius_ * Abs(outward) + Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = at.shading_normal = AsNormal(outward);
    at.uv = TextureCoordinates(outward);
    return at;
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int rows = std::max(2, fineness / 2);
    AddGrid(data, fineness, rows, [&](int column, int row) {
      // Against the sense of u, so that fronts are outside with +z up; the poles and the seam meet to the bit.
      const double turn = -2 * std::numbers::pi * (column % fineness) / fineness;
      const double tilt = std::numbers::pi * row / rows;
      const double across = row == 0 || row == rows ? 0 : std::sin(tilt);
      const Vector outward{across * std::sin(turn), across * std::cos(turn), -std::cos(tilt)};
      return GridCorner{center_ + radius_ * outward,
                        AsNormal(outward),
                        {1 - static_cast<double>(column) / fineness, static_cast<double>(row) / rows}};
    });
    return data;
  }

  bool IsDegenerate() const override { return !(radius_ > 0); }

 private:
  // As the viewer's utility sphere draws it: poles on z, v from -z to +z, u = 0 at +y and 0.25 at +x.
  static R2::Point TextureCoordinates(const Vector& outward) {
    const double u = std::atan2(outward.x, outward.y) / (2 * std::numbers::pi);
    const double v = 1 - std::acos(std::clamp(outward.z, -1.0, 1.0)) / std::numbers::pi;
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
