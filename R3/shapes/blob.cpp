#include <algorithm>
#include <cmath>
#include <vector>

#include "R3/Numeric.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/FieldOnLine.h"
#include "R3/shapes/PlanarUv.h"

namespace R3 {
namespace {

/// One source of the field, in the units of the blob.
struct Ball {
  Vector center;    // relative to the middle of the blob
  double radius;    // above 0
  double strength;  // in thresholds
};

/// The field at a point, in thresholds and units of the blob.
struct Field {
  double value = 0;
  Vector gradient{};
  double magnitude = 0;  // sum of the magnitudes of its terms
};

Field FieldAt(const std::vector<Ball>& balls, const Vector& p) {
  Field field;
  for (const Ball& ball : balls) {
    const Vector d = (p - ball.center) / ball.radius;
    const double q = 1 - Dot(d, d);
    if (!(q > 0)) continue;
    field.value += ball.strength * q * q * q;
    field.magnitude += std::abs(ball.strength);
    field.gradient = field.gradient - (6 * ball.strength * q * q / ball.radius) * d;
  }
  return field;
}

/// Bounds on the field within a box.
struct FieldRange {
  double low = 0, high = 0;
};

FieldRange RangeIn(const std::vector<Ball>& balls, const Box& box) {
  FieldRange range;
  for (const Ball& ball : balls) {
    double nearest = 0, farthest = 0;  // squared distances in radii
    for (int axis = 0; axis < 3; ++axis) {
      const double from_low = (ball.center[axis] - box.low[axis]) / ball.radius,
                   from_high = (box.high[axis] - ball.center[axis]) / ball.radius;
      const double outside = std::max({0.0, -from_low, -from_high}), across = std::max(from_low, from_high);
      nearest += outside * outside, farthest += across * across;
    }
    const auto at = [&](double square) { return square < 1 ? (1 - square) * (1 - square) * (1 - square) : 0; };
    range.low += ball.strength * at(ball.strength > 0 ? farthest : nearest);
    range.high += ball.strength * at(ball.strength > 0 ? nearest : farthest);
  }
  return range;
}

/// A search for the box around all points where the field may be 1, to 2^-8 of the longest side of the region where it
/// is not 0.
class Bounder {
 public:
  explicit Bounder(const std::vector<Ball>& balls) : balls_(balls) {
    Box all;
    for (const Ball& ball : balls) {
      const Vector reach{ball.radius, ball.radius, ball.radius};
      if (ball.strength > 0) all.Extend(Box{Point{} + (ball.center - reach), Point{} + (ball.center + reach)});
    }
    if (!all.IsEmpty()) Extend(all, 3 * 8);
  }

  const Box& Result() const { return result_; }

 private:
  void Extend(const Box& cell, int halvings) {
    if (!result_.IsEmpty() && result_.Contains(cell.low) && result_.Contains(cell.high)) return;
    const FieldRange range = RangeIn(balls_, cell);
    constexpr double rounding = 0x1p-40;  // far more than that of a thousand balls
    if (!(range.high >= 1 - rounding)) return;
    if (halvings == 0 || range.low >= 1) return result_.Extend(cell);
    const int axis = MaxAxis(cell.Size());
    const double middle = cell.Center()[axis];
    const auto with = [&](Point p) {
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = middle;
      return p;
    };
    Extend({cell.low, with(cell.high)}, halvings - 1);
    Extend({with(cell.low), cell.high}, halvings - 1);
  }

  const std::vector<Ball>& balls_;
  Box result_;
};

// The solid where the sum of strength (1 - (d / radius)^2)^3, over the balls whose centers are at a distance d below
// their radius, is above a threshold.
//   source   Wyvill, McPheeters, Wyvill, Data structure for soft objects (1986); this polynomial is zero with two of
//            its derivatives at the radius, and of degree six along a line
class Blob : public Shape {
 public:
  /// Makes a blob of a threshold above 0 and, for each ball, center, radius and strength.
  explicit Blob(std::span<const double> numbers) : numbers_(numbers.begin(), numbers.end()) {
    Box all;
    for (std::size_t i = 1; i < numbers.size(); i += 5) {
      const Vector reach{numbers[i + 3], numbers[i + 3], numbers[i + 3]};
      all.Extend(Box{CenterAt(i) - reach, CenterAt(i) + reach});
    }
    const double size = MaxComponent(all.Size());
    if (!(size > 0)) return;
    middle_ = all.Center();
    constexpr int most = 1000;  // 2^1000 is finite, and no size is far below 2^-1000
    to_unit_ = std::min(most, -std::ilogb(size));
    for (std::size_t i = 1; i < numbers.size(); i += 5)
      if (numbers[i + 3] > 0 && numbers[i + 4] != 0)
        balls_.push_back({ScaledByPower(CenterAt(i) - middle_, to_unit_), std::scalbn(numbers[i + 3], to_unit_),
                          numbers[i + 4] / numbers[0]});
    FindBounds();
  }

