// Lines over the scene: boxes where the tracer has them, and all of it near the scene, however large that is.

#include "source/inspect/SceneLines.h"
#include "R3/ShapeKind.h"

#include <gtest/gtest.h>

#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"
#include "tests/source/inspect/NodeCounts.h"

namespace {

void ExpectNear(const ray::Lines& lines, double most) {
  for (const ray::Vertex& vertex : lines)
    for (const float x : vertex.at) EXPECT_LE(std::abs(x), most);
}

/// A box as lines, undone: by its lowest and highest corner.
R3::Box BoxOf(const ray::Lines& lines, std::size_t first) {
  R3::Box box;
  for (std::size_t i = first; i < first + 24; ++i)
    box.Extend(R3::Point{lines[i].at[0], lines[i].at[1], lines[i].at[2]});
  return box;
}

TEST(NodeBoxes, AreTwelveLinesForEachNodeOfALevel) {
  Draw draw(911);
  for (int i = 0; i < 20; ++i) {
    const project::Stage stage(accelerators::RandomScene(draw, 0.5));
    const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
    const auto counts = graph::NodesWithBoxes(stage.scene->root);
    const int levels = static_cast<int>(counts.size());
    std::size_t sum = 0;
    for (int level = 0; level < levels; ++level) {
      const ray::BoxLines boxes = ray::NodeBoxLines(stage.world, space, level);
      EXPECT_EQ(boxes.boxes, counts[static_cast<std::size_t>(level)]);
      EXPECT_EQ(boxes.lines.size(), 2u * 12 * static_cast<std::size_t>(boxes.boxes));
      EXPECT_EQ(boxes.left_out, 0);
      sum += boxes.lines.size();
      // A group's box may stand out of its parent's once that is turned, but never far.
      ExpectNear(boxes.lines, 16);
    }
    EXPECT_EQ(ray::NodeBoxLines(stage.world, space, ray::all_levels).lines.size(), sum);
    EXPECT_TRUE(ray::NodeBoxLines(stage.world, space, levels).lines.empty());
  }
}

TEST(NodeBoxes, OfTheRootIsTheBoxOfTheScene) {
  const project::Stage stage(project::FromText("sphere -1  1 2 3  0.5\nbox -1  4 5 6  7 8 10\n"));
  const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
  const R3::Box box = BoxOf(ray::NodeBoxLines(stage.world, space, 0).lines, 0);
  const auto low = space.At({0.5, 1.5, 2.5}), high = space.At({7, 8, 10});
  EXPECT_EQ(box, (R3::Box{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}));
}

TEST(NodeBoxes, AreTurnedWithTheGroupAboveThem) {
  // A cube turned by an eighth about z, in a group: its own box is the cube, the group's is around the turned cube.
  const project::Stage stage(
      project::FromText("begin -1  0.6 -0.8 0 0  0.8 0.6 0 0  0 0 1 0  0 0 0 1\n box -1  -1 -1 -1  1 1 1\nend\n"));
  const ray::DrawingSpace space;
  const auto cube = ray::NodeBoxLines(stage.world, space, 2).lines;
  ASSERT_EQ(cube.size(), 24u);
  for (const ray::Vertex& v : cube) EXPECT_NEAR(std::hypot(v.at[0], v.at[1]), std::sqrt(2), 1e-6);
  EXPECT_NEAR(BoxOf(cube, 0).high.x, 1.4, 1e-6);
  EXPECT_NEAR(BoxOf(ray::NodeBoxLines(stage.world, space, 1).lines, 0).high.x, 1.4, 1e-6);
}

TEST(NodeBoxes, OfEmptyGroupsAreLeftOut) {
  const project::Stage stage(project::FromText("begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\nend\n"));
  EXPECT_EQ(graph::NodesWithBoxes(stage.scene->root), (std::vector<std::int64_t>{0, 0}));
  EXPECT_TRUE(ray::NodeBoxLines(stage.world, {}, ray::all_levels).lines.empty());
}

TEST(NodeBoxes, OfAHundredThousandLevelsNeedLittleStack) {
  constexpr int depth = 100'000;
  ray::Node node = accelerators::Leaf(R3::MakeShape("sphere", {0, 0, 0, 1}));
  for (int i = 0; i < depth; ++i) {
    ray::Node group;
    group.children.push_back(std::move(node));
    SetBounds(group);
    node = std::move(group);
  }
  ray::Scene scene;
  scene.root = std::move(node);
  const project::Stage stage(std::move(scene));
  EXPECT_TRUE(ray::NodeBoxLines(stage.world, {}, depth + 1).lines.empty());
  EXPECT_EQ(ray::NodeBoxLines(stage.world, {}, depth).boxes, 1);
  EXPECT_EQ(ray::NodeBoxLines(stage.world, {}, ray::all_levels).boxes, depth + 1);
}

TEST(AcceleratorBoxes, LieInTheSceneAndHoldAllItsHits) {
  Draw draw(912);
  for (int i = 0; i < 20; ++i) {
    const project::Stage stage(accelerators::RandomScene(draw, 0.5));
    const R3::Box& bounds = stage.scene->root.bounds;
    const double pad = 1e-5 * bounds.Radius();  // single precision, and room for rays from afar
    const R3::Vector pads{pad, pad, pad};
    const R3::Box padded{bounds.low - pads, bounds.high + pads};
    const auto rays = accelerators::RaysAt(stage.world, draw, 200);
    for (const auto* kind : ray::AcceleratorKinds()) {
      const auto accelerator = kind->Make(stage.world, {});
      const bool is_tree = accelerator->BoxLevels() > 0;
      EXPECT_TRUE(is_tree || (kind->name != std::string("bvh") && kind->name != std::string("octree")));
      EXPECT_EQ(accelerator->BoxesAt(0).size(), is_tree ? 1u : 0u) << kind->name;
      EXPECT_TRUE(accelerator->BoxesAt(-1).empty());
      EXPECT_TRUE(accelerator->BoxesAt(accelerator->BoxLevels()).empty());
      for (int level = 0; level < accelerator->BoxLevels(); ++level) {
        const auto boxes = accelerator->BoxesAt(level);
        EXPECT_FALSE(boxes.empty()) << kind->name << ' ' << level;
        for (const R3::Box& box : boxes) {
          EXPECT_TRUE(padded.Contains(box.low) && padded.Contains(box.high)) << kind->name << ' ' << level;
        }
        const ray::BoxLines lines = ray::AcceleratorBoxLines(*accelerator, ray::DrawingSpace::Of(bounds), level);
        EXPECT_EQ(lines.lines.size(), 24 * boxes.size());
        ExpectNear(lines.lines, 1.001);
      }
      if (accelerator->BoxLevels() < 2) continue;
      ray::Workspace workspace;
      for (const R3::Ray& ray : rays) {
        const auto hit = accelerator->Intersect(ray, workspace);
        if (!hit) continue;
        const R3::Point at = stage.world.At(ray, *hit).position;
        const auto boxes = accelerator->BoxesAt(1);
        EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const R3::Box& box) {
          return R3::Box{box.low - pads, box.high + pads}.Contains(at);
        })) << kind->name;
      }
    }
  }
}

