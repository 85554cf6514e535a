// Closed meshes let nothing through: rays from inside aimed exactly at edges and at corners.

#include <gtest/gtest.h>

#include <numbers>

#include "R3/Mesh.h"
#include "R3/Transform.h"
#include "tests/Draw.h"
#include "tests/Quad.h"
#include "tests/extremes/Placements.h"

namespace {

/// A bumpy ball of `around` x `rings` quads split in two, with poles of valence `around`, and on every tenth triangle a
/// corner of valence 3 in its middle.
R3::MeshData BumpyBall(int around, int rings) {
  R3::MeshData data;
  const auto place = [&](double theta, double phi) {
    const double r = 1 + 0.2 * std::sin(5 * theta) * std::sin(4 * phi);
    return R3::Point{r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi)};
  };
  data.positions = {place(0, 0), place(std::numbers::pi, 0)};
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j)
      data.positions.push_back(place(std::numbers::pi * i / rings, 2 * std::numbers::pi * j / around));
  const auto at = [&](int i, int j) -> std::uint32_t {
    return i == 0 ? 0 : i == rings ? 1 : static_cast<std::uint32_t>(2 + (i - 1) * around + j % around);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (data.triangles.size() % 10 != 9) {
      data.triangles.push_back({a, b, c});
      return;
    }
    const auto middle = static_cast<std::uint32_t>(data.positions.size());
    const R3::Vector sum =
        FromOrigin(data.positions[a]) + FromOrigin(data.positions[b]) + FromOrigin(data.positions[c]);
    data.positions.push_back(R3::Point{} + sum / 3);
    data.triangles.push_back({a, b, middle});
    data.triangles.push_back({b, c, middle});
    data.triangles.push_back({c, a, middle});
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      if (i > 0) add(at(i, j), at(i, j + 1), at(i + 1, j));
      if (i < rings - 1) add(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
  return data;
}

bool IsHit(const R3::Mesh& mesh, const R3::Ray& ray) {
  for (int e = 0; e < mesh.Elements(); ++e)
    if (mesh.Intersect(ray, e)) return true;
  return false;
}

/// Rays from around `inside`, half aimed at random points of edges, half at corners; counts those that find no way out.
void ExpectNoLeaks(const R3::Mesh& mesh, const R3::Matrix& matrix, Draw& draw, int rays) {
  const auto& data = mesh.Data();
  for (int i = 0; i < rays; ++i) {
    const R3::Point origin = matrix * (R3::Point{} + 0.3 * draw.Between(0, 1) * draw.Direction());
    const auto& t = data.triangles[static_cast<std::size_t>(draw.Whole(0, mesh.Elements() - 1))];
    const R3::Point a = data.positions[t[0]], b = data.positions[t[1]];
    const R3::Point target = i % 2 ? a : a + draw.Between(0, 1) * (b - a);
    const R3::Ray ray{origin, target - origin};
    EXPECT_TRUE(IsHit(mesh, ray)) << "leak: " << oracle::Hex(ray);
  }
}

TEST(Extremes, D1_D2_NoRayLeavesAMeshThroughEdgesOrCorners) {
  const R3::Matrix identity;
  Draw draw(401);
  const R3::Mesh coarse(BumpyBall(12, 8));
  ExpectNoLeaks(coarse, identity, draw, Count(60'000, 10'000'000));
  const R3::Mesh fine_poles(BumpyBall(200, 4));  // corners of valence 200
  ExpectNoLeaks(fine_poles, identity, draw, Count(6'000, 1'000'000));
}

TEST(Extremes, D3_NoRayLeavesAMeshUnderExtremeTransforms) {
  Draw draw(402);
  for (const R3::Matrix& m : HardPlacements(draw))
    ExpectNoLeaks(R3::Mesh(Moved(BumpyBall(12, 8), m)), m, draw, Count(4'000, 1'000'000));
}

TEST(Extremes, D5_TrianglesWithoutAreaAreDroppedAndTheirNeighborsStayClosed) {
  R3::MeshData data = BumpyBall(12, 8);
  const auto real = data.triangles.size();
  // Two equal corners, three equal, and three on a line that doubles can hold exactly.
  const auto first = data.triangles.front();
  data.triangles.insert(data.triangles.begin() + 5, {first[0], first[1], first[1]});
  data.triangles.push_back({first[2], first[2], first[2]});
  const auto n = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(),
                        {R3::Point{0, 0, 0}, R3::Point{0.25, 0.5, 0.125}, R3::Point{0.75, 1.5, 0.375}});
  data.triangles.push_back({n, n + 1, n + 2});
  const R3::Mesh mesh(std::move(data));
  EXPECT_EQ(mesh.DroppedTriangles(), 3);
  EXPECT_EQ(static_cast<std::size_t>(mesh.Elements()), real);
  Draw draw(405);
  ExpectNoLeaks(mesh, {}, draw, 4'000);
  for (int e = 0; e < mesh.Elements(); ++e) {
    const auto c = mesh.Corners(e);
    const R3::Point middle = R3::Point{} + (FromOrigin(c[0]) + FromOrigin(c[1]) + FromOrigin(c[2])) / 3;
    const R3::Ray ray{{}, middle - R3::Point{}};
    const auto hit = mesh.Intersect(ray, e);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(Length(AsVector(mesh.At(ray, *hit, e).normal)), 1, 4 * R3::unit_roundoff);
  }
}

TEST(Mesh, BlendsNormalsOnlyWhenAskedAndPresent) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}};
  data.normals = {{0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, 0.5}};
  const R3::Ray ray{{0.2, 0.2, 5}, {0, 0, -1}};
  const auto shading = [&](const R3::MeshData& d, bool smooth) {
    const R3::Mesh mesh(d, smooth);
    return mesh.At(ray, *mesh.Intersect(ray, 0), 0).shading_normal;
  };
  EXPECT_EQ(shading(data, false), (R3::Normal{0, 0, 1}));
  EXPECT_NEAR(shading(data, true).x, std::sqrt(0.5), 1e-15);
  data.normals = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(shading(data, true), (R3::Normal{0, 0, 1}));
}

}  // namespace
