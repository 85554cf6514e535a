#include "R3/shapes/FormulaLanes.h"

#include <algorithm>
#include <numbers>

namespace R3 {
namespace {

using Operation = Expression::Operation;

constexpr double whole_turn = 2 * std::numbers::pi;

/// Sets each lane of `to` to the result of `made` for its number.
template <typename Made>
inline void Each(Lanes& to, const Made& made) {
  for (std::size_t i = 0; i < Lanes::count; ++i) to.at[i] = made(i);
}
template <typename Made>
inline void Each(IntervalLanes& to, const Made& made) {
  IntervalLanes all;  // separate from the operands, so that all lanes can be computed together
  for (std::size_t i = 0; i < Lanes::count; ++i) all.Set(i, made(i));
  to = all;
}

/// Equals R1::SinCos bit for bit. Large angles, and those so near to quarter turns that more digits of pi matter, are
/// delegated to it.
inline void SinCosEach(const Lanes& angles, Lanes& sine, Lanes& cosine) {
  namespace c = R1::coefficients;
  Lanes hard;
  for (std::size_t i = 0; i < Lanes::count; ++i) {
    const double x = angles.at[i];
    const R1::Nearest quarters(x * c::two_over_pi_rounded);
    const double n = quarters.Value();
    const DoubleDouble rest = ExactSum(x - n * c::half_pi_parts[0], -(n * c::half_pi_parts[1]));
    const DoubleDouble angle = QuickSum(rest.high, rest.low - n * c::half_pi_parts[2]);
    const R1::SineCosine turned = R1::Turned(R1::SinCosNearZero(angle.high, angle.low), quarters.Bits());
    sine.at[i] = turned.sine, cosine.at[i] = turned.cosine;
    const double is_far = std::abs(x) < 0x1p20 ? 0 : 1, is_near = std::abs(rest.high) > 0x1p-20 ? 0 : 1;
    hard.at[i] = is_far + (n == 0 ? 0 : is_near);
  }
  for (std::size_t i = 0; i < Lanes::count; ++i)
    if (hard.at[i] > 0) {
      const R1::SineCosine exact = R1::SinCos(angles.at[i]);
      sine.at[i] = exact.sine, cosine.at[i] = exact.cosine;
    }
}

/// Computes x^n in each lane, rounded as in R1::WholePower.
inline void WholePowerEach(const Lanes& base, std::uint32_t n, Lanes& power) {
  Lanes x = base;
  Each(power, [](std::size_t) { return 1.0; });
  for (; n != 0; n >>= 1) {
    if (n & 1) Each(power, [&](std::size_t i) { return power.at[i] * x.at[i]; });
    Each(x, [&](std::size_t i) { return x.at[i] * x.at[i]; });
  }
}

inline void WholePowerEach(const IntervalLanes& a, std::uint32_t n, IntervalLanes& to) {
  IntervalLanes base = a;
  if (n % 2 == 0)
    Each(base, [&](std::size_t i) -> Interval {
      const double low = a.low.at[i], high = a.high.at[i], most = std::max(-low, high);
      return {low >= 0 ? low : std::max(-high, 0.0), low >= 0 ? high : most};
    });
  IntervalLanes power;
  WholePowerEach(base.low, n, power.low);
  WholePowerEach(base.high, n, power.high);
  const double share = 4 * n * unit_roundoff;
  Each(to, [&](std::size_t i) {
    const double low = power.low.at[i], high = power.high.at[i];
    return NotNegative(n % 2 == 0, Outward(low - std::abs(low) * share, high + std::abs(high) * share));
  });
}

/// Sets each lane to 1 if its interval may contain one of start + k turns, otherwise to 0.
inline void MayHoldEach(const IntervalLanes& a, double start, Lanes& held) {
  Each(held, [&](std::size_t i) { return MayHold(a[i], start, whole_turn) ? 1.0 : 0.0; });
}

/// Bounds a function that oscillates between -1 and 1 from its values at the ends of intervals and whether it reaches
/// -1 and 1 between them.
inline void HullEach(const IntervalLanes& a, const Lanes& p, const Lanes& q, const Lanes& has_bottom,
                     const Lanes& has_top, IntervalLanes& hull) {
  Each(hull, [&](std::size_t i) -> Interval {
    const Interval ends = Outward(std::min(p.at[i], q.at[i]), std::max(p.at[i], q.at[i]), 2);
    const double length = a.high.at[i] - a.low.at[i];
    const double low = has_bottom.at[i] > 0 ? -1 : std::max(ends.low, -1.0),
                 high = has_top.at[i] > 0 ? 1 : std::min(ends.high, 1.0);
    return {length < whole_turn ? low : -1, length < whole_turn ? high : 1};
  });
}

/// Computes the sine and the cosine of intervals from those of the ends.
inline void SinCosEach(const IntervalLanes& a, IntervalLanes& sines, IntervalLanes& cosines) {
  constexpr double half = std::numbers::pi, quarter = std::numbers::pi / 2;
  Lanes sine[2], cosine[2], has_bottom, has_top;
  SinCosEach(a.low, sine[0], cosine[0]);
  SinCosEach(a.high, sine[1], cosine[1]);
  MayHoldEach(a, -quarter, has_bottom);
  MayHoldEach(a, quarter, has_top);
  HullEach(a, sine[0], sine[1], has_bottom, has_top, sines);
  MayHoldEach(a, half, has_bottom);
  MayHoldEach(a, 0, has_top);
  HullEach(a, cosine[0], cosine[1], has_bottom, has_top, cosines);
}

}  // namespace

template <typename Made>
inline void FormulaLanes::ForEachStep(const Made& made) {
  for (std::size_t i = 0; i < formula_.steps_.size(); ++i) made(formula_.steps_[i], cells_[i]);
}

inline void FormulaLanes::Value(const Step& step, const IntervalLanes& t, Cell& cell) const {
  const IntervalLanes &a = cells_[step.a].value, &b = cells_[step.b].value;
  IntervalLanes& value = cell.value;
  switch (step.operation) {
    case Operation::x:
      return Each(value, [&](std::size_t i) { return Interval(ray_.origin.x) + Interval(ray_.direction.x) * t[i]; });
    case Operation::y:
      return Each(value, [&](std::size_t i) { return Interval(ray_.origin.y) + Interval(ray_.direction.y) * t[i]; });
    case Operation::z:
      return Each(value, [&](std::size_t i) { return Interval(ray_.origin.z) + Interval(ray_.direction.z) * t[i]; });
    case Operation::number:
      return Each(value, [&](std::size_t) { return Interval(step.number); });
    case Operation::negate:
      return Each(value, [&](std::size_t i) { return -a[i]; });
    case Operation::add:
      return Each(value, [&](std::size_t i) { return a[i] + b[i]; });
    case Operation::subtract:
      return Each(value, [&](std::size_t i) { return a[i] - b[i]; });
    case Operation::multiply:
      return Each(value, [&](std::size_t i) { return a[i] * b[i]; });
    case Operation::divide:
      return Each(value, [&](std::size_t i) { return a[i] / b[i]; });
    case Operation::power:
      return WholePowerEach(a, static_cast<std::uint32_t>(step.number), value);
    case Operation::sin:
      if (!step.HasTwin()) return SinCosEach(a, value, cell.cofunction);
      value = cells_[step.b].cofunction, cell.cofunction = b;
      return;
    case Operation::cos:
      if (!step.HasTwin()) return SinCosEach(a, cell.cofunction, value);
      value = cells_[step.b].cofunction, cell.cofunction = b;
      return;
    case Operation::exp:
      return Each(value, [&](std::size_t i) { return Exp(a[i]); });
    case Operation::log:
      return Each(value, [&](std::size_t i) { return Log(a[i]); });
    case Operation::sqrt:
      return Each(value, [&](std::size_t i) {
        const Interval root = Sqrt(Interval(std::max(a[i].low, 0.0), a[i].high));
        return Choice(a[i].low >= 0, root, Interval::Whole());
      });
    case Operation::abs:
      return Each(value, [&](std::size_t i) -> Interval {
        return {std::max(std::max(a[i].low, -a[i].high), 0.0), std::max(-a[i].low, a[i].high)};
      });
    case Operation::min:
      return Each(value, [&](std::size_t i) -> Interval {
        return {std::min(a[i].low, b[i].low), std::min(a[i].high, b[i].high)};
      });
    case Operation::max:
      return Each(value, [&](std::size_t i) -> Interval {
        return {std::max(a[i].low, b[i].low), std::max(a[i].high, b[i].high)};
      });
  }
}

inline void FormulaLanes::Slope(const Step& step, Cell& cell) const {
  const Cell &a = cells_[step.a], &b = cells_[step.b];
  const IntervalLanes &as = a.slope, &bs = b.slope;
  IntervalLanes& slope = cell.slope;
  const auto all = [&](double number) { Each(slope, [&](std::size_t) { return Interval(number); }); };
  switch (step.operation) {
    case Operation::x:
      return all(ray_.direction.x);
    case Operation::y:
      return all(ray_.direction.y);
    case Operation::z:
      return all(ray_.direction.z);
    case Operation::number:
      return all(0);
    case Operation::negate:
      return Each(slope, [&](std::size_t i) { return -as[i]; });
    case Operation::add:
      return Each(slope, [&](std::size_t i) { return as[i] + bs[i]; });
    case Operation::subtract:
      return Each(slope, [&](std::size_t i) { return as[i] - bs[i]; });
    case Operation::multiply:
      if (formula_.steps_[step.a].operation == Operation::number)
        return Each(slope, [&](std::size_t i) { return a.value[i] * bs[i]; });
      return Each(slope, [&](std::size_t i) { return as[i] * b.value[i] + a.value[i] * bs[i]; });
    case Operation::divide:
      return Each(slope, [&](std::size_t i) { return (as[i] - cell.value[i] * bs[i]) / b.value[i]; });
    case Operation::power: {
      const auto n = static_cast<std::uint32_t>(step.number);
      IntervalLanes below;
      WholePowerEach(a.value, n - 1, below);
      return Each(slope, [&](std::size_t i) { return Interval(n) * below[i] * as[i]; });
    }
    case Operation::sin:
      return Each(slope, [&](std::size_t i) { return cell.cofunction[i] * as[i]; });
    case Operation::cos:
      return Each(slope, [&](std::size_t i) { return -(cell.cofunction[i] * as[i]); });
    case Operation::exp:
      return Each(slope, [&](std::size_t i) { return cell.value[i] * as[i]; });
    case Operation::log:
      return Each(slope, [&](std::size_t i) { return as[i] / a.value[i]; });
    case Operation::sqrt:
      return Each(slope, [&](std::size_t i) {
        return Choice(a.value[i].low >= 0, as[i] / (Interval(2) * cell.value[i]), Interval::Whole());
      });
    case Operation::abs:
      return Each(slope, [&](std::size_t i) {
        return Choice(a.value[i].low > 0, as[i], Choice(a.value[i].high < 0, -as[i], Hull(as[i], -as[i])));
      });
    case Operation::min:
      return Each(slope, [&](std::size_t i) {
        return Choice(a.value[i].high < b.value[i].low, as[i],
                      Choice(b.value[i].high < a.value[i].low, bs[i], Hull(as[i], bs[i])));
      });
    case Operation::max:
      return Each(slope, [&](std::size_t i) {
        return Choice(a.value[i].high < b.value[i].low, bs[i],
                      Choice(b.value[i].high < a.value[i].low, as[i], Hull(as[i], bs[i])));
      });
  }
}

inline void FormulaLanes::Number(const Step& step, const Lanes& t, Cell& cell) const {
  const Lanes &a = cells_[step.a].number, &b = cells_[step.b].number;
  Lanes& number = cell.number;
  switch (step.operation) {
    case Operation::x:
      return Each(number, [&](std::size_t i) { return ray_.origin.x + t.at[i] * ray_.direction.x; });
    case Operation::y:
      return Each(number, [&](std::size_t i) { return ray_.origin.y + t.at[i] * ray_.direction.y; });
    case Operation::z:
      return Each(number, [&](std::size_t i) { return ray_.origin.z + t.at[i] * ray_.direction.z; });
    case Operation::number:
      return Each(number, [&](std::size_t) { return step.number; });
    case Operation::negate:
      return Each(number, [&](std::size_t i) { return -a.at[i]; });
    case Operation::add:
      return Each(number, [&](std::size_t i) { return a.at[i] + b.at[i]; });
    case Operation::subtract:
      return Each(number, [&](std::size_t i) { return a.at[i] - b.at[i]; });
    case Operation::multiply:
      return Each(number, [&](std::size_t i) { return a.at[i] * b.at[i]; });
    case Operation::divide:
      return Each(number, [&](std::size_t i) { return a.at[i] / b.at[i]; });
    case Operation::power:
      return WholePowerEach(a, static_cast<std::uint32_t>(step.number), number);
    case Operation::sin:
      if (!step.HasTwin()) return SinCosEach(a, number, cell.number_of_cofunction);
      number = cells_[step.b].number_of_cofunction;
      return;
    case Operation::cos:
      if (!step.HasTwin()) return SinCosEach(a, cell.number_of_cofunction, number);
      number = cells_[step.b].number_of_cofunction;
      return;
    case Operation::exp:
      return Each(number, [&](std::size_t i) { return R1::Exp(a.at[i]); });
    case Operation::log:
      return Each(number, [&](std::size_t i) { return R1::Log(a.at[i]); });
    case Operation::sqrt:
      return Each(number, [&](std::size_t i) { return std::sqrt(a.at[i]); });
    case Operation::abs:
      return Each(number, [&](std::size_t i) { return std::abs(a.at[i]); });
    case Operation::min:
      return Each(number, [&](std::size_t i) { return std::min(a.at[i], b.at[i]); });
    case Operation::max:
      return Each(number, [&](std::size_t i) { return -std::min(-a.at[i], -b.at[i]); });
  }
}

R3_VECTORIZED
const Lanes& FormulaLanes::At(const Lanes& t) {
  ForEachStep([&](const Step& step, Cell& cell) { Number(step, t, cell); });
  return cells_[formula_.result_].number;
}

R3_VECTORIZED
const IntervalLanes& FormulaLanes::In(const IntervalLanes& t) {
  ForEachStep([&](const Step& step, Cell& cell) { Value(step, t, cell); });
  return cells_[formula_.result_].value;
}

R3_VECTORIZED
const IntervalLanes& FormulaLanes::Slopes() {
  ForEachStep([&](const Step& step, Cell& cell) { Slope(step, cell); });
  return cells_[formula_.result_].slope;
}

}  // namespace R3