TEST(AcceleratorBoxes, AreTheBoundsOfOneLeafAndNoneOfNothing) {
  const project::Stage one(project::FromText("sphere -1  1 2 3  0.5\n")), nothing(project::FromText("\n"));
  for (const auto* kind : ray::AcceleratorKinds()) {
    EXPECT_EQ(kind->Make(nothing.world, {})->BoxLevels(), 0) << kind->name;
    const auto accelerator = kind->Make(one.world, {});
    if (accelerator->BoxLevels() == 0) continue;
    EXPECT_EQ(accelerator->BoxesAt(0)[0], one.scene->root.bounds) << kind->name;
  }
}

TEST(CameraLines, GoThroughTheCornersOfTheImage) {
  const ray::Camera camera = ray::Aim({1, 2, 3}, {0, 0, -1}, {0, 1, 0}).camera;
  const ray::Lines lines = ray::CameraLines(camera, 200, 100, 2, {}, {255, 255, 255, 255});
  const double half = 2 * std::tan(camera.xfov);
  bool is_there = false;
  for (const ray::Vertex& v : lines)
    is_there |= std::abs(v.at[0] - (1 - half)) < 1e-5 && std::abs(v.at[1] - (2 - half / 2)) < 1e-5 &&
                std::abs(v.at[2] - 1) < 1e-5;
  EXPECT_TRUE(is_there);
  EXPECT_EQ(lines.size() % 2, 0u);
}

