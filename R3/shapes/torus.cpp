#include <array>
#include <numbers>
#include <utility>

#include "R1/DoubleDouble.h"
#include "R1/Elementary.h"
#include "R3/ShapeKind.h"
#include "R3/shapes/Revolution.h"

namespace R3 {
namespace {

// Polynomials are stored as their coefficients, the constant one first.

/// Positions on a line, ascending.
template <std::size_t most>
struct Places {
  std::array<double, most> at{};
  std::size_t count = 0;
};

template <typename Number, std::size_t size>
double Value(const std::array<Number, size>& c, double x) {
  Number sum = c[size - 1];
  for (std::size_t i = size - 1; i-- > 0;) sum = sum * Number(x) + c[i];
  return static_cast<double>(sum);
}

/// Returns the zero of a polynomial that is monotonic from `low` to `high` and has different signs there. Uses Newton's
/// method, bisecting the bracket if a step leaves it or is not half of the last one; after 64 steps, as for a root at
/// 0, it bisects the doubles in the bracket, so that 128 steps are enough.
template <typename Number, std::size_t size>
double RootBetween(const std::array<Number, size>& c, double low, double high, bool rises) {
  constexpr int most_steps = 128;
  double x = low + (high - low) / 2, step = high - low;
  for (int steps = 0; steps < most_steps; ++steps) {
    Number sum = c[size - 1];
    double slope = 0;
    for (std::size_t i = size - 1; i-- > 0;) {
      slope = slope * x + static_cast<double>(sum);
      sum = sum * Number(x) + c[i];
    }
    const double value = static_cast<double>(sum);
    if (value == 0) return x;
    ((value < 0) == rises ? low : high) = x;
    double next = x - value / slope;
    if (steps >= most_steps / 2)
      next = AmongDoubles(low, high, 0.5);
    else if (!(next > low && next < high && std::abs(next - x) < step / 2))
      next = low + (high - low) / 2;
    step = std::abs(next - x);
    if (step <= 2 * unit_roundoff * std::abs(x)) return next;
    x = next;
  }
  return x;
}

/// Returns the sign changes of the polynomial in [low, high]. It is monotonic between the roots of its derivative,
/// which are found in the same way in plain doubles: near a turn the value hardly changes. Where it only touches zero,
/// the sign of the rounded value at the turn decides.
template <typename Number, std::size_t size>
Places<size - 1> SignChanges(const std::array<Number, size>& c, double low, double high) {
  Places<size - 1> changes, ends;  // ends of the stretches between turns
  if constexpr (size > 2) {
    std::array<double, size - 1> derivative;
    for (std::size_t i = 0; i < size - 1; ++i)
      derivative[i] = static_cast<double>(i + 1) * static_cast<double>(c[i + 1]);
    const auto turns = SignChanges(derivative, low, high);
    std::copy_n(turns.at.begin(), turns.count, ends.at.begin());
    ends.count = turns.count;
  }
  ends.at[ends.count++] = high;
  bool is_negative = Value(c, low) < 0;
  for (std::size_t i = 0; i < ends.count; ++i) {
    const bool was_negative = std::exchange(is_negative, Value(c, ends.at[i]) < 0);
    if (is_negative != was_negative) changes.at[changes.count++] = RootBetween(c, low, ends.at[i], was_negative);
    low = ends.at[i];
  }
  return changes;
}

// A ring about a line parallel to y: a circle of radius `minor` whose center goes around one of radius `major` > minor.
class Torus : public Shape {
 public:
  Torus(const Point& center, double major, double minor)
      : center_(center),
        major_(major),
        minor_(minor),
        to_unit_(major + minor > 0 ? std::scalbn(1, -std::ilogb(major + minor)) : 1) {}

  Box Bounds(int) const override {
    const Vector reach{major_ + minor_, minor_, major_ + minor_};
    return {center_ - reach, center_ + reach};
  }

  Profile ProfileInBounds() const override { return Profile::Upright(); }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (!MayMeet(ray)) return {};
    for (const double t : PlacesAlong(ray).at)
      if (t > ray.t_min) return t < ray.t_max ? std::optional(Hit{t}) : std::nullopt;
    return {};
  }

  Crossings CrossingsAlong(const Ray& ray, int) const override {
    Crossings crossings;
    if (!MayMeet(ray)) return crossings;
    double after = ray.t_min;
    for (const double t : PlacesAlong(ray).at) {
      if (!(t > after)) continue;
      if (!(t < ray.t_max)) break;
      crossings.Add({t});
      after = t;
    }
    return crossings;
  }

