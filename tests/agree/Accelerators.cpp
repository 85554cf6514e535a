// For any scene and ray, every accelerator, in every variation and on every instruction set, finds the hits that
// testing every primitive finds.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace {

using accelerators::Compare;
using accelerators::EveryWay;
using accelerators::Group;
using accelerators::Leaf;

TEST(Accelerators, AgreeInRandomScenesOfEveryShapeAndScale) {
  const auto ways = EveryWay();
  for (const double powers : {0.0, 1.0, 3.0, 6.0})
    for (int seed = 0; seed < Count(12, 1000); ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 900);
      const ray::Scene scene = accelerators::RandomScene(draw, powers, AllShapeKinds());
      const ray::World world(scene);
      SCOPED_TRACE("seed " + std::to_string(seed + 900) + " powers " + std::to_string(powers));
      Compare(world, accelerators::RaysAt(world, draw, 60), ways);
    }
}

TEST(Accelerators, AgreeInRandomSoupsOfTriangles) {
  const auto ways = EveryWay();
  for (int seed = 0; seed < Count(20, 1000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 950);
    R3::MeshData data;
    const double shift = draw.Whole(0, 1) ? 0 : draw.Scale(0, 8), size = draw.Scale(-3, 0);
    for (std::uint32_t i = 0; i < 400; ++i) {
      const R3::Point a = R3::Point{shift, -shift, shift} + draw.Between(0, 1) * draw.Direction();
      const R3::Vector along = size * draw.Direction(), across = draw.Scale(-6, 0) * size * draw.Direction();
      for (const R3::Point& p : {a, a + along, a + across}) data.positions.push_back(p);
      data.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto positions = data.positions;
    ray::Scene scene;
    scene.root.children.push_back(Leaf(std::make_shared<R3::Mesh>(std::move(data))));
    SetBounds(scene.root);
    const ray::World world(scene);
    auto rays = accelerators::RaysAt(world, draw, 150);
    for (int i = 0; i < 150; ++i) {  // exactly at corners and along edges
      const auto k = static_cast<std::size_t>(draw.Whole(0, static_cast<int>(positions.size()) - 1));
      const R3::Point from = R3::Point{shift, -shift, shift} + draw.Scale(-1, 3) * draw.Direction();
      rays.push_back({from, positions[k] - from});
      rays.push_back({positions[k], positions[k / 3 * 3 + (k + 1) % 3] - positions[k]});
    }
    SCOPED_TRACE("seed " + std::to_string(seed + 950));
    Compare(world, rays, ways);
  }
}

/// Returns rays past a sphere within some ulps of a tangent, from near and far and from inside, and along its surface.
std::vector<R3::Ray> RaysGrazing(const R3::Point& center, double radius, Draw& draw) {
  std::vector<R3::Ray> rays;
  for (int i = 0; i < 4; ++i) {
    const R3::Vector along = draw.Direction(), across = Unit(Cross(along, draw.Direction()));
    const double miss = radius * (1 + draw.Whole(-3, 3) * 0x1p-52), far = draw.Scale(-3, 9) * std::max(radius, 1e-6);
    const double length = draw.Scale(-6, 6);
    rays.push_back({center - far * along + miss * across, length * along});
    rays.push_back({center - far * along, length * (far * along + miss * across)});
    rays.push_back({center + draw.Between(0, 1) * radius * across, length * along, 0, draw.Scale(-3, 3)});
    rays.push_back({center + radius * across, length * (along + draw.Whole(-2, 2) * 0x1p-50 * across)});
  }
  return rays;
}

TEST(Accelerators, AgreeAboutSpheresOfAnySizeThatRaysGraze) {
  const auto ways = EveryWay();
  for (int seed = 0; seed < Count(12, 1000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 1200);
    const double shift = draw.Whole(0, 1) ? 0 : draw.Scale(0, 8), size = draw.Scale(-6, 1);
    ray::Scene scene;
    std::vector<R3::Ray> rays;
    for (int i = 0; i < 60; ++i) {
      const R3::Point center = R3::Point{shift, -shift, shift} + draw.Between(0, 1) * draw.Direction();
      const double radius = draw.Whole(0, 19) == 0 ? 0 : draw.Whole(0, 19) == 0 ? 1e3 : size * draw.Scale(-6, 0);
      auto& siblings = scene.root.children;
      siblings.push_back(Leaf(R3::MakeShape("sphere", {center.x, center.y, center.z, radius})));
      if (draw.Whole(0, 3) == 0) {
        ray::Node group = Group(draw.Affine(1));
        group.children.push_back(std::move(siblings.back()));
        SetBounds(group);
        siblings.back() = std::move(group);
      }
      for (const R3::Ray& ray : RaysGrazing(center, radius, draw)) rays.push_back(ray);
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    for (const R3::Ray& ray : accelerators::RaysAt(world, draw, 60)) rays.push_back(ray);
    SCOPED_TRACE("seed " + std::to_string(seed + 1200));
    Compare(world, rays, ways);
  }
}

// Below 1e-140 and above 1e100 the products of a triangle test leave the range of doubles.
TEST(Accelerators, AgreeAtTheEndsOfTheRangeOfNumbers) {
  Draw draw(955);
  for (const double size : {1e-100, 1e-30, 1.0, 1e30, 1e100}) {
    R3::MeshData data = accelerators::BumpyBall(8, 6);
    for (R3::Point& p : data.positions) p = R3::Point{size * p.x, size * p.y, size * p.z};
    ray::Scene scene;
    scene.root.children.push_back(Leaf(std::make_shared<R3::Mesh>(std::move(data))));
    scene.root.children.push_back(Leaf(R3::MakeShape("box", {0, 0, 0, size, size, size})));
    SetBounds(scene.root);
    const ray::World world(scene);
    std::vector<R3::Ray> rays;
    for (int i = 0; i < 200; ++i) {
      const R3::Vector from = draw.Between(0, 3) * draw.Direction(), to = draw.Direction();
      const double length = draw.Scale(-300, 300), far = draw.Whole(0, 3) ? size : draw.Scale(-300, 300);
      rays.push_back({R3::Point{} + far * from, length * (to - from)});
      if (draw.Whole(0, 4) == 0) rays.back().t_min = -R3::infinity;
      if (draw.Whole(0, 4) == 0) rays.back().t_min = draw.Between(-2, 1) * size / length;
      if (draw.Whole(0, 4) == 0) rays.back().t_max = draw.Between(1, 2) * size / length;
    }
    SCOPED_TRACE("size " + std::to_string(std::log10(size)));
    Compare(world, rays, EveryWay());
  }
}

TEST(Extremes, C5_AcceleratorsAgreeOnRaysInSplittingPlanes) {
  // A lattice of unit boxes made of triangles and shapes: grids, octrees and boxes divide it along whole numbers.
  Draw draw(960);
  ray::Scene scene;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        if (draw.Whole(0, 2) == 0) continue;
        const double a = x, b = y, c = z;
        if (draw.Whole(0, 1))
          scene.root.children.push_back(Leaf(R3::MakeShape("box", {a, b, c, a + 1, b + 1, c + 1})));
        else
          scene.root.children.push_back(Leaf(R3::MakeShape("tri", {a, b, c, a + 1, b, c, a, b + 1, c + 1})));
      }
  SetBounds(scene.root);
  const ray::World world(scene);
  std::vector<R3::Ray> rays;
  for (int i = 0; i < Count(6'000, 1'000'000); ++i) {
    const auto half = [&](int low, int high) { return 0.5 * draw.Whole(low, high); };
    const auto part = [&] { return draw.Whole(0, 1) ? half(-2, 2) : draw.Whole(0, 1) ? 0.0 : -0.0; };
    rays.push_back({{half(-8, 8), half(-8, 8), half(-8, 8)}, {part(), part(), part()}});
    if (rays.back().direction == R3::Vector{}) rays.pop_back();
  }
  Compare(world, rays, EveryWay());
}

TEST(Extremes, C6_BadRaysHitNothingAndAreCounted) {
  ray::Scene scene;
  scene.root.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, 0, 1})));
  scene.root.children.push_back(Leaf(std::make_shared<R3::Mesh>(accelerators::BumpyBall(8, 6))));
  SetBounds(scene.root);
  const ray::World world(scene);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = R3::infinity;
  const std::vector<R3::Ray> bad{{{0, 0, 5}, {0, 0, 0}},        {{0, 0, 5}, {0, -0.0, 0}},   {{0, 0, 5}, {0, nan, -1}},
                                 {{0, 0, 5}, {0, 0, -inf}},     {{nan, 0, 5}, {0, 0, -1}},   {{0, inf, 5}, {0, 0, -1}},
                                 {{0, 0, 5}, {0, 0, -1}, 7, 3}, {{0, 0, 5}, {0, 0, -1}, nan}};
  for (const auto& way : EveryWay()) {
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    ray::Workspace workspace;
    for (const R3::Ray& ray : bad) {
      EXPECT_FALSE(accelerator->Intersect(ray, workspace)) << way.name << ' ' << oracle::Hex(ray);
      EXPECT_FALSE(accelerator->IsOccluded(ray, workspace)) << way.name << ' ' << oracle::Hex(ray);
    }
    EXPECT_EQ(workspace.counts.bad_rays, 2 * bad.size()) << way.name;
    EXPECT_EQ(workspace.counts.primitive_tests, 0u) << way.name;
  }
}

