// Solids of a formula, compared with the same solids made otherwise.
#include "R3/Implicit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>

#include "R3/ShapeKind.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"

namespace R3 {
namespace {

const Box around_two{{-2, -2, -2}, {2, 2, 2}};

Implicit SolidOf(const char* formula, const Box& box = around_two) { return Implicit(Expression(formula), box); }

Ray RayThroughSolid(Draw& draw) {
  const Vector d = draw.Direction();
  return {Point{} + 1.5 * draw.Direction() - draw.Scale(0.6, 2) * d, d};
}

/// Expects that the formula is hit where the shape is, with its normals, except for a few rays that graze.
void ExpectTheSame(const Implicit& solid, const Shape& shape, int rays = Count(3000, 300'000)) {
  Draw draw(61);
  int differ = 0, hits = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = RayThroughSolid(draw);
    const std::vector<double> found = crossings::Along(solid, ray), expected = crossings::Along(shape, ray);
    differ += found.size() != expected.size();
    if (found.size() != expected.size()) continue;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k], expected[k], 1e-10);
      const Ray rest{ray.origin, ray.direction, found[k] - 1e-8};
      const auto hit = solid.Intersect(rest, 0), other = shape.Intersect(rest, 0);
      ASSERT_TRUE(hit && other);
      EXPECT_GT(Dot(solid.At(rest, *hit, 0).normal, AsVector(shape.At(rest, *other, 0).normal)), 1 - 1e-7);
    }
    hits += found.empty() ? 0 : 1;
  }
  EXPECT_LE(differ, 1);
  EXPECT_GT(hits, rays / 6);
}

TEST(Implicit, ABallIsThatOfTheSphere) {
  ExpectTheSame(SolidOf("x^2 + y^2 + z^2 - 2"), *MakeShape("sphere", {0, 0, 0, std::sqrt(2.0)}));
}

TEST(Implicit, ATorusIsThatOfTheTorus) {
  ExpectTheSame(SolidOf("(sqrt(x^2 + z^2) - 1.25)^2 + y^2 - 0.0625"), *MakeShape("torus", {0, 0, 0, 1.25, 0.25}));
}

TEST(Implicit, BoxesOfMaximaAreThoseOfBoxes) {
  ExpectTheSame(SolidOf("max(max(abs(x) - 1, abs(y) - 1.5), abs(z) - 0.5)"),
                *MakeShape("box", {-1, -1.5, -0.5, 1, 1.5, 0.5}));
}

TEST(Implicit, ItsBoxCutsItOff) {
  ExpectTheSame(SolidOf("-1", {{-1, -1, -1}, {1, 1.5, 1}}), *MakeShape("box", {-1, -1, -1, 1, 1.5, 1}));
  EXPECT_EQ(crossings::Along(SolidOf("x^2 + y^2 - 1", {{-2, -2, -1}, {2, 2, 1}}), {{0.25, 0, 5}, {0, 0, -1}}),
            (std::vector<double>{4, 6}));
}

TEST(Implicit, SheetsAsThinAsAHairAreNotSkipped) {
  // Forty-one plates of 10^-9, one 0.1 behind the other.
  const Implicit plates = SolidOf("abs(sin(10 pi x)) - 3e-8");
  const std::vector<double> hits = crossings::Along(plates, {{-5.03, 0.1, 0.2}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u * 41);  // plus one half plate at each end of the box
  for (std::size_t i = 1; i < 40; ++i) EXPECT_NEAR(hits[2 * i], 3.03 + 0.1 * static_cast<double>(i), 1e-8);
}

TEST(Implicit, UndefinedPointsAreOutside) {
  EXPECT_EQ(crossings::Along(SolidOf("sqrt(x) - 1"), {{-5, 0, 0}, {1, 0, 0}}).size(), 2u);
  EXPECT_NEAR(crossings::Along(SolidOf("sqrt(x) - 1"), {{-5, 0, 0}, {1, 0, 0}})[0], 5, 1e-12);
  EXPECT_NEAR(crossings::Along(SolidOf("1 / x"), {{-5, 0, 0}, {1, 0, 0}})[1], 5, 1e-12);
  EXPECT_TRUE(crossings::Along(SolidOf("log(-1 - x^2)"), {{-5, 0, 0}, {1, 0, 0}}).empty());
}

TEST(Implicit, CrossingsDoNotDependOnWhereARayBegins) {
  const Implicit gyroid = SolidOf("sin(4 x) cos(4 y) + sin(4 y) cos(4 z) + sin(4 z) cos(4 x)");
  Draw draw(67);
  for (int i = 0; i < 300; ++i) {
    const Ray ray = RayThroughSolid(draw);
    const std::vector<double> all = crossings::Along(gyroid, ray);
    EXPECT_EQ(crossings::Along(gyroid, {ray.origin, ray.direction, -infinity}).size() % 2, 0u);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto hit = gyroid.Intersect({ray.origin, ray.direction, all[k] - 1e-3, NextUp(all[k])}, 0);
      EXPECT_TRUE(hit && hit->t <= all[k]);
      EXPECT_FALSE(gyroid.Intersect({ray.origin, ray.direction, k > 0 ? all[k - 1] : 0, all[k]}, 0));
    }
  }
}

