// Bicubic patches, compared with surfaces that are known otherwise.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "tests/Draw.h"

namespace {

using Corners = std::array<R3::Point, 16>;

std::unique_ptr<const R3::Shape> Patch(const Corners& corners) {
  std::vector<double> numbers;
  for (const R3::Point& p : corners) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return R3::MakeShape("bezier", numbers);
}

/// Makes control points over a square grid: heights(i, j) at x = 3 times the share along a row, z along the rows.
template <typename Height>
Corners Over(const Height& height) {
  Corners corners;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) corners[static_cast<std::size_t>(4 * j + i)] = {i * 1.0, height(i, j), 3.0 - j};
  return corners;
}

int CountHits(const R3::Shape& shape, R3::Ray ray) {
  int count = 0;
  while (const auto hit = shape.Intersect(ray, 0)) ++count, ray.t_min = hit->t;
  return count;
}

TEST(Bezier, OverAGridItIsTheCubicOfItsHeights) {
  // With x = 3 u and z = 3 - 3 v, the height is the blend of heights by Bernstein's polynomials.
  Draw draw(81);
  for (int n = 0; n < 50; ++n) {
    std::array<std::array<double, 4>, 4> heights;
    for (auto& row : heights)
      for (double& h : row) h = draw.Between(-2, 2);
    const auto patch =
        Patch(Over([&](int i, int j) { return heights[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]; }));
    for (int k = 0; k < 100; ++k) {
      const double u = draw.Between(0, 1), v = draw.Between(0, 1);
      const R3::Ray ray{{3 * u, 10, 3 - 3 * v}, {0, -1, 0}};
      const auto hit = patch->Intersect(ray, 0);
      ASSERT_TRUE(hit);
      long double height = 0;
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
          const auto weight = [](long double x, int index) {
            constexpr std::array<int, 4> choose{1, 3, 3, 1};
            return choose[static_cast<std::size_t>(index)] * std::pow(x, index) * std::pow(1 - x, 3 - index);
          };
          height += weight(u, i) * weight(v, j) * heights[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
        }
      EXPECT_NEAR(hit->t, static_cast<double>(10 - height), 1e-14);
      EXPECT_NEAR(hit->u, u, 1e-14);
      EXPECT_NEAR(hit->v, v, 1e-14);
    }
  }
}

TEST(Bezier, RaysFindTheUvOfPointsOnCurvedPatches) {
  // Where u and v are nonlinear functions of the position, one step of Newton's method is not enough.
  Draw draw(82);
  int judged = 0;
  for (int n = 0; n < 40; ++n) {
    Corners corners = Over([&](int, int) { return draw.Between(-1, 1); });
    for (R3::Point& p : corners) p.x += draw.Between(-0.4, 0.4), p.z += draw.Between(-0.4, 0.4);
    const auto patch = Patch(corners);
    for (int k = 0; k < 50; ++k) {
      const double u = draw.Between(0, 1), v = draw.Between(0, 1);
      const R3::Intersection at = patch->At({}, {0, u, v, 0}, 0);
      const R3::Vector direction = draw.Direction();
      if (std::abs(Dot(at.normal, direction)) < 0.3) continue;
      ++judged;
      double nearest = R3::infinity;
      R3::Ray ray{at.position - 2 * direction, direction};
      while (const auto hit = patch->Intersect(ray, 0)) {
        nearest = std::min(nearest, std::abs(hit->u - u) + std::abs(hit->v - v));
        ray.t_min = hit->t;
      }
      // The ray passes within 10^-15 of the point, and the patch is 3 wide; slopes differ by a factor of some ten.
      EXPECT_LE(nearest, 2e-14) << n << ' ' << k;
    }
  }
  EXPECT_GT(judged, 1000);
}

TEST(Bezier, WithoutCurvatureItIsHitAsItsTwoTrianglesAre) {
  const auto patch = Patch(Over([](int i, int j) { return 0.3 * i - 0.2 * j; }));
  const auto at = [](double x, double z) { return R3::Point{x, 0.3 * x - 0.2 * (3 - z), z}; };
  R3::MeshData data;
  data.positions = {at(0, 3), at(3, 3), at(3, 0), at(0, 0)};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  const R3::Mesh mesh(std::move(data));
  Draw draw(83);
  for (int i = 0; i < 10'000; ++i) {
    const R3::Point origin = R3::Point{1.5, 0, 1.5} + 5 * draw.Direction();
    const R3::Ray ray{origin,
                      R3::Point{draw.Between(-0.5, 3.5), draw.Between(-1, 1), draw.Between(-0.5, 3.5)} - origin};
    auto expected = mesh.Intersect(ray, 0);
    if (!expected) expected = mesh.Intersect(ray, 1);
    const auto hit = patch->Intersect(ray, 0);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
    if (!hit) continue;
    EXPECT_NEAR(hit->t, expected->t, 1e-12);
    EXPECT_NEAR(Dot(patch->At(ray, *hit, 0).normal, AsVector(mesh.At(ray, *expected, 0).normal)), 1, 1e-12);
  }
}