TEST(Extremes, C6_BadRaysHitNothingAndAffectNoOthers) {
  ray::Scene scene;
  scene.root.children.push_back(Leaf(std::make_shared<R3::Mesh>(accelerators::BumpyBall(8, 6))));
  scene.root.children.push_back(Leaf(R3::MakeShape("plane", {0, -3, 0, 0, 1, 0})));  // which no box contains
  SetBounds(scene.root);
  const ray::World world(scene);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = R3::infinity;
  std::vector<R3::Ray> bad{{{0, 0, 5}, {0, 0, 0}}, {{0, 0, 5}, {0, 0, -1}, 7, 3}, {{0, 0, 5}, {0, 0, -1}, 0, nan}};
  for (const double x : {nan, inf, -inf})
    for (const R3::Vector& where : {R3::Vector{x, 0, 0}, R3::Vector{0, x, 0}, R3::Vector{0, 0, x}}) {
      bad.push_back({R3::Point{0, 0, 5} + where, {.1, .1, -1}});
      bad.push_back({{0, 0, 5}, R3::Vector{.1, .1, -1} + where});
    }
  for (const auto& way : EveryWay()) {
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    for (std::size_t i = 0; i < bad.size(); ++i) {
      std::vector<R3::Ray> rays;
      for (int k = 0; k < 16; ++k) rays.push_back({{0, 0, 5}, {.1 * (k % 4) - .15, .1 * (k / 4) - .15, -1}});
      rays[i % 16] = bad[i];
      std::vector<std::optional<ray::WorldHit>> hits(rays.size());
      bool is_occluded[16];
      ray::Workspace together, alone;
      accelerator->Intersect(rays, hits.data(), together);
      accelerator->IsOccluded(rays, is_occluded, together);
      EXPECT_EQ(together.counts.bad_rays, 2u) << way.name << ' ' << oracle::Hex(bad[i]);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        const auto hit = accelerator->Intersect(rays[k], alone);
        EXPECT_EQ(hits[k].has_value(), hit.has_value()) << way.name << ' ' << oracle::Hex(rays[k]);
        EXPECT_EQ(is_occluded[k], hit.has_value()) << way.name << ' ' << oracle::Hex(rays[k]);
        if (hit && hits[k]) {
          EXPECT_EQ(hits[k]->t, hit->t) << way.name << ' ' << oracle::Hex(rays[k]);
        }
      }
      EXPECT_FALSE(hits[i % 16]) << way.name << ' ' << oracle::Hex(bad[i]);
    }
  }
}

