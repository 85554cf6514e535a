#pragma once

#include <cstddef>
#include <memory>

#include "R3/Expression.h"
#include "R3/Ray.h"

namespace R3 {

/// Numbers that are worked on together, so many that loops over them become vector instructions.
struct Lanes {
  static constexpr std::size_t count = 8;
  alignas(64) double at[count];
};

/// Intervals, their ends each an array.
struct IntervalLanes {
  Lanes low, high;

  Interval operator[](std::size_t i) const { return {low.at[i], high.at[i]}; }
  void Set(std::size_t i, const Interval& interval) { low.at[i] = interval.low, high.at[i] = interval.high; }
};

/// A formula at eight places of the line of a ray, or in eight stretches of it, at once. What a lane gives is what
/// Expression::At gives of a place, bit for bit, or bounds as those that it gives of a stretch. With eight calls of
/// Expression::At instead, images of implicit surfaces take 3 to 4.5 times as long: scenes/implicit.scn 1.5 s instead
/// of 0.41 s at 256 x 256 pixels on one core of an AMD EPYC with AVX-512.
class FormulaLanes {
 public:
  /// `formula` and `ray` outlive this.
  FormulaLanes(const Expression& formula, const Ray& ray)
      : formula_(formula), ray_(ray), cells_(std::make_unique_for_overwrite<Cell[]>(formula.steps_.size())) {}

  /// The values at parameters of the ray.
  const Lanes& At(const Lanes& t);
  /// Bounds on the values.
  const IntervalLanes& In(const IntervalLanes& t);
  /// Bounds on how fast the values change with t, where In was last asked for.
  const IntervalLanes& Slopes();

 private:
  /// What a step of the formula comes to.
  struct Cell {
    IntervalLanes value, slope;
    IntervalLanes cofunction;  // the cosine of what this is the sine of, and the other way around
    Lanes number, number_of_cofunction;
  };
  using Step = Expression::Step;

  template <typename Made>
  void ForEachStep(const Made& made);
  void Number(const Step& step, const Lanes& t, Cell& cell) const;
  void Value(const Step& step, const IntervalLanes& t, Cell& cell) const;
  void Slope(const Step& step, Cell& cell) const;

  const Expression& formula_;
  const Ray& ray_;
  std::unique_ptr<Cell[]> cells_;
};

}  // namespace R3
