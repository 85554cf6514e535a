#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

struct AnyPlane {
  R3::Point point;
  R3::Vector normal;
  std::unique_ptr<const R3::Shape> shape;
};

AnyPlane PlaneOf(const R3::Point& p, const R3::Vector& n) {
  return {p, n, R3::MakeShape("plane", {p.x, p.y, p.z, n.x, n.y, n.z})};
}

AnyPlane Drawn(Draw& draw) {
  return PlaneOf(R3::Point{} + draw.Scale(-3, 6) * draw.Direction(), draw.Scale(-3, 3) * draw.Direction());
}

/// Returns n.(p - point) / |n| in 113 bits: the distance of a point from the plane.
double Distance(const AnyPlane& plane, const R3::Point& p) {
  const oracle::Vector n = oracle::Of(plane.normal);
  const Quad along = Dot(n, oracle::Of(p) - oracle::Of(plane.point));
  return static_cast<double>(oracle::Abs(along) / oracle::Sqrt(Dot(n, n)));
}

TEST(Plane, IsHitWhereExactArithmeticSays) {
  Draw draw(11);
  int hits = 0;
  for (int i = 0; i < Count(100'000, 10'000'000); ++i) {
    const AnyPlane plane = Drawn(draw);
    const R3::Ray ray{R3::Point{} + draw.Scale(-3, 6) * draw.Direction(), draw.Scale(-3, 3) * draw.Direction()};
    const oracle::Vector n = oracle::Of(plane.normal);
    const Quad t = Dot(n, oracle::Of(plane.point) - oracle::Of(ray.origin)) / Dot(n, oracle::Of(ray.direction));
    const auto hit = plane.shape->Intersect(ray, 0);
    ASSERT_EQ(hit.has_value(), t > 0) << i;
    if (!hit) continue;
    ++hits;
    // Along the normal, where it matters: a grazing ray's t may err by more.
    const double reach = hit->t * Length(ray.direction) + Length(FromOrigin(ray.origin));
    ASSERT_LE(Distance(plane, ray.At(hit->t)), 32 * 0x1p-53 * reach);
  }
  EXPECT_GT(hits, 10'000);
}

TEST(Plane, ItsPointsLieWithinTheirErrorOfIt) {
  Draw draw(12);
  for (int i = 0; i < Count(100'000, 10'000'000); ++i) {
    const AnyPlane plane = Drawn(draw);
    const R3::Ray ray{R3::Point{} + draw.Scale(-3, 6) * draw.Direction(), draw.Direction()};
    const auto hit = plane.shape->Intersect(ray, 0);
    if (!hit) continue;
    const R3::Intersection at = plane.shape->At(ray, *hit, 0);
    ASSERT_LE(Distance(plane, at.position), Dot(at.error, Abs(AsVector(at.normal)))) << i;
    ASSERT_NEAR(Length(AsVector(at.normal)), 1, 1e-15);
  }
}

TEST(Plane, IsMissedByRaysAlongItAndInIt) {
  const AnyPlane plane = PlaneOf({0, 1, 0}, {0, 3, 0});
  EXPECT_FALSE(plane.shape->Intersect({{0, 2, 0}, {1, 0, 0}}, 0));
  EXPECT_FALSE(plane.shape->Intersect({{0, 1, 0}, {1, 0, 0}}, 0));
  EXPECT_FALSE(plane.shape->Intersect({{0, 2, 0}, {0, 1, 0}}, 0));
  EXPECT_EQ(plane.shape->Intersect({{0, 2, 0}, {0, -0.5, 0}}, 0)->t, 2);
  EXPECT_FALSE(plane.shape->Intersect({{0, 2, 0}, {0, -0.5, 0}, 2, 9}, 0)) << "the interval is open";
  EXPECT_FALSE(plane.shape->Intersect({{0, 2, 0}, {0, -0.5, 0}, 0, 2}, 0));
}

TEST(Plane, RejectsAZeroNormal) {
  try {
    R3::FindShapeKind("plane")->make(std::vector<double>{1, 2, 3, 0, 0, 0});
    FAIL();
  } catch (const R3::ArgumentError& error) {
    EXPECT_EQ(error.index, 3u);
  }
}

}  // namespace
