// The scene as triangles: all of it, where it is, in single precision however large or far away.

#include "R3/ShapeKind.h"
#include "source/draw/preview/ScenePicture.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

ray::ScenePicture PictureOf(const project::Stage& stage, const ray::PictureBudget& budget = {}) {
  return ray::PictureOf(stage.world, {}, ray::DrawingSpace::Of(stage.scene->root.bounds), budget);
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

TEST(ScenePicture, LiesWithinTheSceneOfAnySizeAnywhere) {
  for (const char* text : {"sphere -1  0 0 0  1e12\n", "sphere -1  3e12 0 -4e12  1\n", "sphere -1  1 1 1  1e-12\n",
                           "box -1  -1e150 0 0  1e150 1 1\n", "sphere -1  0 0 0  1e-150\n",
                           "box -1  -1e150 -1e150 -1e150  1e150 1e150 1e150\n"}) {
    const project::Stage stage(project::FromText(text));
    const ray::ScenePicture picture = PictureOf(stage);
    EXPECT_GT(Count(picture.surfaces), 0u) << text;
    ExpectWithin(picture.surfaces, 1.001);
  }
}

TEST(ScenePicture, LiesWithinTheBoxOfEveryRandomScene) {
  Draw draw(921);
  for (int i = 0; i < 20; ++i) {
    const project::Stage stage(accelerators::RandomScene(draw, 2));
    const ray::ScenePicture picture = PictureOf(stage);
    EXPECT_EQ(picture.left_out + picture.as_boxes, 0);
    EXPECT_EQ(picture.primitives, stage.world.Primitives());
    ExpectWithin(picture.surfaces, 1.001);
  }
}

TEST(ScenePicture, HasItsFrontsOutsideMirroredOrNot) {
  for (const char* matrix : {"1 0 0 0", "-1 0 0 0"})
    for (const char* shape : {"sphere -1 0 0 0 1", "tri -1 0 0 1  1 0 1  0 1 1"}) {
      const project::Stage stage(
          project::FromText(std::string("begin -1 ") + matrix + "  0 1 0 0  0 0 1 0  0 0 0 1\n" + shape + "\nend\n"));
      const ray::Surfaces surfaces = ray::PictureOf(stage.world, {}, {}).surfaces;
      for (std::size_t t = 0; t < surfaces.indices.size(); t += 3) {
        const auto corner = [&](std::size_t k) {
          const auto& at = surfaces.vertices[surfaces.indices[t + k]].at;
          return R3::Point{at[0], at[1], at[2]};
        };
        // Both are seen from outside by whom the origin is behind.
        EXPECT_GT(Dot(Cross(corner(1) - corner(0), corner(2) - corner(0)), FromOrigin(corner(0))), 0) << shape;
      }
    }
}

TEST(ScenePicture, HasABatchForEachMaterialWithClearOnesLast) {
  const project::Stage stage(
      project::FromText("ambient 0.5 0.5 0.5\nmaterial  0 0 0  1 1 1  0 0 0  0.5 0.5 0.5  0 0 0  1 1 0\n"
                        "material  0.2 0.2 0.2  1 1 1  0 0 0  0 0 0  0 0 0.3  1 1 0\n"
                        "sphere 0  0 0 0  1\nsphere 1  3 0 0  1\nsphere 1  6 0 0  1\n"));
  const ray::Surfaces surfaces = PictureOf(stage).surfaces;
  ASSERT_EQ(surfaces.batches.size(), 2u);
  EXPECT_FALSE(surfaces.batches[0].is_clear);
  EXPECT_TRUE(surfaces.batches[1].is_clear);
  EXPECT_EQ(surfaces.batches[0].count, 2 * surfaces.batches[1].count);
  EXPECT_EQ(surfaces.batches[0].material.ambient, (R2::Color{0.1, 0.1, 0.1}));
  EXPECT_EQ(surfaces.batches[0].material.emission, (R2::Color{0, 0, 0.3}));
  EXPECT_TRUE(surfaces.uvs.empty()) << "nothing has a texture";
}

TEST(ScenePicture, ShowsEachSolidOfACsgInItsOwnMaterial) {
  const project::Stage stage(
      project::FromText("material  0 0 0  1 0 0  0 0 0  0 0 0  0 0 0  1 1 0\n"
                        "material  0 0 0  0 1 0  0 0 0  0 0 0  0 0 0  1 1 0\n"
                        "csg difference 0\nbox 0  -2 -1 -2  2 1 2\ncylinder 1  0 0 0  1 2\nend\n"));
  const ray::Surfaces surfaces = PictureOf(stage).surfaces;
  ASSERT_EQ(surfaces.batches.size(), 2u);
  // Green is the wall of the hole alone, within a radius of 1 of the axis but for the size of a triangle.
  for (const ray::SurfaceBatch& batch : surfaces.batches) {
    EXPECT_GT(batch.count, 100u);
    if (batch.material.kd.g == 0) continue;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
      const auto& at = surfaces.vertices[surfaces.indices[i]].at;
      EXPECT_LT(std::hypot(at[0], at[2]), 1.4 / 3);  // in radii of the scene
    }
  }
}

