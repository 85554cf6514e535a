#include "R3/Implicit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "R3/SearchLimit.h"
#include "R3/Warp.h"
#include "R3/shapes/FormulaLanes.h"
#include "R3/shapes/PlanarUv.h"
#include "R3/shapes/Span.h"

namespace R3 {
namespace {

/// Returns true if the bounds of a formula put a whole stretch inside or outside. NaN bounds decide nothing.
bool Decides(const Interval& value) { return value.low > 0 || value.high <= 0; }

/// A test that decides which points of a ray are inside: those where the formula is below 0, and those where it is 0
/// next to another point inside. If a formula only touches 0, as (f)^2 does, there is no surface, regardless of
/// rounding. Points where it is undefined are outside.
class InsideTest {
 public:
  /// Prepares the test; the ray meets the box at `enter` and `leave`.
  InsideTest(const Expression& formula, const Ray& ray, double enter, double leave)
      : formula_(formula),
        ray_(ray),
        enter_(enter),
        leave_(leave),
        shortest_(64 * unit_roundoff * std::max(std::abs(enter), std::abs(leave))) {}

  bool operator()(double t) { return Of(t, ValueAt(t)); }
  /// Decides for a point whose value is known.
  bool Of(double t, double value) { return value < 0 || (value == 0 && IsBesideInside(t)); }
  /// Returns the distance in t below which rounding makes points indistinguishable.
  double Shortest() const { return shortest_; }

 private:
  double ValueAt(double t) {
    const Point p = ray_.At(t);
    return formula_.At(p.x, p.y, p.z, values_);
  }
  bool IsBesideInside(double t) {
    const double before = t - shortest_, after = t + shortest_;
    return (before >= enter_ && ValueAt(before) <= 0) || (after <= leave_ && ValueAt(after) <= 0);
  }

  const Expression& formula_;
  const Ray& ray_;
  double enter_, leave_, shortest_;
  std::vector<double> values_;
};

/// A formula along the line of a ray.
class FormulaOnLine {
 public:
  FormulaOnLine(const Expression& formula, const Ray& ray, InsideTest& is_inside, double low, double high)
      : is_inside_(is_inside), lanes_(formula, ray), shortest_(is_inside.Shortest()) {
    waiting_.push_back({low, high, is_inside_(low), is_inside_(high), most_divisions, State::undecided});
  }

  /// Returns the next change between inside and outside after t_min, which must increase from one call to the next. The
  /// set of changes does not depend on t_min.
  std::optional<double> NextChange(double t_min) {
    while (!waiting_.empty()) {
      if (SearchLimit::EndsSearches()) return {};
      const Stretch stretch = waiting_.back();
      waiting_.pop_back();
      if (!(stretch.high > t_min) || stretch.state == State::unchanged) continue;
      const bool is_short = stretch.high - stretch.low <= shortest_ || stretch.divisions == 0;
      if (stretch.state == State::undecided && !is_short) {
        Divide(stretch);
      } else if (stretch.begins_inside != stretch.ends_inside) {
        const double t = ChangeIn(stretch);
        if (t > t_min) return t;
      }
    }
    return {};
  }

 private:
  enum class State { unchanged, monotonic, undecided };

  struct Stretch {
    double low, high;
    bool begins_inside, ends_inside;
    int divisions;  // remaining budget for this stretch
    State state;
  };
  static constexpr std::size_t parts = Lanes::count;

  // Limits the divisions of a ray, since one that lies in the surface would be divided forever. A stretch shares its
  // budget among the parts that need it, so that the budget of one place does not depend on queries about others. This
  // is enough for five divisions of everything.
  static constexpr int most_divisions = 1 + 8 + 64 + 512 + 4096;

  void Divide(const Stretch& s) {
    // Divides in two if the parts would be shorter than rounding.
    const std::size_t count = s.high - s.low > parts * shortest_ / 2 ? parts : 2;
    const double width = (s.high - s.low) / static_cast<double>(count);
    Lanes ends;
    for (std::size_t i = 0; i < parts; ++i)
      ends.at[i] = i + 1 < count ? s.low + static_cast<double>(i + 1) * width : s.high;
    std::array<bool, parts> is_inside{};
    TestInside(ends, count, is_inside);
    is_inside[count - 1] = s.ends_inside;
    std::array<State, parts> states{};
    ComputeStates(s.low, ends, states);
    const auto undecided =
        std::count(states.begin(), states.begin() + static_cast<std::ptrdiff_t>(count), State::undecided);
    const int divisions = undecided > 0 ? (s.divisions - 1) / static_cast<int>(undecided) : 0;
    for (std::size_t i = count; i-- > 0;)
      if (states[i] != State::unchanged)
        waiting_.push_back({i > 0 ? ends.at[i - 1] : s.low, ends.at[i], i > 0 ? is_inside[i - 1] : s.begins_inside,
                            is_inside[i], divisions, states[i]});
  }