  Box Bounds(int) const override { return bounds_; }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    const double largest = MaxComponent(Abs(ray.direction));
    if (is_empty_ || !(largest > 0 && largest < infinity) || !IsFinite(FromOrigin(ray.origin))) return {};
    const int shorter = -std::ilogb(largest);
    field::FieldOnLine line = FieldAlong(ray, shorter);
    const auto in_t = [&](double s) { return std::scalbn(s, shorter - to_unit_); };
    const auto s = line.First([&](double place) { return in_t(place) > ray.t_min; });
    return s && in_t(*s) < ray.t_max ? std::optional(Hit{.t = in_t(*s)}) : std::nullopt;
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    Vector p = FromMiddle(ray.At(hit.t));
    // One step of Newton's method along the gradient corrects the rounding of a distant ray, and is limited to that
    // error: where the gradient vanishes nothing is known.
    const auto off = [](const Field& field) { return (field.value - 1) / Dot(field.gradient, field.gradient); };
    const Field near = FieldAt(balls_, p);
    const double step = off(near);
    if (std::abs(step) * Length(near.gradient) < largest_error) p = p - step * near.gradient;
    const Field field = FieldAt(balls_, p);
    Intersection at;
    at.position = middle_ + ScaledByPower(p, -to_unit_);
    // Each term has 24 roundings, and its sum one per ball; doubled to cover the effect of the curvature.
    const double rounding = 2 * Gamma(24 + static_cast<int>(balls_.size())) * (field.magnitude + 1);
    const double error = (std::abs(field.value - 1) + rounding) / Length(field.gradient);
    const double known = std::scalbn(error < largest_error ? error : largest_error, -to_unit_);
    at.error = Vector{known, known, known} + Gamma(4) * (Abs(FromOrigin(at.position)) + Abs(FromOrigin(middle_)));
    const Vector outward = Unit(-field.gradient);
    at.normal = at.shading_normal = outward == Vector{} ? Normal{0, 1, 0} : AsNormal(outward);
    SetPlanarUv(at, bounds_);
    return at;
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const override {
    return PlanarUvTangents(At(ray, hit, element).normal, bounds_);
  }

  bool IsDegenerate() const override { return is_empty_; }
  std::optional<Recipe> MadeFrom() const override { return Recipe{"blob", numbers_}; }

 private:
  /// The error limit in units of the blob: beyond this share of its size, the slope at a point does not predict the
  /// surface.
  static constexpr double largest_error = 0x1p-20;

  Point CenterAt(std::size_t i) const { return {numbers_[i], numbers_[i + 1], numbers_[i + 2]}; }
  Vector FromMiddle(const Point& p) const { return ScaledByPower(p - middle_, to_unit_); }

  void FindBounds() {
    const Box box = Bounder(balls_).Result();
    is_empty_ = box.IsEmpty();
    if (is_empty_) return;
    const auto in_world = [&](const Point& p) { return middle_ + ScaledByPower(FromOrigin(p), -to_unit_); };
    bounds_ = {in_world(box.low), in_world(box.high)};
  }

  /// Returns the field along a ray, with each ball relative to its own nearest point to the center, so that small balls
  /// are as accurate as large ones.
  field::FieldOnLine FieldAlong(const Ray& ray, int shorter) const {
    const Vector v = ScaledByPower(ray.direction, shorter), origin = FromMiddle(ray.origin);
    const double vv = Dot(v, v);
    field::FieldOnLine line;
    for (const Ball& ball : balls_) {
      const Vector p = origin - ball.center;
      const double middle = -Dot(p, v) / vv;
      const Vector miss = (p + middle * v) / ball.radius;
      const double height = 1 - Dot(miss, miss), bend = vv / (ball.radius * ball.radius);
      if (!(height > 0)) continue;
      const double half = std::sqrt(height / bend);
      line.Add({middle, height, bend, ball.strength, middle - half, middle + half});
    }
    return line;
  }

  std::vector<double> numbers_;
  Point middle_;
  int to_unit_ = 0;  // times 2^this, the size is in [1, 2)
  std::vector<Ball> balls_;
  Box bounds_{{0, 0, 0}, {0, 0, 0}};
  bool is_empty_ = true;
};

}  // namespace

extern const ShapeKind blob_kind{
    "blob",
    "a soft solid: where the fields of balls, strength (1 - (d / radius)^2)^3 at a distance d from each center, add up "
    "to more than a threshold; strengths below 0 dent it",
    {{"threshold", false}, {"cx"}, {"cy"}, {"cz"}, {"radius", false}, {"strength"}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      if (!(a[0] > 0)) throw ArgumentError(0, "threshold must be positive, got 0");
      for (std::size_t i = 5; i < a.size(); i += 5)
        if (!(std::abs(a[i] / a[0]) < 1e150)) throw ArgumentError(i, "strength must not exceed 1e150 thresholds");
      return std::make_unique<Blob>(a);
    },
    {0.5, 0, -0.25, 0.5, 1.2, 1, 1.1, 0.25, 0.75, 1.2, 1, 0.5, 0.6, 1.2, 0.8, -0.4},
    5,
};

}  // namespace R3
