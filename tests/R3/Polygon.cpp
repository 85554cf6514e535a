// Faces with any number of corners, split into triangles.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "R3/Polygon.h"
#include "tests/source/parse/ReadMesh.h"

namespace ray {
namespace {

ReadMesh Read(const std::string& name, std::string bytes) { return MeshOfBytes(name, std::move(bytes)); }

double AreaOf(const R3::Cuts& cuts, std::span<const R3::Point> polygon) {
  double area = 0;
  for (const auto& t : cuts) {
    const double twice = Cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]).z;
    EXPECT_GE(twice, 0);  // none is flipped
    area += twice / 2;
  }
  return area;
}

TEST(Extremes, D9_TrianglesCoverAConcaveFaceOnce) {
  // A fan from the first corner would cover area outside each of them.
  const std::vector<R3::Point> arrow{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.9, 0.1, 0}};
  EXPECT_NEAR(AreaOf(*R3::Triangulate(arrow), arrow), 0.2, 1e-12);
  const std::vector<R3::Point> comb{{0, 0, 0}, {5, 0, 0}, {5, 2, 0}, {4, 2, 0}, {4, 1, 0}, {3, 1, 0},
                                    {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  EXPECT_NEAR(AreaOf(*R3::Triangulate(comb), comb), 8, 1e-12);
  EXPECT_EQ(R3::Triangulate(comb)->size(), comb.size() - 2);
}

double Shoelace(std::span<const R3::Point> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const R3::Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

/// Makes counter-clockwise polygons of n corners: a comb with teeth of different lengths, a star, and a strip that
/// spirals to the middle and is as wide as the gaps between its turns.
std::vector<std::vector<R3::Point>> ConcavePolygons(int n) {
  std::vector<R3::Point> comb{{0, -9, 0}, {n - 1.0, -9, 0}}, star, spiral;
  for (int i = n - 3; i >= 0; --i) comb.push_back({i + 0.5, i % 2 ? 0 : 5.0 + i * 37 % 101, 0});
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n, radius = i % 2 ? 1 : 5 + i * 37 % 101;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  const auto wound = [](double t, double radius) { return R3::Point{radius * std::cos(t), radius * std::sin(t), 0}; };
  for (int i = 0; i < n / 2; ++i) spiral.push_back(wound(0.05 * i, 10 + 0.05 * i));
  for (int i = n / 2; i-- > 0;) spiral.push_back(wound(0.05 * i, 10 + 0.05 * i - 3.14159));
  if (Shoelace(spiral) < 0) std::ranges::reverse(spiral);
  return {comb, star, spiral};
}

TEST(Extremes, D9_TrianglesCoverAConcaveFaceOf5000CornersOnce) {
  for (const int n : {300, 5000})
    for (const auto& polygon : ConcavePolygons(n)) {
      const auto cuts = R3::Triangulate(polygon);
      ASSERT_TRUE(cuts);
      EXPECT_EQ(cuts->size(), polygon.size() - 2);
      const double area = Shoelace(polygon);
      EXPECT_NEAR(AreaOf(*cuts, polygon), area, 1e-9 * area);
    }
}

/// Returns the area of all triangles, whichever way they turn.
double AreaOf(const R3::MeshData& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const R3::Point &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    area += Length(Cross(b - a, c - a)) / 2;
  }
  return area;
}

TEST(Extremes, D9_AFaceWhoseSidesCrossIsCutWhereTheyDo) {
  // A bow tie in any plane, its halves of the same size and of different ones, and a star of five points.
  EXPECT_NEAR(AreaOf(Read("a.off", "OFF 4 1 0 0 0 0 1 1 0 1 0 0 0 1 0 4 0 1 2 3").data), 0.5, 1e-12);
  EXPECT_NEAR(AreaOf(Read("a.off", "OFF 4 1 0 0 0 0 0 1 1 0 1 0 0 0 1 4 0 1 2 3").data), 0.5, 1e-12);
  EXPECT_NEAR(AreaOf(Read("a.off", "OFF 4 1 0 0 0 0 3 3 0 3 0 0 0 1 0 4 0 1 2 3").data), 3 * 2.25 / 2 + 0.75 / 2,
              1e-12);
  std::string star = "OFF 5 1 0\n";
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * 2 * i / 5;
    star += std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
  }
  // It goes around the pentagon in its middle twice, which may be covered twice.
  const double inner = 1 / std::pow((1 + std::sqrt(5)) / 2, 2), once = 5 * inner * std::sin(0.2 * std::numbers::pi),
               pentagon = 2.5 * inner * inner * std::sin(0.4 * std::numbers::pi);
  const double area = AreaOf(Read("a.off", star + "5 0 1 2 3 4").data);
  EXPECT_LT(std::min(std::abs(area - once), std::abs(area - once - pentagon)), 1e-5) << area;
}

