// The scene as triangles: all of it, in place, in single precision for any size and distance.

#include "R3/ShapeKind.h"
#include "source/draw/preview/PreviewScene.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

ray::PreviewScene PreviewOf(const project::Stage& stage, const ray::PreviewBudget& budget = {}) {
  return ray::PreviewOf(stage.world, {}, ray::DrawingSpace::Of(stage.scene->root.bounds), budget);
}

void ExpectWithin(const ray::Surfaces& surfaces, double most) {
  for (const ray::SurfaceVertex& vertex : surfaces.vertices)
    for (const float x : vertex.at) EXPECT_LE(std::abs(x), most);
  for (const std::uint32_t i : surfaces.indices) EXPECT_LT(i, surfaces.vertices.size());
  std::size_t next = 0;
  for (const ray::SurfaceBatch& batch : surfaces.batches) {
    EXPECT_EQ(batch.first, next) << "batches follow each other";
    EXPECT_EQ(batch.count % 3, 0u);
    next += batch.count;
  }
  EXPECT_EQ(next, surfaces.indices.size());
}

std::size_t Count(const ray::Surfaces& surfaces) { return surfaces.indices.size() / 3; }

TEST(PreviewScene, LiesWithinTheSceneOfAnySizeAnywhere) {
  for (const char* text : {"sphere -1  0 0 0  1e12\n", "sphere -1  3e12 0 -4e12  1\n", "sphere -1  1 1 1  1e-12\n",
                           "box -1  -1e150 0 0  1e150 1 1\n", "sphere -1  0 0 0  1e-150\n",
                           "box -1  -1e150 -1e150 -1e150  1e150 1e150 1e150\n"}) {
    const project::Stage stage(project::FromText(text));
    const ray::PreviewScene preview = PreviewOf(stage);
    EXPECT_GT(Count(preview.surfaces), 0u) << text;
    ExpectWithin(preview.surfaces, 1.001);
  }
}

TEST(PreviewScene, LiesWithinTheBoxOfEveryRandomScene) {
  Draw draw(921);
  for (int i = 0; i < 20; ++i) {
    const project::Stage stage(accelerators::RandomScene(draw, 2));
    const ray::PreviewScene preview = PreviewOf(stage);
    EXPECT_EQ(preview.left_out + preview.as_boxes, 0);
    ExpectWithin(preview.surfaces, 1.001);
  }
}

TEST(PreviewScene, HasItsFrontsOutsideMirroredOrNot) {
  for (const char* matrix : {"1 0 0 0", "-1 0 0 0"})
    for (const char* shape : {"sphere -1 0 0 0 1", "tri -1 0 0 1  1 0 1  0 1 1"}) {
      const project::Stage stage(
          project::FromText(std::string("begin -1 ") + matrix + "  0 1 0 0  0 0 1 0  0 0 0 1\n" + shape + "\nend\n"));
      const ray::Surfaces surfaces = ray::PreviewOf(stage.world, {}, {}).surfaces;
      for (std::size_t t = 0; t < surfaces.indices.size(); t += 3) {
        const auto corner = [&](std::size_t k) {
          const auto& at = surfaces.vertices[surfaces.indices[t + k]].at;
          return R3::Point{at[0], at[1], at[2]};
        };
        // Both are seen from outside if the origin is behind.
        EXPECT_GT(Dot(Cross(corner(1) - corner(0), corner(2) - corner(0)), FromOrigin(corner(0))), 0) << shape;
      }
    }
}

TEST(PreviewScene, HasABatchForEachMaterialWithClearOnesLast) {
  const project::Stage stage(
      project::FromText("ambient 0.5 0.5 0.5\nmaterial  0 0 0  1 1 1  0 0 0  0.5 0.5 0.5  0 0 0  1 1 0\n"
                        "material  0.2 0.2 0.2  1 1 1  0 0 0  0 0 0  0 0 0.3  1 1 0\n"
                        "sphere 0  0 0 0  1\nsphere 1  3 0 0  1\nsphere 1  6 0 0  1\n"));
  const ray::Surfaces surfaces = PreviewOf(stage).surfaces;
  ASSERT_EQ(surfaces.batches.size(), 2u);
  EXPECT_FALSE(surfaces.batches[0].is_clear);
  EXPECT_TRUE(surfaces.batches[1].is_clear);
  EXPECT_EQ(surfaces.batches[0].count, 2 * surfaces.batches[1].count);
  EXPECT_EQ(surfaces.batches[0].material.ambient, (R2::Color{0.1, 0.1, 0.1}));
  EXPECT_EQ(surfaces.batches[0].material.emission, (R2::Color{0, 0, 0.3}));
  EXPECT_TRUE(surfaces.uvs.empty()) << "nothing has a texture";
}

TEST(PreviewScene, ShowsEachSolidOfACsgInItsOwnMaterial) {
  const project::Stage stage(
      project::FromText("material  0 0 0  1 0 0  0 0 0  0 0 0  0 0 0  1 1 0\n"
                        "material  0 0 0  0 1 0  0 0 0  0 0 0  0 0 0  1 1 0\n"
                        "csg difference 0\nbox 0  -2 -1 -2  2 1 2\ncylinder 1  0 0 0  1 2\nend\n"));
  const ray::Surfaces surfaces = PreviewOf(stage).surfaces;
  ASSERT_EQ(surfaces.batches.size(), 2u);
  // Green is only the wall of the hole, within a radius of 1 of the axis except for the size of a triangle.
  for (const ray::SurfaceBatch& batch : surfaces.batches) {
    EXPECT_GT(batch.count, 100u);
    if (batch.material.kd.g == 0) continue;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
      const auto& at = surfaces.vertices[surfaces.indices[i]].at;
      EXPECT_LT(std::hypot(at[0], at[2]), 1.4 / 3);  // in radii of the scene
    }
  }
}

