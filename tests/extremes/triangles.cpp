// Triangles of any shape, alone: slivers, grazed planes, rays beside an edge. Oracle: the plane and the distances of
// two lines, in 113 bits. If this fails, meshes get wrong outlines, or dots along their edges.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "R3/Mesh.h"
#include "tests/Draw.h"
#include "tests/ExactTriangle.h"

namespace {

using R3::unit_roundoff;

struct Triangle {
  std::array<R3::Point, 3> corners;

  std::unique_ptr<const R3::Mesh> Make() const {
    R3::MeshData data;
    data.positions.assign(corners.begin(), corners.end());
    data.triangles = {{0, 1, 2}};
    return std::make_unique<R3::Mesh>(std::move(data));
  }
  double Size() const {
    return std::max(
        {Length(corners[1] - corners[0]), Length(corners[2] - corners[1]), Length(corners[0] - corners[2])});
  }
};

oracle::TriangleCrossing Truth(const Triangle& triangle, const R3::Ray& ray) {
  const auto& c = triangle.corners;
  return {{oracle::Of(c[0]), oracle::Of(c[1]), oracle::Of(c[2])}, oracle::Of(ray)};
}

/// Outside a band of `roundings` u (distance + size) around its outline a triangle is hit exactly when it should be,
/// and where it should be.
void Check(const Triangle& triangle, const R3::Mesh& mesh, const R3::Ray& ray, double roundings) {
  const double reach = Length(ray.origin - triangle.corners[0]) + triangle.Size();
  const Quad band = Quad(roundings * unit_roundoff) * reach;
  const oracle::TriangleCrossing truth = Truth(triangle, ray);
  const auto hit = mesh.Intersect(ray, 0);
  const auto story = [&] {
    std::string text = "corners";
    for (const R3::Point& p : triangle.corners)
      for (const double x : {p.x, p.y, p.z}) {
        std::array<char, 40> number{};
        std::snprintf(number.data(), number.size(), " %a", x);
        text += number.data();
      }
    return text + ": " + oracle::Hex(ray);
  };
  if (!(truth.cosine > 0)) return;
  const Quad t_band = band / (truth.cosine * oracle::Length(oracle::Of(ray.direction)));
  if (truth.inside > band && truth.t > t_band) {
    EXPECT_TRUE(hit) << "a hole: " << story();
  }
  if (truth.inside < -band || truth.t < -t_band) {
    EXPECT_FALSE(hit) << "hit, but the ray passes by: " << story();
  }
  if (hit) {
    EXPECT_LE(oracle::Double(oracle::Abs(Quad(hit->t) - truth.t) / t_band), 1) << "off the plane: " << story();
  }
}

/// A ray from `distance` sizes away to near the triangle: to its inside, to an edge, or to a corner.
R3::Ray RayNear(Draw& draw, const Triangle& triangle, double distance) {
  double v = draw.Between(0, 1), w = draw.Between(0, 1);
  if (v + w > 1) v = 1 - v, w = 1 - w;
  if (draw.Whole(0, 2) == 0) w = 0;
  const auto& c = triangle.corners;
  const R3::Point target = c[0] + v * (c[1] - c[0]) + w * (c[2] - c[0]);
  const R3::Point origin = target + distance * triangle.Size() * draw.Direction();
  return {origin, draw.Scale(-3, 3) * (target - origin)};
}

TEST(Extremes, D6_SliversAreHitAndHaveAccurateNormals) {
  Draw draw(406);
  for (int k = 0; k <= 16; ++k)
    for (int i = 0; i < Count(200, 20'000); ++i) {
      // A base of length 1 in any direction and a height of 10^-k of it.
      const R3::Point a = R3::Point{} + draw.Between(0, 2) * draw.Direction();
      const R3::Vector base = draw.Direction(), up = Unit(Cross(base, draw.Direction()));
      const double height = std::pow(10, -k);
      const Triangle sliver{{a, a + base, a + (draw.Between(-0.2, 1.2) * base + height * up)}};
      const auto mesh = sliver.Make();
      if (mesh->Elements() == 0) continue;  // no area is left after rounding
      for (int n = 0; n < 10; ++n) Check(sliver, *mesh, RayNear(draw, sliver, draw.Scale(-2, 4)), 8);

      const R3::Ray straight{a + 5 * Cross(base, up), -Cross(base, up)};
      const R3::Normal normal = mesh->At(straight, {}, 0).normal;
      EXPECT_NEAR(Length(AsVector(normal)), 1, 4 * unit_roundoff);
      // The corners' own rounding is given; what the program adds is that of the edges it takes between them.
      const auto& c = sliver.corners;
      const auto n = oracle::Cross(oracle::Of(c[1]) - oracle::Of(c[0]), oracle::Of(c[2]) - oracle::Of(c[0]));
      const auto off = oracle::Of(AsVector(normal)) - 1 / oracle::Length(n) * n;
      const double narrow = oracle::Double(oracle::Length(n));  // height over a base of about 1
      EXPECT_LE(oracle::Double(oracle::Length(off)), 8 * unit_roundoff * (1 + 2 / narrow)) << "height 1e-" << k;
    }
}

TEST(Extremes, B8_AlmostParallelRaysHitAPlaneAccurately) {
  Draw draw(407);
  // A floor in no special position, seen at angles down to 1e-16 from a place whose distance is about its size.
  const R3::Vector n = draw.Direction(), along = Unit(Cross(n, draw.Direction())), across = Cross(n, along);
  const R3::Point center{0.25, -0.5, 0.125};
  const Triangle floor{
      {center + 1000 * along, center + -800 * along + 600 * across, center + -500 * along + -900 * across}};
  const auto mesh = floor.Make();
  int hits = 0;
  for (int power = 1; power <= 16; ++power)
    for (int i = 0; i < Count(500, 50'000); ++i) {
      const double turn = draw.Between(0, 6.28), angle = std::pow(10, -power);
      const R3::Vector d = std::cos(turn) * along + std::sin(turn) * across - angle * n;
      const R3::Ray ray{center - 1000 * d, d};
      const oracle::TriangleCrossing truth = Truth(floor, ray);
      const auto hit = mesh->Intersect(ray, 0);
      if (!hit) {
        EXPECT_LT(oracle::Double(truth.cosine), 1e-12) << "a hole: " << oracle::Hex(ray);
        continue;
      }
      ++hits;
      const Quad bar = Quad(4 * unit_roundoff) / truth.cosine;
      EXPECT_LE(oracle::Double(oracle::Abs(Quad(hit->t) / truth.t - 1) / bar), 1) << oracle::Hex(ray);
    }
  EXPECT_GT(hits, 16 * Count(500, 50'000) / 2);
}

TEST(Extremes, B8_RaysParallelToOrInAPlaneMissIt) {
  const Triangle floor{{R3::Point{-1, 0, -1}, {1, 0, -1}, {0, 0, 2}}};
  const auto mesh = floor.Make();
  for (const double y : {0.0, 1e-300, 1e-9, 1.0})
    for (const R3::Vector& d : {R3::Vector{0, 0, 1}, {1, 0, 0}, {0.6, 0, -0.8}})
      EXPECT_FALSE(mesh->Intersect({R3::Point{0, y, 0} - 3 * d, d}, 0)) << y;
}

}  // namespace