  void TestInside(const Lanes& t, std::size_t count, std::array<bool, parts>& is_inside) {
    if (count == 2) {
      is_inside[0] = is_inside_(t.at[0]);
      return;
    }
    const Lanes& values = lanes_.At(t);
    for (std::size_t i = 0; i < parts; ++i) is_inside[i] = is_inside_.Of(t.at[i], values.at[i]);
  }

  /// Computes the interval bounds of the formula from each end to the next, the first starting at `low`. Around the
  /// middle, the bound of the slope limits the change of the value, which is much narrower on short stretches than
  /// evaluating the formula on all of it.
  void ComputeStates(double low, const Lanes& ends, std::array<State, parts>& states) {
    IntervalLanes t;
    for (std::size_t i = 0; i < parts; ++i) t.Set(i, {i > 0 ? ends.at[i - 1] : low, ends.at[i]});
    const IntervalLanes& values = lanes_.In(t);
    bool all_decided = true;
    for (std::size_t i = 0; i < parts; ++i) {
      states[i] = Decides(values[i]) ? State::unchanged : State::undecided;
      all_decided &= states[i] != State::undecided;
    }
    if (all_decided) return;  // most stretches are far from the surface
    const IntervalLanes slopes = lanes_.Slopes();
    all_decided = true;
    for (std::size_t i = 0; i < parts; ++i) {
      const Interval slope = slopes[i];
      if (states[i] == State::undecided && !slope.Holds(0) && slope.low > -infinity && slope.high < infinity)
        states[i] = State::monotonic;
      all_decided &= states[i] != State::undecided;
    }
    if (all_decided) return;
    IntervalLanes middles;
    for (std::size_t i = 0; i < parts; ++i) middles.Set(i, t[i].low + (t[i].high - t[i].low) / 2);
    const IntervalLanes& at_middles = lanes_.In(middles);
    for (std::size_t i = 0; i < parts; ++i)
      if (states[i] == State::undecided && Decides(at_middles[i] + slopes[i] * (t[i] - middles[i])))
        states[i] = State::unchanged;
  }

  /// Finds a point where the formula changes by narrowing brackets with eight values at a time: evenly at first, then
  /// ever closer to the root expected by interpolation. This needs no slopes and ends after four or five steps. A root
  /// at 0, where doubles are ever denser, would take hundreds of steps; there the doubles in between are divided, a
  /// ninth of which remains each time, so that neighboring doubles are found within 21 more steps.
  double ChangeIn(const Stretch& s) {
    constexpr int usual_steps = 64;
    double low = s.low, high = s.high;
    Lanes t;
    SpreadEvenly(low, high, t);
    for (int step = 0;; ++step) {
      const Lanes& f = lanes_.At(t);
      std::size_t k = 0;  // the first whose state differs from the start of the stretch
      while (k < parts && is_inside_.Of(t.at[k], f.at[k]) == s.begins_inside) ++k;
      const double width = high - low;
      if (k > 0) low = t.at[k - 1];
      if (k < parts) high = t.at[k];
      const double middle = low + (high - low) / 2, rounding = 2 * unit_roundoff * std::abs(middle);
      if (high - low <= 2 * rounding || middle == low || middle == high) return middle;
      const bool is_stuck = !(high - low < width / 2);
      const std::size_t first = std::clamp<std::size_t>(k, 2, parts - 1) - 2;
      if (step >= usual_steps)
        SpreadAmongDoubles(low, high, t);
      else if (is_stuck || !SpreadAround(Guess(t, f, first), low, high, t))
        SpreadEvenly(low, high, t);
    }
  }

  static void SpreadEvenly(double low, double high, Lanes& t) {
    const double width = high - low;
    for (std::size_t i = 0; i < parts; ++i) t.at[i] = low + width * (static_cast<double>(i + 1) / (parts + 1));
  }

  static void SpreadAmongDoubles(double low, double high, Lanes& t) {
    for (std::size_t i = 0; i < parts; ++i) t.at[i] = AmongDoubles(low, high, static_cast<double>(i + 1) / (parts + 1));
  }

