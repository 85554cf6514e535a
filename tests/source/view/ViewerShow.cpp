// What is drawn over the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numeric>

#include "source/inspect/SceneLines.h"
#include "tests/source/view/ScriptedViewer.h"
#include "tests/source/inspect/NodeCounts.h"

namespace ray {
namespace {

TEST_F(ViewerTest, AnUnlitSceneAnnouncesTheLightAtTheEye) {
  const CopiedScenes folder;
  std::ofstream(folder / "dark.scn") << "point_light 0 0 0  0 0 0  1 0 0\nsphere -1  0 0 0  1\n";
  Open(folder / "dark.scn");
  Do("tick 0.1");
  EXPECT_NE(viewer_->Message().find("light at the eye"), std::string::npos) << viewer_->Message();
}

TEST_F(ViewerTest, LightsOutsideOfTheSceneAreDrawnAndFramed) {
  const auto furthest = [&] {
    double most = 0;
    const auto lines = viewer_->Show().lines;
    for (const Vertex& v : *lines) most = std::max(most, static_cast<double>(std::hypot(v.at[0], v.at[1], v.at[2])));
    return most;
  };
  EXPECT_LT(furthest(), 1);
  Do("key L");
  EXPECT_NE(viewer_->Message().find("2 lights, 2 out of view"), std::string::npos) << viewer_->Message();
  EXPECT_GT(furthest(), 1.2);
  Do("key F");
  for (const auto& light : viewer_->scene().parsed.scene.lights) {
    const R3::Point p = light->Bound().center;
    const auto pixel = PixelOf(camera(), p, {width, height});
    ASSERT_TRUE(pixel);
    EXPECT_TRUE(pixel->x > 0 && pixel->x < width && pixel->y > 0 && pixel->y < height);
    // Between the near and the far plane.
    const ClipMatrix m = viewer_->Show().clip_from_drawing;
    const auto at = DrawingSpace::Of(viewer_->scene().parsed.scene.root.bounds).At(p);
    const auto row = [&](std::size_t r) { return m[r] * at[0] + m[4 + r] * at[1] + m[8 + r] * at[2] + m[12 + r]; };
    EXPECT_LT(std::abs(row(2)), row(3));
  }
}

TEST_F(ViewerTest, ThePickIsMarkedAtOneSizeHoweverNear) {
  const auto extent = [&] {
    const auto marks = viewer_->Show().marks;
    const DrawingSpace space = DrawingSpace::Of(viewer_->scene().parsed.scene.root.bounds);
    double least = width, most = 0;
    for (const Vertex& v : *marks) {
      const R3::Point p = space.center + space.radius * R3::Vector{v.at[0], v.at[1], v.at[2]};
      const auto pixel = PixelOf(camera(), p, {width, height});
      EXPECT_TRUE(pixel);
      least = std::min(least, pixel->x), most = std::max(most, pixel->x);
    }
    return most - least;
  };
  Do("click left 32 24");
  const double before = extent();
  EXPECT_GT(before, 4);
  Do("scroll 10 32 24");
  EXPECT_NEAR(extent(), before, 0.15 * before);  // less a little perspective
}

TEST_F(ViewerTest, GridRaysCoverEvery25thPixelAndStayPut) {
  Do("resize 512 512\nkey G");
  ASSERT_EQ(viewer_->Rays().Grid().size(), 441u);
  const LoadedScene& scene = viewer_->scene();
  const auto none = FindAcceleratorKind("none")->Make(scene.world, {});
  Workspace workspace;
  for (const PixelTrace& trace : viewer_->Rays().Grid()) {
    EXPECT_EQ(trace.column % 25, 0);
    EXPECT_EQ(trace.row % 25, 0);
    int roots = 0;
    for (const RecordedRay& ray : trace.rays) {
      roots += ray.parent == RecordedRay::none;
      EXPECT_LT(ray.parent, &ray - trace.rays.data());
      const auto hit = none->Intersect(ray.ray, workspace);
      ASSERT_EQ(hit.has_value(), ray.at.has_value());
      if (hit) {
        EXPECT_EQ(scene.world.At(ray.ray, *hit).position, ray.at->position);
      }
    }
    EXPECT_EQ(roots, 1);
  }
  for (const PixelTrace& trace : viewer_->Rays().Grid()) {
    std::map<std::uint32_t, int> shadow_rays;  // of each surface
    for (const RecordedRay& ray : trace.rays)
      if (ray.kind == RayKind::shadow) ++shadow_rays[static_cast<std::uint32_t>(ray.parent)];
    for (const auto& [surface, count] : shadow_rays) EXPECT_LE(count, 2) << "one to each of two lights";
  }
  const auto before = viewer_->Show().lines;
  Do("drag left 100 100 200 150");
  EXPECT_EQ(viewer_->Rays().Grid().size(), 441u);
  const auto after = viewer_->Show().lines;
  ASSERT_EQ(before->size(), after->size());
  for (std::size_t i = 0; i < before->size(); ++i) ASSERT_EQ((*before)[i].at, (*after)[i].at);
}

TEST_F(ViewerTest, KindsOfRaysAreShownAndHidden) {
  Do("resize 200 200\nkey G");
  const std::size_t all = viewer_->Show().lines->size();
  std::size_t hidden = 0;
  for (const char* key : {"F2", "F3", "F4", "F5"}) {
    const std::size_t before = viewer_->Show().lines->size();
    Do(std::string("key ") + key);
    hidden += before - viewer_->Show().lines->size();
  }
  Do("key G");
  const std::size_t others = viewer_->Show().lines->size();
  EXPECT_EQ(all - hidden, others) << "all kinds hidden is the same as no rays";
  EXPECT_GT(hidden, 0u);
}

TEST_F(ViewerTest, BoxesAreAsManyAsNodesAtThatDepth) {
  const std::size_t without = viewer_->Show().lines->size();
  Do("key B");
  const auto counts = graph::NodesWithBoxes(viewer_->scene().parsed.scene.root);
  const auto lines = [](std::int64_t boxes) { return 2 * 12 * static_cast<std::size_t>(boxes); };
  EXPECT_EQ(viewer_->Show().lines->size() - without,
            lines(std::accumulate(counts.begin(), counts.end(), std::int64_t{0})));
  Do("key .\nkey .");
  EXPECT_EQ(viewer_->Show().lines->size() - without, lines(counts.at(1)));
  Do("key ,\nkey ,\nkey B");
  EXPECT_GT(viewer_->Show().lines->size(), without) << "the accelerator's";
  Do("key B");
  EXPECT_EQ(viewer_->Show().lines->size(), without);
}

TEST_F(ViewerTest, TheCutFollowsItsRowAndPlanes) {
  Do("key X");
  FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.section);
  EXPECT_GT(shown.section->size(), 0u);
  EXPECT_EQ(shown.view.width, width / 2);
  EXPECT_EQ(StateLine("cut"), "row 24");
  Do("key Up\nkey Up");
  EXPECT_EQ(StateLine("cut"), "row 26");
  const auto first = shown.section;
  EXPECT_NE(viewer_->Show().section, first);
  for (const char* plane : {"xz", "yz", "xy", "row"}) {
    Do("key Shift+X");
    viewer_->Show();
    EXPECT_EQ(StateLine("cut").find(plane), 0u) << StateLine("cut");
  }
}

// Lines along the edges of the window looked like a mistake while S ran from the same view.
TEST_F(ViewerTest, ARenderedImageIsFramedOnlyFromElsewhere) {
  constexpr Rgba frame{255, 255, 120, 255};
  const auto has_frame = [&] {
    const FrameState shown = viewer_->Show();
    return std::ranges::any_of(*shown.lines, [&](const Vertex& v) { return v.color == frame; });
  };
  Do("key S\nwait trace");
  EXPECT_FALSE(has_frame());
  Do("drag left 10 10 40 30");
  EXPECT_TRUE(has_frame());
  Do("key Z");
  EXPECT_FALSE(has_frame());
}

// The camera of fisheye.scn sees 200 degrees; a pinhole would draw the boxes elsewhere, or not at all.
TEST_F(ViewerTest, LinesOverAnImageFollowItsProjection) {
  Open(project::Root() / "scenes/fisheye.scn");
  viewer_->state().traced.ShowLive({});
  Do("key B\nwait image\n");
  while (!viewer_->Traced().Depths()) {  // begun by Show once the view rests
    viewer_->Show();
    WaitUntilIdle();
  }
  const FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.has_flat_lines);
  ASSERT_FALSE(shown.lines->empty());
  int faint = 0;
  for (const Vertex& vertex : *shown.lines) faint += vertex.color[3] < 100;
  EXPECT_GT(faint, 0) << "parts of boxes are hidden";
  EXPECT_LT(faint, static_cast<int>(shown.lines->size()));
  const DrawingSpace& space = viewer_->state().scene.Space();
  viewer_->state().traced.HideLive();
  WaitUntilIdle();
  const FrameState in_space = viewer_->Show();
  ASSERT_FALSE(in_space.has_flat_lines);
  const auto corner = camera().PlaceOf(space.PointAt(in_space.lines->front().at), width, height);
  ASSERT_TRUE(corner);
  double nearest = 2;
  for (const Vertex& vertex : *shown.lines)
    nearest = std::min(nearest, std::hypot((vertex.at[0] + 1.0) * width / 2 - corner->x,
                                           (vertex.at[1] + 1.0) * shown.view.height / 2 - corner->y));
  EXPECT_LT(nearest, 1e-3);
}

