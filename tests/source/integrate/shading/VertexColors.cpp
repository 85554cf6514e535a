// Colors of a mesh's vertices multiply kd if the material requests them.

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "tests/Named.h"
#include "tests/Project.h"

namespace ray {
namespace {

R3::MeshData Triangle() {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  data.triangles = {{0, 1, 2}};
  data.colors = {{1, 0, 0.5f}, {0, 1, 0.5f}, {0, 0, 0.5f}};
  return data;
}

Scene SceneOf(R3::MeshData data, const R3::Matrix& matrix, bool asks) {
  Scene scene = project::FromText("camera 1 2 9  0 0 -1  0 1 0  1e-7  .01 100  dir_light 1 1 1  0 0 -1  ambient 1 1 1");
  Material material;
  material.ka = {0, 0, 0.25};
  material.kd = {0.8, 0.4, 1};
  material.ks = material.kr = {0, 0, 0};
  material.has_vertex_colors = asks;
  scene.materials.push_back(material);
  Node node;
  node.shape = std::make_shared<const R3::Mesh>(std::move(data));
  node.material = 1;
  SetBounds(node);
  Node group;
  group.transform = matrix;
  group.children.push_back(std::move(node));
  SetBounds(group);
  scene.root.children.push_back(std::move(group));
  SetBounds(scene.root);
  return scene;
}

R2::Color Seen(Scene scene, const char* mode) {
  RenderSettings settings = project::Sized(1);
  settings.mode = project::Named{mode};
  return project::Render(project::Stage(std::move(scene)), settings).image.At(0, 0);
}

void ExpectColor(const R2::Color& seen, const R2::Color& expected) {
  EXPECT_NEAR(seen.r, expected.r, 1e-6);
  EXPECT_NEAR(seen.g, expected.g, 1e-6);
  EXPECT_NEAR(seen.b, expected.b, 1e-6);
}

// At (1, 2) the corners weigh a quarter, a quarter and a half.
TEST(VertexColors, AreBlendedByBarycentricCoordinatesInEveryMode) {
  for (const char* mode : {"whitted", "path"}) {
    ExpectColor(Seen(SceneOf(Triangle(), {}, true), mode), {0.25 * 0.8, 0.25 * 0.4, 0.5 + 0.25});
    ExpectColor(Seen(SceneOf(Triangle(), {}, false), mode), {0.8, 0.4, 1 + 0.25});
  }
  ExpectColor(Seen(SceneOf(Triangle(), {}, true), "flat"), {0.25 * 0.8, 0.25 * 0.4, 0.5});
}

TEST(VertexColors, StayAtTheirCornersWhenTheMeshIsMirrored) {
  R3::Matrix mirror;
  mirror.m = {{{-1, 0, 0, 3}, {0, 1, 0, 0}, {0, 0, 1, 0}}};  // x = 1 shows what was at 2
  ExpectColor(Seen(SceneOf(Triangle(), mirror, true), "whitted"), {0, 0.5 * 0.4, 0.5 + 0.25});
}

TEST(VertexColors, OfAMeshWithoutAnyAreWhite) {
  R3::MeshData plain = Triangle();
  plain.colors.clear();
  ExpectColor(Seen(SceneOf(plain, {}, true), "whitted"), {0.8, 0.4, 1 + 0.25});
}

TEST(VertexColors, AreKeptByFinerTriangles) {
  const R3::MeshData fine = R3::Mesh(Triangle()).Tessellate(40);
  ASSERT_GT(fine.triangles.size(), 9u);
  ASSERT_EQ(fine.colors.size(), fine.positions.size());
  for (std::size_t i = 0; i < fine.positions.size(); ++i) {
    EXPECT_NEAR(fine.colors[i][0], 1 - (fine.positions[i].x + fine.positions[i].y) / 4, 1e-6);
    EXPECT_NEAR(fine.colors[i][1], fine.positions[i].x / 4, 1e-6);
  }
}

}  // namespace
}  // namespace ray