TEST(Bezier, AllCrossingsAreFoundInOrder) {
  // A wave along x whose height is the cubic with control values 0, 3, -3, 0: 9 u (1 - u) (1 - 2 u). A level line
  // across it meets it at the corresponding roots.
  const auto wave = Patch(Over([](int i, int) { return i == 1 ? 3.0 : i == 2 ? -3.0 : 0.0; }));
  EXPECT_EQ(CountHits(*wave, {{-1, 0.5, 1.234}, {1, 0, 0}}), 2);
  EXPECT_EQ(CountHits(*wave, {{-1, 0.86, 1.234}, {1, 0, 0}}), 2);
  EXPECT_EQ(CountHits(*wave, {{-1, 0.87, 1.234}, {1, 0, 0}}), 0);  // the crest is at sqrt(3) / 2 = 0.866
  // The line y = 0.4 (x - 1.5) through the middle meets it only there: 9 u (1 - u) (1 - 2 u) = -0.6 (1 - 2 u) has no
  // other root within the patch. A falling line meets it twice more, at 9 u (1 - u) = 0.6.
  EXPECT_EQ(CountHits(*wave, {{-1.5, -1.2, 0.777}, {3, 1.2, 0}}), 1);
  EXPECT_EQ(CountHits(*wave, {{-1.5, 1.2, 0.777}, {3, -1.2, 0}}), 3);
}

TEST(Bezier, PatchesWithACommonEdgeLeaveNoGap) {
  Draw draw(87);
  Corners left, right;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 7; ++i) {
      const R3::Point p{1.0 * static_cast<double>(i) + draw.Between(-0.3, 0.3), draw.Between(-1, 1),
                        3 - static_cast<double>(j) + draw.Between(-0.3, 0.3)};
      if (i < 4) left[4 * j + i] = p;
      if (i >= 3) right[4 * j + i - 3] = p;
    }
  const auto a = Patch(left), b = Patch(right);
  int through = 0;
  for (int i = 0; i < Count(20'000, 1'000'000); ++i) {
    const double v = draw.Between(0.001, 0.999);
    const R3::Point on_edge = a->At({}, {0, 1, v, 0}, 0).position;
    const R3::Vector direction = R3::Unit({draw.Between(-0.5, 0.5), -1, draw.Between(-0.5, 0.5)});
    const R3::Ray ray{on_edge - draw.Scale(0, 2) * direction, direction};
    through += !a->Intersect(ray, 0) && !b->Intersect(ray, 0);
  }
  EXPECT_EQ(through, 0);
}

TEST(Bezier, ADegenerateCornerHasANormalAndNoHole) {
  // The first row is one point, as in the lid of the teapot.
  Corners corners = Over([](int i, int j) { return 0.2 * (i - 1.5) * (i - 1.5) - 0.4 * j; });
  for (std::size_t i = 0; i < 4; ++i) corners[i] = {1.5, 1, 3};
  const auto patch = Patch(corners);
  Draw draw(89);
  for (int i = 0; i < 5000; ++i) {
    const double u = draw.Between(0, 1), v = draw.Scale(-9, -0.01);
    const R3::Point on_patch = patch->At({}, {0, u, v, 0}, 0).position;
    const R3::Vector direction = R3::Unit({draw.Between(-0.3, 0.3), -1, draw.Between(-0.3, 0.3)});
    const R3::Ray ray{on_patch - 3 * direction, direction};
    // Around the corner it is a cone, which the ray may meet before. Within 10^-6 of it nothing is proven.
    double nearest = R3::infinity;
    R3::Ray rest = ray;
    while (const auto hit = patch->Intersect(rest, 0)) {
      nearest = std::min(nearest, std::abs(hit->t - 3));
      EXPECT_NEAR(Length(AsVector(patch->At(ray, *hit, 0).normal)), 1, 1e-12);
      rest.t_min = hit->t;
    }
    EXPECT_LE(nearest, v > 1e-6 ? 1e-13 : 2e-6) << u << ' ' << v;
  }
  const R3::Normal at_corner = patch->At({}, {0, 0.3, 0, 0}, 0).normal;
  EXPECT_NEAR(Length(AsVector(at_corner)), 1, 1e-12);
  EXPECT_GT(at_corner.y, 0.5);
}

TEST(Bezier, ARayThatLiesInItEnds) {
  const auto flat = Patch(Over([](int, int) { return 0.0; }));
  EXPECT_LE(CountHits(*flat, {{-1, 0, 1.3}, {1, 0, 0.1}}), 2'000);
}

TEST(Bezier, TangentsAreThoseOfFiniteDifferences) {
  Draw draw(91);
  const auto* kind = R3::FindShapeKind("bezier");
  const auto patch = kind->make(kind->example);
  for (int i = 0; i < 1000; ++i) {
    const double u = draw.Between(0.01, 0.99), v = draw.Between(0.01, 0.99), step = 1e-6;
    const auto at = [&](double a, double b) { return patch->At({}, {0, a, b, 0}, 0).position; };
    const R3::UvTangents uv = patch->UvTangentsAt({}, {0, u, v, 0}, 0);
    EXPECT_LE(Length(uv.first - (at(u + step, v) - at(u - step, v)) / (2 * step)), 1e-8);
    EXPECT_LE(Length(uv.second - (at(u, v + step) - at(u, v - step)) / (2 * step)), 1e-8);
  }
}

}  // namespace