  struct Root {
    double t, error;
  };
  /// Estimates a root and its uncertainty from three points and their values, by linear and quadratic inverse
  /// interpolation.
  ///   source   Brent, Algorithms for Minimization without Derivatives (1973), chapter 4
  static Root Guess(const Lanes& t, const Lanes& f, std::size_t i) {
    const double a = t.at[i], b = t.at[i + 1], c = t.at[i + 2], fa = f.at[i], fb = f.at[i + 1], fc = f.at[i + 2];
    const double ab = (b - a) / (fb - fa), bc = (c - b) / (fc - fb);
    const double linear = b - fb * bc, correction = fb * fc * (bc - ab) / (fc - fa);
    return {linear + correction, std::abs(correction) / 8};
  }

  /// Places points on both sides of a root, each farther from it by the same factor.
  ///   returns   false if the root is not between the ends, or is 0 and known too well for factors
  static bool SpreadAround(const Root& root, double low, double high, Lanes& t) {
    if (!(root.t > low && root.t < high)) return false;
    const double nearest = std::max(root.error, 1.5 * unit_roundoff * std::abs(root.t));
    if (!(nearest > 0)) return false;
    const auto factor = [&](double reach) { return std::sqrt(std::sqrt(std::max(reach / nearest, 1.0))); };
    const double below = factor(root.t - low), above = factor(high - root.t);
    double down = nearest, up = nearest;
    for (std::size_t i = 0; i < parts / 2; ++i, down *= below, up *= above) {
      t.at[parts / 2 - 1 - i] = std::max(root.t - down, low);
      t.at[parts / 2 + i] = std::min(root.t + up, high);
    }
    return true;
  }