TEST(ScenePicture, HasTextureCoordinatesWhereThereAreTextures) {
  const project::Stage textured(project::Root() / "scenes/texture.scn");
  const ray::Surfaces surfaces = PictureOf(textured).surfaces;
  EXPECT_EQ(surfaces.uvs.size(), surfaces.vertices.size());
  std::set<std::array<float, 2>> places(surfaces.uvs.begin(), surfaces.uvs.end());
  EXPECT_GT(places.size(), 20u);
}

TEST(ScenePicture, SpreadsReflectionsByGlossOrByTheExponent) {
  const std::string material = "material  0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  50 1 0\n";
  const project::Stage sharp(project::FromText(material + "sphere 0  0 0 0  1\n"));
  const project::Stage blurred(project::FromText(material + "gloss 0  8 1\nsphere 0  0 0 0  1\n"));
  const auto lobe = [](const project::Stage& stage, bool glossy) {
    ray::RenderSettings settings;
    settings.trace.glossy = glossy;
    return ray::PictureOf(stage.world, settings, {}).surfaces.batches.at(0).material.lobe;
  };
  const auto half_as_strong = [](double exponent) { return 2 * std::acos(std::pow(0.5, 1 / exponent)); };
  EXPECT_EQ(lobe(sharp, false), 0);
  EXPECT_NEAR(lobe(sharp, true), half_as_strong(50), 1e-12);
  for (const bool glossy : {false, true}) EXPECT_NEAR(lobe(blurred, glossy), half_as_strong(8), 1e-12);
}

TEST(ScenePicture, AbsorbsOnHalfTheMeanWayThroughABall) {
  const project::Stage stage(project::FromText(
      "material  0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 1.5 0\nabsorb 0  0.3 0 0\nsphere 0  0 0 0  3\n"));
  const R2::Color kt = PictureOf(stage).surfaces.batches.at(0).material.kt;
  EXPECT_NEAR(kt.r, std::exp(-0.3 * 4 / 2), 1e-12);  // the mean way is 4/3 of the radius
  EXPECT_EQ(kt.g, 1);
}

