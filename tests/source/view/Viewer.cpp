#include "source/view/Viewer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/view/commands/Commands.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

// Waiting for a whole image to see one corner of it wastes an hour.
TEST_F(ViewerTest, SRendersOnlyTheDraggedCropUntilEscape) {
  Do("down right 8 6 Control\nmove 40 30\nup right 40 30 Control\n");
  EXPECT_EQ(viewer_->Message(), "crop of 33x25 pixels; S renders it, Escape clears it");
  EXPECT_FALSE(viewer_->navigator().IsDragging()) << "the camera stays";
  const FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.crop);
  EXPECT_EQ(shown.crop->size(), 8u) << "the four sides of its frame";
  Do("key S\nwait trace\n");
  ASSERT_EQ(host_.traced.size(), 1u);
  RenderSettings settings = viewer_->state().SettingsOfView();
  EXPECT_FALSE(settings.crop);
  settings.crop = {8, 6, 41, 31};
  EXPECT_EQ(host_.traced[0], Rendered(settings));
  EXPECT_EQ(host_.traced_settings[0].crop, settings.crop);

  // Flat, it is where it is in the view, and its pixels are those that are clicked.
  Do("key I");
  const FrameState flat = viewer_->Show();
  ASSERT_TRUE(flat.covering);
  EXPECT_NEAR(flat.covering->place.left, 8, 1e-9);
  EXPECT_NEAR(flat.covering->place.width, 33, 1e-9);
  EXPECT_NEAR(flat.covering->place.bottom, 6, 1e-9);
  Do("key Escape\nkey Escape\n");
  EXPECT_EQ(viewer_->Message(), "crop cleared; S renders the whole view");
  Do("key S\nwait trace\n");
  ASSERT_EQ(host_.traced.size(), 2u);
  EXPECT_EQ(host_.traced[1].Width(), width);
}

TEST_F(ViewerTest, CropsAreCutToTheWindowAndForgottenOnResize) {
  Do("down right 30 20 Control\nmove 900 -50\nup right 900 -50 Control\n");
  EXPECT_EQ(viewer_->state().crop, (PixelRectangle{30, 0, width, 21}));
  Do("resize 100 80\n");
  EXPECT_FALSE(viewer_->state().crop);
}

TEST_F(ViewerTest, RotatesAsATurntableUntilKeyT) {
  Do("drag left 10 10 40 40\ndrag left 10 10 20 45");
  EXPECT_NEAR(camera().right.y, 0, 1e-12) << "the horizon is level";
  Do("drag left 10 40 10 0\ndrag left 10 40 10 0\ndrag left 10 40 10 0");
  EXPECT_GT(camera().up.y, 0) << "it stops short of the pole";
  Do("key Pad0\nkey T\ndrag left 10 10 40 40\ndrag left 10 10 20 45");
  EXPECT_GT(std::abs(camera().right.y), 1e-3);
}

TEST_F(ViewerTest, APixelsRaysArePrintedAsRayproPrintsThem) {
  const RenderSettings settings = viewer_->state().SettingsOfView();
  SetDebugRays(viewer_->state(), {settings.samples, settings.trace.shadow_samples, 10});
  Do("click right 30 20");
  const LoadedScene& scene = viewer_->scene();
  EXPECT_NE(host_.printed.find(DebugPixel(scene.world, *scene.accelerator, viewer_->state().SettingsOfView(), 30, 20)),
            std::string::npos);
  Do("key Right\nkey Up");
  EXPECT_EQ(StateLine("pixel"), "31 21");
  Do("key O");
  EXPECT_EQ(std::count(host_.rays.begin(), host_.rays.end(), 'l') > 0, true);
  EXPECT_EQ(host_.rays.find("nan"), std::string::npos);
}

TEST_F(ViewerTest, AClickDescribesWhatTheTracerHits) {
  Do("click left 32 24");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  const R3::Ray ray = camera().Through(32.5, 24.5, width, height);
  Workspace workspace;
  const auto hit = viewer_->scene().accelerator->Intersect(ray, workspace);
  ASSERT_TRUE(hit);
  EXPECT_EQ(viewer_->scene().world.At(ray, *hit).position, *viewer_->Picked()->point);
  EXPECT_NE(host_.printed.find("hello.scn:"), std::string::npos) << host_.printed;
}

