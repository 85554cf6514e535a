// Spheres far away, hit at the rim, and as large as a planet. Oracle: 113-bit arithmetic on the same rounded inputs.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "R3/shapes/Quadric.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

using R3::unit_roundoff;

/// A ray from `distance` towards a unit sphere at the origin that passes its center at `impact`, from a random side.
R3::Ray RayPast(Draw& draw, double distance, double impact) {
  const R3::Vector along = draw.Direction(), across = Unit(Cross(along, draw.Direction()));
  const R3::Point origin = R3::Point{} + (-distance * along + impact * across);
  return {origin, draw.Scale(-3, 3) * along};
}

/// How near the exact ray comes to the center.
double ExactImpact(const R3::Ray& ray) {
  const auto o = oracle::Of(ray.origin), d = oracle::Of(ray.direction);
  return oracle::Double(oracle::Length(oracle::Cross(o, d)) / oracle::Length(d));
}

double OffSurface(const R3::Ray& ray, double t) {
  const auto p = oracle::Of(ray.origin) + Quad(t) * oracle::Of(ray.direction);
  return oracle::Double(oracle::Abs(oracle::Length(p) - 1));
}

void CheckAgainstOracle(const R3::Shape& sphere, const R3::Ray& ray, double distance) {
  const double bar = 8 * unit_roundoff * (distance + 1);
  const double impact = ExactImpact(ray);
  const auto hit = sphere.Intersect(ray, 0);
  const bool is_certain = std::abs(impact - 1) > bar;
  EXPECT_TRUE(!is_certain || hit.has_value() == (impact < 1)) << oracle::Hex(ray);
  if (!hit) return;
  EXPECT_LE(OffSurface(ray, hit->t), bar) << oracle::Hex(ray);
  const auto at = sphere.At(ray, *hit, 0);
  EXPECT_LE(oracle::Double(oracle::Abs(oracle::Length(oracle::Of(at.position)) - 1)), 8 * unit_roundoff);
}

TEST(Extremes, B1_SpheresAreHitUpToATrillionRadiiAway) {
  const auto sphere = R3::MakeShape("sphere", {0, 0, 0, 1});
  Draw draw(101);
  for (int power = 0; power <= 12; ++power) {
    const double distance = std::pow(10, power) * (power == 0 ? 1.5 : 1);
    for (int i = 0; i < Count(20'000, 1'000'000); ++i)
      CheckAgainstOracle(*sphere, RayPast(draw, distance, draw.Between(0, 1.1)), distance);
  }
}

// A ray that begins a few roundings off the surface, heading anywhere: where IsCertainlyLeaving says so, it begins
// outside and no nearer place lies ahead.
TEST(Extremes, B1_ARayThatCertainlyLeavesASphereComesNoNearer) {
  Draw draw(111);
  int certain = 0;
  for (int i = 0; i < Count(200'000, 10'000'000); ++i) {
    const R3::Point center = R3::Point{} + draw.Scale(-3, 6) * draw.Direction();
    const double radius = draw.Scale(-3, 3);
    const double off = 1 + draw.Between(-20, 60) * unit_roundoff;
    const R3::Vector outward = draw.Direction(), across = Unit(Cross(outward, draw.Direction()));
    const R3::Point origin = center + radius * off * outward;
    const R3::Vector direction = draw.Scale(-3, 3) * (draw.Scale(-18, 0) * (i % 2 ? 1 : -1) * outward + across);
    const R3::Vector from_center = origin - center;
    if (!R3::IsCertainlyLeaving(from_center, direction, radius)) continue;
    ++certain;
    const auto f = oracle::Of(origin) - oracle::Of(center), d = oracle::Of(direction);
    const Quad along = oracle::Dot(f, d), ahead = along < 0 ? -along / oracle::Dot(d, d) : Quad(0);
    EXPECT_GT(oracle::Double(oracle::Length(f + ahead * d) - Quad(radius)), 0) << oracle::Hex({origin, direction});
  }
  EXPECT_GT(certain, 1000);
}

TEST(Extremes, B2_GrazingRaysAreDecidedWithinTheSameBand) {
  const auto sphere = R3::MakeShape("sphere", {0, 0, 0, 1});
  Draw draw(102);
  for (const double distance : {10.0, 1e4})
    for (int j = 2; j <= 15; ++j)
      for (int i = 0; i < 500; ++i)
        CheckAgainstOracle(*sphere, RayPast(draw, distance, 1 - std::pow(10, -j)), distance);
}

TEST(Extremes, B2_AnExactTangentGetsTheSameAnswerEveryTime) {
  const auto sphere = R3::MakeShape("sphere", {0, 0, 0, 1});
  const R3::Ray ray{{1, 0, 10}, {0, 0, -1}};
  const auto first = sphere->Intersect(ray, 0);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(sphere->Intersect(ray, 0).has_value(), first.has_value());
  EXPECT_NEAR(first ? first->t : 10, 10, 1e-6);
}

TEST(Extremes, B3_PlanetSizedSpheresAreHitAccurately) {
  Draw draw(103);
  for (const auto& [radius, bar] : {std::pair{1e6, 1e-9}, std::pair{1e9, 1e-6}}) {
    const auto ground = R3::MakeShape("sphere", {0, -radius, 0, radius});
    for (const double eye : {1e-3, 1.0, 100.0})
      for (int i = 0; i < Count(20'000, 1'000'000); ++i) {
        // Downwards at any angle from straight to grazing.
        const double fall = draw.Scale(-4, 0), turn = draw.Between(0, 6.28);
        const R3::Ray ray{{draw.Between(-1, 1), eye, draw.Between(-1, 1)}, {std::cos(turn), -fall, std::sin(turn)}};
        const auto f = oracle::Of(ray.origin) - oracle::Vector{0, -Quad(radius), 0}, d = oracle::Of(ray.direction);
        const Quad a = Dot(d, d), b = -Dot(f, d), c = Dot(f, f) - Quad(radius) * Quad(radius), D = b * b - a * c;
        const auto hit = ground->Intersect(ray, 0);
        if (D < 0) {
          EXPECT_FALSE(hit) << oracle::Hex(ray);
          continue;
        }
        const double t = oracle::Double(c / (b + oracle::Sqrt(D)));
        if (oracle::Double(D / (b * b)) < 1e-6) continue;  // a tangent: the distance itself is not determined
        ASSERT_TRUE(hit) << oracle::Hex(ray);
        EXPECT_LE(std::abs(hit->t / t - 1), bar) << oracle::Hex(ray);
      }
  }
}

}  // namespace