TEST(Implicit, ARayThatLiesInItsSurfaceEnds) {
  EXPECT_LE(crossings::Along(SolidOf("y (x^2 + 1)"), {{-5, 0, 0}, {1, 0, 0}}).size(), 2u);
  EXPECT_LE(crossings::Along(SolidOf("0 x"), {{-5, 0.3, 0}, {1, 0.1, 0}}).size(), 2u);
}

// Each of these rays once never ended.
TEST(Implicit, E10_RaysThatStartOnTheirSurfaceEnd) {
  const char* through_origin[] = {"y",
                                  "-y",
                                  "y^3",
                                  "y exp(x)",
                                  "sin(y)",
                                  "y (x^2 + 1) / 3",
                                  "y + x^2 z^2 0",
                                  "sin(4 x) cos(4 y) + sin(4 y) cos(4 z) + sin(4 z) cos(4 x)",
                                  "y - 0.3 sin(3 x) sin(3 z)",
                                  "x^2 + y^2 + z^2 - y"};
  Draw draw(71);
  for (const char* formula : through_origin) {
    const Implicit solid = SolidOf(formula);
    for (int i = 0; i < 200; ++i) {
      const Vector d = i < 6 ? Vector{i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0}
                             : draw.Scale(-3, 3) * draw.Direction();
      const Ray ray{{0, 0, 0}, i % 2 ? -d : d};  // on the surface of each
      const auto hit = solid.Intersect(ray, 0);
      EXPECT_TRUE(!hit || hit->t > 0) << formula;
      EXPECT_LT(crossings::Along(solid, {ray.origin, ray.direction, -infinity}).size(), 100u) << formula;
    }
  }
}

