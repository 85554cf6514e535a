// Rings of any thickness and rays along everything special about them. Oracle: the distance of a ray's points from the
// ring's middle circle, in 113 bits; where the ray crosses the surface that distance passes `minor`. Its square is
// |p|^2 + R^2 - 2 R |p across|, a parabola less a convex function, so that it is convex, concave and convex again with
// ends that a closed form gives; it rises or falls all the way between those and its turns, at most three.

#include <gtest/gtest.h>

#include <algorithm>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"
#include "tests/ExactRing.h"

namespace {

using R3::unit_roundoff;

struct Ring {
  R3::Point center;
  double major, minor;
  std::unique_ptr<const R3::Shape> shape = R3::MakeShape("torus", {center.x, center.y, center.z, major, minor});

  double Size() const { return major + minor; }
  oracle::Ring Exact() const { return {major, minor}; }

  /// Every crossing that is certain is reported once, and nothing is that is none.
  void Check(const R3::Ray& ray) const {
    const oracle::Line line{oracle::Of(ray.origin) - oracle::Of(center), oracle::Of(ray.direction)};
    const oracle::Ring exact = Exact();
    const Quad bar = 8 * unit_roundoff * (Length(ray.origin - center) + Size() + Length(FromOrigin(center)));
    const auto story = [&](double t) {
      return "torus " + std::to_string(major) + ' ' + std::to_string(minor) + ' ' + oracle::Hex(ray) + ' ' +
             std::to_string(t);
    };
    std::vector<double> hits;
    R3::Ray rest = ray;
    while (const auto hit = shape->Intersect(rest, 0)) {
      ASSERT_LE(hits.size(), 4u) << story(hit->t);
      ASSERT_GT(hit->t, rest.t_min) << story(hit->t);
      rest.t_min = hit->t;
      hits.push_back(hit->t);
      EXPECT_LE(oracle::Double(oracle::Abs(exact.Outside(line.At(hit->t)))), oracle::Double(bar))
          << "off the surface: " << story(hit->t);
      CheckSurface(ray, *hit);
    }
    // Where it starts near by, the side is known better.
    Quad from = 0, outside_from = exact.Outside(line.o);
    Quad bar_from = Length(ray.origin - center) < 8 * Size() ? Quad(0x1p-90) * Size() : bar;
    std::size_t counted = 0;
    for (const Quad to : exact.Breaks(line, 0)) {
      if (!(to > from)) continue;
      const Quad outside_to = exact.Outside(line.At(to));
      const auto first = hits.begin() + static_cast<std::ptrdiff_t>(counted);
      const auto in_piece = std::count_if(first, hits.end(), [&](double t) { return Quad(t) <= to; });
      if (outside_from > bar_from && outside_to > bar)
        EXPECT_EQ(in_piece, 0) << "outside all the way: " << story(oracle::Double(to));
      else if (outside_from < -bar_from && outside_to < -bar)
        EXPECT_EQ(in_piece, 0) << "inside all the way: " << story(oracle::Double(to));
      else if ((outside_from > bar_from && outside_to < -bar) || (outside_from < -bar_from && outside_to > bar))
        EXPECT_EQ(in_piece, 1) << "a hole: " << story(oracle::Double(to));
      else
        EXPECT_LE(in_piece, 1) << story(oracle::Double(to));
      counted += static_cast<std::size_t>(in_piece);
      from = to, outside_from = outside_to, bar_from = bar;
    }
    EXPECT_EQ(counted, hits.size()) << "beyond it: " << story(0);
  }

