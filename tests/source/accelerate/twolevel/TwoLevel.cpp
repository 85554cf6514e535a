// Results that are certain in single precision must be so in the scene's own coordinates too.
#include "source/accelerate/twolevel/TwoLevel.h"

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "source/accelerate/Workspace.h"
#include "tests/Accelerators.h"

namespace ray {
namespace {

constexpr int triangles = 8;

/// Returns the number of triangles tested by a ray that meets one: they are in a row along x, each of that size.
std::uint64_t TrianglesAsked(double size) {
  R3::MeshData data;
  for (int i = 0; i < triangles; ++i) {
    const auto n = static_cast<std::uint32_t>(data.positions.size());
    const double x = 2 * i * size;
    data.positions.insert(data.positions.end(), {{x, 0, 0}, {x + size, 0, 0}, {x, size, 0}});
    data.triangles.push_back({n, n + 1, n + 2});
  }
  Scene scene;
  scene.root = accelerators::Leaf(std::make_shared<R3::Mesh>(std::move(data)));
  SetBounds(scene.root);
  const World world(scene);
  const auto bvh = FindAcceleratorKind("bvh")->Make(world, {});
  Workspace workspace;
  const auto hit = bvh->Intersect({{size / 4, size / 4, -size}, {0, 0, 1}}, workspace);
  EXPECT_TRUE(hit && hit->element == 0 && hit->t == size);
  return workspace.counts.primitive_tests;
}

TEST(TwoLevel, TrianglesWhoseProductsLeaveDoublesAreAllTested) {
  EXPECT_EQ(TrianglesAsked(1), 1U);
  for (const double size : {0x1p-190, 0x1p190}) EXPECT_EQ(TrianglesAsked(size), 1U) << size;
  for (const double size : {0x1p-230, 0x1p230}) EXPECT_EQ(TrianglesAsked(size), triangles * 1U) << size;
}

}  // namespace
}  // namespace ray
