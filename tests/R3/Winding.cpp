// Triangles that are wound against their vertex normals: a smooth mesh looks as if its exporter had not mirrored it.
#include "R3/Winding.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>

#include "R3/Mesh.h"
#include "tests/Accelerators.h"

namespace {

using Triangle = std::array<std::uint32_t, 3>;

R3::Vector AreaOf(const R3::MeshData& mesh, const Triangle& t) {
  const R3::Point& p = mesh.positions[t[0]];
  return Cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p);
}

void Turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Makes a closed surface that is completely visible from the origin, with triangles wound outward and radial normals.
R3::MeshData Ball() {
  R3::MeshData ball = accelerators::BumpyBall(12, 8);
  for (Triangle& t : ball.triangles)
    if (Dot(AreaOf(ball, t), FromOrigin(ball.positions[t[0]])) < 0) Turn(t);
  for (const R3::Point& p : ball.positions) ball.normals.push_back(AsNormal(Unit(FromOrigin(p))));
  return ball;
}

/// Returns true if each side of a triangle belongs to exactly one neighbor, traversed the other way.
bool IsClosed(const std::vector<Triangle>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!sides.emplace(t[k], t[(k + 1) % 3]).second) return false;
  return std::ranges::all_of(sides, [&](const auto& side) { return sides.contains({side.second, side.first}); });
}

TEST(Winding, ASmoothMeshInsideOutIsTurnedBack) {
  const R3::MeshData right = Ball();
  R3::MeshData mirrored = right;
  for (Triangle& t : mirrored.triangles) Turn(t);
  const R3::Mesh smooth(mirrored, true), flat(mirrored, false);
  EXPECT_EQ(smooth.Data().triangles, right.triangles);
  EXPECT_EQ(smooth.TurnedTriangles(), static_cast<int>(right.triangles.size()));
  EXPECT_EQ(flat.Data().triangles, mirrored.triangles) << "a flat mesh makes no use of the normals";
  EXPECT_EQ(flat.TurnedTriangles(), 0);
}

TEST(Winding, ARightMeshStaysAsItIs) {
  const R3::Mesh mesh(Ball(), true);
  EXPECT_EQ(mesh.Data().triangles, Ball().triangles);
  EXPECT_EQ(mesh.TurnedTriangles(), 0);
}

TEST(Winding, OneTriangleAmongManyIsTurnedBack) {
  for (const std::size_t stray : {std::size_t{0}, std::size_t{57}, Ball().triangles.size() - 1}) {
    R3::MeshData data = Ball();
    Turn(data.triangles[stray]);
    EXPECT_EQ(R3::TrianglesAgainstNormals(data), std::vector{static_cast<std::uint32_t>(stray)});
  }
}

// Half of a model, mirrored and welded to the other half.
TEST(Winding, PartsOfEqualWindingAreJudgedSeparately) {
  R3::MeshData data = Ball();
  std::vector<std::uint32_t> left;
  for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
    if (data.positions[data.triangles[t][0]].x + data.positions[data.triangles[t][1]].x > 0) continue;
    Turn(data.triangles[t]);
    left.push_back(t);
  }
  ASSERT_GT(left.size(), 50u);
  EXPECT_EQ(R3::TrianglesAgainstNormals(data), left);
}

// In creases, blended normals point behind some triangles of good models. Flipped, they would be holes for code that
// counts how often a ray of light enters and leaves.
TEST(Winding, BackwardNormalsDoNotOpenAClosedSurface) {
  for (const bool is_mirrored : {false, true}) {
    R3::MeshData data = Ball();
    for (const std::uint32_t corner : data.triangles[40]) data.normals[corner] = -data.normals[corner];
    ASSERT_TRUE(IsClosed(data.triangles));
    if (is_mirrored)
      for (Triangle& t : data.triangles) Turn(t);
    const R3::Mesh mesh(data, true);
    EXPECT_EQ(mesh.TurnedTriangles(), is_mirrored ? mesh.Elements() : 0);
    EXPECT_TRUE(IsClosed(mesh.Data().triangles));
  }
}

// Files repeat a position once per normal or texture coordinate; the surface continues there.
TEST(Winding, ASurfaceContinuesAcrossRepeatedPositions) {
  const R3::MeshData whole = Ball();
  R3::MeshData apart;
  for (const Triangle& t : whole.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    apart.triangles.push_back({first, first + 1, first + 2});
    for (const std::uint32_t corner : t) {
      apart.positions.push_back(whole.positions[corner]);
      apart.normals.push_back(whole.normals[corner]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) apart.normals[3 * 40 + k] = -apart.normals[3 * 40 + k];
  EXPECT_EQ(R3::TrianglesAgainstNormals(apart), std::vector<std::uint32_t>{});
}

TEST(Winding, SolidsThatTouchAlongAnEdgeAreTwo) {
  // Tetrahedra on both sides of the edge from corner 0 to corner 1, the second inside out, with alternating triangles.
  R3::MeshData data;
  data.positions = {{0, 0, -1}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  data.triangles = {{0, 1, 2}, {1, 0, 5}, {1, 0, 3}, {0, 1, 4}, {0, 2, 3}, {0, 4, 5}, {1, 3, 2}, {1, 5, 4}};
  const std::vector<R3::Point> positions = std::exchange(data.positions, {});
  for (std::size_t t = 0; t < data.triangles.size(); ++t)
    for (std::uint32_t& corner : data.triangles[t]) {
      data.positions.push_back(positions[corner]);
      data.normals.push_back(AsNormal(Unit(positions[corner] - R3::Point{t % 2 == 0 ? 0.5 : -0.5, 0, 0})));
      corner = static_cast<std::uint32_t>(data.positions.size() - 1);
    }
  EXPECT_EQ(R3::TrianglesAgainstNormals(data), (std::vector<std::uint32_t>{1, 3, 5, 7}));
}

TEST(Winding, ZeroNormalsAreIgnored) {
  R3::MeshData data = Ball();
  for (Triangle& t : data.triangles) Turn(t);
  for (R3::Normal& normal : data.normals) normal = {};
  EXPECT_EQ(R3::TrianglesAgainstNormals(data), std::vector<std::uint32_t>{});
}

TEST(Winding, SizesBeyondTheRangeOfSquaresAreJudgedEqually) {
  for (const double scale : {1e-300, 1e-150, 1e150}) {
    R3::MeshData data = Ball();
    for (Triangle& t : data.triangles) Turn(t);
    for (R3::Point& p : data.positions) p = R3::Point{} + scale * FromOrigin(p);
    EXPECT_EQ(R3::TrianglesAgainstNormals(data).size(), data.triangles.size()) << scale;
  }
}

TEST(Winding, DroppedTrianglesDoNotShiftTheFirstTurnedLine) {
  R3::MeshData data = Ball();
  data.triangles.insert(data.triangles.begin(), {0, 0, 1});
  for (std::uint32_t i = 0; i < data.triangles.size(); ++i) data.lines.push_back(100 + i);
  Turn(data.triangles[8]);
  const R3::Mesh mesh(data, true);
  EXPECT_EQ(mesh.DroppedTriangles(), 1);
  EXPECT_EQ(mesh.TurnedTriangles(), 1);
  EXPECT_EQ(mesh.FirstTurnedLine(), 108u);
}

}  // namespace
