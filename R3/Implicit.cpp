#include "R3/Implicit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "R3/shapes/PlanarUv.h"
#include "R3/shapes/Span.h"

namespace R3 {
namespace {

/// A formula along the line of a ray.
class FormulaOnLine {
 public:
  FormulaOnLine(const Expression& formula, const Ray& ray) : formula_(formula), ray_(ray) {}

  /// Whether the place is inside; where the formula is not defined it is not.
  bool IsInside(double t) {
    const Point p = ray_.At(t);
    return formula_.At(p.x, p.y, p.z, numbers_) < 0;
  }

  /// The first change between inside and outside after t_min. Which changes there are does not depend on t_min.
  std::optional<double> FirstChange(double low, double high, double t_min) {
    shortest_ = 64 * unit_roundoff * std::max(std::abs(low), std::abs(high));
    std::vector<Stretch> waiting{{low, high, IsInside(low), IsInside(high), most_halvings, State::undecided}};
    waiting[0].state = StateOf(waiting[0]);
    while (!waiting.empty()) {
      const Stretch stretch = waiting.back();
      waiting.pop_back();
      if (!(stretch.high > t_min) || stretch.state == State::unchanged) continue;
      const bool is_short = stretch.high - stretch.low <= shortest_ || stretch.halvings == 0;
      if (stretch.state == State::undecided && !is_short) {
        Halve(stretch, waiting);
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
    int halvings;  // that may still be spent on it
    State state;
  };

  // A ray that lies in the surface would be halved without end. A stretch shares what it has among the halves that need
  // any, so that what is spent on one place does not depend on what is asked of others.
  static constexpr int most_halvings = 1 << 14;

  void Halve(const Stretch& s, std::vector<Stretch>& waiting) {
    const double middle = s.low + (s.high - s.low) / 2;
    const bool is_inside = IsInside(middle);
    Stretch first{s.low, middle, s.begins_inside, is_inside, 0, State::undecided};
    Stretch second{middle, s.high, is_inside, s.ends_inside, 0, State::undecided};
    first.state = StateOf(first), second.state = StateOf(second);
    const bool are_both = first.state == State::undecided && second.state == State::undecided;
    first.halvings = second.halvings = are_both ? (s.halvings - 1) / 2 : s.halvings - 1;
    waiting.push_back(second);
    waiting.push_back(first);
  }

  /// What intervals say of the formula from `low` to `high`. Around the middle, the slope anywhere says how far its
  /// value may change, which for short stretches is much less than evaluating the formula on all of it.
  State StateOf(const Stretch& s) {
    const Interval all{s.low, s.high};
    const auto place = [&](int axis) { return Interval(ray_.origin[axis]) + Interval(ray_.direction[axis]) * all; };
    const Interval x = place(0), y = place(1), z = place(2);
    // Most stretches are far from the surface, and slopes take three times as long.
    if (!formula_.At(x, y, z, intervals_).Holds(0)) return State::unchanged;
    const auto f = formula_.At(Slope<Interval>(x, ray_.direction.x), Slope<Interval>(y, ray_.direction.y),
                               Slope<Interval>(z, ray_.direction.z), slopes_);
    if (!f.slope.Holds(0) && f.slope.low > -infinity && f.slope.high < infinity) return State::monotonic;
    const double middle = s.low + (s.high - s.low) / 2;
    const auto at = [&](double o, double d) { return Interval(o) + Interval(d) * Interval(middle); };
    const Interval m = formula_.At(at(ray_.origin.x, ray_.direction.x), at(ray_.origin.y, ray_.direction.y),
                                   at(ray_.origin.z, ray_.direction.z), intervals_);
    return (m + f.slope * (all - Interval(middle))).Holds(0) ? State::undecided : State::unchanged;
  }

  /// Newton's method within a bracket, which is halved where a step leaves it or is not half of the last one.
  double ChangeIn(const Stretch& s) {
    double low = s.low, high = s.high, step = high - low, t = low + step / 2;
    for (;;) {
      const Point p = ray_.At(t);
      const auto f = formula_.At(Slope<double>(p.x, ray_.direction.x), Slope<double>(p.y, ray_.direction.y),
                                 Slope<double>(p.z, ray_.direction.z), tangents_);
      ((f.value < 0) == s.begins_inside ? low : high) = t;
      double next = t - f.value / f.slope;
      if (!(next > low && next < high && std::abs(next - t) < step / 2)) next = low + (high - low) / 2;
      step = std::abs(next - t);
      if (step <= 2 * unit_roundoff * std::abs(t)) return next;
      t = next;
    }
  }

  const Expression& formula_;
  const Ray& ray_;
  double shortest_ = 0;
  std::vector<double> numbers_;
  std::vector<Interval> intervals_;
  std::vector<Slope<double>> tangents_;
  std::vector<Slope<Interval>> slopes_;
};

}  // namespace

bool Implicit::IsDegenerate() const {
  const Vector size = box_.Size();
  return !(size.x > 0 && size.y > 0 && size.z > 0);
}

std::optional<Hit> Implicit::Intersect(const Ray& ray, int) const {
  if (IsDegenerate() || !IsFinite(FromOrigin(ray.origin)) || !IsFinite(ray.direction)) return {};
  Span span;
  for (int axis = 0; axis < 3; ++axis)
    ClipToSlab(span, box_.low[axis], box_.high[axis], ray.origin[axis], ray.direction[axis], 2 * axis, 2 * axis + 1);
  if (!(span.enter < span.leave) || !std::isfinite(span.enter) || !std::isfinite(span.leave)) return {};
  if (span.leave <= ray.t_min || span.enter >= ray.t_max) return {};
  FormulaOnLine formula(formula_, ray);
  const auto before_end = [&](double t, int part) {
    return t < ray.t_max ? std::optional(Hit{.t = t, .part = part}) : std::nullopt;
  };
  if (span.enter > ray.t_min && formula.IsInside(span.enter)) return before_end(span.enter, span.enter_part);
  if (const auto t = formula.FirstChange(span.enter, span.leave, ray.t_min)) return before_end(*t, surface);
  if (formula.IsInside(span.leave)) return before_end(span.leave, span.leave_part);
  return {};
}

Intersection Implicit::At(const Ray& ray, const Hit& hit, int) const {
  const Point p = ray.At(hit.t);
  Intersection at = hit.part == surface ? OnSurface(p) : OnFace(p, hit.part);
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

/// The formula's value at the rounded place, as far as intervals know it, over its slope there is how far the surface
/// may be off; a cube as large on all axes holds it.
Intersection Implicit::OnSurface(const Point& p) const {
  std::vector<Slope<double>> values;
  const auto slope_along = [&](double x, double y, double z) {
    return formula_.At(Slope<double>(p.x, x), Slope<double>(p.y, y), Slope<double>(p.z, z), values).slope;
  };
  const Vector gradient{slope_along(1, 0, 0), slope_along(0, 1, 0), slope_along(0, 0, 1)};
  const Vector unit = IsFinite(gradient) ? Unit(gradient) : Vector{};
  std::vector<Interval> bounds;
  const Interval value = formula_.At(Interval(p.x), Interval(p.y), Interval(p.z), bounds);
  const double off = std::max(std::abs(value.low), std::abs(value.high)) / Length(gradient);
  // Where the surface has no slope, or jumps, the last bits of the place are all that is known.
  const double largest = 0x1p-20 * MaxComponent(box_.Size()), error = off < largest ? off : 0;
  Intersection at;
  at.position = p;
  at.error = Vector{error, error, error} + Gamma(4) * Abs(FromOrigin(p));
  at.normal = at.shading_normal = unit == Vector{} ? Normal{0, 1, 0} : AsNormal(unit);
  return at;
}

std::optional<Recipe> Implicit::MadeFrom() const {
  return Recipe{
      "implicit", {box_.low.x, box_.low.y, box_.low.z, box_.high.x, box_.high.y, box_.high.z}, formula_.Text()};
}

}  // namespace R3
