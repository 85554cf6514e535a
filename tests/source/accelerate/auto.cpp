// What `auto` takes, and that it says why.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Accelerators.h"

namespace {

std::string Choice(const ray::Scene& scene, double expected_rays) {
  const ray::World world(scene);
  const auto chosen = ray::FindAcceleratorKind("auto")->Make(world, {.name = "auto", .expected_rays = expected_rays});
  std::string lines;
  for (const std::string& line : chosen->reasons) lines += line + "\n";
  return lines;
}

ray::Scene Hairs(double width, int count) {
  Draw draw(1100);
  R3::MeshData data;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const R3::Point p = R3::Point{} + draw.Direction();
    const R3::Vector along = draw.Direction();
    for (const R3::Point& corner : {p, p + along, p + 0.5 * along + width * draw.Direction()})
      data.positions.push_back(corner);
    data.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  ray::Scene scene;
  scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(std::move(data))));
  SetBounds(scene.root);
  scene.camera = ray::DefaultCamera(scene.root.bounds);
  return scene;
}

TEST(Auto, AsksAHandfulOfPrimitivesDirectly) {
  ray::Scene scene;
  for (int i = 0; i < 3; ++i) scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  SetBounds(scene.root);
  EXPECT_EQ(Choice(scene, 1e6), "auto chose none: few primitives (3): testing all is faster\n");
}

TEST(Auto, PutsATreeOverCompactTriangles) {
  const std::string lines = Choice(Hairs(0.5, 2000), 1e6);
  EXPECT_TRUE(lines.starts_with("auto chose bvh: more than 3 primitives, and bounding boxes have ")) << lines;
}

TEST(Auto, TakesAGridForHairOrTriesBothGivenTime) {
  EXPECT_TRUE(Choice(Hairs(0.002, 2000), 100).starts_with("auto chose grid: bounding boxes have "));
  const std::string lines = Choice(Hairs(0.002, 2000), 1e7);
  EXPECT_TRUE(lines.starts_with("auto tried ")) << lines;
  EXPECT_NE(lines.find(": the faster one; both were tried because bounding boxes"), std::string::npos) << lines;
}

TEST(Auto, GivesBackWhatItChoseWhichKnowsItsKind) {
  const ray::Scene scene = Hairs(0.5, 200);
  const ray::World world(scene);
  EXPECT_EQ(ray::FindAcceleratorKind("auto")->Make(world, {.name = "auto"})->kind, "bvh");
  for (const auto* kind : ray::AcceleratorKinds())
    if (kind->name != std::string("auto")) {
      EXPECT_EQ(kind->Make(world, {})->kind, kind->name);
    }
}

}  // namespace
