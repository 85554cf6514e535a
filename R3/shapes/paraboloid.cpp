#include <cmath>
#include <vector>

#include "R1/DoubleDouble.h"
#include "R1/Elementary.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Revolution.h"
#include "R3/shapes/Span.h"

namespace R3 {
namespace {

// Its axis is parallel to y, apex up; the center is at mid-height, the base is closed.
class Paraboloid : public Shape {
 public:
  Paraboloid(const Point& center, double radius, double height)
      : center_(center),
        radius_(radius),
        height_(height),
        low_(center.y - height / 2),
        high_(center.y + height / 2),
        to_unit_(std::max(radius, height) > 0 ? std::scalbn(1, -std::ilogb(std::max(radius, height))) : 1) {}

  Box Bounds(int) const override {
    return {{center_.x - radius_, low_, center_.z - radius_}, {center_.x + radius_, high_, center_.z + radius_}};
  }

  Profile ProfileInBounds() const override { return Profile::Upright(); }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (IsDegenerate()) return {};
    Span span;
    ClipToSlab(span, low_, high_, ray.origin.y, ray.direction.y, base, side);
    if (!ClipToSide(span, ray)) return {};
    return span.First(ray);
  }

  Crossings CrossingsAlong(const Ray& ray, int) const override {
    if (IsDegenerate()) return {};
    Span span;
    ClipToSlab(span, low_, high_, ray.origin.y, ray.direction.y, base, side);
    return ClipToSide(span, ray) ? span.Ends(ray) : Crossings();
  }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    if (hit.part == base) return AtCap(p, center_, radius_, low_, -1);
    const Vector across{p.x - center_.x, 0, p.z - center_.z};
    return OnSideBeside(p, across, Unit(across));
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    return hit.part == base ? AtCap(p, center_, radius_, low_, -1) : OnSideNear(p);
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override {
    if (hit.part == base) return UvTangentsAtCap(radius_);
    const Point p = OnSideNear(ray.At(hit.t)).position;
    const Vector across{p.x - center_.x, 0, p.z - center_.z}, outward = Unit(across);
    const double share = Length(across) / radius_;
    return {AlongTurn(outward, share * radius_), {-radius_ * outward.x, 2 * height_ * share, -radius_ * outward.z}};
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const std::vector<double> shares = RingsFor(std::max(1, fineness / 4));
    AddGrid(data, fineness, static_cast<int>(shares.size()) - 1, [&](int column, int row) {
      const Vector outward = ColumnOutward(column, fineness);
      const double share = shares[static_cast<std::size_t>(row)];
      const Point p{center_.x + share * radius_ * outward.x, std::lerp(high_, low_, share * share),
                    center_.z + share * radius_ * outward.z};
      return GridCorner{p, NormalAt(outward, share), {ColumnTurn(column, fineness), 1 - share}};
    });
    AddCap(data, fineness, center_, radius_, low_, -1);
    return data;
  }