  Intersection PlaceAt(const Ray& ray, const Hit& hit, int) const override {
    const auto [outward, from_tube] = DirectionsTo(ray.At(hit.t));
    return OnTube(outward, from_tube);
  }

  Intersection At(const Ray& ray, const Hit& hit, int) const override {
    const auto [outward, from_tube] = DirectionsTo(ray.At(hit.t));
    Intersection at = OnTube(outward, from_tube);
    at.uv = {TurnAboutY(outward), 0.5 + R1::Atan2(from_tube.y, from_tube.x) / (2 * std::numbers::pi)};
    return at;
  }

  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override {
    const auto [outward, from_tube] = DirectionsTo(ray.At(hit.t));
    const Vector along_tube{-from_tube.y * outward.x, from_tube.x, -from_tube.y * outward.z};
    return {AlongTurn(outward, major_ + minor_ * from_tube.x), 2 * std::numbers::pi * minor_ * along_tube};
  }

  bool CanBeSampled() const override { return !IsDegenerate(); }

  /// Samples a point; std::nullopt if it faces away from `from`, so that the tube itself hides it.
  std::optional<SurfaceSample> Sample(const Point& from, const R2::Point& u, int element) const override {
    const auto sample = Shape::Sample(from, u, element);
    if (!sample) return {};
    const bool shows_outside = Dot(sample->at.normal, from - sample->at.position) > 0;
    return shows_outside == IsInside(from) ? std::nullopt : sample;
  }

  double SampledArea(const Point&, int) const override {
    return 4 * std::numbers::pi * std::numbers::pi * major_ * minor_;
  }

  /// Samples points of the tube in proportion to their area: the outer one of two at the same height has more, since
  /// its radius about the axis is larger.
  Intersection DrawPlace(const Point&, const R2::Point& u, int) const override {
    const auto around_tube = R1::SinCosTurns(u.x);
    const double share = (1 + minor_ / major_ * around_tube.cosine) / 2;
    const bool is_first = u.y < share;
    const auto [sine, cosine] = R1::SinCosTurns(is_first ? u.y / share : (u.y - share) / (1 - share));
    const Vector from_tube = Unit({is_first ? around_tube.cosine : -around_tube.cosine, around_tube.sine, 0});
    return OnTube(Unit({sine, 0, -cosine}), from_tube);
  }

  bool IsDegenerate() const override { return !(minor_ > 0); }

  std::optional<Recipe> MadeFrom() const override {
    return Recipe{"torus", {center_.x, center_.y, center_.z, major_, minor_}};
  }

 private:
  /// Two unit directions at a point of the tube.
  struct Directions {
    Vector outward;    // away from the axis
    Vector from_tube;  // away from the circle within the tube, in the plane of the axis, with x across it
  };
  Directions DirectionsTo(const Point& place) const {
    const Vector p = place - center_;
    return {Unit({p.x, 0, p.z}), Unit({R1::Hypot(p.x, p.z) - major_, p.y, 0})};
  }

  /// Returns the intersection on the tube. `outward` from the axis and `from_tube`, in the plane of the axis with x
  /// across it, are unit.
  Intersection OnTube(const Vector& outward, const Vector& from_tube) const {
    const double radius = major_ + minor_ * from_tube.x;  // about the axis
    Intersection at;
    at.position = center_ + Vector{radius * outward.x, minor_ * from_tube.y, radius * outward.z};
    // Unit errs by 4 u, sums and products by one each.
    at.error = Gamma(8) * Vector{(radius + minor_) * std::abs(outward.x), minor_ * std::abs(from_tube.y),
                                 (radius + minor_) * std::abs(outward.z)} +
               Gamma(2) * Abs(FromOrigin(at.position));
    at.normal = AsNormal(Unit({from_tube.x * outward.x, from_tube.y, from_tube.x * outward.z}));
    at.shading_normal = at.normal;
    return at;
  }

  bool IsInside(const Point& point) const {
    const Vector p = point - center_;
    return R1::Hypot(R1::Hypot(p.x, p.z) - major_, p.y) < minor_;
  }

  bool MayMeet(const Ray& ray) const {
    return !IsDegenerate() && IsFinite(ray.direction) && IsFinite(FromOrigin(ray.origin));
  }

  static constexpr double pad = 0x1p-40;  // relative padding of the sphere and the planes around the ring

