#include <array>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Quadric.h"
#include "R3/shapes/Revolution.h"
#include "R3/shapes/Span.h"
#include "R3/shapes/SurfaceParts.h"

namespace R3 {
namespace {

// Its axis is parallel to y, the center at mid-height, both ends closed.
class Cylinder : public Shape {
 public:
  Cylinder(const Point& center, double radius, double height)
      : center_(center), radius_(radius), height_(height), low_(center.y - height / 2), high_(center.y + height / 2) {}

  Box Bounds(int) const override {
    return {{center_.x - radius_, low_, center_.z - radius_}, {center_.x + radius_, high_, center_.z + radius_}};
  }

  Profile ProfileInBounds() const override { return Profile::Upright(); }

  // A cylinder is convex, so the ray is inside it where it is inside both the infinite cylinder and the slab: no rim to
  // leak through.
  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (IsDegenerate() || IsLeaving(ray)) return {};
    Span span;
    return Clip(span, ray) ? span.First(ray) : std::nullopt;
  }

  Crossings CrossingsAlong(const Ray& ray, int) const override {
    Span span;
    return !IsDegenerate() && Clip(span, ray) ? span.Ends(ray) : Crossings();
  }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    if (hit.part != side) return AtCap(p, center_, radius_, hit.part == top ? high_ : low_, hit.part == top ? 1 : -1);
    return OnSide(Unit({p.x - center_.x, 0, p.z - center_.z}), std::clamp(p.y, low_, high_));
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    if (hit.part != side) return AtCap(p, center_, radius_, hit.part == top ? high_ : low_, hit.part == top ? 1 : -1);
    const Vector outward = Unit({p.x - center_.x, 0, p.z - center_.z});
    Intersection at = OnSide(outward, std::clamp(p.y, low_, high_));
    at.uv = {TurnAboutY(outward), (at.position.y - low_) / height_};
    at.v_ends = {VEnd::rim, VEnd::rim};
    return at;
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override {
    if (hit.part != side) return UvTangentsAtCap(radius_);
    const Point p = ray.At(hit.t);
    return {AlongTurn(Unit({p.x - center_.x, 0, p.z - center_.z}), radius_), {0, height_, 0}};
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int rows = std::max(1, fineness / 8);
    AddGrid(data, fineness, rows, [&](int column, int row) {
      const Vector outward = ColumnOutward(column, fineness);
      const double share = static_cast<double>(row) / rows;
      const Point p{center_.x + radius_ * outward.x, std::lerp(low_, high_, share), center_.z + radius_ * outward.z};
      return GridCorner{p, AsNormal(outward), {ColumnTurn(column, fineness), share}};
    });
    AddCap(data, fineness, center_, radius_, low_, -1);
    AddCap(data, fineness, center_, radius_, high_, 1);
    return data;
  }

  bool CanBeSampled() const override { return !IsDegenerate(); }

  double SampledArea(const Point& from, int) const override { return Sum(SeenAreas(from)); }

  Intersection DrawPlace(const Point& from, const R2::Point& u, int) const override {
    const auto [part, on_part] = DrawPart(SeenAreas(from), u);
    if (part != side) return DrawOnCap(on_part, center_, radius_, part == top ? high_ : low_, part == top ? 1 : -1);
    const Vector from_axis = from - center_;
    const double angle = (2 * on_part.x - 1) * SeenHalfAngle(from_axis);
    return OnSide(OutwardBeside(from_axis, angle), std::lerp(low_, high_, on_part.y));
  }

  Form FormOfElements() const override { return Form::convex; }
  bool IsDegenerate() const override { return !(radius_ > 0) || !(high_ > low_); }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"cylinder", {center_.x, center_.y, center_.z, radius_, height_}};
  }

 private:
  enum Part { side, bottom, top };

  /// Clips the span; returns false on a certain miss.
  bool Clip(Span& span, const Ray& ray) const {
    ClipToSlab(span, low_, high_, ray.origin.y, ray.direction.y, bottom, top);
    return ClipToCylinder(span, ray, center_, radius_, side);
  }

  /// Returns true if the ray certainly leaves without a hit, as most rays do that start on the surface.
  bool IsLeaving(const Ray& ray) const {
    const Vector across{ray.direction.x, 0, ray.direction.z};
    const auto leaves_from = [&](const Point& p) {
      return IsLeavingSlab(low_, high_, p.y, ray.direction.y) ||
             IsCertainlyLeaving({p.x - center_.x, 0, p.z - center_.z}, across, radius_);
    };
    return leaves_from(ray.origin) && (ray.t_min >= 0 || leaves_from(ray.At(BeforeHits(ray.t_min))));
  }

  Intersection OnSide(const Vector& outward, double y) const {
    Intersection at;
    at.position = {center_.x + radius_ * outward.x, y, center_.z + radius_ * outward.z};
    at.error = Gamma(6) * radius_ * Abs(outward) + Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = at.shading_normal = AsNormal(outward);
    return at;
  }

  bool IsInside(const Point& p) const {
    return low_ <= p.y && p.y <= high_ && R1::Hypot(p.x - center_.x, p.z - center_.z) <= radius_;
  }

  /// Returns half the angle about the axis of the visible part of the side.
  double SeenHalfAngle(const Vector& from_axis) const {
    const double distance = R1::Hypot(from_axis.x, from_axis.z);
    return distance > radius_ ? R1::Acos(radius_ / distance) : std::numbers::pi;
  }

  /// Returns the areas of the visible parts: 0 for those that face away, the whole areas from inside.
  std::array<double, 3> SeenAreas(const Point& from) const {
    const Vector from_axis = from - center_;
    const bool is_inside = IsInside(from);
    const bool is_beside = R1::Hypot(from_axis.x, from_axis.z) > radius_;
    const double cap = std::numbers::pi * radius_ * radius_;
    return {is_inside || is_beside ? 2 * SeenHalfAngle(from_axis) * radius_ * height_ : 0,
            is_inside || from.y < low_ ? cap : 0, is_inside || from.y > high_ ? cap : 0};
  }

  Point center_;
  double radius_, height_, low_, high_;
};

}  // namespace

extern const ShapeKind cylinder_kind{
    "cylinder",
    "a closed cylinder about the y direction: center at mid-height, radius, height",
    {{"cx"}, {"cy"}, {"cz"}, {"radius", false}, {"height", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      return std::make_unique<Cylinder>(Point{a[0], a[1], a[2]}, a[3], a[4]);
    },
    {0.5, -0.25, 1, 0.75, 2},
};

}  // namespace R3