TEST(Implicit, B13_WhereAFormulaIsZeroIsSolid) {
  ExpectTheSame(SolidOf("max(x^2 + y^2 + z^2 - 2, 0)"), *MakeShape("sphere", {0, 0, 0, std::sqrt(2.0)}));
  ExpectTheSame(SolidOf("abs(x) + x + max(abs(y) - 1, 0) + max(abs(z) - 1, 0)"),
                *MakeShape("box", {-2, -1, -1, 0, 1, 1}), Count(300, 30'000));
  ExpectTheSame(SolidOf("0", {{-1, -1, -1}, {1, 1.5, 1}}), *MakeShape("box", {-1, -1, -1, 1, 1.5, 1}));
}

TEST(Implicit, B13_NormalsAreRightWhereTheSlopeIsZeroOrUndefined) {
  ExpectTheSame(SolidOf("(x^2 + y^2 + z^2 - 2)^3"), *MakeShape("sphere", {0, 0, 0, std::sqrt(2.0)}));
  ExpectTheSame(SolidOf("(max(max(abs(x) - 1, abs(y) - 1.5), abs(z) - 0.5))^5"),
                *MakeShape("box", {-1, -1.5, -0.5, 1, 1.5, 0.5}));
  ExpectTheSame(SolidOf("sqrt(max(abs(x) - 1, 0)^2 + max(abs(y) - 1.5, 0)^2 + max(abs(z) - 0.5, 0)^2) + "
                        "min(max(max(abs(x) - 1, abs(y) - 1.5), abs(z) - 0.5), 0)"),
                *MakeShape("box", {-1, -1.5, -0.5, 1, 1.5, 0.5}), Count(300, 30'000));
  // A jump from 1 to -1 across x = 0.3, with no slope anywhere.
  const Implicit jump = SolidOf("(0.3 - x) / abs(0.3 - x)");
  const Ray ray{{-5, 0.2, 0.1}, {1, 0.1, 0}};
  const auto hit = jump.Intersect(ray, 0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 5.3, 1e-12);
  EXPECT_GT(std::abs(jump.At(ray, *hit, 0).normal.x), 0.9999);
  const Implicit slanted = SolidOf("(x + 2 y + 3 z) / abs(x + 2 y + 3 z)");
  Draw draw(73);
  for (int i = 0; i < 50; ++i) {
    const Ray oblique = RayThroughSolid(draw);
    const auto met = slanted.Intersect(oblique, 0);
    if (!met || met->part != 6) continue;
    EXPECT_GT(Dot(slanted.At(oblique, *met, 0).normal, Unit({1, 2, 3})), 1 - 1e-6);
  }
}

/// Makes a random formula. Minus its value at the origin, its surface contains the origin.
std::string RandomFormula(Draw& draw, int depth) {
  const auto inner = [&] { return RandomFormula(draw, depth - 1); };
  if (depth == 0 || draw.Whole(0, 7) == 0) {
    if (draw.Whole(0, 3) > 0) return std::string(1, "xyz"[draw.Whole(0, 2)]);
    return std::to_string(draw.Whole(-3, 3)) + "." + std::to_string(draw.Whole(0, 9));
  }
  switch (draw.Whole(0, 12)) {
    case 0:
    case 1:
      return "(" + inner() + " + " + inner() + ")";
    case 2:
      return "(" + inner() + " - " + inner() + ")";
    case 3:
    case 4:
      return "(" + inner() + ") * (" + inner() + ")";
    case 5:
      return "(" + inner() + ") / (" + inner() + " + 0.01)";
    case 6:
      return "(" + inner() + ")^" + std::to_string(draw.Whole(2, 5));
    case 7:
      return "sin(" + inner() + ")";
    case 8:
      return "sqrt(" + inner() + ")";
    case 9:
      return "abs(" + inner() + ")";
    case 10:
      return "max(" + inner() + ", " + inner() + ")";
    case 11:
      return "min(" + inner() + ", " + inner() + ")";
    default:
      return draw.Whole(0, 1) ? "exp(" + inner() + ")" : "log(" + inner() + ")";
  }
}

// A ray divides at most 4,681 stretches, whatever the formula; see most_divisions. The slowest are printed at night.
TEST(Implicit, E10_RaysOnInAndNearRandomSurfacesEnd) {
  double slowest = 0;
  int tried = 0;
  for (int number = 0; number < Count(500, 1'000'000); ++number) {
    if (number % 50'000 == 49'999) std::printf("%d so far; the slowest ray took %.1f ms\n", tried, 1e3 * slowest);
    Draw draw(static_cast<std::uint64_t>(number) + 5'000'000);
    std::string text = RandomFormula(draw, draw.Whole(1, 4));
    std::optional<Expression> formula;
    try {
      formula.emplace(text);
      std::vector<double> values;
      const double there = formula->At(0.0, 0.0, 0.0, values);
      if (number % 2 == 0 && std::isfinite(there)) formula.emplace(text += " - (" + std::to_string(there) + ")");
    } catch (const ExpressionError&) {
      continue;  // it divides by 0
    }
    ++tried;
    const Implicit solid(*formula, around_two);
    Point start{0, 0, 0};
    for (int i = 0; i < 4; ++i) {
      if (i == 2) start = {draw.Between(-2, 2), draw.Between(-2, 2), draw.Between(-2, 2)};
      const Ray ray{start, draw.Whole(0, 3) ? draw.Direction() : Vector{0, 0, -1}};
      const auto before = std::clock();
      const auto hit = solid.Intersect(ray, 0);
      const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      if (seconds > 0.01 && std::getenv("RAYPRO_NIGHT"))
        std::printf("%.1f ms from %g %g %g: %s\n", 1e3 * seconds, start.x, start.y, start.z, text.c_str());
      slowest = std::max(slowest, seconds);
      if (!hit) continue;
      EXPECT_GT(hit->t, 0) << text;
      const Intersection at = solid.At(ray, *hit, 0);
      EXPECT_NEAR(Length(AsVector(at.normal)), 1, 1e-9) << text;
      start = at.position;  // the next ray starts there
    }
  }
  std::printf("%d formulas; the slowest ray took %.1f ms\n", tried, 1e3 * slowest);
  EXPECT_GT(tried, Count(350, 700'000));
}

}  // namespace
}  // namespace R3
