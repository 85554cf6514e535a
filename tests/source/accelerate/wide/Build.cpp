// The depth of the wide tree: traversal's stacks are sized for the deepest tree.
#include "source/accelerate/wide/Build.h"

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "source/accelerate/wide/Layout.h"
#include "tests/Accelerators.h"

namespace ray {
namespace {

wide::Tree TreeOver(Node root) {
  Scene scene;
  scene.root = std::move(root);
  SetBounds(scene.root);
  const World world(scene);
  return wide::Build(PrimitiveSet(world), width);
}

// Once the first of equal boxes was always split, so that one child of a node kept half of its primitives.
TEST(WideTree, OverEqualTrianglesIsAsShallowAsOverOthers) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.triangles.assign(32'768, {0, 1, 2});
  EXPECT_LE(TreeOver(accelerators::Leaf(std::make_shared<R3::Mesh>(std::move(data)))).depth, 5);
}

TEST(WideTree, OverConcentricSpheresIsAsShallowAsOverOthers) {
  Node root;
  for (int i = 0; i < 20'000; ++i)
    root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {0, 0, 0, 1 + i * 1e-7})));
  EXPECT_LE(TreeOver(std::move(root)).depth, 6);
}

TEST(WideTree, DeeperThanStacksAreIsRefused) {
  std::vector<wide::BuildNode> nodes(static_cast<std::size_t>(wide::most_depth) + 1);
  wide::BuildChild leaf;
  leaf.box.Extend(wide::Float4{0, 0, 0, 0});
  nodes[0].Add(leaf);
  for (std::size_t i = 1; i < nodes.size(); ++i) nodes[i].Add(ChildOf(nodes[i - 1]));
  Scene scene;
  scene.root = accelerators::Leaf(R3::MakeShape("box", {0, 0, 0, 1, 1, 1}));
  const World world(scene);
  const auto depth_of = [&](const wide::BuildNode& node) {
    wide::Tree tree{PrimitiveSet(world)};
    const wide::BuildChild root = ChildOf(node);
    wide::Flatten({&root, 1}, tree);
    return tree.depth;
  };
  EXPECT_EQ(depth_of(nodes[nodes.size() - 2]), wide::most_depth);
  EXPECT_THROW(depth_of(nodes.back()), std::length_error);
}

}  // namespace
}  // namespace ray
