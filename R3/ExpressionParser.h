#pragma once

#include "R3/Expression.h"

namespace R3 {

/// A parser that turns the text of an expression into steps, with one function per level of precedence.
///
///     sum     = product { (+ | -) product }
///     product = factor { [* | /] factor }
///     factor  = (- | +) factor | power
///     power   = primary [ ^ [-] whole number ]
///     primary = number | x | y | z | pi | function ( sum [, sum] ) | ( sum )
///
/// A formula that is evaluated once has $name in place of x, y and z.
class ExpressionParser {
 public:
  /// Parses into `expression`; `value_of` is null for a formula of x, y and z.
  explicit ExpressionParser(Expression& expression, const ValueOfName* value_of = nullptr)
      : expression_(expression), text_(expression.text_), value_of_(value_of) {}

  /// Parses the whole text; throws ExpressionError.
  void Parse();

 private:
  using Operation = Expression::Operation;

  std::size_t Sum();
  std::size_t Product();
  std::size_t Divisor();
  std::size_t Factor();
  std::size_t Power();
  std::size_t Primary();
  std::size_t Number();
  std::size_t Name();
  std::size_t NamedValue();
  std::size_t Call(std::string_view name, std::size_t start);
  int Exponent();

  std::size_t WholePower(std::size_t base, int n);
  std::size_t Add(Operation operation, std::size_t a = 0, std::size_t b = 0, double number = 0);
  /// Returns the index of an equal step, or adds it.
  std::size_t Known(Expression::Step step);
  void SkipBlanks();
  /// Returns the next character that is not blank, without consuming it; 0 at the end of the text.
  char Next();
  bool Takes(char c);
  void Expect(char c);
  [[noreturn]] void Refuse();

  Expression& expression_;
  const std::string& text_;
  const ValueOfName* value_of_;
  std::size_t at_ = 0, operations_ = 0;
  int depth_ = 0;
};

}  // namespace R3
