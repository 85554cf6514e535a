// Discs against formulas in four times the digits, and from far away.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"

namespace {

using LongReal = long double;  // 64 bits of precision: 11 more than what is tested

struct DiscCrossing {
  LongReal t, from_center;
};

/// Where the ray's line crosses the plane, with nothing of the shape's own code.
DiscCrossing PlaneCrossing(const R3::Ray& ray, const std::vector<double>& disc) {
  LongReal towards = 0, away = 0, square = 0;
  const auto part = [](const auto& v, int i) { return static_cast<LongReal>(i == 0 ? v.x : i == 1 ? v.y : v.z); };
  for (int i = 0; i < 3; ++i) {
    const LongReal n = disc[static_cast<std::size_t>(3 + i)], c = disc[static_cast<std::size_t>(i)];
    away += (c - part(ray.origin, i)) * n;
    towards += part(ray.direction, i) * n;
  }
  const LongReal t = away / towards;
  for (int i = 0; i < 3; ++i) {
    const LongReal d = part(ray.origin, i) + t * part(ray.direction, i) - disc[static_cast<std::size_t>(i)];
    square += d * d;
  }
  return {t, std::sqrt(square)};
}

TEST(Disc, IsHitWhereTheFormulaSaysNearAndFar) {
  Draw draw(271);
  for (int i = 0; i < 20'000; ++i) {
    const R3::Vector n = draw.Scale(-3, 3) * draw.Direction();
    const double radius = draw.Scale(-2, 2);
    const R3::Vector c = draw.Between(0, 3) * draw.Direction();
    const std::vector<double> numbers{c.x, c.y, c.z, n.x, n.y, n.z, radius};
    const auto disc = R3::MakeShape("disc", numbers);
    const R3::Point middle = R3::Point{} + c;
    const R3::Point from = middle + draw.Scale(0, 6) * radius * draw.Direction();
    const R3::Point to = middle + draw.Between(0, 2) * radius * draw.Direction();
    const R3::Ray ray{from, to - from};
    const DiscCrossing truth = PlaneCrossing(ray, numbers);
    const double slant = std::abs(Dot(Unit(n), Unit(ray.direction)));
    if (!(slant > 1e-3)) continue;  // edge on, rounding of the ray itself decides
    const double slack = 1e-12 * (Length(from - middle) + Length(c) + radius) / slant;
    const bool is_inside = truth.from_center < radius - slack && truth.t > 0;
    const bool is_outside = truth.from_center > radius + slack || truth.t < 0;
    const auto hit = disc->Intersect(ray, 0);
    if (is_inside) {
      EXPECT_TRUE(hit);
    }
    if (is_outside) {
      EXPECT_FALSE(hit);
    }
    if (!hit) continue;
    EXPECT_LE(std::abs(hit->t - static_cast<double>(truth.t)) * Length(ray.direction), slack);
    // The position is in the plane, within the bound that it states.
    const R3::Intersection at = disc->At(ray, *hit, 0);
    const R3::Vector unit = Unit(n);
    EXPECT_LE(std::abs(Dot(at.position - middle, unit)), Dot(at.error, Abs(unit)));
    EXPECT_GE(at.uv.x, -1e-9);
    EXPECT_LE(at.uv.y, 1 + 1e-9);
  }
}

TEST(Disc, BoundsTouchIt) {
  Draw draw(314);
  for (int i = 0; i < 1000; ++i) {
    const R3::Vector n = draw.Direction(), e{1, 0, 0};
    const auto disc = R3::MakeShape("disc", {1, 2, 3, n.x, n.y, n.z, 0.5});
    // The direction in the disc that is furthest along x.
    const R3::Vector reach = e - Dot(e, n) * n;
    EXPECT_NEAR(disc->Bounds(0).high.x, 1 + 0.5 * Length(reach), 1e-12);
  }
}

// Straight above its middle, a disc fills the cone of half angle atan(r / h): E = pi r^2 / (r^2 + h^2) of radiance 1.
TEST(Disc, SamplesGiveTheIrradianceOfTheClosedForm) {
  const auto disc = R3::MakeShape("disc", {0, 0, 0, 0, 0, 1, 2});
  for (const double h : {0.5, 2.0, 10.0}) {
    const R3::Point below{0, 0, -h};
    double sum = 0;
    constexpr int side = 200;
    for (int i = 0; i < side * side; ++i) {
      const auto drawn = disc->Sample(below, {(i % side + 0.5) / side, (i / side + 0.5) / side}, 0);
      ASSERT_TRUE(drawn);
      const R3::Vector way = Unit(drawn->at.position - below);
      sum += way.z / drawn->pdf / (side * side);
      EXPECT_NEAR(disc->Pdf(below, drawn->at.position - below, drawn->at.normal, 0) / drawn->pdf, 1, 1e-9);
    }
    EXPECT_NEAR(sum, std::numbers::pi * 4 / (4 + h * h), 2e-3 * sum) << h;
  }
}

TEST(Disc, NeedsANormal) { EXPECT_THROW(R3::MakeShape("disc", {0, 0, 0, 0, 0, 0, 1}), R3::ArgumentError); }

}  // namespace