TEST(ScenePicture, StaysWithinItsBudgetAndSaysWhatIsMissing) {
  ray::Scene scene;
  for (int i = 0; i < 10'000; ++i)
    scene.root.children.push_back(
        accelerators::Leaf(R3::MakeShape("sphere", {1.0 * (i % 100), 1.0 * (i / 100), 0, 0.4})));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  const ray::ScenePicture usual = PictureOf(stage);
  EXPECT_LE(Count(usual.surfaces), 2'000'000u);
  EXPECT_GT(Count(usual.surfaces), 500'000u);
  EXPECT_EQ(usual.as_boxes + usual.left_out, 0);

  const ray::ScenePicture boxes = PictureOf(stage, {.usual_triangles = 100'000});
  EXPECT_EQ(boxes.as_boxes, 10'000);
  EXPECT_EQ(boxes.left_out, 0);
  EXPECT_EQ(Count(boxes.surfaces), 120'000u);

  const ray::ScenePicture part = PictureOf(stage, {.usual_triangles = 100'000, .most_vertices = 20'000});
  EXPECT_EQ(part.as_boxes, 2'500);
  EXPECT_EQ(part.left_out, 7'500);
  EXPECT_LE(part.surfaces.vertices.size(), 20'000u);
  ExpectWithin(part.surfaces, 1.001);
}

TEST(ScenePicture, OfMotionHasFewTrianglesAndNothingMissing) {
  ray::Scene scene;
  const auto mesh = std::make_shared<R3::Mesh>(accelerators::BumpyBall(300, 300));
  scene.root.children.push_back(accelerators::Leaf(mesh));
  for (int i = 0; i < 500; ++i)
    scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {0.1 * i, 3, 0, 0.4})));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  const ray::ScenePicture usual = PictureOf(stage), few = PictureOf(stage, ray::budget_in_motion);
  EXPECT_GT(Count(usual.surfaces), 180'000u);
  EXPECT_LT(Count(few.surfaces), 120'000u);
  EXPECT_GT(Count(few.surfaces), 20'000u);
  EXPECT_EQ(few.as_boxes + few.left_out, 0);
  ExpectWithin(few.surfaces, 1.001);
}

TEST(ScenePicture, ThinsHugeMeshesEvenlyAndKeepsSmallThings) {
  ray::Scene scene;
  const auto data = accelerators::BumpyBall(100, 100);
  scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(data)));
  scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {3, 0, 0, 1})));
  scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("tri", {0, 0, 0, 1, 0, 0, 0, 1, 0})));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  const auto of_mesh = static_cast<std::int64_t>(data.triangles.size());
  EXPECT_EQ(PictureOf(stage).left_out, 0);
  const ray::ScenePicture part = PictureOf(stage, {.usual_triangles = 3'000, .most_vertices = 30'000});
  EXPECT_NEAR(static_cast<double>(part.left_out), static_cast<double>(of_mesh) - 10'000, 20);
  EXPECT_EQ(part.as_boxes, 0);  // the sphere is round
  // Triangles of both ends of the mesh, which are those of its poles, are there.
  float lowest = 0, highest = 0;
  for (const ray::SurfaceVertex& v : part.surfaces.vertices)
    lowest = std::min(lowest, v.at[1]), highest = std::max(highest, v.at[1]);
  const auto whole = ray::DrawingSpace::Of(stage.scene->root.bounds);
  EXPECT_NEAR(highest, whole.At(stage.scene->root.bounds.high)[1], 0.05);
  EXPECT_NEAR(lowest, whole.At(stage.scene->root.bounds.low)[1], 0.05);
}

TEST(ScenePicture, ShowsWhatMovesWhereItIsWhenTheShutterOpens) {
  ray::Scene scene;
  ray::Node group;
  group.motion = {10, 0, 0};
  group.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  SetBounds(group);
  scene.root.children.push_back(std::move(group));
  SetBounds(scene.root);
  const project::Stage stage(std::move(scene));
  ExpectWithin(ray::PictureOf(stage.world, {}, {}).surfaces, 1.001);
}

TEST(ScenePicture, OfNothingIsNothing) {
  const project::Stage stage(project::FromText("\n"));
  EXPECT_EQ(Count(PictureOf(stage).surfaces), 0u);
  EXPECT_EQ(PictureOf(stage).left_out, 0);
}

TEST(DrawingSpace, HasARadiusForEverythingAndNothing) {
  EXPECT_EQ(ray::DrawingSpace::Of({}).radius, 1);
  EXPECT_EQ(ray::DrawingSpace::Of({{1, 2, 3}, {1, 2, 3}}).radius, 1);
  EXPECT_EQ(ray::DrawingSpace::Of({{1, 2, 3}, {1, 2, 3}}).center, (R3::Point{1, 2, 3}));
  EXPECT_NEAR(ray::DrawingSpace::Of({{0, 0, 0}, {2, 4, 4}}).radius, 3, 1e-15);
}

TEST(Shown, IsClampedAndNeverStrange) {
  EXPECT_EQ(ray::Shown({-1, 0.5, 7}, 2), (ray::Rgba{0, 128, 255, 255}));
  EXPECT_EQ(ray::Shown({std::nan(""), R3::infinity, -R3::infinity}, 0), (ray::Rgba{0, 255, 0, 0}));
}

}  // namespace