  InsideTest& is_inside_;
  FormulaLanes lanes_;
  double shortest_;
  std::vector<Stretch> waiting_;  // the nearest one last
};

/// Returns the direction of a gradient; 0 0 0 if it has none.
Vector UnitOrZero(const Vector& gradient) { return IsFinite(gradient) ? Unit(gradient) : Vector{}; }

}  // namespace

bool Implicit::IsDegenerate() const {
  const Vector size = box_.Size();
  return !(size.x > 0 && size.y > 0 && size.z > 0);
}

/// Passes the crossings of a ray to `take` in order until it declines one.
template <typename Take>
void Implicit::OfferCrossings(const Ray& ray, const Take& take) const {
  if (IsDegenerate() || !IsFinite(FromOrigin(ray.origin)) || !IsFinite(ray.direction)) return;
  Span span;
  for (int axis = 0; axis < 3; ++axis)
    ClipToSlab(span, box_.low[axis], box_.high[axis], ray.origin[axis], ray.direction[axis], 2 * axis, 2 * axis + 1);
  if (!(span.enter < span.leave) || !std::isfinite(span.enter) || !std::isfinite(span.leave)) return;
  if (span.leave <= ray.t_min || span.enter >= ray.t_max) return;
  InsideTest is_inside(formula_, ray, span.enter, span.leave);
  double last = ray.t_min;
  const auto is_taken = [&](double t, int part) { return t < ray.t_max && take(Hit{.t = last = t, .part = part}); };
  if (span.enter > last && is_inside(span.enter) && !is_taken(span.enter, span.enter_part)) return;
  FormulaOnLine formula(formula_, ray, is_inside, span.enter, span.leave);
  while (const auto t = formula.NextChange(last))
    if (!is_taken(*t, surface)) return;
  if (span.leave > last && is_inside(span.leave)) is_taken(span.leave, span.leave_part);
}

std::optional<Hit> Implicit::Intersect(const Ray& ray, int) const {
  std::optional<Hit> first;
  OfferCrossings(ray, [&](const Hit& hit) { return first = hit, false; });
  return first;
}

Crossings Implicit::CrossingsAlong(const Ray& ray, int) const {
  Crossings crossings;
  OfferCrossings(ray, [&](const Hit& hit) {
    crossings.may_have_more = crossings.count == Crossings::most;
    if (!crossings.may_have_more) crossings.Add(hit);
    return !crossings.may_have_more;
  });
  return crossings;
}

Intersection Implicit::At(const Ray& ray, const Hit& hit, int) const {
  const Point p = ray.At(hit.t);
  Intersection at = hit.part == surface ? OnSurface(p, ray.direction) : OnFace(p, hit.part);
  SetPlanarUv(at, box_);
  return at;
}

UvTangents Implicit::UvTangentsAt(const Ray& ray, const Hit& hit, int element) const {
  return PlanarUvTangents(At(ray, hit, element).normal, box_);
}

Intersection Implicit::OnFace(const Point& p, int face) const {
  const int axis = face / 2;
  const double sign = face % 2 == 1 ? 1 : -1, plane = face % 2 == 1 ? box_.high[axis] : box_.low[axis];
  const auto coordinate = [&](int i) { return i == axis ? plane : std::clamp(p[i], box_.low[i], box_.high[i]); };
  const auto component = [&](int i) { return i == axis ? sign : 0; };
  Intersection at;
  at.position = {coordinate(0), coordinate(1), coordinate(2)};
  at.error = Gamma(2) * Abs(FromOrigin(at.position));
  at.normal = at.shading_normal = {component(0), component(1), component(2)};
  return at;
}

Vector Implicit::GradientAt(const Point& p) const {
  std::vector<Slope<double>> values;
  const auto slope_along = [&](double x, double y, double z) {
    return formula_.At(Slope<double>(p.x, x), Slope<double>(p.y, y), Slope<double>(p.z, z), values).slope;
  };
  return {slope_along(1, 0, 0), slope_along(0, 1, 0), slope_along(0, 0, 1)};
}

/// Searches ever farther before and behind the surface along the ray, starting at the accuracy of coordinates, until
/// there is a slope: for (f)^3, and for distances as roots of squares, it is that of the surface. If a formula jumps
/// between values without a slope, the surface is approximated by the plane through three of its points nearby.
Vector Implicit::DirectionNear(const Point& p, const Vector& way) const {
  constexpr double least = 4 * unit_roundoff, most = 0x1p-16;  // relative to the size of the box plus its distance
  const double reach = Reach(box_);
  const Vector unit = Unit(way);
  for (double step = least; step <= most; step *= 4)
    for (const double side : {-1.0, 1.0}) {
      const Vector direction = UnitOrZero(GradientAt(p + side * step * reach * unit));
      if (!(direction == Vector{})) return direction;
    }
  return AcrossJump(p, unit, most * reach);
}

Vector Implicit::AcrossJump(const Point& p, const Vector& way, double radius) const {
  std::vector<double> values;
  const auto is_inside = [&](const Point& at) { return formula_.At(at.x, at.y, at.z, values) <= 0; };
  Vector outward;  // from the neighbors that are inside to those that are not
  for (int i = 0; i < 27; ++i) {
    const Vector to{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
    outward = outward + (is_inside(p + radius * to) ? -1.0 : 1.0) * to;
  }
  const Vector rough = outward == Vector{} ? -way : Unit(outward);
  const Tangents across = TangentsOf(rough);
  // Bisects for the jump on a line along `rough` that passes next to p.
  const auto place_near = [&](const Vector& aside) {
    const Point start = p + radius * aside;
    double low = -2 * radius, high = 2 * radius;  // inside; outside
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (is_inside(start + middle * rough) ? low : high) = middle;
    }
    return start + low * rough;
  };
  const Point a = place_near(across.first), b = place_near(across.second), c = place_near(-across.first);
  const Vector normal = Unit(Cross(a - b, c - b));
  if (!(std::abs(Dot(normal, rough)) > 0.5)) return rough;  // not a plane
  return Dot(normal, rough) > 0 ? normal : -normal;
}

/// Makes the intersection. The value at the rounded point, bounded by intervals, divided by the slope there bounds the
/// distance from the surface; a cube of that size contains the error.
Intersection Implicit::OnSurface(const Point& p, const Vector& way) const {
  const Vector gradient = GradientAt(p), unit = UnitOrZero(gradient);
  std::vector<Interval> bounds;
  const Interval value = formula_.At(Interval(p.x), Interval(p.y), Interval(p.z), bounds);
  const double off = std::max(std::abs(value.low), std::abs(value.high)) / Length(gradient);
  // If the surface has no slope, or jumps, only the last bits of the point are uncertain.
  const double largest = 0x1p-20 * MaxComponent(box_.Size()), error = off < largest ? off : 0;
  Intersection at;
  at.position = p;
  at.error = Vector{error, error, error} + Gamma(4) * Abs(FromOrigin(p));
  at.normal = at.shading_normal = AsNormal(unit == Vector{} ? DirectionNear(p, way) : unit);
  return at;
}

std::optional<Recipe> Implicit::MadeFrom() const {
  return Recipe{
      "implicit", {box_.low.x, box_.low.y, box_.low.z, box_.high.x, box_.high.y, box_.high.z}, formula_.Text()};
}

}  // namespace R3
