#include "source/parse/meshes/SmoothNormals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "R3/Mesh.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

R3::MeshData Cube(bool shares_vertices) {
  R3::MeshData data;
  for (int i = 0; i < 8; ++i) data.positions.push_back({i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  data.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  if (shares_vertices) return data;
  R3::MeshData split;  // as in STL
  for (const auto& t : data.triangles) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    for (const std::uint32_t i : t) split.positions.push_back(data.positions[i]);
    split.triangles.push_back({first, first + 1, first + 2});
  }
  return split;
}

void ExpectNear(const R3::Normal& a, const R3::Vector& b) {
  EXPECT_NEAR(a.x, b.x, 1e-14);
  EXPECT_NEAR(a.y, b.y, 1e-14);
  EXPECT_NEAR(a.z, b.z, 1e-14);
}

// Three sides meet at a corner of a cube, some of them in two triangles: each counts by its angle, so that the normal
// is the diagonal.
TEST(SmoothNormals, OfACubeAreDiagonalOnlyAboveNinetyDegrees) {
  for (const bool shares_vertices : {true, false}) {
    R3::MeshData round = Cube(shares_vertices);
    SmoothByAngle(round, 91);
    EXPECT_EQ(round.positions.size(), shares_vertices ? 8u : 36u);
    ASSERT_EQ(round.normals.size(), round.positions.size());
    for (std::size_t i = 0; i < round.positions.size(); ++i)
      ExpectNear(round.normals[i], Unit(FromOrigin(round.positions[i])));
    R3::MeshData edged = Cube(shares_vertices);
    SmoothByAngle(edged, 89);
    ASSERT_EQ(edged.triangles.size(), 12u);
    for (const auto& t : edged.triangles) {
      const auto p = [&](std::size_t k) { return edged.positions[t[k]]; };
      const R3::Vector side = Unit(Cross(p(1) - p(0), p(2) - p(0)));
      for (const std::uint32_t i : t) ExpectNear(edged.normals[i], side);
    }
    EXPECT_EQ(edged.positions.size(), shares_vertices ? 24u : 36u) << "each corner has three normals";
  }
}

TEST(SmoothNormals, AreThoseThatTrimeshMakes) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {2, 0, .5}, {.3, 1.5, 0}, {.4, .2, 1.8}, {1.7, 1.2, .9}, {-.8, .9, .6}};
  data.triangles = {{0, 2, 1}, {1, 2, 4}, {0, 1, 3}, {1, 4, 3}, {2, 5, 4}, {4, 5, 3}, {0, 5, 2}, {0, 3, 5}};
  SmoothByAngle(data, 180);
  // trimesh 5.2: Trimesh(...).vertex_normals
  const R3::Vector expected[] = {{-0.35143788, -0.68579356, -0.63732143}, {0.83673788, -0.5076235, -0.20539741},
                                 {-0.10197389, 0.82968237, -0.54884287},  {-0.1912157, -0.2927237, 0.9368828},
                                 {0.68904942, 0.68389066, 0.23980087},    {-0.96302446, 0.25784371, 0.07810575}};
  ASSERT_EQ(data.normals.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(data.normals[i].x, expected[i].x, 1e-8);
    EXPECT_NEAR(data.normals[i].y, expected[i].y, 1e-8);
    EXPECT_NEAR(data.normals[i].z, expected[i].z, 1e-8);
  }
}

TEST(SmoothNormals, TextureCoordinatesAndColorsStayWhereTheyAre) {
  R3::MeshData data = Cube(true);
  for (std::size_t i = 0; i < 8; ++i) {
    data.uvs.push_back({static_cast<double>(i), 0});
    data.colors.push_back({static_cast<float>(i), 0, 0});
  }
  SmoothByAngle(data, 30);
  ASSERT_EQ(data.positions.size(), 24u);
  const R3::MeshData cube = Cube(true);
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(data.positions[i], cube.positions[static_cast<std::size_t>(data.uvs[i].x)]);
    EXPECT_EQ(static_cast<double>(data.colors[i][0]), data.uvs[i].x);
  }
}

