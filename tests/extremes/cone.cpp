// Cones like needles and like plates, and rays along everything special about them.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

using R3::unit_roundoff;

struct Cone {
  double radius, height;
  std::unique_ptr<const R3::Shape> shape = R3::MakeShape("cone", {0, 0, 0, radius, height});

  double Size() const { return radius + height; }

  /// Distance of a point from the solid's surface, from above (to the side, the base or the rim, whichever is nearest).
  double OffSurface(const oracle::Vector& p) const {
    const Quad r = radius, h = height, x = oracle::Sqrt(p.x * p.x + p.z * p.z), y = p.y + h / 2;
    // The side as the segment from (r, 0) to (0, h) in the half plane.
    const Quad length = oracle::Sqrt(r * r + h * h);
    Quad along = ((r - x) * r + y * h) / length;
    along = along < 0 ? Quad(0) : along > length ? length : along;
    const Quad sx = r - along * r / length, sy = along * h / length;
    const Quad side = oracle::Sqrt((x - sx) * (x - sx) + (y - sy) * (y - sy));
    const Quad beyond = x > r ? x - r : Quad(0);
    const Quad base = oracle::Sqrt(beyond * beyond + y * y);
    return oracle::Double(side < base ? side : base);
  }

  void Check(const R3::Ray& ray) const {
    const auto hit = shape->Intersect(ray, 0);
    if (!hit) return;
    const auto p = oracle::Of(ray.origin) + Quad(hit->t) * oracle::Of(ray.direction);
    const double distance = Length(ray.origin - R3::Point{});
    const double bar = 32 * unit_roundoff * (distance + Size());
    EXPECT_LE(OffSurface(p), bar) << radius << ' ' << height << ' ' << oracle::Hex(ray);
    EXPECT_LE(oracle::Double(p.y), height / 2 + bar) << "in the mirror cone: " << oracle::Hex(ray);
    const auto at = shape->At(ray, *hit, 0);
    EXPECT_NEAR(Length(AsVector(at.normal)), 1, 4 * unit_roundoff);
  }
};

std::vector<Cone> Cones() {
  std::vector<Cone> cones;
  for (const double radius : {0.5, 0.75, 1.0, 2.0, 5.0}) cones.push_back({radius, 2});
  for (int k = 1; k <= 8; ++k) {
    cones.push_back({std::pow(10, -k), 1});  // needles, half angle 10^-k
    cones.push_back({1, std::pow(10, -k)});  // plates, half angle pi/2 - 10^-k
  }
  return cones;
}

TEST(Extremes, B5_NeedlesAndPlatesAreHitOnTheirSurfaceFromAnywhere) {
  Draw draw(501);
  for (const Cone& cone : Cones())
    for (int i = 0; i < Count(5'000, 1'000'000); ++i) {
      const R3::Point origin = R3::Point{} + draw.Scale(-1, 5) * draw.Direction();
      const R3::Point target{cone.radius * draw.Between(-1.2, 1.2), cone.height * draw.Between(-0.6, 0.6),
                             cone.radius * draw.Between(-1.2, 1.2)};
      cone.Check({origin, draw.Scale(-3, 3) * (target - origin)});
    }
}

TEST(Extremes, B5_RaysThroughTheApexStayOnTheRightCone) {
  Draw draw(502);
  for (const Cone& cone : Cones()) {
    const R3::Point apex{0, cone.height / 2, 0};
    for (int i = 0; i < 2'000; ++i) {
      const R3::Point origin = apex + draw.Scale(-1, 2) * draw.Direction();
      cone.Check({origin, apex - origin});
      // Along a generator line, from beyond the apex, where the mirror cone would be, and from below the base.
      const double turn = draw.Between(0, 6.28);
      const R3::Vector down{cone.radius * std::cos(turn), -cone.height, cone.radius * std::sin(turn)};
      cone.Check({apex - 2 * down, down});
      cone.Check({apex + 3 * down, -down});
    }
    const auto from_above = cone.shape->Intersect({{0, 5, 0}, {0, -1, 0}}, 0);
    ASSERT_TRUE(from_above);
    EXPECT_DOUBLE_EQ(from_above->t, 5 - cone.height / 2);
    EXPECT_EQ(cone.shape->At({{0, 5, 0}, {0, -1, 0}}, *from_above, 0).normal, (R3::Normal{0, 1, 0}));
    const auto from_below = cone.shape->Intersect({{0, -5, 0}, {0, 1, 0}}, 0);
    ASSERT_TRUE(from_below);
    EXPECT_DOUBLE_EQ(from_below->t, 5 - cone.height / 2);
    EXPECT_EQ(cone.shape->At({{0, -5, 0}, {0, 1, 0}}, *from_below, 0).normal, (R3::Normal{0, -1, 0}));
  }
}

TEST(Extremes, B5_RaysThatMeetOnlyTheMirrorConeMiss) {
  Draw draw(503);
  for (const Cone& cone : Cones())
    for (int i = 0; i < 2'000; ++i) {
      const double y = cone.height * (0.5 + draw.Between(0.01, 3));
      EXPECT_FALSE(cone.shape->Intersect({{-10 * cone.Size(), y, cone.radius * draw.Between(-1, 1)}, {1, 0, 0}}, 0));
    }
}

}  // namespace