TEST_F(ViewerTest, ADoubleClickSetsThePivotUnderIt) {
  Do("click left 32 24\ntick 0.1\nclick left 32 24");
  ASSERT_TRUE(viewer_->navigator().Pivot());
  const R3::Ray ray = camera().Through(32, 24, width, height);
  const R3::Point pivot = *viewer_->navigator().Pivot();
  EXPECT_LT(Length(Cross(pivot - ray.origin, Unit(ray.direction))), 1e-6) << "on the line of sight";
  const auto before = PixelOf(camera(), pivot, {width, height});
  Do("drag left 5 5 40 30");
  const auto after = PixelOf(camera(), pivot, {width, height});
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(before->x, after->x, 0.5);
  EXPECT_NEAR(before->y, after->y, 0.5);
}

TEST_F(ViewerTest, APreviewThatIsNotTheProjectionSaysSo) {
  const auto says = [&] {
    std::string text;  // in lines that fit the small window, which cut words
    for (const Label& label : viewer_->Show().labels) text += label.text;
    std::erase(text, ' ');
    return text.find("Stracesthetrueprojection,fisheye") != std::string::npos;
  };
  EXPECT_FALSE(says());
  Open(project::Root() / "scenes/fisheye.scn");
  EXPECT_TRUE(says());
  const R2::Image preview_pinhole = Rendered(viewer_->state().SettingsOfView());
  EXPECT_EQ(preview_pinhole.At(0, 0), R2::Color()) << "the corner of what S traces is outside of the circle";
  Do("key F");
  EXPECT_STREQ(camera().kind->name, "fisheye") << "a view that moves keeps its projection";
}

TEST_F(ViewerTest, ClicksThatAreFarApartInTimeAreNotDouble) {
  Do("click left 32 24\ntick 1\nclick left 32 24");
  EXPECT_FALSE(viewer_->navigator().Pivot());
}

TEST_F(ViewerTest, FlyingNeedsTheRightButtonAndKeepsPaceWithTime) {
  const R3::Point start = camera().eye;
  Do("press W\ntick 1\nrelease W");
  EXPECT_EQ(camera().eye, start) << "W alone hides faces";
  Do("key W\ndown right 30 20\npress W\ntick 0.25\ntick 0.25\nrelease W\ntick 5\nup right 30 20");
  const double radius = viewer_->scene().parsed.scene.root.bounds.Radius();
  const R3::Vector way = camera().eye - start;
  EXPECT_NEAR(Length(way), 0.5 * viewer_->navigator().FlySpeed() * radius, 1e-9 * radius);
  EXPECT_NEAR(Dot(Unit(way), camera().towards), 1, 1e-12);
  EXPECT_FALSE(viewer_->Rays().Pixel()) << "no click for the pixel debugger";
}

TEST_F(ViewerTest, ViewsGoBackAndForth) {
  const Camera first = camera();
  Do("drag left 10 10 30 30");
  const Camera second = camera();
  Do("key Pad7");
  const Camera third = camera();
  Do("key Z");
  EXPECT_TRUE(IsCameraOf(second));
  Do("key Z");
  EXPECT_TRUE(IsCameraOf(first)) << "a drag is one step";
  Do("key Z");
  EXPECT_TRUE(IsCameraOf(first)) << "there is nothing before";
  Do("key Shift+Z\nkey Shift+Z");
  EXPECT_TRUE(IsCameraOf(third));
}

