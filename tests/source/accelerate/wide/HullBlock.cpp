// The purpose of hulls: a rotated shape whose box a ray crosses is tested only if the ray comes near the shape itself.
#include "source/accelerate/wide/HullBlock.h"

#include <gtest/gtest.h>

#include <cmath>

#include "R3/ShapeKind.h"
#include "tests/Accelerators.h"

namespace ray {
namespace {

/// Makes a shape along the diagonal of x and y, from y of its own frame.
Scene Slanted(const char* shape, const std::vector<double>& arguments) {
  const double half = std::sqrt(0.5);
  Scene scene;
  Node group = accelerators::Group({{{{half, half, 0, 0}, {-half, half, 0, 0}, {0, 0, 1, 0}}}});
  group.children.push_back(accelerators::Leaf(R3::MakeShape(shape, arguments)));
  SetBounds(group);
  scene.root.children.push_back(std::move(group));
  SetBounds(scene.root);
  return scene;
}

/// Returns how many of sixteen rays along z, `beside` away from that diagonal, test the shape: one at a time, and
/// together.
std::array<std::uint64_t, 2> Asked(const Scene& scene, const std::string& kind, double beside) {
  const World world(scene);
  const auto accelerator = FindAcceleratorKind(kind)->Make(world, {.name = kind});
  std::vector<R3::Ray> rays;
  for (int i = 0; i < 16; ++i) {
    const double along = (i - 7.5) / 16;
    rays.push_back({{along + beside, along - beside, 5}, {0, 0, -1}});
  }
  Workspace single, together;
  for (const R3::Ray& ray : rays) accelerator->Intersect(ray, single);
  std::array<std::optional<WorldHit>, 16> hits;
  accelerator->Intersect(rays, hits.data(), together);
  return {single.counts.primitive_tests, together.counts.primitive_tests};
}

TEST(Hulls, SaveTestsOfShapesThatRaysMiss) {
  const std::vector<std::pair<const char*, std::vector<double>>> shapes{{"cylinder", {0, 0, 0, 0.1, 4}},
                                                                        {"box", {-0.1, -2, -0.1, 0.1, 2, 0.1}},
                                                                        {"cone", {0, 0, 0, 0.1, 4}}};
  for (const auto& [shape, arguments] : shapes)
    for (const char* kind : {"bvh", "octree", "grid"}) {
      const Scene scene = Slanted(shape, arguments);
      for (const std::uint64_t asked : Asked(scene, kind, 0)) EXPECT_EQ(asked, 16u) << shape << ' ' << kind;
      for (const std::uint64_t asked : Asked(scene, kind, 0.2)) EXPECT_EQ(asked, 0u) << shape << ' ' << kind;
    }
}

TEST(Hulls, OfConesBecomeThinner) {
  const Scene scene = Slanted("cone", {0, 0, 0, 0.4, 4});
  const World world(scene);
  const auto accelerator = FindAcceleratorKind("bvh")->Make(world, {.name = "bvh"});
  const double half = std::sqrt(0.5);
  const auto is_asked = [&](double height, double beside) {  // in the cone's frame
    Workspace workspace;
    accelerator->Intersect({{half * (height + beside), half * (height - beside), 5}, {0, 0, -1}}, workspace);
    return workspace.counts.primitive_tests == 1;
  };
  for (const double height : {-1.9, -1.0, 0.0, 1.0}) {
    const double radius = 0.4 * (2 - height) / 4;
    EXPECT_TRUE(is_asked(height, 0.99 * radius)) << height;
    EXPECT_FALSE(is_asked(height, 1.01 * radius)) << height;
  }
}

}  // namespace
}  // namespace ray
