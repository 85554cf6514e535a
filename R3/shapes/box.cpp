#include <utility>

#include "R3/GridMesh.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Span.h"

namespace R3 {
namespace {

// Hit::part is 2 axis for the low face and 2 axis + 1 for the high one.
class BoxShape : public Shape {
 public:
  explicit BoxShape(const Box& box) : box_(box) {}

  Box Bounds(int) const override { return box_; }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (IsDegenerate()) return {};
    Span span;
    for (int axis = 0; axis < 3; ++axis)
      ClipToSlab(span, box_.low[axis], box_.high[axis], ray.origin[axis], ray.direction[axis], 2 * axis, 2 * axis + 1);
    return span.First(ray);
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const int axis = hit.part / 2;
    const bool is_high = hit.part % 2 == 1;
    const double face = is_high ? box_.high[axis] : box_.low[axis];
    const double outward = is_high ? 1 : -1;
    Intersection at;
    const Point p = ray.At(hit.t);
    at.position = {axis == 0 ? face : Within(p.x, 0), axis == 1 ? face : Within(p.y, 1),
                   axis == 2 ? face : Within(p.z, 2)};
    at.error = Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = {axis == 0 ? outward : 0, axis == 1 ? outward : 0, axis == 2 ? outward : 0};
    at.shading_normal = at.normal;
    at.uv = TextureCoordinates(at.position, hit.part);
    return at;
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int pieces = std::max(1, fineness / 4);
    for (int part = 0; part < 6; ++part) {
      const int axis = part / 2;
      const bool is_high = part % 2 == 1;
      const double outward = is_high ? 1 : -1;
      // Which of the other two axes runs to the right decides where the front is.
      const int right = (axis + (is_high ? 1 : 2)) % 3;
      AddGrid(data, pieces, pieces, [&](int column, int row) {
        const auto along = [&](int a) {
          const double share = static_cast<double>(a == right ? column : row) / pieces;
          return a == axis ? (is_high ? box_.high[a] : box_.low[a]) : std::lerp(box_.low[a], box_.high[a], share);
        };
        const Point p{along(0), along(1), along(2)};
        const Normal normal{axis == 0 ? outward : 0, axis == 1 ? outward : 0, axis == 2 ? outward : 0};
        return GridCorner{p, normal, TextureCoordinates(p, part)};
      });
    }
    return data;
  }

  /// A box flat along one axis is a rectangle; flat along two it is a line, which nothing hits.
  bool IsDegenerate() const override {
    const Vector size = box_.Size();
    return (size.x > 0) + (size.y > 0) + (size.z > 0) < 2;
  }

 private:
  double Within(double coordinate, int axis) const { return std::clamp(coordinate, box_.low[axis], box_.high[axis]); }

  R2::Point TextureCoordinates(const Point& p, int part) const {
    const auto share = [&](int axis) {
      const double length = box_.high[axis] - box_.low[axis];
      return length > 0 ? (p[axis] - box_.low[axis]) / length : 0;
    };
    const double x = share(0), y = share(1), z = share(2);
    switch (part) {
      case 0:
        return {1 - y, z};
      case 1:
        return {y, z};
      case 2:
        return {x, z};
      case 3:
        return {1 - x, z};
      case 4:
        return {x, 1 - y};
      default:
        return {x, y};
    }
  }

  Box box_;
};

}  // namespace

extern const ShapeKind box_kind{
    "box",
    "an axis-aligned box: two opposite corners, in any order",
    {{"x"}, {"y"}, {"z"}, {"X"}, {"Y"}, {"Z"}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      Box box;  // sorted: hand-out scenes give reversed corners
      box.Extend(Point{a[0], a[1], a[2]});
      box.Extend(Point{a[3], a[4], a[5]});
      return std::make_unique<BoxShape>(box);
    },
    {-1, -0.5, -2, 1.5, 1, 0.5},
};

}  // namespace R3