TEST(LightLines, AreThereForEveryKindOfLightInItsColor) {
  for (const ray::LightKind* kind : ray::LightKinds()) {
    ray::Scene scene;
    scene.lights.push_back(kind->make(kind->example));
    const ray::DrawingSpace space{{0, 0, 0}, 10};
    const ray::Lines lines = ray::LightLines(scene, space);
    ASSERT_GE(lines.size(), 6u) << kind->name;
    ExpectNear(lines, 2);
    for (const ray::Vertex& v : lines) {
      EXPECT_EQ(v.color[0], 255) << kind->name;  // examples are red most of all
      EXPECT_LT(v.color[2], v.color[0]) << kind->name;
    }
  }
}

TEST(LightLines, OfDirectedLightsHaveAnArrowThatWay) {
  const auto lines = [](const std::string& text) {
    const project::Stage stage(project::FromText(text));
    return ray::LightLines(*stage.scene, {});
  };
  const auto star = lines("point_light 1 1 1  0 0 0  1 0 0\n"),
             spot = lines("spot_light 1 1 1  0 0 0  0 -1 0  1 0 0  0.5 2\n");
  EXPECT_GT(spot.size(), star.size());
  double lowest = 0;
  for (const ray::Vertex& v : spot) lowest = std::min(lowest, static_cast<double>(v.at[1]));
  EXPECT_NEAR(lowest, -0.25, 0.01);
}

TEST(SceneLineLines, AreWhereTheirGroupsBringThem) {
  const project::Stage stage(
      project::FromText("begin -1  2 0 0 1  0 2 0 0  0 0 2 0  0 0 0 1\n line -1  0 0 0  1 2 3\nend\n"));
  const ray::Lines lines = ray::SceneLineLines(stage.world, {});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].at, (std::array<float, 3>{1, 0, 0}));
  EXPECT_EQ(lines[1].at, (std::array<float, 3>{3, 4, 6}));
  EXPECT_EQ(ray::SceneLineLines(project::Stage(project::Root() / "scenes/lines.scn").world, {}).size(), 24u);
}

TEST(NodeBoxes, OfVeryManyThingsAreFaint) {
  const auto alpha_of = [](int count) {
    ray::Scene scene;
    for (int i = 0; i < count; ++i)
      scene.root.children.push_back(accelerators::Leaf(R3::MakeShape("sphere", {2.0 * i, 0, 0, 1})));
    SetBounds(scene.root);
    const project::Stage stage(std::move(scene));
    return ray::NodeBoxLines(stage.world, {}, ray::all_levels).lines.at(0).color[3];
  };
  EXPECT_EQ(alpha_of(10), 255);
  EXPECT_LT(alpha_of(5'000), 30);
  EXPECT_GT(alpha_of(5'000), 0);
}

TEST(LevelColors, OfNeighborsDiffer) {
  for (int level = 0; level < 50; ++level)
    for (int other = level + 1; other < level + 4; ++other) {
      const ray::Rgba a = ray::LevelColor(level), b = ray::LevelColor(other);
      int apart = 0;
      for (std::size_t i = 0; i < 3; ++i) apart += std::abs(a[i] - b[i]);
      EXPECT_GT(apart, 60) << level << ' ' << other;
    }
}

TEST(Marks, AreLinesAtAPoint) {
  EXPECT_EQ(ray::AxesAt({1, 2, 3}, 0.5, {}).size(), 6u);
  EXPECT_EQ(ray::CrossAt({1, 2, 3}, 0.5, {}, {}).size(), 6u);
  const ray::Lines arrow = ray::ArrowAt({1, 2, 3}, {0, 2, 0}, {}, {});
  EXPECT_EQ(arrow[1].at, (std::array<float, 3>{1, 4, 3}));
  EXPECT_EQ(ray::ArrowAt({1, 2, 3}, {}, {}, {}).size(), 2u);
}

}  // namespace