// Each of them would be a separate vertex.
TEST(Extremes, D9_SidesThatCrossTooOftenAreNotCut) {
  constexpr int n = 101;
  std::string off = "OFF 101 1 0\n", face = "101";
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i * (n / 2) / n;
    off += std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i);
  }
  const R3::MeshData mesh = Read("a.off", off + face).data;
  EXPECT_EQ(mesh.positions.size(), 101u);
  EXPECT_EQ(mesh.triangles.size(), 99u);
}

TEST(Extremes, D9_CrossingVerticesInterpolateEveryAttribute) {
  const auto expect_middle = [](const char* name, const std::string& text, std::size_t vertices) {
    const R3::MeshData mesh = Read(name, text).data;
    ASSERT_EQ(mesh.positions.size(), vertices) << text;
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.back(), (R3::Point{0.5, 0.5, 0}));
    EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.back() == (R2::Point{0.5, 0.25}));
    EXPECT_TRUE(mesh.normals.empty() || mesh.normals.back().z == 0.5);
    EXPECT_TRUE(mesh.colors.empty() || mesh.colors.back() == (std::array<float, 3>{0.5f, 0.5f, 0}));
  };
  const std::string obj = "v 0 0 0 0 0 0\nv 1 1 0 1 1 0\nv 1 0 0 1 0 0\nv 0 1 0 0 1 0\n";
  expect_middle("a.obj", obj + "f 1 2 3 4\n", 5);
  expect_middle("a.obj", obj + "vt 0 0\nvt 1 .5\nvt 1 0\nvt 0 .5\nvn 0 0 0\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/2 4/4/1\n", 5);
  expect_middle("a.off", "COFF 4 1 0\n0 0 0 0 0 0 1\n1 1 0 1. 1 0 1\n1 0 0 1. 0 0 1\n0 1 0 0 1. 0 1\n4 0 1 2 3\n", 5);
  const std::string
      ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
      face = "element face 1\nproperty list uchar int vertex_indices\n";
  expect_middle("a.ply",
                ply + "property float s\nproperty float t\n" + face +
                    "end_header\n0 0 0 0 0\n1 1 0 1 .5\n1 0 0 1 0\n0 1 0 0 .5\n4 0 1 2 3\n",
                5);
  expect_middle(
      "a.ply",
      ply + face +
          "property list uchar float texcoord\nend_header\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3 8 0 0 1 .5 1 0 0 .5\n",
      5);
}

TEST(Extremes, D9_SlowFacesAreCutAsFansWithAWarning) {
  // Crosses itself so often that hardly any corner is an ear.
  constexpr int n = 20'001;
  std::string off = "OFF " + std::to_string(n) + " 1 0\n", face = std::to_string(n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i * (n / 2) / n;
    off += std::to_string(std::cos(angle) * 1e6) + " " + std::to_string(std::sin(angle) * 1e6) + " 0\n";
    face += " " + std::to_string(i);
  }
  const auto read = Read("a.off", off + face);
  EXPECT_EQ(read.data.triangles.size(), n - 2u);
  EXPECT_EQ(
      read.warnings,
      (std::vector<std::string>{"a.off: warning: concave faces with very many corners, triangulated as if convex: 1"}));
}

TEST(Extremes, D9_EdgesOfAFaceStayEdgesOfItsTriangles) {
  // Faces that met along an edge still do, so a closed mesh stays closed. The third polygon crosses itself, the fourth
  // repeats a corner, the fifth is not flat, the last has no area at all.
  const std::vector<std::vector<R3::Point>> polygons{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.9, 0.1, 0}},
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}},
      {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 1, 0}},
      {{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}},
      {{0, 0, 1}, {2, 0, -1}, {2, 2, 1}, {1, 0.5, -3}, {0, 2, 0}},
      {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}},
  };
  for (const auto& polygon : polygons) {
    const auto n = static_cast<std::uint32_t>(polygon.size());
    const auto cuts = R3::Triangulate(polygon);
    ASSERT_TRUE(cuts);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;  // directed; those inside cancel
    for (const auto& t : *cuts)
      for (std::size_t i = 0; i < 3; ++i) {
        ++edges[{t[i], t[(i + 1) % 3]}];
        --edges[{t[(i + 1) % 3], t[i]}];
      }
    for (const auto& [edge, count] : edges) {
      const bool is_side = (edge.first + 1) % n == edge.second, is_side_back = (edge.second + 1) % n == edge.first;
      EXPECT_EQ(count, is_side ? 1 : is_side_back ? -1 : 0);
    }
  }
}

TEST(Extremes, D9_ConvexFacesAreFansFromTheirFirstCorner) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool reversed : {false, true}) {
      std::vector<R3::Point> square;
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const double x = reversed ? b : a, y = reversed ? a : b;
        square.push_back(axis == 0 ? R3::Point{5, x, y} : axis == 1 ? R3::Point{x, 5, y} : R3::Point{x, y, 5});
      }
      EXPECT_EQ(*R3::Triangulate(square), (R3::Cuts{{0, 1, 2}, {0, 2, 3}}));
    }
}

}  // namespace
}  // namespace ray