TEST_F(ViewerTest, EditedScenesAreReloadedUnlessBroken) {
  const project::Folder folder;
  const auto scene = folder / "scene.scn";
  const auto write = [&](const std::string& text) { folder.Write("scene.scn", text); };
  write("sphere -1  0 0 0  1\n");
  Open(scene);
  Do("drag left 10 10 30 30");
  const Camera moved = camera();
  write("sphere -1  0 0 0  1\nbox -1  2 2 2  3 3 3\n");
  Do("tick 1");
  EXPECT_EQ(viewer_->scene().world.Instances().size(), 2u);
  EXPECT_TRUE(IsCameraOf(moved)) << "the camera stays";
  write("sphere -1  0 0 0  1\n\n  spere -1  0 0 0  1 1 1\n");
  Do("tick 1");
  EXPECT_EQ(viewer_->scene().world.Instances().size(), 2u) << "the old scene stays";
  EXPECT_NE(viewer_->Message().find("scene.scn:3:3: error: unknown command 'spere'"), std::string::npos)
      << viewer_->Message();
  write("sphere -1  0 0 0  2\n");
  Do("tick 1");
  EXPECT_EQ(viewer_->scene().world.Instances().size(), 1u);
}

/// A scene of its own that is written again and again.
class SceneOnDisk : public ViewerTest {
 protected:
  void SetUp() override {
    Write("sphere -1  0 0 0  1\n");
    Open(File());
  }
  std::filesystem::path File() const { return folder_ / "scene.scn"; }
  void Write(const std::string& text) const { folder_.Write("scene.scn", text); }
  bool IsSeen(const std::string& words) const {
    std::string all;
    for (const Label& label : viewer_->Show().labels) all += label.text + " ";
    return all.find(words) != std::string::npos;
  }

 private:
  project::Folder folder_;
};

// It faded after five seconds, and the scene from before looked as if it were the file's.
TEST_F(SceneOnDisk, AMistakeStaysVisibleUntilItIsFixed) {
  Do("resize 640 480\ntick 1");
  Write("sphere -1  0 0 0  1\nspere -1  0 0 0  1\n");
  Do("tick 1\ntick 60\ntick 60");
  EXPECT_TRUE(IsSeen("unknown command 'spere'"));
  EXPECT_TRUE(IsSeen("from before"));
  EXPECT_NE(viewer_->Title().find("mistakes in"), std::string::npos) << viewer_->Title();
  Do("key Escape");
  EXPECT_TRUE(IsSeen("unknown command 'spere'")) << "it is no message to be closed";
  Write("sphere -1  0 0 0  2\n");
  Do("tick 1");
  EXPECT_FALSE(IsSeen("spere"));
  EXPECT_EQ(viewer_->Title().find("mistakes in"), std::string::npos) << viewer_->Title();
}

TEST_F(SceneOnDisk, AMissingFileIsReportedButNotOneBeingSaved) {
  Do("resize 640 480\ntick 1");
  std::filesystem::remove(File());
  Do("tick 0.3");
  EXPECT_EQ(StateLine("problem"), "");
  Write("sphere -1  0 0 0  2\n");
  Do("tick 0.3");
  EXPECT_EQ(StateLine("problem"), "") << "an editor has saved it by renaming";
  std::filesystem::remove(File());
  Do("tick 0.3\ntick 0.3\ntick 60");
  EXPECT_TRUE(IsSeen("scene.scn"));
  EXPECT_TRUE(IsSeen("from before"));
  Write("sphere -1  0 0 0  2\n");
  Do("tick 0.3");
  EXPECT_EQ(StateLine("problem"), "");
}

// There was no window at all, so that one had to start over and over.
TEST_F(SceneOnDisk, AnInitiallyBrokenSceneIsShownOnceFixed) {
  Write("camera 0 0 9  0 0 -1  0 1 0  0.3 1 100\nspere -1  0 0 0  1\n");
  ParsedScene nothing;
  nothing.scene.files = {File()};
  ViewerSettings settings;
  settings.scene = File();
  settings.render.width = 640, settings.render.height = 480;
  viewer_ = std::make_unique<Viewer>(
      settings, std::make_shared<const LoadedScene>(std::move(nothing), settings.accelerator), host_);
  try {
    Parse(File(), {});
    FAIL();
  } catch (const SceneErrors& mistakes) {
    viewer_->ShowMistakes(mistakes);
  }
  Do("tick 60");
  EXPECT_TRUE(IsSeen("unknown command 'spere'"));
  Write("camera 0 0 9  0 0 -1  0 1 0  0.3 1 100\nsphere -1  0 0 0  1\n");
  Do("tick 1");
  EXPECT_EQ(viewer_->scene().world.Instances().size(), 1u);
  EXPECT_TRUE(IsCameraOf(viewer_->scene().parsed.scene.camera));
  EXPECT_FALSE(IsSeen("spere"));
}

