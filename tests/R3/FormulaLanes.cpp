// Formulas in eight lanes, compared with the same formula one point at a time.
#include "R3/shapes/FormulaLanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/Draw.h"

namespace R3 {
namespace {

// These include every operation, angles of all sizes, one-sided domains, and repeated steps.
const char* const lane_formulas[] = {"x^2 + y^2 + z^2 - 1",
                                "(x^2 + 2.25 y^2 + z^2 - 1)^3 - x^2 z^3 - 0.1125 y^2 z^3",
                                "sin(3 x) + cos(3 x) sin(1000000 z) - cos(1e9 y) / sin(3 x)",
                                "sin(pi x) cos(x^60) + cos(x / 1e-200)",
                                "exp(-x^2 - y^2) - abs(z)",
                                "exp(900 x) - exp(900 y) + exp(-z)",
                                "min(x^2 + y^2, max(y, -z)) - 0.3",
                                "x / (y^2 + 0.1) - log(z + 1) + sqrt(x + z)",
                                "x^-2 + tan(y) - z^-3 + (x - y)^0",
                                "log(abs(x)) - sqrt(abs(y) - 1) / z",
                                "x x - (x + y)(x + y) - -z"};

Ray RayOf(Draw& draw) {
  return {Point{draw.Between(-2, 2), draw.Between(-2, 2), draw.Between(-2, 2)}, draw.Scale(-3, 3) * draw.Direction()};
}

bool AreAlike(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(FormulaLanes, HaveTheBitsOfOnePlaceAtATime) {
  Draw draw(75);
  for (const char* text : lane_formulas) {
    const Expression formula(text);
    std::vector<double> values;
    for (int i = 0; i < Count(2000, 200'000); ++i) {
      const Ray ray = RayOf(draw);
      FormulaLanes lanes(formula, ray);
      Lanes t;
      for (double& one : t.at) one = draw.Scale(-300, i % 2 == 0 ? 1 : 300) * draw.Between(-1, 1);
      if (i % 10 == 0) t.at[3] = std::nan(""), t.at[4] = infinity, t.at[5] = 0;
      const Lanes& all = lanes.At(t);
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        const Point p = ray.At(t.at[k]);
        const double value = formula.At(p.x, p.y, p.z, values);
        ASSERT_TRUE(AreAlike(all.at[k], value)) << text << " at " << t.at[k] << ": " << all.at[k] << ' ' << value;
      }
    }
  }
}

TEST(FormulaLanes, ContainEveryValueAndEverySlope) {
  Draw draw(76);
  for (const char* text : lane_formulas) {
    const Expression formula(text);
    std::vector<Slope<double>> of_points;
    int with_bounds = 0;
    for (int i = 0; i < Count(1000, 100'000); ++i) {
      const Ray ray = RayOf(draw);
      FormulaLanes lanes(formula, ray);
      IntervalLanes t;
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        const double middle = draw.Scale(-3, 0) * draw.Between(-1, 1), size = draw.Scale(-16, 0);
        t.Set(k, {middle - size, middle + size});
      }
      const IntervalLanes values = lanes.In(t), slopes = lanes.Slopes();
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        with_bounds += values[k].high - values[k].low < 4;
        for (int place = 0; place < 4; ++place) {
          const double share = place == 3 ? 1 : place / 2.0;
          const double at = std::clamp(t[k].low + share * (t[k].high - t[k].low) * draw.Between(0.5, 1), t[k].low,
                                       t[k].high);
          const Point p = ray.At(at);
          const auto f = formula.At(Slope<double>(p.x, ray.direction.x), Slope<double>(p.y, ray.direction.y),
                                    Slope<double>(p.z, ray.direction.z), of_points);
          EXPECT_TRUE(values[k].Holds(f.value) || std::isnan(f.value)) << text;
          EXPECT_TRUE(slopes[k].Holds(f.slope) || std::isnan(f.slope)) << text;
        }
      }
    }
    EXPECT_GT(with_bounds, 100) << text;
  }
}

/// The cost of bounds depends on their width: each lane's are those of Interval, up to some last bits.
TEST(FormulaLanes, AreNoWiderThanOneStretchAtATime) {
  Draw draw(77);
  for (const char* text : lane_formulas) {
    const Expression formula(text);
    std::vector<Slope<Interval>> of_boxes;
    for (int i = 0; i < 500; ++i) {
      const Ray ray = RayOf(draw);
      FormulaLanes lanes(formula, ray);
      IntervalLanes t;
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        const double middle = draw.Between(-1, 1), size = draw.Scale(-8, 0);
        t.Set(k, {middle - size, middle + size});
      }
      const IntervalLanes values = lanes.In(t), slopes = lanes.Slopes();
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        const auto along = [&](int axis) {
          return Slope<Interval>(Interval(ray.origin[axis]) + Interval(ray.direction[axis]) * t[k],
                                 ray.direction[axis]);
        };
        const auto one = formula.At(along(0), along(1), along(2), of_boxes);
        EXPECT_EQ(values[k].low, one.value.low) << text;
        EXPECT_EQ(values[k].high, one.value.high) << text;
        const double width = slopes[k].high - slopes[k].low, width_of_one = one.slope.high - one.slope.low;
        EXPECT_TRUE(!(width > width_of_one * (1 + 1e-9))) << text << ' ' << width << ' ' << width_of_one;
      }
    }
  }
}

}  // namespace
}  // namespace R3
