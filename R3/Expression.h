#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "R3/Interval.h"

namespace R3 {

/// An error in a formula, and the range of characters that it concerns.
struct ExpressionError : std::runtime_error {
  ExpressionError(std::size_t first, std::size_t count, const std::string& message, std::string what_to_do = {})
      : std::runtime_error(message), at(first), length(count), hint(std::move(what_to_do)) {}
  std::size_t at, length;
  std::string hint;
};

/// A number and its rate of change along some direction.
template <typename Number>
struct Slope {
  Number value{}, slope{};

  Slope() = default;
  Slope(double constant) : value(constant) {}  // a constant has slope 0
  Slope(const Number& v, const Number& s) : value(v), slope(s) {}
};

/// A function that returns the number that $name stands for in a formula, or throws std::runtime_error with the reason.
using ValueOfName = std::function<double(std::string_view name)>;

/// Returns the value of a formula without x, y and z, in which $name stands for a number: "($day * 12 + 30)". The rest
/// is as in an Expression; each operation rounds to a double. Throws ExpressionError, also if the value is not finite.
double Evaluate(std::string_view formula, const ValueOfName& value_of);

/// A formula of x, y and z: + - * / ^ with whole exponents, sin cos tan exp log sqrt abs min max, pi. A product may be
/// written without a sign, as in 3 x.
class Expression {
 public:
  /// Parses a formula; throws ExpressionError.
  explicit Expression(std::string_view text);

  const std::string& Text() const { return text_; }

  /// Evaluates the formula at a point.
  ///   Number   double; Interval, for all points within; or a Slope of one of them
  ///   values   for all steps; kept between calls so that it is allocated once
  template <typename Number>
  Number At(const Number& x, const Number& y, const Number& z, std::vector<Number>& values) const;

  enum class Operation {
    x,
    y,
    z,
    number,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    sin,
    cos,
    exp,
    log,
    sqrt,
    abs,
    min,
    max
  };

 private:
  Expression(std::string_view text, const ValueOfName& value_of);

  friend double Evaluate(std::string_view formula, const ValueOfName& value_of);
  friend class ExpressionParser;
  friend class FormulaLanes;
  /// One operation on the results of earlier ones. No two steps are equal.
  struct Step {
    Operation operation;
    std::size_t a = 0, b = 0;
    double number = 0;  // or the exponent, 1 or more
    friend bool operator==(const Step&, const Step&) = default;

    /// Returns true if step b is the cosine of the sine a or the other way around. Other steps with one operand have b
    /// = a.
    bool HasTwin() const { return a != b; }
  };

  std::string text_;
  std::vector<Step> steps_;
  std::size_t result_ = 0;  // the step that computes the formula
};

}  // namespace R3
