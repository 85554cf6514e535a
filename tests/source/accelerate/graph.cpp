// Boxes only cull: the scene graph, with any of its switches, finds exactly the hits of testing every primitive.

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

std::shared_ptr<const R3::Shape> RandomShape(Draw& draw) {
  const auto kinds = BoundedShapeKinds();
  const auto* kind = kinds[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(kinds.size()) - 1))];
  return kind->make(kind->example);
}

/// Makes nested groups, sheared, mirrored and scaled by up to `powers` orders of magnitude, with shapes on every level.
ray::Node RandomGroup(Draw& draw, int levels, double powers) {
  ray::Node group;
  if (draw.Whole(0, 3) > 0) group.transform = draw.Affine(powers);
  for (int i = draw.Whole(1, 4); i > 0; --i) {
    if (levels > 0 && draw.Whole(0, 2) > 0) {
      group.children.push_back(RandomGroup(draw, levels - 1, powers));
    } else {
      ray::Node leaf;
      leaf.shape = RandomShape(draw);
      SetBounds(leaf);
      group.children.push_back(std::move(leaf));
    }
  }
  SetBounds(group);
  return group;
}

void ExpectSame(const std::optional<ray::WorldHit>& a, const std::optional<ray::WorldHit>& b, const R3::Ray& ray,
                const char* how) {
  ASSERT_EQ(a.has_value(), b.has_value()) << how << ' ' << oracle::Hex(ray);
  if (!a) return;
  EXPECT_EQ(a->t, b->t) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->u, b->u);
  EXPECT_EQ(a->v, b->v);
  EXPECT_EQ(a->part, b->part);
  EXPECT_EQ(a->instance, b->instance) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->element, b->element);
}

void CompareInOneScene(const ray::Scene& scene, Draw& draw, int rays) {
  const ray::World world(scene);
  const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
  const R3::Box& box = scene.root.bounds;
  std::vector<R3::Ray> list;
  for (int i = 0; i < rays; ++i) {
    const R3::Vector size = box.Size();
    const auto inside = [&] {
      return box.low +
             R3::Vector{size.x * draw.Between(0, 1), size.y * draw.Between(0, 1), size.z * draw.Between(0, 1)};
    };
    // Aimed at a shape's own box, which hardly any other ray would meet in scenes of many scales.
    const auto& instance =
        world.Instances()[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(world.Instances().size()) - 1))];
    const R3::Box own = world.Frames()[instance.frame] * instance.node->bounds;
    const R3::Point target = own.low + R3::Vector{own.Size().x * draw.Between(0, 1), own.Size().y * draw.Between(0, 1),
                                                  own.Size().z * draw.Between(0, 1)};
    const R3::Point origin = draw.Whole(0, 1) ? target + 4 * own.Radius() * draw.Direction()
                                              : box.Center() + 2 * box.Radius() * draw.Direction();
    R3::Vector d = target - origin;
    if (draw.Whole(0, 9) == 0) d = {d.x, 0, 0};  // along an axis
    if (draw.Whole(0, 9) == 0) list.push_back({own.Corner(draw.Whole(0, 7)), inside() - origin});
    list.push_back({origin, d});
    ray::Workspace workspace;
    if (const auto hit = none->Intersect(list.back(), workspace))  // and on from the surface found
      list.push_back({SpawnPoint(world.At(list.back(), *hit), -d), -d});
  }
  for (int switches = 0; switches < 8; ++switches) {
    const ray::AcceleratorSettings how{"graph", (switches & 1) == 0, (switches & 2) == 0, (switches & 4) == 0};
    const auto graph = ray::FindAcceleratorKind("graph")->Make(world, how);
    ray::Workspace for_none, for_graph;
    const std::string name = "switches " + std::to_string(switches);
    for (const R3::Ray& ray : list) {
      ExpectSame(graph->Intersect(ray, for_graph), none->Intersect(ray, for_none), ray, name.c_str());
      const R3::Ray shadow{ray.origin, ray.direction, 0, 1};
      EXPECT_EQ(graph->IsOccluded(shadow, for_graph), none->IsOccluded(shadow, for_none))
          << name << ' ' << oracle::Hex(ray);
    }
  }
}

TEST(Graph, AgreesWithBruteForceInRandomScenes) {
  for (const double powers : {0.0, 1.0, 3.0, 6.0})
    for (int seed = 0; seed < Count(15, 1000); ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 800);
      ray::Scene scene;
      scene.root = RandomGroup(draw, 3, powers);
      scene.root.transform = {};
      SetBounds(scene.root);
      SCOPED_TRACE("seed " + std::to_string(seed) + " powers " + std::to_string(powers));
      CompareInOneScene(scene, draw, 60);
    }
}

ray::Node Leaf(std::shared_ptr<const R3::Shape> shape) {
  ray::Node node;
  node.shape = std::move(shape);
  SetBounds(node);
  return node;
}

TEST(Graph, AmongEqualDistancesTheLowestPrimitiveWins) {
  // Three copies of one box, the first one deepest in the graph and therefore tested last.
  const std::shared_ptr<const R3::Shape> box = R3::MakeShape("box", {-1, -1, -1, 1, 1, 1});
  ray::Scene scene;
  ray::Node inner, outer;
  inner.children.push_back(Leaf(box));
  SetBounds(inner);
  outer.children.push_back(std::move(inner));
  SetBounds(outer);
  scene.root.children.push_back(std::move(outer));
  scene.root.children.push_back(Leaf(box));
  scene.root.children.push_back(Leaf(box));
  SetBounds(scene.root);
  const ray::World world(scene);
  for (const auto* kind : ray::AcceleratorKinds()) {
    ray::Workspace workspace;
    const auto hit = kind->Make(world, {})->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace);
    ASSERT_TRUE(hit);
    EXPECT_EQ(world.PrimitiveId(*hit), 0) << kind->name;
  }
}