TEST(Extremes, C9_AcceleratorsAgreeOnScenesFlatAlongAnyAxes) {
  Draw draw(970);
  for (int flat = 1; flat < 8; ++flat) {
    ray::Scene scene;
    const auto extent = [&](int axis) { return flat >> axis & 1 ? 0.0 : draw.Between(-2, 2); };
    for (int i = 0; i < 40; ++i) {
      const double x = extent(0), y = extent(1), z = extent(2);
      // Boxes may be flat; a mesh that is flat in one axis still has area.
      scene.root.children.push_back(Leaf(R3::MakeShape(
          "box", {x, y, z, x + (flat & 1 ? 0 : 0.5), y + (flat & 2 ? 0 : 0.5), z + (flat & 4 ? 0 : 0.5)})));
      if (flat == 1 || flat == 2 || flat == 4)
        scene.root.children.push_back(Leaf(R3::MakeShape("tri", {extent(0), extent(1), extent(2), extent(0), extent(1),
                                                                 extent(2), extent(0), extent(1), extent(2)})));
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    SCOPED_TRACE("flat axes " + std::to_string(flat));
    Compare(world, accelerators::RaysAt(world, draw, 150), EveryWay());
  }
}

TEST(Extremes, C8_C10_AcceleratorsFindATinyMeshInAHugeOne) {
  Draw draw(980);
  ray::Scene scene;
  R3::Matrix huge, tiny;
  huge.m = {{{1e6, 0, 0, 0}, {0, 1e6, 0, 0}, {0, 0, 1e6, 0}}};
  tiny.m = {{{1e-6, 0, 0, 3}, {0, 1e-6, 0, -2}, {0, 0, 1e-6, 1}}};
  for (const auto& [matrix, sides] : {std::pair{huge, 12}, {tiny, 24}}) {
    ray::Node group = Group(matrix);
    group.children.push_back(Leaf(std::make_shared<R3::Mesh>(accelerators::BumpyBall(sides, sides))));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
  }
  SetBounds(scene.root);
  const ray::World world(scene);
  auto rays = accelerators::RaysAt(world, draw, 100);
  for (int i = 0; i < 100; ++i) {
    const R3::Vector d = draw.Direction();
    rays.push_back({R3::Point{3, -2, 1} - 1e-5 * d + 5e-7 * draw.Direction(), d});
  }
  Compare(world, rays, EveryWay());
  for (const auto& way : EveryWay()) {
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    EXPECT_LE(accelerator->Bytes(), 4000u * static_cast<std::size_t>(world.Primitives())) << way.name;
  }
}

TEST(Extremes, A11_InstancesEqualCopiesButShareOneMesh) {
  Draw draw(990);
  const auto mesh = std::make_shared<R3::Mesh>(accelerators::BumpyBall(12, 8));
  const auto scene_of = [&](bool is_shared, int count) {
    Draw places(7);
    ray::Scene scene;
    for (int i = 0; i < count; ++i) {
      R3::Matrix m;  // whole numbers and powers of two: moving corners rounds nothing
      const double scale = places.Whole(0, 1) ? 0.5 : 1;
      m.m = {{{scale, 0, 0, 4.0 * places.Whole(-8, 8)},
              {0, scale, 0, 4.0 * places.Whole(-8, 8)},
              {0, 0, scale, 4.0 * places.Whole(-8, 8)}}};
      ray::Node group = Group(m);
      group.children.push_back(Leaf(is_shared ? mesh : std::make_shared<R3::Mesh>(*mesh)));
      SetBounds(group);
      scene.root.children.push_back(std::move(group));
    }
    SetBounds(scene.root);
    return scene;
  };
  const ray::Scene shared = scene_of(true, 60), copied = scene_of(false, 60);
  const ray::World shared_world(shared), copied_world(copied);
  ASSERT_EQ(shared_world.SharedMeshes().size(), 1u);
  ASSERT_EQ(copied_world.SharedMeshes().size(), 0u);
  const auto rays = accelerators::RaysAt(shared_world, draw, 200);
  Compare(shared_world, rays, EveryWay());
  Compare(copied_world, rays, EveryWay());
  // The copies' corners are rounded once more, so the same hit may differ in its last digits, not in what it is.
  const auto a = ray::FindAcceleratorKind("bvh")->Make(shared_world, {}),
             b = ray::FindAcceleratorKind("bvh")->Make(copied_world, {});
  int same = 0, hits = 0;
  for (const R3::Ray& ray : rays) {
    ray::Workspace w;
    const auto one = a->Intersect(ray, w), other = b->Intersect(ray, w);
    if (!one || !other) continue;
    ++hits;
    same += std::abs(one->t - other->t) <= 1e-9 * one->t;
  }
  EXPECT_GT(hits, 100);
  EXPECT_GE(same, hits - 3);  // at an outline the last digit decides
  const ray::Scene many = scene_of(true, 20'000);
  const ray::World many_world(many);
  for (const char* kind : {"bvh"})
    EXPECT_LE(ray::FindAcceleratorKind(kind)->Make(many_world, {})->Bytes(), 200u * 20'000u) << kind;
}

TEST(Extremes, D7_OfCoincidentShapesTheFirstWins) {
  Draw draw(995);
  ray::Scene scene;
  R3::MeshData copies;
  copies.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, 0.5, 0}, {1, 0.5, 0}, {0, -1.5, 0}};
  for (int i = 0; i < 1'000; ++i) copies.triangles.push_back({0, 1, 2});
  copies.triangles.push_back({3, 4, 5});  // overlaps them in their plane
  scene.root.children.push_back(Leaf(std::make_shared<R3::Mesh>(std::move(copies))));
  const std::shared_ptr<const R3::Shape> sphere = R3::MakeShape("sphere", {0, 0, -3, 1});
  for (int i = 0; i < 200; ++i) scene.root.children.push_back(Leaf(sphere));
  SetBounds(scene.root);
  const ray::World world(scene);
  Compare(world, accelerators::RaysAt(world, draw, 30), EveryWay());
}

TEST(Extremes, D7_H2_AMillionNearDuplicatesBuildInBoundedTimeAndMemory) {
  const int count = Count(100'000, 1'000'000);
  ray::Scene scene;
  // One box for all in single precision; no two are equal.
  for (int i = 0; i < count; ++i)
    scene.root.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, -3, 1 - 0x1p-52 * i})));
  scene.root.children.resize(static_cast<std::size_t>(count) + 1000);  // and empty nodes
  SetBounds(scene.root);
  const ray::World world(scene);
  ASSERT_EQ(world.Primitives(), count);
  for (const char* kind : {"graph", "grid", "octree", "bvh", "auto"}) {
    const auto accelerator = ray::FindAcceleratorKind(kind)->Make(world, {.name = kind});
    EXPECT_LE(accelerator->Bytes(), 200u * static_cast<std::size_t>(count)) << kind;
    ray::Workspace workspace;
    const auto hit = accelerator->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace);
    ASSERT_TRUE(hit) << kind;
    EXPECT_EQ(hit->instance, 0u) << kind;
    EXPECT_TRUE(accelerator->IsOccluded({{0, 0, 5}, {0, 0, -1}}, workspace)) << kind;
    EXPECT_FALSE(accelerator->IsOccluded({{3, 0, 5}, {0, 0, -1}}, workspace)) << kind;
  }
}