  Form FormOfElements() const override { return Form::convex; }
  bool IsDegenerate() const override { return !(radius_ > 0) || !(high_ > low_); }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"paraboloid", {center_.x, center_.y, center_.z, radius_, height_}};
  }

 private:
  enum Part { side, base };

  /// Returns the rings for display, from the rim to the apex, as shares of the radius, plus one where the slope is 1:
  /// between there and the apex the normals turn most.
  std::vector<double> RingsFor(int rows) const {
    std::vector<double> shares;
    for (int row = 0; row <= rows; ++row) shares.push_back(1 - static_cast<double>(row) / rows);
    const double at_slope_one = radius_ / (2 * height_);
    if (at_slope_one < 1.0 / rows) shares.insert(shares.end() - 1, at_slope_one);
    return shares;
  }

  /// Returns the outward normal at this share of the radius from the axis: the gradient of x^2 + z^2 + r^2 y / h, times
  /// 1 / r.
  Normal NormalAt(const Vector& outward, double share) const {
    return AsNormal(Unit({2 * share * outward.x, radius_ / height_, 2 * share * outward.z}));
  }

  /// Returns the point of the side next to `p`: at its height where the side is steep, above or below it where the side
  /// is flat, since the height does not determine the radius near the apex.
  Intersection OnSideNear(const Point& p) const {
    const Vector across{p.x - center_.x, 0, p.z - center_.z}, outward = Unit(across);
    Intersection at = OnSideBeside(p, across, outward);
    at.uv = {outward == Vector{} ? 0 : TurnAboutY(outward),
             1 - R1::Hypot(at.position.x - center_.x, at.position.z - center_.z) / radius_};
    at.v_ends = {VEnd::rim, VEnd::pole};
    return at;
  }

  Intersection OnSideBeside(const Point& p, const Vector& across, const Vector& outward) const {
    const double share = std::min(1.0, Length(across) / radius_);
    const bool is_steep = 2 * share > radius_ / height_;
    const double y = std::clamp(p.y, low_, high_);
    return is_steep ? OnSide(outward, std::sqrt((high_ - y) / height_), y)
                    : OnSide(outward, share, std::max(low_, high_ - share * share * height_));
  }

  /// Returns the intersection on the side. `outward` is zero at the apex. One of `share` and `y` is given and the other
  /// follows; the latter is off by 8 u relative, which moves the surface by as much along its normal.
  Intersection OnSide(const Vector& outward, double share, double y) const {
    Intersection at;
    at.position = {center_.x + share * radius_ * outward.x, y, center_.z + share * radius_ * outward.z};
    at.error = Gamma(16) * share * radius_ * Abs(outward) + Gamma(4) * Abs(FromOrigin(at.position)) +
               Vector{0, Gamma(8) * std::min(share * share, share) * height_, 0};
    at.normal = at.shading_normal = NormalAt(outward, share);
    return at;
  }

  /// Clips to the infinite paraboloid, which is convex. With g and e the horizontal parts of origin (from the axis) and
  /// direction, and s + t s' the depth below the apex, the line is inside where
  ///     A t^2 - 2 B t + C <= 0,   A = |e|^2, B = k s' / 2 - g.e, C = |g|^2 - k s, k = r^2 / h.
  /// In double-words, which are off by 2^-100 of their terms, no visible cancellation occurs: C is off by 2^-100 D^2,
  /// and the surface by 2^-100 D^2 / r, which is less than u D up to D = 2^47 r. Without a horizontal direction A is 0,
  /// and one of the roots is infinite. Computed in units in which radius, height and direction are about 1. Returns
  /// false on a certain miss.
  R3_USES_FMA
  bool ClipToSide(Span& span, const Ray& ray) const {
    const double largest = MaxComponent(Abs(ray.direction));
    if (!(largest > 0 && largest < infinity)) return false;
    const double shorter = std::scalbn(1, -std::ilogb(largest)), r = to_unit_ * radius_, h = to_unit_ * height_;
    const Vector d = shorter * ray.direction;
    const auto between = [&](double o, double c) {
      const DoubleDouble p = ExactSum(o, -c);
      return DoubleDouble{to_unit_ * p.high, to_unit_ * p.low};
    };
    const DoubleDouble gx = between(ray.origin.x, center_.x), gz = between(ray.origin.z, center_.z);
    const DoubleDouble depth = DoubleDouble(h / 2) - between(ray.origin.y, center_.y);
    const DoubleDouble k = ExactProduct(r, r) / DoubleDouble(h);
    const DoubleDouble A = ExactProduct(d.x, d.x) + ExactProduct(d.z, d.z);
    const DoubleDouble B = k * (-0.5 * d.y) - (gx * d.x + gz * d.z), C = gx * gx + gz * gz - k * depth;
    const double discriminant = static_cast<double>(B * B - A * C);
    if (!(discriminant >= 0)) return false;
    const double half = static_cast<double>(B), q = half + std::copysign(std::sqrt(discriminant), half);
    const auto clip = [&](double one, double other) {
      const auto in_t = [&](double t) { return t * shorter / to_unit_; };
      span.Clip(in_t(std::min(one, other)), in_t(std::max(one, other)), side, side);
      return true;
    };
    if (q == 0) return clip(0, 0);
    return clip(static_cast<double>(C) / q, q / static_cast<double>(A));
  }

  Point center_;
  double radius_, height_, low_, high_;
  double to_unit_;  // the power of two that brings the larger of radius and height into [1, 2)
};

}  // namespace

extern const ShapeKind paraboloid_kind{
    "paraboloid",
    "a closed paraboloid about the y direction, apex up: center at mid-height, radius of the base, height",
    {{"cx"}, {"cy"}, {"cz"}, {"radius", false}, {"height", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      return std::make_unique<Paraboloid>(Point{a[0], a[1], a[2]}, a[3], a[4]);
    },
    {0.5, -0.25, 1, 0.75, 2},
};

}  // namespace R3
