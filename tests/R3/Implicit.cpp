// Solids of a formula, against the same solids made otherwise.
#include "R3/Implicit.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// That the formula is met where the shape is, with its normals; all but a few rays that touch.
void ExpectTheSame(const Implicit& solid, const Shape& shape) {
  Draw draw(61);
  int differ = 0, hits = 0;
  for (int i = 0; i < Count(3000, 300'000); ++i) {
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
  EXPECT_GT(hits, 500);
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

TEST(Implicit, SheetsAsThinAsAHairAreNotSteppedOver) {
  // Forty-one plates of 10^-9, one 0.1 behind the other.
  const Implicit plates = SolidOf("abs(sin(10 pi x)) - 3e-8");
  const std::vector<double> hits = crossings::Along(plates, {{-5.03, 0.1, 0.2}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u * 41);  // and one half plate at each end of the box
  for (std::size_t i = 1; i < 40; ++i) EXPECT_NEAR(hits[2 * i], 3.03 + 0.1 * static_cast<double>(i), 1e-8);
}

TEST(Implicit, WhatIsNotDefinedIsOutside) {
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

}  // namespace
}  // namespace R3
