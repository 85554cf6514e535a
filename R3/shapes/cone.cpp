#include <array>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Quadric.h"
#include "R3/shapes/Revolution.h"
#include "R3/shapes/Span.h"
#include "R3/shapes/SurfaceParts.h"

namespace R3 {
namespace {

// Its axis is parallel to y, apex up; the center is at mid-height, the base is closed.
class Cone : public Shape {
 public:
  Cone(const Point& center, double radius, double height)
      : center_(center),
        radius_(radius),
        height_(height),
        slope_(radius / height),
        low_(center.y - height / 2),
        high_(center.y + height / 2) {}

  Box Bounds(int) const override {
    return {{center_.x - radius_, low_, center_.z - radius_}, {center_.x + radius_, high_, center_.z + radius_}};
  }

  Profile ProfileInBounds() const override { return Profile::Pointed(); }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (IsDegenerate()) return {};
    if (!IsInRange(radius_ * radius_ + height_ * height_)) [[unlikely]]
      return IntersectScaled(ray);
    Span span;
    return Clip(span, ray) ? span.First(ray) : std::nullopt;
  }

  Crossings CrossingsAlong(const Ray& ray, int element) const override {
    if (IsDegenerate() || !IsInRange(radius_ * radius_ + height_ * height_)) return Shape::CrossingsAlong(ray, element);
    Span span;
    return Clip(span, ray) ? span.Ends(ray) : Crossings();
  }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    if (hit.part == base) return AtCap(p, center_, radius_, low_, -1);
    return OnSide(Unit({p.x - center_.x, 0, p.z - center_.z}), std::clamp(p.y, low_, high_));
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const Point p = ray.At(hit.t);
    if (hit.part == base) return AtCap(p, center_, radius_, low_, -1);
    const Vector outward = Unit({p.x - center_.x, 0, p.z - center_.z});  // zero at the apex
    Intersection at = OnSide(outward, std::clamp(p.y, low_, high_));
    at.uv = {outward == Vector{} ? 0 : TurnAboutY(outward), (at.position.y - low_) / height_};
    at.v_ends = {VEnd::rim, VEnd::pole};
    return at;
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override {
    if (hit.part == base) return UvTangentsAtCap(radius_);
    const Point p = ray.At(hit.t);
    const Vector outward = Unit({p.x - center_.x, 0, p.z - center_.z});
    return {AlongTurn(outward, slope_ * (high_ - std::clamp(p.y, low_, high_))),
            {-radius_ * outward.x, height_, -radius_ * outward.z}};
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (IsDegenerate()) return data;
    const int rows = std::max(1, fineness / 4);
    AddGrid(data, fineness, rows, [&](int column, int row) {
      const Vector outward = ColumnOutward(column, fineness);
      const double share = static_cast<double>(row) / rows, radius = (1 - share) * radius_;
      const Point p{center_.x + radius * outward.x, std::lerp(low_, high_, share), center_.z + radius * outward.z};
      return GridCorner{p, AsNormal(Unit({outward.x, slope_, outward.z})), {ColumnTurn(column, fineness), share}};
    });
    AddCap(data, fineness, center_, radius_, low_, -1);
    return data;
  }

  bool CanBeSampled() const override { return !IsDegenerate(); }

  double SampledArea(const Point& from, int) const override { return Sum(SeenAreas(from)); }

  Intersection DrawPlace(const Point& from, const R2::Point& u, int) const override {
    const auto [part, on_part] = DrawPart(SeenAreas(from), u);
    if (part == base) return DrawOnCap(on_part, center_, radius_, low_, -1);
    const double half_angle = SeenHalfAngle(from) > 0 ? SeenHalfAngle(from) : std::numbers::pi;
    // The area above a height is proportional to the square of the distance from the apex.
    return OnSide(OutwardBeside(from - center_, (2 * on_part.x - 1) * half_angle),
                  std::lerp(high_, low_, std::sqrt(on_part.y)));
  }