TEST(PreviewScene, HasTextureCoordinatesWhereThereAreTextures) {
  const project::Stage textured(project::Root() / "scenes/texture.scn");
  const ray::Surfaces surfaces = PreviewOf(textured).surfaces;
  EXPECT_EQ(surfaces.uvs.size(), surfaces.vertices.size());
  std::set<std::array<float, 2>> places(surfaces.uvs.begin(), surfaces.uvs.end());
  EXPECT_GT(places.size(), 20u);
}

TEST(PreviewScene, ShowsMovingObjectsWhenTheShutterOpens) {
  ray::Scene scene;
  ray::Node group;
  group.motion = {10, 0, 0};
  group.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  SetBounds(group);
  scene.root.children.push_back(std::move(group));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  ExpectWithin(ray::PreviewOf(stage.world, {}, {}).surfaces, 1.001);
}

TEST(PreviewScene, StaysWithinItsBudgetAndCountsMissingParts) {
  ray::Scene scene;
  for (int i = 0; i < 10'000; ++i)
    scene.root.children.push_back(
        accelerators::Leaf(R3::MakeShape("sphere", {1.0 * (i % 100), 1.0 * (i / 100), 0, 0.4})));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  const ray::PreviewScene fine = PreviewOf(stage, {.shape_triangles = 2'000'000});
  EXPECT_GT(Count(fine.surfaces), 1'000'000u);
  EXPECT_EQ(fine.as_boxes + fine.left_out, 0);

  const ray::PreviewScene boxes = PreviewOf(stage, {.shape_triangles = 100'000});
  EXPECT_EQ(boxes.as_boxes, 10'000);
  EXPECT_EQ(boxes.left_out, 0);
  EXPECT_EQ(Count(boxes.surfaces), 120'000u);

  const ray::PreviewScene part = PreviewOf(stage, {.shape_triangles = 100'000, .boxes = 2'500});
  EXPECT_EQ(part.as_boxes, 2'500);
  EXPECT_EQ(part.left_out, 7'500);
  ExpectWithin(part.surfaces, 1.001);
}

TEST(PreviewScene, SimplifiesHugeMeshesAndKeepsSmallObjects) {
  ray::Scene scene;
  const auto data = accelerators::BumpyBall(300, 300);
  scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(data)));
  scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {3, 0, 0, 1})));
  scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("tri", {0, 0, 0, 1, 0, 0, 0, 1, 0})));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  const ray::PreviewScene preview = PreviewOf(stage);
  EXPECT_EQ(preview.simplified, 1);
  EXPECT_EQ(preview.as_boxes + preview.left_out, 0);
  EXPECT_LT(Count(preview.surfaces), 200'000u);
  EXPECT_GT(Count(preview.surfaces), 50'000u);
  ExpectWithin(preview.surfaces, 1.001);
  EXPECT_EQ(PreviewOf(stage, {.mesh_triangles = 1'000'000}).simplified, 0);
}

TEST(PreviewScene, IsLitByTheMeanOfItsEnvironment) {
  R2::Image map(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) map.Set(x, y, y < 16 ? R2::Color{2, 0, 0} : R2::Color{0, 0.5, 0});
  ray::Scene scene = project::FromText("sphere -1  0 0 0  1");
  scene.environment = std::make_shared<const ray::Environment>(map);
  const R2::Color around = PreviewOf(project::Stage(std::move(scene))).around;
  EXPECT_NEAR(around.r, 1, 1e-6);
  EXPECT_NEAR(around.g, 0.25, 1e-6);
}

TEST(Shrunk, KeepsBlockMeansAndLeavesSmallImagesAlone) {
  R2::Image image(5, 2);
  for (int x = 0; x < 5; ++x) image.Set(x, 1, {1.0 * x, 0, 0});
  EXPECT_EQ(ray::Shrunk(image, 5, 2), image);
  const R2::Image shrunk = ray::Shrunk(image, 2, 1);
  ASSERT_EQ(shrunk.Width(), 2);
  EXPECT_NEAR(shrunk.At(0, 0).r, 0.25, 1e-6);
  EXPECT_NEAR(shrunk.At(1, 0).r, 1.5, 1e-6);
}

TEST(PreviewScene, OfAnEmptySceneIsEmpty) {
  const project::Stage stage(project::FromText("\n"));
  EXPECT_EQ(Count(PreviewOf(stage).surfaces), 0u);
  EXPECT_EQ(PreviewOf(stage).left_out, 0);
}

TEST(DrawingSpace, HasARadiusForEverythingAndNothing) {
  EXPECT_EQ(ray::DrawingSpace::Of({}).radius, 1);
  EXPECT_EQ(ray::DrawingSpace::Of({{1, 2, 3}, {1, 2, 3}}).radius, 1);
  EXPECT_EQ(ray::DrawingSpace::Of({{1, 2, 3}, {1, 2, 3}}).center, (R3::Point{1, 2, 3}));
  EXPECT_NEAR(ray::DrawingSpace::Of({{0, 0, 0}, {2, 4, 4}}).radius, 3, 1e-15);
}

TEST(Shown, IsClampedAndAlwaysFinite) {
  EXPECT_EQ(ray::Shown({-1, 0.5, 7}, 2), (ray::Rgba{0, 128, 255, 255}));
  EXPECT_EQ(ray::Shown({std::nan(""), R3::infinity, -R3::infinity}, 0), (ray::Rgba{0, 255, 0, 0}));
}

}  // namespace