  /// The position is as near the surface as it says: what starts outside its error starts on the right side.
  void CheckSurface(const R3::Ray& ray, const R3::Hit& hit) const {
    const auto at = shape->At(ray, hit, 0);
    const R3::Vector n = AsVector(at.normal);
    EXPECT_NEAR(R3::Length(n), 1, 4 * unit_roundoff);
    for (const double side : {1.0, -1.0}) {
      const auto start = oracle::Of(SpawnPoint(at, side * n)) - oracle::Of(center);
      EXPECT_GT(oracle::Double(Quad(side) * Exact().Outside(start)), 0) << oracle::Hex(ray);
    }
  }
};

Ring DrawRing(Draw& draw) {
  const double major = draw.Scale(-6, 6);
  const double share = draw.Whole(0, 1)   ? draw.Between(0.05, 0.95)
                       : draw.Whole(0, 1) ? draw.Scale(-4, 0)
                                          : 1 - draw.Scale(-4, -1);
  const double away = draw.Whole(0, 2) * major;
  return {R3::Point{} + away * draw.Direction(), major, std::min(share, 0.9999) * major};
}

R3::Vector Across(double turn) { return {std::cos(turn), 0, std::sin(turn)}; }

/// A point at a share of `minor` from the middle circle (1 is on the surface), and the direction away from that circle.
struct Place {
  R3::Point point;
  R3::Vector outward;
};
Place DrawPlace(Draw& draw, const Ring& ring, double share) {
  const double tilt = draw.Between(0, 6.28);
  const R3::Vector across = Across(draw.Between(0, 6.28));
  const R3::Vector outward = std::cos(tilt) * across + R3::Vector{0, std::sin(tilt), 0};
  return {ring.center + ring.major * across + share * ring.minor * outward, outward};
}

R3::Point DrawOrigin(Draw& draw, const Ring& ring) {
  return ring.center + draw.Scale(-1, 6) * ring.Size() * draw.Direction();
}

template <typename MakeRay>
void CheckMany(std::uint64_t seed, const MakeRay& ray) {
  Draw draw(seed);
  for (int i = 0; i < Count(200, 200'000); ++i) {
    const Ring ring = DrawRing(draw);
    for (int k = 0; k < 10; ++k) ring.Check(ray(draw, ring));
    if (testing::Test::HasFailure()) return;  // one story is enough
  }
}

TEST(Extremes, B6_ARingFromAnywhereHasNeitherHolesNorHairs) {
  CheckMany(901, [](Draw& draw, const Ring& ring) {
    const R3::Point origin = DrawOrigin(draw, ring), target = DrawPlace(draw, ring, draw.Between(0, 1.5)).point;
    return R3::Ray{origin, draw.Scale(-3, 3) * (target - origin)};
  });
}

TEST(Extremes, B6_ATorusGrazedDeeperThanRoundingIsHit) {
  CheckMany(902, [](Draw& draw, const Ring& ring) {
    const auto [point, outward] = DrawPlace(draw, ring, 1 + draw.Whole(-1, 1) * draw.Scale(-16, -1));
    const R3::Vector along = Unit(Cross(outward, draw.Direction()));
    return R3::Ray{point - draw.Scale(-3, 6) * ring.Size() * along, draw.Scale(-3, 3) * along};
  });
}

TEST(Extremes, B6_ARingLetsRaysThroughItsHole) {
  CheckMany(903, [](Draw& draw, const Ring& ring) {
    const R3::Point target =
        ring.center + draw.Between(0, 1.1) * (ring.major - ring.minor) * Across(draw.Between(0, 6.28));
    const R3::Point origin = DrawOrigin(draw, ring);
    return R3::Ray{origin, target - origin};
  });
}

TEST(Extremes, B6_ATorusIsHitAlongItsAxisAndPlane) {
  CheckMany(904, [](Draw& draw, const Ring& ring) {
    const double distance = draw.Scale(-1, 6) * ring.Size();
    const R3::Vector across = Across(draw.Between(0, 6.28)), up{0, draw.Whole(0, 1) ? 1.0 : -1.0, 0};
    const R3::Vector aside = draw.Between(0, 1.1) * ring.Size() * Across(draw.Between(0, 6.28));
    const double nearly = draw.Whole(0, 1) ? 0 : draw.Scale(-16, -3);
    switch (draw.Whole(0, 4)) {
      case 0:  // on the axis
        return R3::Ray{ring.center - distance * up, up + nearly * across};
      case 1:  // beside it
        return R3::Ray{ring.center - distance * up + aside, up + nearly * across};
      case 2:  // through it
        return R3::Ray{ring.center - distance * across, across + nearly * up};
      case 3:  // in the plane, or level beside it
        return R3::Ray{
            ring.center - distance * across + aside + draw.Whole(0, 1) * draw.Between(0, 1.1) * ring.minor * up,
            across + nearly * up};
      default: {  // along a coordinate axis
        const R3::Vector x{draw.Whole(0, 1) ? 1.0 : -1.0, 0, -0.0};
        return R3::Ray{ring.center - distance * x + draw.Whole(0, 1) * aside, x};
      }
    }
  });
}

TEST(Extremes, B6_RaysFromInsideATorusFindAllCrossings) {
  CheckMany(905, [](Draw& draw, const Ring& ring) {
    const R3::Point origin = DrawPlace(draw, ring, draw.Between(0, 1)).point;
    const R3::Vector round = Unit(Cross(origin - ring.center, {0, 1, 0}));
    return R3::Ray{origin, draw.Scale(-3, 3) * (draw.Whole(0, 1) ? draw.Direction() : round + 0.01 * draw.Direction())};
  });
}

TEST(Extremes, B6_E1_RaysLeavingATorusDoNotHitTheirOrigin) {
  CheckMany(906, [](Draw& draw, const Ring& ring) {
    for (;;) {
      const R3::Point target = DrawPlace(draw, ring, draw.Between(0, 1)).point, origin = DrawOrigin(draw, ring);
      const R3::Ray to{origin, target - origin};
      const auto hit = ring.shape->Intersect(to, 0);
      if (!hit) continue;  // only where the target is off by more than it is deep
      const auto at = ring.shape->At(to, *hit, 0);
      const R3::Vector n = AsVector(at.normal), along = Cross(n, draw.Direction());
      const R3::Vector onward =
          draw.Whole(0, 1) ? draw.Direction() : Unit(along) + draw.Scale(-12, 0) * draw.Whole(-1, 1) * n;
      return R3::Ray{SpawnPoint(at, onward), onward};
    }
  });
}

TEST(Extremes, B6_ARingThatIsASpindleIsRefused) {
  EXPECT_THROW(R3::MakeShape("torus", {0, 0, 0, 1, 1}), R3::ArgumentError);
  EXPECT_THROW(R3::MakeShape("torus", {0, 0, 0, 0, 1}), R3::ArgumentError);
  EXPECT_TRUE(R3::MakeShape("torus", {0, 0, 0, 1, 0})->IsDegenerate());
}

TEST(Torus, LiesAroundYWithUvAlongRingAndTube) {
  const auto ring = R3::MakeShape("torus", {0, 0, 0, 2, 0.5});
  const auto uv = [&](const R3::Point& p, const R3::Vector& from) {
    const R3::Ray ray{p + from, -from};
    return ring->At(ray, *ring->Intersect(ray, 0), 0).uv;
  };
  EXPECT_NEAR(uv({2.5, 0, 0}, {1, 0, 0}).x, 0.25, 1e-12);  // as cylinder and cone
  EXPECT_NEAR(uv({2.5, 0, 0}, {1, 0, 0}).y, 0.5, 1e-12);
  EXPECT_NEAR(uv({0, 0.5, 2}, {0, 1, 0}).x, 0.5, 1e-12);
  EXPECT_NEAR(uv({0, 0.5, 2}, {0, 1, 0}).y, 0.75, 1e-12);
  EXPECT_NEAR(uv({0, -0.5, -2}, {0, -1, 0}).y, 0.25, 1e-12);
}

}  // namespace
