
#include "R3/GridMesh.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Span.h"
#include "R3/shapes/SurfaceParts.h"

namespace R3 {
namespace {

// Hit::part is 2 axis for the low face and 2 axis + 1 for the high one.
class BoxShape : public Shape {
 public:
  explicit BoxShape(const Box& box) : box_(box), is_degenerate_(IsLineOrLess(box.Size())) {}

  Box Bounds(int) const override { return box_; }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (is_degenerate_ || IsLeavingBox(box_, ray)) return {};
    return InsideOf(ray).First(ray);
  }

  Crossings CrossingsAlong(const Ray& ray, int) const override {
    if (is_degenerate_) return {};
    return InsideOf(ray).Ends(ray);
  }

  Intersection At(const Ray& ray, const Hit& hit, int element) const override {
    Intersection at = BoxShape::PlaceAt(ray, hit, element);
    at.uv = TextureCoordinates(at.position, hit.part);
    return at;
  }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    return OnFace(hit.part, [&](int axis) { return Within(p[axis], axis); });
  }

  UvTangents UvTangentsAt(const Ray&, const Hit& hit, int) const override {
    const int right = (hit.part / 2 + 1) % 3, up = (hit.part / 2 + 2) % 3;
    const auto side = [&](int along) {
      const auto reach = [&](int axis) { return axis == along ? box_.high[axis] - box_.low[axis] : 0; };
      return Vector{reach(0), reach(1), reach(2)};
    };
    const auto gain = [&](int along) {
      return TextureCoordinates(box_.low + side(along), hit.part) - TextureCoordinates(box_.low, hit.part);
    };
    return {side(right), side(up), gain(right), gain(up)};
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int pieces = std::max(1, fineness / 4);
    for (int part = 0; part < 6; ++part) {
      const int axis = part / 2;
      const bool is_high = part % 2 == 1;
      const double outward = is_high ? 1 : -1;
      // The front depends on which of the other two axes runs to the right.
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

  bool CanBeSampled() const override { return !IsDegenerate(); }

  double SampledArea(const Point& from, int) const override { return Sum(SeenAreas(from)); }

  Intersection DrawPlace(const Point& from, const R2::Point& u, int) const override {
    const auto [part, on_face] = DrawPart(SeenAreas(from), u);
    const int right = (part / 2 + 1) % 3;
    return OnFace(part, [&, at = on_face](int axis) {
      return std::lerp(box_.low[axis], box_.high[axis], axis == right ? at.x : at.y);
    });
  }

  /// A box flat along one axis is a rectangle; flat along two it is a line, which nothing hits.
  Form FormOfElements() const override { return Form::convex; }
  bool IsDegenerate() const override { return is_degenerate_; }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"box", {box_.low.x, box_.low.y, box_.low.z, box_.high.x, box_.high.y, box_.high.z}};
  }

 private:
  Span InsideOf(const Ray& ray) const {
    Span span;
    for (int axis = 0; axis < 3; ++axis)
      ClipToSlab(span, box_.low[axis], box_.high[axis], ray.origin[axis], ray.direction[axis], 2 * axis, 2 * axis + 1);
    return span;
  }

  static bool IsLineOrLess(const Vector& size) { return (size.x > 0) + (size.y > 0) + (size.z > 0) < 2; }

  /// Returns the point on a face with these coordinates along the other axes.
  template <typename Coordinate>
  Intersection OnFace(int part, const Coordinate& along) const {
    const int face_axis = part / 2;
    const bool is_high = part % 2 == 1;
    const double face = is_high ? box_.high[face_axis] : box_.low[face_axis], outward = is_high ? 1 : -1;
    const auto coordinate = [&](int axis) { return axis == face_axis ? face : along(axis); };
    const auto component = [&](int axis) { return axis == face_axis ? outward : 0; };
    Intersection at;
    at.position = {coordinate(0), coordinate(1), coordinate(2)};
    at.error = Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = at.shading_normal = {component(0), component(1), component(2)};
    return at;
  }

  /// Returns the areas of the visible faces: 0 for those that face away, the whole areas from inside.
  std::array<double, 6> SeenAreas(const Point& from) const {
    const Vector size = box_.Size();
    const bool is_inside = box_.Contains(from);
    std::array<double, 6> areas{};
    for (int axis = 0; axis < 3; ++axis) {
      const double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
      const auto low = static_cast<std::size_t>(2 * axis);
      if (is_inside || from[axis] < box_.low[axis]) areas[low] = area;
      if (is_inside || from[axis] > box_.high[axis]) areas[low + 1] = area;
    }
    return areas;
  }

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
  bool is_degenerate_;
};

}  // namespace

extern const ShapeKind box_kind{
    "box",
    "an axis-aligned box: two opposite corners, in any order",
    {{"x"}, {"y"}, {"z"}, {"X"}, {"Y"}, {"Z"}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      Box box;  // sorted, since course scenes list corners in reverse
      box.Extend(Point{a[0], a[1], a[2]});
      box.Extend(Point{a[3], a[4], a[5]});
      return std::make_unique<BoxShape>(box);
    },
    {-1, -0.5, -2, 1.5, 1, 0.5},
};

}  // namespace R3
