#include "R3/ExpressionParser.h"

#include <array>
#include <charconv>

namespace R3 {
namespace {

// Nobody types a longer formula, and every ray would have to evaluate it.
constexpr std::size_t most_steps = 1000;
constexpr int deepest = 100;  // of brackets and signs, each of which is a recursive call
constexpr int largest_exponent = 64;

struct Function {
  std::string_view name;
  Expression::Operation operation;
  int arguments;
};
constexpr std::array functions{
    Function{"sin", Expression::Operation::sin, 1},   Function{"cos", Expression::Operation::cos, 1},
    Function{"exp", Expression::Operation::exp, 1},   Function{"log", Expression::Operation::log, 1},
    Function{"sqrt", Expression::Operation::sqrt, 1}, Function{"abs", Expression::Operation::abs, 1},
    Function{"min", Expression::Operation::min, 2},   Function{"max", Expression::Operation::max, 2}};
constexpr std::string_view known_functions = "sin, cos, tan, exp, log, sqrt, abs, min and max";

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

void ExpressionParser::Parse() {
  expression_.result_ = Sum();
  if (Next() != 0) Refuse();
}

std::size_t ExpressionParser::Sum() {
  std::size_t sum = Product();
  for (;;) {
    if (Takes('+'))
      sum = Add(Operation::add, sum, Product());
    else if (Takes('-'))
      sum = Add(Operation::subtract, sum, Product());
    else
      return sum;
  }
}

std::size_t ExpressionParser::Product() {
  std::size_t product = Factor();
  for (;;) {
    const char next = Next();
    if (Takes('/'))
      product = Add(Operation::divide, product, Divisor());
    else if (Takes('*') || IsDigit(next) || next == '.' || IsLetter(next) || next == '(' || (value_of_ && next == '$'))
      product = Add(Operation::multiply, product, Factor());
    else
      return product;
  }
}

std::size_t ExpressionParser::Divisor() {
  SkipBlanks();
  const std::size_t start = at_, divisor = Factor();
  const Expression::Step& last = expression_.steps_[divisor];
  if (last.operation == Operation::number && last.number == 0)
    throw ExpressionError(start, text_.find_last_not_of(" \t", at_ - 1) + 1 - start,
                          "this divides by zero, so the formula is defined nowhere");
  return divisor;
}

std::size_t ExpressionParser::Factor() {
  if (++depth_ > deepest) throw ExpressionError(at_, 1, "the formula is nested deeper than 100 levels");
  const bool is_negative = Takes('-');
  const std::size_t factor = is_negative || Takes('+') ? Factor() : Power();
  --depth_;
  return is_negative ? Add(Operation::negate, factor) : factor;
}

std::size_t ExpressionParser::Power() {
  const std::size_t base = Primary();
  if (!Takes('^')) return base;
  const std::size_t power = WholePower(base, Exponent());
  if (Next() == '^') throw ExpressionError(at_, 1, "a power of a power needs brackets", "(x^2)^3");
  return power;
}

std::size_t ExpressionParser::WholePower(std::size_t base, int n) {
  if (n == 0) return Add(Operation::number, 0, 0, 1);
  const std::size_t power = Add(Operation::power, base, base, std::abs(static_cast<double>(n)));
  return n > 0 ? power : Add(Operation::divide, Add(Operation::number, 0, 0, 1), power);
}

int ExpressionParser::Exponent() {
  const bool is_negative = Takes('-');
  SkipBlanks();
  const std::size_t start = at_;
  while (at_ < text_.size() && (IsDigit(text_[at_]) || text_[at_] == '.' || IsLetter(text_[at_]))) ++at_;
  int exponent = 0;
  const auto [end, error] = std::from_chars(text_.data() + start, text_.data() + at_, exponent);
  if (at_ == start || error != std::errc() || end != text_.data() + at_ || exponent > largest_exponent)
    throw ExpressionError(start, std::max<std::size_t>(1, at_ - start), "an exponent must be a whole number up to 64",
                          "use sqrt(x) or exp(2 log(x)) for others");
  return is_negative ? -exponent : exponent;
}

std::size_t ExpressionParser::Primary() {
  const char next = Next();
  if (IsDigit(next) || next == '.') return Number();
  if (IsLetter(next)) return Name();
  if (value_of_ && next == '$') return NamedValue();
  if (!Takes('(')) Refuse();
  const std::size_t inner = Sum();
  Expect(')');
  return inner;
}

std::size_t ExpressionParser::Number() {
  double number = 0;
  const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
  if (error != std::errc()) throw ExpressionError(at_, 1, "this number does not fit a double");
  at_ = static_cast<std::size_t>(end - text_.data());
  return Add(Operation::number, 0, 0, number);
}

std::size_t ExpressionParser::Name() {
  const std::size_t start = at_;
  while (at_ < text_.size() && (IsLetter(text_[at_]) || IsDigit(text_[at_]))) ++at_;
  const std::string_view name = std::string_view(text_).substr(start, at_ - start);
  if (!value_of_ && name == "x") return Add(Operation::x);
  if (!value_of_ && name == "y") return Add(Operation::y);
  if (!value_of_ && name == "z") return Add(Operation::z);
  if (name == "pi") return Add(Operation::number, 0, 0, std::numbers::pi);
  return Call(name, start);
}

std::size_t ExpressionParser::NamedValue() {
  const std::size_t start = at_++;
  while (at_ < text_.size() && (IsLetter(text_[at_]) || IsDigit(text_[at_]))) ++at_;
  try {
    return Add(Operation::number, 0, 0, (*value_of_)(std::string_view(text_).substr(start + 1, at_ - start - 1)));
  } catch (const std::runtime_error& error) {
    throw ExpressionError(start, at_ - start, error.what());
  }
}

std::size_t ExpressionParser::Call(std::string_view name, std::size_t start) {
  const bool is_tangent = name == "tan";
  const Function* function = is_tangent ? &functions[0] : nullptr;
  for (const Function& known : functions)
    if (known.name == name) function = &known;
  if (!function)
    throw ExpressionError(start, name.size(), "no variable or function is named '" + std::string(name) + "'",
                          (value_of_ ? "variables are written $name; there are pi, " : "there are x, y, z, pi, ") +
                              std::string(known_functions));
  Expect('(');
  const std::size_t a = Sum();
  std::size_t b = a;
  if (function->arguments == 2) {
    Expect(',');
    b = Sum();
  }
  Expect(')');
  if (is_tangent) return Add(Operation::divide, Add(Operation::sin, a, a), Add(Operation::cos, a, a));
  return Add(function->operation, a, b);
}

std::size_t ExpressionParser::Add(Operation operation, std::size_t a, std::size_t b, double number) {
  if (++operations_ > most_steps)
    throw ExpressionError(0, text_.size(), "the formula has more than 1000 operations");
  // x x becomes x^2, which has narrower bounds: it is never below 0.
  if (operation == Operation::multiply && a == b) return Known({Operation::power, a, a, 2});
  return Known({operation, a, b, number});
}

std::size_t ExpressionParser::Known(Expression::Step step) {
  auto& steps = expression_.steps_;
  const bool is_sine = step.operation == Operation::sin;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_like = steps[i].a == step.a && steps[i].number == step.number;
    const bool is_trigonometric = steps[i].operation == Operation::sin || steps[i].operation == Operation::cos;
    if (is_like && steps[i].operation == step.operation && (steps[i].b == step.b || is_trigonometric)) return i;
    if (is_like && steps[i].operation == (is_sine ? Operation::cos : Operation::sin) &&
        (is_sine || step.operation == Operation::cos))
      step.b = i;
  }
  steps.push_back(step);
  return steps.size() - 1;
}

void ExpressionParser::SkipBlanks() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
}

char ExpressionParser::Next() {
  SkipBlanks();
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool ExpressionParser::Takes(char c) {
  if (Next() != c || at_ >= text_.size()) return false;
  ++at_;
  return true;
}

void ExpressionParser::Expect(char c) {
  if (Takes(c)) return;
  const bool is_at_end = Next() == 0;
  throw ExpressionError(is_at_end && at_ > 0 ? at_ - 1 : at_, 1,
                        std::string("'") + c + "' is missing " + (is_at_end ? "at the end" : "here"));
}

void ExpressionParser::Refuse() {
  if (Next() == 0)
    throw ExpressionError(at_ > 0 ? at_ - 1 : 0, 1,
                          "the formula ends where a number, a variable or a function is missing");
  throw ExpressionError(at_, 1, "a number, a variable or an operation cannot begin here");
}

}  // namespace R3
