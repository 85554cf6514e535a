// The choices of `auto` and their reasons.

#include <gtest/gtest.h>

#include "R1/Elementary.h"
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

ray::Scene Of(std::vector<std::shared_ptr<const R3::Shape>> shapes) {
  ray::Scene scene;
  for (auto& shape : shapes) scene.root.children.push_back(accelerators::Leaf(std::move(shape)));
  SetBounds(scene.root);
  scene.camera = ray::DefaultCamera(scene.root.bounds);
  return scene;
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
  return Of({std::make_shared<R3::Mesh>(std::move(data))});
}

TEST(Auto, TestsASinglePrimitiveDirectlyIfThatIsQuick) {
  const std::shared_ptr<const R3::Shape> ball = R3::MakeShape("sphere", {0, 0, 0, 1}),
                                         ring = R3::MakeShape("torus", {0, 0, 0, 2, 0.5});
  EXPECT_EQ(Choice(Of({ball}), 1e6), "auto chose none: 1 primitive: testing it is faster\n");
  for (const auto& shapes : {std::vector{ball, ball, ring}, std::vector{ring}})
    EXPECT_TRUE(Choice(Of(shapes), 1e6).starts_with("auto chose bvh: ")) << shapes.size();
}

TEST(Auto, PutsATreeOverCompactTriangles) {
  const std::string lines = Choice(Hairs(0.5, 2000), 1e6);
  EXPECT_TRUE(lines.starts_with("auto chose bvh: bounding boxes have ")) << lines;
}

TEST(Auto, TriesAGridForHairGivenRaysEnough) {
  EXPECT_TRUE(Choice(Hairs(0.002, 2000), 100).starts_with("auto chose bvh: too few rays to try a grid, though "));
  const std::string lines = Choice(Hairs(0.002, 2000), 1e7);
  EXPECT_TRUE(lines.starts_with("auto tried ")) << lines;
  EXPECT_NE(lines.find(": the faster one; both were tried because bounding boxes"), std::string::npos) << lines;
}

/// Slivers around a vertex: each lies in the box of hundreds of cells.
ray::Scene Fan(std::uint32_t count) {
  R3::MeshData data;
  data.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto turn = R1::SinCosTurns(static_cast<double>(i) / count);
    data.positions.push_back({turn.cosine, turn.sine, 0});
    data.triangles.push_back({0, i + 1, (i + 1) % count + 1});
  }
  return Of({std::make_shared<R3::Mesh>(std::move(data))});
}

TEST(Auto, BuildsNoGridThatTakesLongerThanItsRaysCanSave) {
  // A grid of these takes over a hundred times as long to build as 5,000 rays take in a tree.
  const std::string lines = Choice(Fan(20'000), 5000);
  EXPECT_NE(lines.find("auto chose bvh: a grid would take more than "), std::string::npos) << lines;
}

TEST(Auto, IsGivenNoGridThatTakesTooLong) {
  const ray::Scene scene = Fan(20'000);
  const ray::World world(scene);
  EXPECT_THROW(ray::FindAcceleratorKind("grid")->Make(world, {.most_build_seconds = 0}), ray::BuildTookTooLong);
}

TEST(Auto, ReturnsItsChoiceWhichKnowsItsKind) {
  const ray::Scene scene = Hairs(0.5, 200);
  const ray::World world(scene);
  EXPECT_EQ(ray::FindAcceleratorKind("auto")->Make(world, {.name = "auto"})->kind, "bvh");
  for (const auto* kind : ray::AcceleratorKinds())
    if (kind->name != std::string("auto")) {
      EXPECT_EQ(kind->Make(world, {})->kind, kind->name);
    }
}

}  // namespace