  /// Returns the s at which a line p + s v is within a sphere around the origin; empty, or with a NaN, if nowhere.
  ///   pp, pv, vv   p.p, p.v and v.v
  static Span InSphere(double radius, double pp, double pv, double vv) {
    const double beyond = pp - radius * radius, discriminant = pv * pv - vv * beyond;
    if (!(discriminant >= 0)) return {infinity, -infinity};
    const double half = std::sqrt(discriminant);
    Span span;
    span.Clip((-pv - half) / vv, (-pv + half) / vv, 0, 0);
    return span;
  }

  /// Returns all t at which the line crosses the surface, padded with infinity to four. With R and r the radii and p +
  /// s v the ray from the center, in units of about R + r, that is where
  ///     (|p + s v|^2 + R^2 - r^2)^2 - 4 R^2 (its part across the axis)^2 = 0.
  /// A ray from afar is first moved to its point nearest to the center. Moved, expanded and evaluated in double-words,
  /// the quartic errs by less than 2^-95, which is 2^-95 R / r in distance: negligible compared with the rounding of t,
  /// for any ring that is visible. Inside tests and near misses are therefore decided as by exact arithmetic. Own
  /// derivation; oracle: 113-bit arithmetic in tests/extremes/torus.cpp.
  R3_USES_FMA
  Places<4> PlacesAlong(const Ray& ray) const {
    Places<4> crossings;
    crossings.at.fill(infinity);
    const double R = to_unit_ * major_, r = to_unit_ * minor_, largest = MaxComponent(Abs(ray.direction));
    if (!(largest > 0)) return crossings;
    const double shorter = std::scalbn(1, -std::ilogb(largest));  // a power of two, as are all of the units
    const Vector v = shorter * ray.direction;
    const auto from_center = [&](double o, double c) {
      const DoubleDouble p = ExactSum(o, -c);
      return DoubleDouble{to_unit_ * p.high, to_unit_ * p.low};
    };
    DoubleDouble x = from_center(ray.origin.x, center_.x), y = from_center(ray.origin.y, center_.y),
                 z = from_center(ray.origin.z, center_.z);
    const Vector near{x.high, y.high, z.high};
    constexpr double far_away = 16;  // up to this distance, a start near the surface must keep its sign
    double start = 0;
    if (Length(near) > far_away) {
      start = -Dot(near, v) / Dot(v, v);
      x = x + ExactProduct(start, v.x);
      y = y + ExactProduct(start, v.y);
      z = z + ExactProduct(start, v.z);
    }

    const DoubleDouble across_vv = ExactProduct(v.x, v.x) + ExactProduct(v.z, v.z),
                       vv = across_vv + ExactProduct(v.y, v.y);
    const DoubleDouble across_pv = x * v.x + z * v.z, pv = across_pv + y * v.y;
    const DoubleDouble across_pp = x * x + z * z, pp = across_pp + y * y;

    Span inside = InSphere(R + r + pad, pp.high, pv.high, vv.high);
    ClipToSlab(inside, -r - pad, r + pad, y.high, v.y, 0, 0);
    if (!(inside.enter < inside.leave)) return crossings;

    const DoubleDouble k = pp + ExactSum(R, -r) * ExactSum(R, r), four_RR = 4.0 * ExactProduct(R, R);
    const std::array<DoubleDouble, 5> quartic{k * k - four_RR * across_pp, 4.0 * pv * k - 2.0 * four_RR * across_pv,
                                              4.0 * pv * pv + 2.0 * vv * k - four_RR * across_vv, 4.0 * pv * vv,
                                              vv * vv};
    const auto changes = SignChanges(quartic, inside.enter, inside.leave);
    for (std::size_t i = 0; i < changes.count; ++i) crossings.at[i] = (start + changes.at[i]) * shorter / to_unit_;
    crossings.count = changes.count;
    return crossings;
  }

  Point center_;
  double major_, minor_;
  double to_unit_;  // the power of two that brings major + minor into [1, 2)
};

}  // namespace

extern const ShapeKind torus_kind{
    "torus",
    "a ring about the y direction: center, radius of the ring, radius of its tube, which must be smaller",
    {{"cx"}, {"cy"}, {"cz"}, {"major", false}, {"minor", false}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      if (a[4] > 0 && !(a[4] < a[3])) throw ArgumentError(4, "minor must be smaller than major");
      return std::make_unique<Torus>(Point{a[0], a[1], a[2]}, a[3], a[4]);
    },
    {0.5, -0.25, 1, 1, 0.4},
};

}  // namespace R3
