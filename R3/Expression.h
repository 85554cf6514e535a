#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "R3/Interval.h"

namespace R3 {

/// What is wrong with a formula, and with which of its characters.
struct ExpressionError : std::runtime_error {
  ExpressionError(std::size_t first, std::size_t count, const std::string& message, std::string what_to_do = {})
      : std::runtime_error(message), at(first), length(count), hint(std::move(what_to_do)) {}
  std::size_t at, length;
  std::string hint;
};

/// A number and how fast it changes along some direction.
template <typename Number>
struct Slope {
  Number value{}, slope{};

  Slope() = default;
  Slope(double constant) : value(constant) {}  // that does not change
  Slope(const Number& v, const Number& s) : value(v), slope(s) {}
};

/// Returns the number that $name stands for in a formula. If there is none, throws std::runtime_error with the reason.
using ValueOfName = std::function<double(std::string_view name)>;

/// Returns the value of a formula without x, y and z, in which $name stands for a number: "($day * 12 + 30)". The rest
/// is as in an Expression; each operation rounds to a double. Throws ExpressionError, also if the value is not finite.
double Evaluate(std::string_view formula, const ValueOfName& value_of);

/// A formula of x, y and z: + - * / ^ with whole exponents, sin cos tan exp log sqrt abs min max, pi. Two factors may
/// stand beside each other, as in 3 x.
class Expression {
 public:
  /// Throws ExpressionError.
  explicit Expression(std::string_view text);

  const std::string& Text() const { return text_; }

  /// The value at a place.
  ///   Number   double; Interval, then of all places within; or a Slope of one of them
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
  /// One operation on the results of earlier ones. No two are alike.
  struct Step {
    Operation operation;
    std::size_t a = 0, b = 0;
    double number = 0;  // or the exponent, 1 or more
    friend bool operator==(const Step&, const Step&) = default;

    /// Whether step b, of a sine, is the cosine of the same or the other way around; else, of what has one operand, b
    /// is a.
    bool HasTwin() const { return a != b; }
  };

  std::string text_;
  std::vector<Step> steps_;
  std::size_t result_ = 0;  // the step whose result is the formula's
};

}  // namespace R3