TEST(Graph, EachOfItsOptimizationsSavesTests) {
  // A row of groups of spheres seen end-on: boxes skip whole groups, order skips farther ones, the cache finds
  // neighbors.
  ray::Scene scene;
  for (int g = 0; g < 20; ++g) {
    ray::Node group;
    group.transform.m[2][3] = -3.0 * (19 - g);  // farthest first in the file
    for (int i = 0; i < 20; ++i) group.children.push_back(Leaf(R3::MakeShape("sphere", {3.0 * i, 0, 0, 1})));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
  }
  SetBounds(scene.root);
  const ray::World world(scene);
  const auto primitive_tests = [&](const ray::AcceleratorSettings& how) {
    const auto accelerator = ray::FindAcceleratorKind(how.name)->Make(world, how);
    ray::Workspace workspace;
    for (int i = 0; i < 100; ++i) accelerator->Intersect({{0.005 * i, 0.1, 10}, {0, 0, -1}}, workspace);
    return workspace.counts.primitive_tests;
  };
  const auto none = primitive_tests({"none"}), bare = primitive_tests({"graph", false, false, false});
  const auto boxes = primitive_tests({"graph", true, false, false}),
             sorted = primitive_tests({"graph", true, true, false});
  const auto cached = primitive_tests({"graph", true, true, true});
  EXPECT_EQ(none, 100u * 400u);
  EXPECT_EQ(bare, none);
  EXPECT_EQ(boxes, 100u * 20u);
  EXPECT_EQ(sorted, 100u);
  EXPECT_LE(cached, 101u);
}

TEST(World, InheritsMaterialsAndNumbersPrimitivesInFileOrder) {
  ray::Scene scene;
  scene.materials.resize(4);
  ray::Node a, b, c;
  a.material = 2;
  b.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));  // inherits through b from a
  c.material = 3;
  c.children.push_back(Leaf(R3::MakeShape("sphere", {1, 0, 0, 1})));
  ray::Node own = Leaf(R3::MakeShape("sphere", {2, 0, 0, 1}));
  own.material = 1;
  c.children.push_back(std::move(own));
  a.children.push_back(std::move(b));
  a.children.push_back(std::move(c));
  scene.root.children.push_back(std::move(a));
  scene.root.children.push_back(Leaf(R3::MakeShape("sphere", {3, 0, 0, 1})));
  const ray::World world(scene);
  ASSERT_EQ(world.Instances().size(), 4u);
  const int expected[] = {2, 3, 1, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(world.Instances()[i].material, &scene.materials[static_cast<std::size_t>(expected[i])]) << i;
    EXPECT_EQ(world.Instances()[i].first_primitive, static_cast<std::int64_t>(i));
    EXPECT_EQ(Bounds(*world.Instances()[i].shape).Center().x, static_cast<double>(i));
  }
  EXPECT_EQ(world.Frames().size(), 1u);  // no group has a transform of its own
}

TEST(Extremes, A6_ASingularGroupIsSkippedAndTheRestStays) {
  ray::Scene scene;
  ray::Node flat;
  flat.transform.m[1][1] = 0;
  flat.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  SetBounds(flat);
  EXPECT_EQ(flat.bounds, (R3::Box{{-1, 0, -1}, {1, 0, 1}}));
  scene.root.children.push_back(std::move(flat));
  scene.root.children.push_back(Leaf(R3::MakeShape("sphere", {5, 0, 0, 1})));
  SetBounds(scene.root);
  const ray::World world(scene);
  for (const auto* kind : ray::AcceleratorKinds()) {
    const auto accelerator = kind->Make(world, {});
    ray::Workspace workspace;
    EXPECT_FALSE(accelerator->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace));
    EXPECT_TRUE(accelerator->Intersect({{5, 0, 5}, {0, 0, -1}}, workspace));
  }
}

TEST(World, WarnsOnceWhereTransformsTogetherLeaveTheRangeOfDoubles) {
  ray::Scene scene;
  ray::Node outer, inner;
  for (std::size_t i = 0; i < 3; ++i) outer.transform.m[i][i] = inner.transform.m[i][i] = 1e-200;
  inner.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  outer.children.push_back(std::move(inner));
  scene.root.children.push_back(std::move(outer));
  const ray::World world(scene);
  EXPECT_EQ(world.Warnings().size(), 1u);
  EXPECT_TRUE(world.Instances().empty());
}

TEST(Extremes, H1_AHundredThousandLevelsAreTracedByEveryAccelerator) {
  ray::Node node = Leaf(R3::MakeShape("sphere", {0, 0, 0, 1}));
  Draw draw(810);
  for (int i = 0; i < 100'000; ++i) {
    ray::Node group;
    group.transform = draw.Rotation();
    group.children.push_back(std::move(node));
    SetBounds(group);
    node = std::move(group);
  }
  ray::Scene scene;
  scene.root.children.push_back(std::move(node));
  SetBounds(scene.root);
  const ray::World world(scene);
  for (const auto* kind : ray::AcceleratorKinds()) {
    ray::Workspace workspace;
    const auto hit = kind->Make(world, {})->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace);
    ASSERT_TRUE(hit) << kind->name;
    EXPECT_NEAR(hit->t, 4, 1e-12) << kind->name;
  }
}

}  // namespace
