#include "R3/Vector.h"

#include <gtest/gtest.h>

#include "R3/Box.h"
#include "R3/Intersection.h"
#include "R3/Transform.h"
#include "tests/Draw.h"

namespace {

TEST(Vector, LengthAndUnitNeitherOverflowNorUnderflow) {
  for (const double scale : {0x1p-1070, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e307}) {
    EXPECT_NEAR(Length(R3::Vector{3 * scale, 0, 4 * scale}) / scale, 5, 1e-14);
    const R3::Vector u = Unit(R3::Vector{3 * scale, 0, -4 * scale});
    EXPECT_NEAR(u.x, 0.6, 1e-15);
    EXPECT_NEAR(u.z, -0.8, 1e-15);
  }
  EXPECT_EQ(Unit(R3::Vector{}), R3::Vector{});
  EXPECT_EQ(Unit(R3::Vector{std::nan(""), 1, 0}), R3::Vector{});
  EXPECT_EQ(Unit(R3::Vector{1, std::nan(""), 0}), R3::Vector{});
  EXPECT_EQ(Unit(R3::Vector{R3::infinity, 1, 0}), R3::Vector{});
}

TEST(Vector, MaxAxisTakesTheLowestAmongEquals) {
  EXPECT_EQ(R3::MaxAxis({1, -1, 1}), 0);
  EXPECT_EQ(R3::MaxAxis({0, -2, 2}), 1);
  EXPECT_EQ(R3::MaxAxis({0, 1, -2}), 2);
}

TEST(Box, GrowsFromNothingAndKnowsWhenItIsEmpty) {
  R3::Box box;
  EXPECT_TRUE(box.IsEmpty());
  EXPECT_EQ(box.Radius(), 0);
  box.Extend(R3::Box{});
  EXPECT_TRUE(box.IsEmpty());
  box.Extend(R3::Point{1, 2, 3});
  EXPECT_FALSE(box.IsEmpty());
  EXPECT_EQ(box.Center(), (R3::Point{1, 2, 3}));
}

TEST(Transform, MapsBoxesAndKeepsTheTOfRays) {
  R3::Matrix m;
  m.m = {{{0, -2, 0, 1}, {2, 0, 0, 0}, {0, 0, 2, 0}}};
  const auto transform = R3::Transform::Of(m);
  ASSERT_TRUE(transform);
  EXPECT_EQ(*transform * (R3::Box{{0, 0, 0}, {1, 2, 3}}), (R3::Box{{-3, 0, 0}, {1, 2, 6}}));
  EXPECT_TRUE((*transform * R3::Box{}).IsEmpty());
  const R3::Ray ray{{1, 2, 3}, {0.5, 0.25, -1}, 0.1, 7};
  const R3::Ray back = transform->Back(ray);
  EXPECT_EQ(*transform * back.At(3), ray.At(3));
  EXPECT_EQ(back.t_min, 0.1);
  EXPECT_EQ(back.t_max, 7);
}

TEST(Transform, NormalsStayPerpendicularUnderAnyAffineMap) {
  Draw draw(911);
  for (int i = 0; i < 10'000; ++i) {
    const auto transform = R3::Transform::Of(draw.Affine(3));
    ASSERT_TRUE(transform);
    const R3::Vector n = draw.Direction(), tangent = Unit(Cross(n, draw.Direction()));
    EXPECT_NEAR(Dot(*transform * AsNormal(n), Unit(*transform * tangent)), 0, 1e-12);
  }
}

TEST(SpawnPoint, LiesBeyondTheErrorOnTheRaysSide) {
  R3::Intersection at;
  at.position = {1, 2, 3};
  at.error = {1e-9, 2e-9, 3e-9};
  at.normal = {0.6, 0, 0.8};
  for (const double side : {1.0, -1.0}) {
    const R3::Point p = SpawnPoint(at, side * R3::Vector{0.7, 0.1, 0.7});
    const double moved = side * Dot(at.normal, p - at.position);
    EXPECT_GE(moved, 0.6 * 1e-9 + 0.8 * 3e-9);
    EXPECT_LE(moved, 4e-9);
  }
}

}  // namespace