// Ten million triangles in nightly tests.
TEST(Extremes, D10_AHugeMeshTakesBoundedMemoryAndIsHit) {
  const int sides = Count(400, 2240);
  ray::Scene scene;
  auto mesh = std::make_shared<const R3::Mesh>(accelerators::BumpyBall(sides, sides));
  scene.root.children.push_back(Leaf(mesh));
  SetBounds(scene.root);
  const ray::World world(scene);
  const auto triangles = static_cast<std::size_t>(world.Primitives());
  EXPECT_GE(triangles, Count(300'000, 10'000'000));
  for (const char* kind : {"bvh", "octree", "grid"}) {
    const auto accelerator = ray::FindAcceleratorKind(kind)->Make(world, {.name = kind});
    EXPECT_LE(accelerator->Bytes(), 200 * triangles) << kind;
    ray::Workspace workspace;
    EXPECT_TRUE(accelerator->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace)) << kind;
    EXPECT_FALSE(accelerator->IsOccluded({{3, 0, 5}, {0, 0, -1}}, workspace)) << kind;
  }
}

// Each ray once tested each of 100,000 spheres: a minute for the smallest image.
TEST(Extremes, D7_ARayTestsOneOfManyEqualShapes) {
  const R3::Matrix aside{{{{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  ray::Scene scene;
  const auto add = [&](const char* kind, const std::vector<double>& numbers, bool is_aside) {
    ray::Node leaf = Leaf(R3::MakeShape(kind, numbers));
    if (!is_aside) return scene.root.children.push_back(std::move(leaf));
    ray::Node group = Group(aside);
    group.children.push_back(std::move(leaf));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
  };
  constexpr int each = 1000;
  for (int i = 0; i < each; ++i) {
    add("sphere", {0, 0, 0, 1}, false);
    add("sphere", {0, 0, 0, 1}, true);
    add("box", {-1, -1, -1, 1, 1, 1}, false);  // in the same box as the sphere, but different
    add("plane", {0, -3, 0, 0, 1, 0}, false);
  }
  SetBounds(scene.root);
  const ray::World world(scene);
  Draw draw(996);
  Compare(world, accelerators::RaysAt(world, draw, 30), EveryWay());
  for (const char* kind : {"graph", "grid", "octree", "bvh", "auto"}) {
    const auto accelerator = ray::FindAcceleratorKind(kind)->Make(world, {.name = kind});
    ray::Workspace workspace;
    for (const double x : {0.0, 5.0}) {
      const R3::Ray ray{{x, 0.25, 9}, {0, -0.125, -1}};
      const auto hit = accelerator->Intersect(ray, workspace);
      ASSERT_TRUE(hit);
      EXPECT_LT(hit->instance, 4u);
    }
    EXPECT_LE(workspace.counts.primitive_tests, 40u) << kind;
  }
}

// Shapes that differ in the last bit, in motion or in material are still separate.
TEST(Extremes, D7_AlmostEqualShapesAreTested) {
  ray::Scene scene;
  const auto add_at = [&](double shift, const R3::Vector& motion, double radius) {
    ray::Node group = Group(R3::Matrix{{{{1, 0, 0, shift}, {0, 1, 0, 0}, {0, 0, 1, 0}}}});
    group.motion = motion;
    group.children.push_back(Leaf(R3::MakeShape("sphere", {0, 0, 0, radius})));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
  };
  add_at(0, {}, 1);
  add_at(0, {}, std::nextafter(1, 2));
  add_at(0, {3, 0, 0}, 1);
  add_at(std::nextafter(0, 1), {}, 1);
  add_at(0, {}, 1);
  SetBounds(scene.root);
  const ray::World world(scene);
  for (std::size_t i = 0; i < world.Instances().size(); ++i) EXPECT_EQ(world.Instances()[i].is_repeated, i == 4) << i;
}

}  // namespace