  Form FormOfElements() const override { return Form::convex; }
  bool IsDegenerate() const override { return !(radius_ > 0) || !(high_ > low_); }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"cone", {center_.x, center_.y, center_.z, radius_, height_}};
  }

 private:
  enum Part { side, base };

  /// Clips the span; returns false on a certain miss.
  bool Clip(Span& span, const Ray& ray) const {
    // Between base and apex only one of the two mirror cones remains, and it is convex. The plane through the apex is
    // not a face: it touches the solid only at the apex.
    ClipToSlab(span, low_, high_, ray.origin.y, ray.direction.y, base, side);
    if (!ClipToSide(span, ray)) return false;
    // A flat cone's side and base meet at such a sharp angle that the rounding of either would move the rim outward by
    // `slope` times as much; the cylinder around the rim is more accurate there.
    constexpr double flat_slope = 4;
    return slope_ <= flat_slope || ClipToCylinder(span, ray, center_, radius_, side);
  }

  /// Returns the intersection on the side. `outward` is zero at the apex.
  Intersection OnSide(const Vector& outward, double y) const {
    const double radius = slope_ * (high_ - y);
    Intersection at;
    at.position = {center_.x + radius * outward.x, y, center_.z + radius * outward.z};
    // Unit 4 u, radius 3 u, product and the cone test's own radius and slope another 7 u.
    at.error = Gamma(16) * radius * Abs(outward) + Gamma(4) * Abs(FromOrigin(at.position));
    at.normal = outward == Vector{} ? Normal{0, 1, 0} : AsNormal(Unit({outward.x, slope_, outward.z}));
    at.shading_normal = at.normal;
    return at;
  }

  /// Intersects a copy of cone and origin scaled by a power of two, then scales t back.
  std::optional<Hit> IntersectScaled(const Ray& ray) const {
    const int exponent = std::ilogb(std::max(radius_, height_));
    Ray near = ray;
    near.origin = ScaledByPower(ray.origin, -exponent);
    near.t_min = std::scalbn(ray.t_min, -exponent), near.t_max = std::scalbn(ray.t_max, -exponent);
    const double radius = std::scalbn(radius_, -exponent), height = std::scalbn(height_, -exponent);
    if (!IsInRange(radius * radius + height * height)) return {};
    auto hit = Cone(ScaledByPower(center_, -exponent), radius, height).Intersect(near, 0);
    if (hit) hit->t = std::scalbn(hit->t, exponent);
    return hit;
  }

  /// Returns half the angle, about the axis, of the lines from the apex to the rim whose outside is visible; 0 if none
  /// is. The plane that touches the cone along such a line has `from` on its outer side.
  double SeenHalfAngle(const Point& from) const {
    const double distance = R1::Hypot(from.x - center_.x, from.z - center_.z), inside = slope_ * (high_ - from.y);
    if (distance > std::abs(inside)) return R1::Acos(inside / distance);
    return inside < 0 ? std::numbers::pi : 0;
  }

  /// Returns the visible areas of side and base: 0 for parts that face away, the whole areas from inside.
  std::array<double, 2> SeenAreas(const Point& from) const {
    const double half_angle = SeenHalfAngle(from);
    const bool is_below = from.y < low_, is_inside = !is_below && half_angle == 0;
    return {(is_inside ? std::numbers::pi : half_angle) * radius_ * R1::Hypot(radius_, height_),
            is_inside || is_below ? std::numbers::pi * radius_ * radius_ : 0};
  }

  /// Clips the span, already between base and apex, to |horizontal part| <= slope (apex height - y). With g and e the
  /// horizontal parts of origin (from the apex) and direction, and R0 + t R1 the cone's radius along the ray, that is
  ///     A t^2 - 2 B t + C <= 0,   A = |e|^2 - R1^2,   B = R0 R1 - g.e,   C = |g|^2 - R0^2,
  /// all factored so that nothing cancels, and B^2 - A C = |R0 e - R1 g|^2 - |g x e|^2 (Lagrange's identity for the
  /// form x^2 + z^2 - r^2), the counterpart of the sphere's miss distance, factored too. A steep ray from afar still
  /// loses the errors of A, B and C relative to |g|^2, so each root is finished by one step of Newton's method, with
  /// the form evaluated at the point itself. Own derivation; oracle: 113-bit arithmetic in tests/extremes/cone.cpp.
  /// Returns false on a certain miss.
  R3_USES_FMA
  bool ClipToSide(Span& span, const Ray& ray) const {
    const double gx = ray.origin.x - center_.x, gz = ray.origin.z - center_.z;
    const double ex = ray.direction.x, ez = ray.direction.z;
    const double R0 = slope_ * (high_ - ray.origin.y), R1 = -slope_ * ray.direction.y;
    const double g = std::sqrt(gx * gx + gz * gz), e = std::sqrt(ex * ex + ez * ez);

    const double A = (e - R1) * (e + R1), B = R0 * R1 - (gx * ex + gz * ez), C = (g - R0) * (g + R0);
    const double mx = DifferenceOfProducts(R0, ex, R1, gx), mz = DifferenceOfProducts(R0, ez, R1, gz);
    const double m = std::sqrt(mx * mx + mz * mz), cross = std::abs(DifferenceOfProducts(gx, ez, gz, ex));
    const double discriminant = (m - cross) * (m + cross);

    const auto polished = [&](double t) {
      const double x = std::fma(t, ex, gx), z = std::fma(t, ez, gz), r = std::fma(t, R1, R0);
      const double rho = std::sqrt(x * x + z * z);
      const double slope = x * ex + z * ez - r * R1;  // half the slope of the form
      // Both may be only rounding errors, as they are at the apex; then the root cannot be improved.
      const double noise = Gamma(4) * (g + std::abs(R0) + std::abs(t) * (e + std::abs(R1)));
      if (!(std::abs(rho - r) > noise && std::abs(slope) > 4 * noise * (e + std::abs(R1)))) return t;
      const double step = (rho - r) * (rho + r) / (2 * slope);
      // Near a tangent the slope is useless; there t is not determined and the point is on the surface anyway.
      constexpr double small_share = 0x1p-20;
      return std::abs(step) < small_share * std::abs(t) ? t - step : t;
    };

    if (A > 0) {  // flatter than the side: one stretch of the line is inside
      if (!(discriminant >= 0)) return false;
      const double q = B + std::copysign(std::sqrt(discriminant), B);
      if (q == 0) return Keep(span, 0, 0);
      const double one = polished(C / q), other = polished(q / A);
      return Keep(span, std::min(one, other), std::max(one, other));
    }
    // Steeper than the side, or parallel to it: the line is inside this cone from one root to the base's end of it, and
    // inside the mirror cone beyond the other root. Only rounding could make the discriminant negative.
    const double q = B + std::copysign(std::sqrt(std::max(discriminant, 0.0)), B);
    if (q == 0) return C <= 0;
    const double one = polished(C / q), other = A < 0 ? polished(q / A) : -std::copysign(infinity, q);
    if (R1 > 0) return Keep(span, std::max(one, other), infinity);
    if (R1 < 0) return Keep(span, -infinity, std::min(one, other));
    return false;  // zero direction, or NaN
  }

  static bool Keep(Span& span, double from, double to) {
    span.Clip(from, to, side, side);
    return true;
  }

  Point center_;
  double radius_, height_, slope_, low_, high_;
};

}  // namespace

extern const ShapeKind cone_kind{
    "cone",
    "a closed cone about the y direction, apex up: center at mid-height, radius of the base, height",
    {{"cx"}, {"cy"}, {"cz"}, {"radius", false}, {"height", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      return std::make_unique<Cone>(Point{a[0], a[1], a[2]}, a[3], a[4]);
    },
    {0.5, -0.25, 1, 0.75, 2},
};

}  // namespace R3
