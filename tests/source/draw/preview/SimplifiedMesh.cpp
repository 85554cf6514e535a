#include "source/draw/preview/SimplifiedMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

/// Returns a ball of radius 1 about `middle`, without normals.
R3::MeshData Ball(std::uint32_t rings, const R3::Point& middle = {3, 5, 7}) {
  R3::MeshData mesh;
  const std::uint32_t sides = 2 * rings;
  for (std::uint32_t k = 0; k <= rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double a = std::numbers::pi * k / rings, b = 2 * std::numbers::pi * i / sides;
      mesh.positions.push_back(middle + R3::Vector{std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)});
    }
  for (std::uint32_t k = 0; k < rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      if (k > 0) mesh.triangles.push_back({a, a + sides, b});
      if (k + 1 < rings) mesh.triangles.push_back({b, a + sides, b + sides});
    }
  return mesh;
}

TEST(SimplifiedMesh, HasAboutTheRequestedNumberOfTriangles) {
  const R3::MeshData ball = Ball(200);
  for (const std::int64_t wanted : {500, 5000, 20'000}) {
    const auto count = static_cast<double>(ray::SimplifiedMesh(ball, wanted).triangles.size());
    EXPECT_GT(count, 0.3 * static_cast<double>(wanted));
    EXPECT_LT(count, 1.5 * static_cast<double>(wanted));
  }
}

TEST(SimplifiedMesh, StaysNearTheSurfaceAndFacesTheSameWay) {
  const R3::MeshData ball = Ball(200), simple = ray::SimplifiedMesh(ball, 2000);
  const R3::Point middle{3, 5, 7};
  ASSERT_EQ(simple.normals.size(), simple.positions.size());
  for (std::size_t i = 0; i < simple.positions.size(); ++i) {
    const R3::Vector from = simple.positions[i] - middle;
    EXPECT_NEAR(Length(from), 1, 0.06);
    EXPECT_GT(Dot(AsVector(simple.normals[i]), Unit(from)), 0.95);
  }
  double volume = 0;
  for (const auto& [a, b, c] : simple.triangles) {
    const auto at = [&](std::uint32_t i) { return simple.positions[i] - middle; };
    volume += Dot(at(a), Cross(at(b), at(c))) / 6;
  }
  EXPECT_NEAR(volume, 4 * std::numbers::pi / 3, 0.3) << "some triangles are missing, or turned over";
}

TEST(SimplifiedMesh, KeepsTheVerticesAttributes) {
  R3::MeshData ball = Ball(100);
  for (const R3::Point& p : ball.positions) {
    ball.normals.push_back({0, 0, 1});
    ball.uvs.push_back({p.x, p.y});
    ball.colors.push_back({1, 0.5F, 0.25F});
  }
  const R3::MeshData simple = ray::SimplifiedMesh(ball, 1000);
  ASSERT_EQ(simple.uvs.size(), simple.positions.size());
  ASSERT_EQ(simple.colors.size(), simple.positions.size());
  for (std::size_t i = 0; i < simple.positions.size(); ++i) {
    EXPECT_EQ(simple.normals[i].z, 1);
    EXPECT_NEAR(simple.uvs[i].x, simple.positions[i].x, 0.2);
  }
}

TEST(SimplifiedMesh, IsTheMeshItselfIfThatIsSmallEnough) {
  const R3::MeshData ball = Ball(10);
  const R3::MeshData same = ray::SimplifiedMesh(ball, static_cast<std::int64_t>(ball.triangles.size()));
  EXPECT_EQ(same.triangles, ball.triangles);
  EXPECT_TRUE(same.normals.empty());
}

TEST(SimplifiedMesh, OfAFlatSheetOrASinglePlaceIsFinite) {
  R3::MeshData sheet = Ball(50);
  for (R3::Point& p : sheet.positions) p.y = 5;
  R3::MeshData place = sheet;
  for (R3::Point& p : place.positions) p = {1, 2, 3};
  for (const R3::MeshData& mesh : {sheet, place})
    for (const R3::Point& p : ray::SimplifiedMesh(mesh, 100).positions)
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

}  // namespace
