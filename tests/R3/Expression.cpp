// Formulas: their meaning, error messages for invalid ones, and intervals that contain every value.
#include "R3/Expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/Draw.h"

namespace R3 {
namespace {

double ValueOf(const std::string& text, double x = 0, double y = 0, double z = 0) {
  std::vector<double> values;
  return Expression(text).At(x, y, z, values);
}

TEST(Expression, MeansWhatOneWrites) {
  EXPECT_EQ(ValueOf("1 + 2 * 3"), 7);
  EXPECT_EQ(ValueOf("(1 + 2) * 3"), 9);
  EXPECT_EQ(ValueOf("8 / 4 / 2"), 1);
  EXPECT_EQ(ValueOf("8 - 4 - 2"), 2);
  EXPECT_EQ(ValueOf("-x^2", 3), -9);
  EXPECT_EQ(ValueOf("2x^3 y", 2, 5), 80);
  EXPECT_EQ(ValueOf("2(x + 1)(y - 1)", 1, 3), 8);
  EXPECT_EQ(ValueOf("x^-2", 2), 0.25);
  EXPECT_EQ(ValueOf("1e-3 x", 2), 1e-3 * 2);
  EXPECT_EQ(ValueOf("min(x, y) + max(x, y) - abs(-z)", 2, 3, 4), 1);
  EXPECT_NEAR(ValueOf("sin(pi / 6) + cos(0) + tan(pi / 4) + exp(0) + log(1) + sqrt(4)"), 0.5 + 1 + 1 + 1 + 2, 1e-15);
}

/// Returns "9-3: no variable ...".
std::string FaultOf(const std::string& text) {
  try {
    Expression expression(text);
  } catch (const ExpressionError& error) {
    return std::to_string(error.at) + "+" + std::to_string(error.length) + ": " + error.what();
  }
  return "none";
}

TEST(Expression, MistakesAreReportedAtTheirPosition) {
  EXPECT_EQ(FaultOf("x^2 + foo(y)"), "6+3: no variable or function is named 'foo'");
  EXPECT_EQ(FaultOf("x +"), "2+1: the formula ends where a number, a variable or a function is missing");
  EXPECT_EQ(FaultOf(""), "0+1: the formula ends where a number, a variable or a function is missing");
  EXPECT_EQ(FaultOf("x + * y"), "4+1: a number, a variable or an operation cannot begin here");
  EXPECT_EQ(FaultOf("x = 1"), "2+1: a number, a variable or an operation cannot begin here");
  EXPECT_EQ(FaultOf("(x + 1"), "5+1: ')' is missing at the end");
  EXPECT_EQ(FaultOf("min(x)"), "5+1: ',' is missing here");
  EXPECT_EQ(FaultOf("x^1.5"), "2+3: an exponent must be a whole number up to 64");
  EXPECT_EQ(FaultOf("x^y"), "2+1: an exponent must be a whole number up to 64");
  EXPECT_EQ(FaultOf("x^2^3"), "3+1: a power of a power needs brackets");
  EXPECT_EQ(FaultOf("1e999"), "0+1: this number does not fit a double");
}

TEST(Expression, EndlessOnesAreRefused) {
  EXPECT_TRUE(FaultOf(std::string(100'000, '(')).ends_with("the formula is nested deeper than 100 levels"));
  EXPECT_TRUE(FaultOf(std::string(100'000, '-')).ends_with("the formula is nested deeper than 100 levels"));
  std::string sum = "x";
  for (int i = 0; i < 1000; ++i) sum += "+x";
  EXPECT_TRUE(FaultOf(sum).ends_with("the formula has more than 1000 operations"));
}

const char* const formulas[] = {"x^2 + y^2 + z^2 - 1",
                                "(x^2 + 2.25 y^2 + z^2 - 1)^3 - x^2 z^3 - 0.1125 y^2 z^3",
                                "sin(3 x) + cos(5 y) sin(z) - 0.2",
                                "exp(-x^2 - y^2) - abs(z)",
                                "min(x^2 + y^2, max(y, z)) - 0.3",
                                "x / (y^2 + 0.1) - log(z^2 + 1) + sqrt(x^2 + z^2)",
                                "x^-2 + tan(y) - z"};

TEST(Expression, IntervalsHoldEveryValueAndEverySlope) {
  Draw draw(71);
  for (const char* text : formulas) {
    const Expression f(text);
    std::vector<Slope<double>> of_points;
    std::vector<Slope<Interval>> of_boxes;
    for (int i = 0; i < Count(2000, 200'000); ++i) {
      const double x = draw.Between(-2, 2), y = draw.Between(-2, 2), z = draw.Between(-2, 2),
                   size = draw.Scale(-16, 0.5);
      const Vector d = draw.Direction();
      const auto box = [&](double c, double slope) { return Slope<Interval>(Interval(c - size, c + size), slope); };
      const auto bounds = f.At(box(x, d.x), box(y, d.y), box(z, d.z), of_boxes);
      for (int k = 0; k < 10; ++k) {
        const auto within = [&](double c, double slope) {
          return Slope<double>(std::clamp(c + size * draw.Between(-1, 1), c - size, c + size), slope);
        };
        const auto at = f.At(within(x, d.x), within(y, d.y), within(z, d.z), of_points);
        EXPECT_TRUE(bounds.value.Holds(at.value) || std::isnan(at.value)) << text;
        EXPECT_TRUE(bounds.slope.Holds(at.slope) || std::isnan(at.slope)) << text;
      }
    }
  }
}

TEST(Expression, SlopesAreThoseOfFiniteDifferences) {
  Draw draw(73);
  for (const char* text : formulas) {
    const Expression f(text);
    std::vector<Slope<double>> values;
    std::vector<double> numbers;
    int far = 0;
    for (int i = 0; i < 500; ++i) {
      const Point p{draw.Between(-2, 2), draw.Between(0.2, 1.2), draw.Between(-2, 2)};
      const Vector d = draw.Direction();
      const double slope = f.At<Slope<double>>({p.x, d.x}, {p.y, d.y}, {p.z, d.z}, values).slope;
      constexpr double step = 1e-6;
      const auto at = [&](double t) { return f.At(p.x + t * d.x, p.y + t * d.y, p.z + t * d.z, numbers); };
      const double difference = (at(step) - at(-step)) / (2 * step);
      far += !(std::abs(slope - difference) <= 1e-4 * (1 + std::abs(slope)));
    }
    EXPECT_LE(far, 5) << text;  // near kinks and poles
  }
}

}  // namespace
}  // namespace R3