// 16 samples were 16 equal rows of 53 rays each.
TEST_F(ViewerTest, APixelShowsTheRaysOfOneSample) {
  RenderSettings many;
  many.samples = 16;
  Open(project::Root() / "scenes/area_light.scn", many);
  Do("click right 32 10");
  ASSERT_TRUE(viewer_->Rays().Pixel());
  const auto& rays = viewer_->Rays().Pixel()->rays;
  const auto count = [&](RayKind kind, int parent) {
    return std::ranges::count_if(rays, [&](const RecordedRay& r) { return r.kind == kind && r.parent == parent; });
  };
  EXPECT_EQ(count(RayKind::camera, RecordedRay::none), 1);
  const auto lights = static_cast<long>(viewer_->scene().parsed.scene.lights.size());
  for (int i = 0; i < static_cast<int>(rays.size()); ++i) EXPECT_LE(count(RayKind::shadow, i), lights);
  EXPECT_NE(viewer_->Message().find("1 of 16 samples, 1 of 16 shadow rays"), std::string::npos) << viewer_->Message();
}

TEST_F(ViewerTest, OneOfAThingIsNotCalledMany) {
  Do("key B\nkey ,\nkey .");
  EXPECT_EQ(StateLine("boxes"), "1 box of nodes of level 0");
}

}  // namespace
}  // namespace ray