TEST_F(SceneOnDisk, AMistakeOfADroppedFileGoesWithEscape) {
  Do("resize 640 480\ndrop no/such/file\ntick 60");
  EXPECT_TRUE(IsSeen("no/such/file"));
  Do("key Escape\ntick 60");
  EXPECT_FALSE(IsSeen("no/such/file"));
}

// Each window wrote the file as it knew it.
TEST_F(ViewerTest, BookmarksOfTwoWindowsAreAllKept) {
  const CopiedScenes folder;
  Open(folder / "hello.scn");
  Do("key [");
  const Camera first = camera();
  const auto one = std::move(viewer_);
  Open(folder / "hello.scn");
  Do("key ]\nkey Control+2");
  for (const ScriptStep& step : ReadEventScript({"test", "key Control+1"})) one->Handle(std::get<Event>(step.what));
  Open(folder / "hello.scn");
  Do("key 1");
  EXPECT_TRUE(IsCameraOf(first));
  EXPECT_EQ(viewer_->Message(), "at bookmark 1");
  Do("key 2");
  EXPECT_EQ(viewer_->Message(), "at bookmark 2");
}

TEST_F(ViewerTest, DroppedFilesAreScenesOrReferences) {
  Do("drop " + (project::Root() / "scenes/glass.scn").string());
  EXPECT_NE(StateLine("scene").find("glass.scn"), std::string::npos);
  EXPECT_TRUE(IsCameraOf(viewer_->scene().parsed.scene.camera));
  Do("drop " + (project::Root() / "scenes/meshes/icosahedron.off").string());
  EXPECT_EQ(viewer_->scene().world.Primitives(), 21);  // and the ground that it stands on
  Do("drop " + (project::Root() / "scenes/glass.scn").string() + "\ndrop picture");
  EXPECT_EQ(StateLine("reference"), "yes");
  Do("drop no/such/file");
  EXPECT_NE(StateLine("scene").find("glass.scn"), std::string::npos);
  EXPECT_NE(viewer_->Message().find("no/such/file"), std::string::npos) << viewer_->Message();
}

TEST_F(ViewerTest, AnEmptySceneCanBeLookedAt) {
  Open(project::Root() / "scenes/empty.scn");
  Do("key F\nkey B\nkey G\nkey X\nkey L\nkey Shift+C\nclick left 5 5\nclick right 5 5\ndrag left 1 1 30 30\nkey S\n"
     "wait trace\nkey P\nwait trace");
  EXPECT_EQ(host_.traced.size(), 1u);
  viewer_->Show();
}

TEST_F(ViewerTest, ABookmarkThatCannotBeWrittenLastsForTheSession) {
  {
    const CopiedScenes folder;
    Open(folder / "hello.scn");
  }
  Do("drag left 10 10 30 30\nkey Control+3");
  EXPECT_NE(viewer_->Message().find("bookmark 3 lasts for this session only: cannot write "), std::string::npos)
      << viewer_->Message();
  const Camera kept = camera();
  Do("drag left 10 10 30 30\nkey 3");
  EXPECT_TRUE(IsCameraOf(kept));
  EXPECT_EQ(Bookmarks("-").File(), "") << "nothing is beside standard input";
}

TEST_F(ViewerTest, NonsenseIsBorne) {
  Do("up left 5 5\nmove 1 1\nmove -1e9 1e9\ndown left 5 5\ndown right 6 6\nup right 6 6\nmove 1e300 1e300\nup left 5 "
     "5\n"
     "scroll 1e6 10 10\nscroll -1e6 10 10\nresize 1 1\nkey S\nwait trace\nresize 50 40\nkey Z\ntick 0");
  const Camera& now = camera();
  EXPECT_TRUE(std::isfinite(now.eye.x) && std::isfinite(now.towards.x));
  viewer_->Show();
}

}  // namespace
}  // namespace ray
