// Texture coordinates that a mesh gets by projection.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "R3/FlatTriangle.h"
#include "R3/Mesh.h"
#include "R3/ShapeKind.h"

namespace R3 {
namespace {

MeshData WithoutUvs(const Shape& shape) {
  MeshData data = shape.Tessellate(12);
  data.uvs.clear();
  return data;
}

const ShapeKind& KindNamed(std::string_view name) {
  return **std::ranges::find_if(ShapeKinds(), [&](const ShapeKind* kind) { return kind->name == name; });
}

Normal NormalOf(const Mesh& mesh, int element) {
  const auto [p, q, r] = mesh.Corners(element);
  return AsNormal(FaceDirection(p, q, r));
}

/// Returns the derivatives of a triangle's texture coordinates by position, as the rows of a matrix: u is the first, v
/// the second.
std::array<Vector, 2> GradientsOf(const Mesh& mesh, int element) {
  const UvTangents uv = mesh.UvTangentsAt({}, {}, element);
  const Vector n = Cross(uv.first, uv.second);
  const Vector first = (1 / Dot(n, n)) * Cross(uv.second, n), second = (1 / Dot(n, n)) * Cross(n, uv.first);
  return {uv.gain_first.x * first + uv.gain_second.x * second, uv.gain_first.y * first + uv.gain_second.y * second};
}

TEST(ProjectedMesh, OfABoxShowsImagesUprightAndUnscaled) {
  const auto box = KindNamed("box").make(std::array{-1.0, 0.5, 2.0, 1.0, 3.0, 4.0});
  const auto mesh = Mesh(WithoutUvs(*box)).Projected();
  int walls = 0;
  for (int i = 0; i < mesh->Elements(); ++i) {
    const Vector n = AsVector(NormalOf(*mesh, i));
    const auto [u, v] = GradientsOf(*mesh, i);
    EXPECT_LT(Length(Cross(u, v) - n), 1e-9);
    EXPECT_NEAR(Length(u), 1, 1e-9);
    const bool is_wall = std::abs(n.y) < 0.5;
    EXPECT_LT(Length(v - (is_wall ? Vector{0, 1, 0} : Vector{0, 0, -n.y})), 1e-9);
    walls += is_wall;
    const std::uint32_t corner = mesh->Data().triangles[static_cast<std::size_t>(i)][0];
    const R2::Point uv = mesh->Data().uvs[corner];
    EXPECT_NEAR(uv.x, Dot(u, FromOrigin(mesh->Data().positions[corner])), 1e-9);
    EXPECT_NEAR(uv.y, Dot(v, FromOrigin(mesh->Data().positions[corner])), 1e-9);
  }
  EXPECT_GE(walls, 8);
}

// Images are nowhere mirrored: from a triangle's front, its corners turn the same way on the image.
TEST(ProjectedMesh, ImagesAreSeenTheRightWayRoundFromEveryFront) {
  const auto mesh = Mesh(WithoutUvs(*KindNamed("sphere").make(std::array{1.0, 2.0, 3.0, 4.0}))).Projected();
  ASSERT_GT(mesh->Elements(), 100);
  for (int i = 0; i < mesh->Elements(); ++i) {
    const UvTangents uv = mesh->UvTangentsAt({}, {}, i);
    const double turn = uv.gain_first.x * uv.gain_second.y - uv.gain_first.y * uv.gain_second.x;
    const Vector n = Abs(AsVector(NormalOf(*mesh, i)));
    const double area = Length(Cross(uv.first, uv.second));
    // Its size on the image is its projection along the axis that its normal is nearest to.
    EXPECT_NEAR(turn, area * MaxComponent(n), 1e-9 * area);
  }
}

/// Makes a cube of eight corners, each shared by three sides, with separate normals and colors.
MeshData Cube() {
  MeshData data;
  for (int i = 0; i < 8; ++i) {
    const Vector corner{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    data.positions.push_back(Point{} + corner);
    data.normals.push_back(AsNormal(Unit(corner)));
    data.colors.push_back({static_cast<float>(i), static_cast<float>(2 * i), 1});
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t high = 1u << axis, right = 1u << (axis + 1) % 3, upward = 1u << (axis + 2) % 3;
    data.triangles.push_back({high, high | right, high | right | upward});
    data.triangles.push_back({high, high | right | upward, high | upward});
    data.triangles.push_back({0, upward, right | upward});
    data.triangles.push_back({0, right | upward, right});
  }
  return data;
}

TEST(ProjectedMesh, KeepsEveryCornerNormalAndColorWhereItWas) {
  const Mesh mesh(Cube(), true);
  const auto projected = mesh.Projected();
  const MeshData &before = mesh.Data(), &after = projected->Data();
  EXPECT_EQ(after.positions.size(), 24u) << "one for each side";
  EXPECT_EQ(after.uvs.size(), after.positions.size());
  ASSERT_EQ(after.triangles.size(), before.triangles.size());
  EXPECT_TRUE(projected->IsSmooth());
  for (std::size_t i = 0; i < before.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t old_corner = before.triangles[i][k], corner = after.triangles[i][k];
      EXPECT_EQ(after.positions[corner], before.positions[old_corner]);
      EXPECT_EQ(AsVector(after.normals[corner]), AsVector(before.normals[old_corner]));
      EXPECT_EQ(after.colors[corner], before.colors[old_corner]);
    }
}

/// Makes a polygon tilted by `degrees` from +z towards +y.
MeshData Leaning(double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180, y = std::cos(angle), z = -std::sin(angle);
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, y, z}, {0, y, z}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  data.is_one_polygon = true;
  return data;
}

TEST(ProjectedMesh, APolygonFacesOneWayAndUpWinsTies) {
  for (const double degrees : {0.0, 30.0, 44.0, 45.0, 46.0, 90.0}) {
    const auto mesh = Mesh(Leaning(degrees)).Projected();
    EXPECT_EQ(mesh->Data().positions.size(), 4u) << degrees;
    const Point& far = mesh->Data().positions[2];
    const bool is_level = degrees >= 45;
    EXPECT_EQ(mesh->Data().uvs[2].x, 1) << degrees;
    EXPECT_EQ(mesh->Data().uvs[2].y, is_level ? -far.z : far.y) << degrees;
  }
}

}  // namespace
}  // namespace R3