const std::string roof =  // two slopes of 45 degrees that meet at x = 0
    "v -1 0 0\nv 0 1 0\nv 0 1 1\nv -1 0 1\nv 1 0 0\nv 1 0 1\n";

/// Returns the shading normals at the first corner of each triangle at x = 0.
R3::MeshData Roof(const std::string& faces, const std::string& how) {
  const Folder folder;
  folder.Write("roof.obj", roof + faces);
  const Scene scene = Parse(folder.Write("scene.scn", "mesh -1 roof.obj " + how + "\n"), {}).scene;
  const auto& mesh = dynamic_cast<const R3::Mesh&>(*scene.root.children.at(0).shape);
  return mesh.IsSmooth() ? mesh.Data() : R3::MeshData{};
}

std::vector<R3::Normal> NormalsAtTheRidge(const R3::MeshData& data) {
  std::vector<R3::Normal> normals;
  for (const auto& t : data.triangles)
    for (const std::uint32_t i : t)
      if (data.positions[i].x == 0) normals.push_back(data.normals[i]);
  return normals;
}

TEST(SmoothNormals, FollowSmoothingGroupsWhereTheFileHasNone) {
  const std::string left = "f 1 4 3 2\n", right = "f 2 3 6 5\n";
  const double h = std::sqrt(0.5);
  for (const char* both : {"s 1\n", "s 7\n"})
    for (const R3::Normal& n : NormalsAtTheRidge(Roof(both + left + right, "smooth"))) ExpectNear(n, {0, 1, 0});
  const auto apart = NormalsAtTheRidge(Roof("s 1\n" + left + "s 2\n" + right, "smooth"));
  ASSERT_FALSE(apart.empty());
  for (const R3::Normal& n : apart) ExpectNear(n, {n.x < 0 ? -h : h, h, 0});
  for (const R3::Normal& n : NormalsAtTheRidge(Roof("s 1\n" + left + "s off\n" + right, "smooth")))
    ExpectNear(n, {n.x < 0 ? -h : h, h, 0});
  EXPECT_TRUE(Roof("s 1\n" + left + right, "").normals.empty()) << "flat, as in the course";
  for (const R3::Normal& n : NormalsAtTheRidge(Roof(left + right, "smooth 91"))) ExpectNear(n, {0, 1, 0});
  for (const R3::Normal& n : NormalsAtTheRidge(Roof(left + right, "smooth 89")))
    ExpectNear(n, {n.x < 0 ? -h : h, h, 0});
}

TEST(SmoothNormals, GivenInTheFileWinOverSmoothingGroups) {
  const auto normals = NormalsAtTheRidge(Roof("vn 0 0 1\ns 1\nf 1 4 3//1 2\nf 2 3 6 5\n", "smooth"));
  int of_file = 0, of_group = 0;
  for (const R3::Normal& n : normals) (n.z == 1 ? of_file : of_group) += 1;
  EXPECT_EQ(of_file, 2);  // one corner in two triangles
  EXPECT_GT(of_group, 0);
}

// All pairs of them would take minutes.
TEST(SmoothNormals, AreFastWhereManyTrianglesMeet) {
  R3::MeshData fan;
  fan.positions.push_back({0, 0, 0});
  constexpr std::uint32_t n = 100'000;
  for (std::uint32_t i = 0; i < n; ++i)
    fan.positions.push_back({std::cos(6.28 * i / n), std::sin(6.28 * i / n), i % 2 ? 0.1 : 0});
  for (std::uint32_t i = 1; i < n; ++i) fan.triangles.push_back({0, i, i + 1});
  SmoothByAngle(fan, 60);
  EXPECT_EQ(fan.triangles.size(), n - 1);
}

}  // namespace
}  // namespace ray
