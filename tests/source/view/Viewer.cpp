#include "source/view/Viewer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <thread>

#include "R2/compare/Difference.h"
#include "source/scene/CameraText.h"
#include "source/view/EventScript.h"
#include "source/view/live/JobStatus.h"
#include "source/view/overlay/SceneLines.h"
#include "tests/Project.h"
#include "tests/source/view/CopiedScenes.h"
#include "tests/source/view/Witness.h"
#include "tests/source/view/overlay/NodeCounts.h"

namespace ray {
namespace {

/// A viewer whose user types.
class ViewerTest : public testing::Test {
 protected:
  static constexpr int width = 64, height = 48;

  void Open(const std::filesystem::path& scene, const RenderSettings& render = {}, bool live_is_endless = false) {
    ViewerSettings settings;
    settings.scene = scene;
    settings.render = render;
    settings.render.width = width;
    settings.render.height = height;
    settings.live_is_endless = live_is_endless;
    viewer_ = std::make_unique<Viewer>(
        settings, std::make_shared<const LoadedScene>(scene, settings.parse, settings.accelerator), host_);
  }
  void SetUp() override { Open(project::Root() / "scenes/hello.scn"); }

  /// Steps of a script, but for pictures and prints.
  void Do(const std::string& script) {
    for (const ScriptStep& step : ReadEventScript({"test", script})) {
      if (const auto* event = std::get_if<Event>(&step)) viewer_->Handle(*event);
      viewer_->Update();
      if (std::holds_alternative<WaitForTrace>(step)) WaitUntilIdle();
    }
  }
  void WaitUntilIdle() {
    while (viewer_->IsBusy()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      viewer_->Update();
    }
    viewer_->Update();
  }
  const Camera& camera() const { return viewer_->navigator().camera(); }
  bool IsCameraOf(const Camera& c) const { return CameraLine(camera()) == CameraLine(c); }
  R2::Image Rendered(const RenderSettings& settings) const {
    const LoadedScene& scene = viewer_->scene();
    return Render(scene.world, *scene.accelerator, settings).image;
  }
  std::string StateLine(const std::string& name) const {
    std::istringstream in(viewer_->State());
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, name.size() + 1, name + " ") == 0) return line.substr(name.size() + 1);
    return "no such line";
  }

  Witness host_;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(ViewerTest, KeySTracesThePictureThatRayproMakes) {
  Do("key S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  EXPECT_FALSE(host_.traced_settings[0].view) << "the scene's own view needs no mention";
  EXPECT_EQ(host_.traced[0], Rendered(host_.traced_settings[0]));
  EXPECT_EQ(viewer_->Message(), "saved");
  EXPECT_EQ(StateLine("quad"), "yes");
}

TEST_F(ViewerTest, AMovedViewTracesAsTheSceneWithThePrintedCamera) {
  Do("drag left 10 10 25 17\nscroll 2 30 20\ndrag middle 5 5 9 9\nkey ]\nkey C\nkey S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  const std::string line = host_.printed.substr(0, host_.printed.find('\n'));
  EXPECT_EQ(host_.clipboard, line + "\n");
  // The printed line in the place of the scene's own.
  const CopiedScenes copy;
  std::ifstream in(copy / "hello.scn");
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::size_t own = text.find("\ncamera ");
  ASSERT_NE(own, std::string::npos);
  text.replace(own + 1, text.find('\n', own + 1) - own - 1, line);
  std::ofstream(copy / "again.scn") << text;
  const project::Stage stage(copy / "again.scn");
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  EXPECT_EQ(host_.traced[0], project::Render(stage, settings).image);
}

TEST_F(ViewerTest, EveryKeyIsInTheHelpAndDoesSomething) {
  const auto help = Viewer::Help();
  std::set<std::string> names;
  for (const Viewer::Binding& binding : Viewer::Bindings()) {
    const std::string name = NameOf(binding.key, binding.modifiers);
    EXPECT_TRUE(names.insert(name).second) << name << " is bound twice";
    const bool is_told = std::any_of(help.begin(), help.end(), [&](const std::string& line) {
      return (" " + line).find(" " + name + " ") != std::string::npos;
    });
    EXPECT_TRUE(is_told) << name;
  }
  // What each needs before it can do anything, and then something that can be told from outside must have changed.
  const std::map<std::string, std::string> before{
      {"I", "key S\nwait trace"},
      {"V", "key S\nwait trace"},
      {"Shift+X", "key X"},
      {"Shift+F", "click left 32 24\ntick 1"},
      {"Z", "key ["},
      {"Shift+Z", "key [\nkey Z"},
      {"Pad1", "key Pad3"},
      {"Pad0", "key Pad3"},
      {"N", "click right 32 24"},
      {"Shift+N", "click right 32 24"},
      {"O", "click right 32 24"},
      {"Backspace", "click right 32 24"},
      {"Left", "click right 32 24"},
      {"Right", "click right 32 24"},
      {"Up", "click right 32 24"},
      {"Down", "click right 32 24"},
      {"Control+0", "key Control+Up"},
      {"R", "key P\nwait trace"},
      {"Shift+R", "key P\nwait trace\nkey R"},
      {"D", "key P\nwait trace\nkey R"},
  };
  const CopiedScenes folder;
  for (const Viewer::Binding& binding : Viewer::Bindings()) {
    const std::string name = NameOf(binding.key, binding.modifiers);
    host_ = {};
    Open(folder / "hello.scn");
    if (const auto found = before.find(name); found != before.end()) Do(found->second);
    const auto seen = [&] {
      const FrameState shown = viewer_->Show();
      return viewer_->State() + std::to_string(host_.drawings) + host_.printed + host_.rays + host_.clipboard +
             std::to_string(shown.lines->size()) + std::to_string(viewer_->IsClosed());
    };
    const std::string without = seen();
    Do("press " + name);
    EXPECT_NE(seen(), without) << name << " does nothing";
    Do("release " + name);
  }
}

TEST_F(ViewerTest, EscapeEndsWhatIsOpenOneByOneAndNeverQuits) {
  RenderSettings slow;
  slow.samples = 100'000;
  Open(project::Root() / "scenes/hello.scn", slow);
  Do("key S\nkey X\nclick left 10 24\nkey H");
  EXPECT_EQ(StateLine("help"), "1");
  Do("key Escape");
  EXPECT_EQ(StateLine("help"), "0");
  EXPECT_TRUE(viewer_->Picked());
  Do("key Escape");
  EXPECT_FALSE(viewer_->Picked());
  EXPECT_NE(StateLine("cut"), "no");
  Do("key Escape");
  EXPECT_EQ(StateLine("cut"), "no");
  EXPECT_EQ(StateLine("trace"), "running");
  Do("key Escape\nwait trace");
  EXPECT_EQ(StateLine("trace"), "stopped");
  EXPECT_TRUE(host_.traced.empty());
  Do("key Escape\nkey Escape");
  EXPECT_FALSE(viewer_->IsClosed());
}

// An hour of rendering is not thrown away by one slip.
TEST_F(ViewerTest, QQuitsAtOnceOrAsksOnceWhileATraceRuns) {
  Do("key Q");
  EXPECT_TRUE(viewer_->IsClosed());
  RenderSettings slow;
  slow.samples = 100'000;
  Open(project::Root() / "scenes/hello.scn", slow);
  Do("key S\nkey Q");
  EXPECT_FALSE(viewer_->IsClosed());
  EXPECT_NE(viewer_->Message().find("Q again"), std::string::npos);
  Do("key E\nkey Q");
  EXPECT_FALSE(viewer_->IsClosed()) << "another key is an answer too";
  Do("key Q");
  EXPECT_TRUE(viewer_->IsClosed());
}

TEST_F(ViewerTest, EveryKeyTellsWhatItDid) {
  for (const Viewer::Binding& binding : Viewer::Bindings()) {
    const CopiedScenes folder;
    Open(folder / "hello.scn");
    Do("press " + NameOf(binding.key, binding.modifiers));
    if (viewer_->IsClosed()) continue;
    EXPECT_NE(viewer_->Message(), "") << NameOf(binding.key, binding.modifiers);
  }
}

TEST_F(ViewerTest, KeysThatTurnSomethingOnAndOffSayWhichOfThemTheyDid) {
  for (const char* key : {"E", "W", "L", "Shift+L", "Shift+C", "P", "F7", "F2", "F6", "G", "T", "X"}) {
    Do(std::string("key ") + key);
    const std::string first = viewer_->Message();
    Do(std::string("key ") + key);
    EXPECT_NE(viewer_->Message(), first) << key;
  }
}

TEST_F(ViewerTest, MessagesFadeAndTheFirstOneNamesTheHelp) {
  EXPECT_TRUE(viewer_->Show().labels.empty()) << "a script that only draws gets the scene alone";
  Do("tick 0.1");
  ASSERT_EQ(viewer_->Show().labels.size(), 1u);
  EXPECT_EQ(viewer_->Show().labels[0].text, "H: help");
  EXPECT_EQ(viewer_->Show().labels[0].color[3], 255);
  Do("tick 4.4");
  const int fading = viewer_->Show().labels.at(0).color[3];
  EXPECT_GT(fading, 0);
  EXPECT_LT(fading, 255);
  viewer_->Handle(TickEvent{2});
  EXPECT_TRUE(viewer_->Update()) << "it is to be drawn without the message";
  EXPECT_TRUE(viewer_->Show().labels.empty());
  Do("key E");
  EXPECT_EQ(viewer_->Show().labels.at(0).text, "edges on");
}

TEST_F(ViewerTest, TheHelpIsNeverCutOffInTheWindowThatIsUsual) {
  Do("resize 512 512");
  for (int page = 1; page < 100; ++page) {
    Do("key H");
    if (StateLine("help") == "0") break;
    for (const Label& label : viewer_->Show().labels) {
      EXPECT_LE(label.x + 8.0 * static_cast<double>(label.text.size()), 512) << label.text;
      EXPECT_GE(label.y, 0) << label.text;
      EXPECT_LE(label.y + 16, 512) << label.text;
    }
  }
  EXPECT_EQ(StateLine("help"), "0") << "after the last page it is closed";
}

TEST_F(ViewerTest, AnUnlitSceneSaysThatItIsSeenByALightAtTheEye) {
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

TEST_F(ViewerTest, RotatesAsATurntableUntilKeyT) {
  Do("drag left 10 10 40 40\ndrag left 10 10 20 45");
  EXPECT_NEAR(camera().right.y, 0, 1e-12) << "the horizon is level";
  Do("drag left 10 40 10 0\ndrag left 10 40 10 0\ndrag left 10 40 10 0");
  EXPECT_GT(camera().up.y, 0) << "it stops short of the pole";
  Do("key Pad0\nkey T\ndrag left 10 10 40 40\ndrag left 10 10 20 45");
  EXPECT_GT(std::abs(camera().right.y), 1e-3);
}

TEST_F(ViewerTest, TheLivePictureEndsAsRayproMakesIt) {
  RenderSettings four;
  four.samples = 4;
  Open(project::Root() / "scenes/hello.scn", four);
  Do("key P\nwait trace");
  ASSERT_TRUE(viewer_->Pictures().Live());
  ASSERT_TRUE(viewer_->Pictures().Live()->IsComplete());
  EXPECT_EQ(viewer_->Pictures().Live()->Result()->image, Rendered(viewer_->SettingsOfView()));
  const std::uint64_t number = viewer_->Pictures().LiveNumber();
  Do("key Control+Up");
  EXPECT_EQ(viewer_->Pictures().LiveNumber(), number) << "exposure does not begin the picture anew";
  Do("key [");
  EXPECT_EQ(viewer_->Pictures().LiveNumber(), number + 1) << "a move does, once";
  Do("wait trace");
  EXPECT_EQ(viewer_->Pictures().Live()->Result()->image, Rendered(viewer_->SettingsOfView()));
}

TEST_F(ViewerTest, WithoutSamplesAskedForTheLivePictureGrowsUntilEscape) {
  Open(project::Root() / "scenes/hello.scn", {}, true);
  Do("key P");
  EXPECT_EQ(viewer_->Message(), "live rendering, mode whitted, until stopped");
  while (viewer_->Pictures().Live()->Samples() < 4) std::this_thread::yield();
  viewer_->Update();
  EXPECT_NE(viewer_->Title().find(" samples until stopped "), std::string::npos) << viewer_->Title();
  Do("key Escape");
  WaitUntilIdle();
  EXPECT_NE(viewer_->Title().find(" samples stopped "), std::string::npos) << viewer_->Title();
  EXPECT_TRUE(viewer_->Pictures().IsLive()) << "what there is stays";
  Do("key [");
  EXPECT_TRUE(viewer_->IsBusy()) << "a move begins it anew";
  // Its samples would not be better by being more.
  for (const char* key : {"key F7", "key F10", "key F11", "key F12"}) {
    Do(key + std::string("\nwait trace"));
    EXPECT_TRUE(viewer_->Pictures().Live()->IsComplete()) << key;
    EXPECT_EQ(viewer_->Pictures().Live()->Samples(), 1) << key;
  }
}

TEST_F(ViewerTest, ALivePictureWithAnErrorEndsWithItsClaim) {
  RenderSettings settings;
  settings.budget.error = {4, ErrorUnit::display};
  Open(project::Root() / "scenes/hello.scn", settings, true);
  Do("key P\nwait trace");
  const RenderResult* result = viewer_->Pictures().Live()->Result();
  ASSERT_TRUE(result && result->error);
  EXPECT_EQ(result->stop, Stop::error);
  EXPECT_EQ(result->image, Rendered(viewer_->SettingsOfView()));
  EXPECT_EQ(viewer_->Message(), ClaimOf(*result));
  EXPECT_EQ(viewer_->Title(), "hello.scn 64x48 " + ClaimOf(*result));
}

TEST_F(ViewerTest, TheTitleChangesWithEachPassAndElseOnlyAsTimePasses) {
  Open(project::Root() / "scenes/hello.scn", {}, true);
  Do("tick 1\nkey P");
  std::map<int, std::set<std::string>> titles;
  for (int i = 0; i < 2000 && titles.size() < 6; ++i) {
    viewer_->Update();
    const std::string title = viewer_->Title();
    std::istringstream words(title.substr(std::string("hello.scn 64x48 ").size()));
    int samples = -1;
    words >> samples;
    titles[samples].insert(title);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GT(titles.size(), 2u);
  for (const auto& [samples, of_it] : titles) EXPECT_EQ(of_it.size(), 1u) << samples;
  // A rate that is measured over more and more seconds does not stay the same for long.
  const std::string title = viewer_->Title();
  for (int i = 0; i < 60'000 && viewer_->Title() == title; ++i) {
    viewer_->Handle(TickEvent{0.3});
    viewer_->Update();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_NE(viewer_->Title(), title);
  Do("key Escape");
  WaitUntilIdle();
  const std::string last = viewer_->Title();
  Do("tick 9");
  viewer_->Update();
  for (int i = 0; i < 9; ++i) {
    viewer_->Handle(TickEvent{0.3});
    EXPECT_FALSE(viewer_->Update()) << "nothing is drawn once it is over";
    EXPECT_EQ(viewer_->Title(), last);
  }
}

TEST_F(ViewerTest, GridRaysAreThoseOfEvery25thPixelAndStayWhenTheCameraMoves) {
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

TEST_F(ViewerTest, APixelsRaysArePrintedAsRayproPrintsThem) {
  Do("click right 30 20");
  const LoadedScene& scene = viewer_->scene();
  EXPECT_NE(host_.printed.find(DebugPixel(scene.world, *scene.accelerator, viewer_->SettingsOfView(), 30, 20)),
            std::string::npos);
  Do("key Right\nkey Up");
  EXPECT_EQ(StateLine("pixel"), "31 21");
  Do("key O");
  EXPECT_EQ(std::count(host_.rays.begin(), host_.rays.end(), 'l') > 0, true);
  EXPECT_EQ(host_.rays.find("nan"), std::string::npos);
}

TEST_F(ViewerTest, AClickTellsWhatTheTracerHits) {
  Do("click left 32 24");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  const R3::Ray ray = camera().Through(32.5, 24.5, width, height);
  Workspace workspace;
  const auto hit = viewer_->scene().accelerator->Intersect(ray, workspace);
  ASSERT_TRUE(hit);
  EXPECT_EQ(viewer_->scene().world.At(ray, *hit).position, *viewer_->Picked()->point);
  EXPECT_NE(host_.printed.find("hello.scn:"), std::string::npos) << host_.printed;
}

TEST_F(ViewerTest, ADoubleClickSetsThePivotToThePointUnderIt) {
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

TEST_F(ViewerTest, ClicksThatAreFarApartInTimeAreNotDouble) {
  Do("click left 32 24\ntick 1\nclick left 32 24");
  EXPECT_FALSE(viewer_->navigator().Pivot());
}

TEST_F(ViewerTest, FlyingNeedsTheRightButtonAndGoesAsFastAsTime) {
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

// The scene is drawn in half of the width then, and clicks were taken as if it had all of it.
TEST_F(ViewerTest, BesideTheCutAClickMeansWhatIsSeenThere) {
  Do("click left 20 30");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  const R3::Point without = *viewer_->Picked()->point;
  Do("key X\nclick left 10 27");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  EXPECT_EQ(*viewer_->Picked()->point, without);
  Do("click right 10 27");
  EXPECT_EQ(StateLine("pixel"), "20 30");
  Do("tick 1\nclick left 10 27\nclick left 10 27");
  ASSERT_TRUE(viewer_->navigator().Pivot());
  const auto seen = PixelOf(camera(), *viewer_->navigator().Pivot(), {width / 2, height});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x, 10, 1e-6);
  EXPECT_NEAR(seen->y, 27, 1e-6);
}

TEST_F(ViewerTest, OverTheCutThePointerTellsDistancesAlongThePlane) {
  Do("resize 640 480\nkey X\nkey Shift+X");
  viewer_->Show();
  const auto numbers = [&] {
    std::vector<double> all;
    std::istringstream words(StateLine("under the pointer"));
    for (std::string word; words >> word;)
      if (char* end = nullptr; std::strtod(word.c_str(), &end) != 0 && end != word.c_str())
        all.push_back(std::stod(word));
    return all;
  };
  Do("move 100 240");
  EXPECT_TRUE(numbers().empty()) << "not over the cut";
  const Camera before = camera();
  Do("down left 400 100\nmove 500 300");
  const auto told = numbers();  // x, z, distance from the origin, distance from the press
  ASSERT_EQ(told.size(), 4u) << StateLine("under the pointer");
  EXPECT_NEAR(told[2], std::hypot(told[0], told[1]), 1e-3);
  Do("move 400 100");
  const auto first = numbers();
  EXPECT_NEAR(told[3], std::hypot(told[0] - first[0], told[1] - first[1]), 1e-2);
  Do("up left 400 100");
  EXPECT_TRUE(IsCameraOf(before)) << "the scene is not dragged from there";
  EXPECT_EQ(numbers().size(), 3u);
}

TEST_F(ViewerTest, TheWheelOverTheCutMovesItsPlane) {
  Do("key X\nscroll 1 50 20");
  EXPECT_EQ(StateLine("cut"), "row 25");
  Do("scroll -2 50 20");
  EXPECT_EQ(StateLine("cut"), "row 24");
}

TEST_F(ViewerTest, ASceneThatIsEditedIsReadAgainAndABrokenOneIsNot) {
  std::string name = (std::filesystem::temp_directory_path() / "rayview-test-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  const auto scene = folder / "scene.scn";
  const auto write = [&](const std::string& text) { std::ofstream(scene) << text; };
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
  std::filesystem::remove_all(folder);
}

TEST_F(ViewerTest, DroppedFilesAreScenesOrReferences) {
  Do("drop " + (project::Root() / "scenes/glass.scn").string());
  EXPECT_NE(StateLine("scene").find("glass.scn"), std::string::npos);
  EXPECT_TRUE(IsCameraOf(viewer_->scene().parsed.scene.camera));
  Do("drop " + (project::Root() / "scenes/meshes/icosahedron.off").string());
  EXPECT_EQ(viewer_->scene().world.Primitives(), 20);
  Do("drop " + (project::Root() / "scenes/glass.scn").string() + "\ndrop picture");
  EXPECT_EQ(StateLine("reference"), "yes");
  Do("drop no/such/file");
  EXPECT_NE(StateLine("scene").find("glass.scn"), std::string::npos);
  EXPECT_NE(viewer_->Message().find("no/such/file"), std::string::npos) << viewer_->Message();
}

TEST_F(ViewerTest, ComparingTellsTheDifferenceOfThePictures) {
  Do("key P\nwait trace\nkey R\nkey [\nwait trace\nkey D");
  const auto current = viewer_->Pictures().Current();
  const R2::Difference difference = R2::Compare(*current, *viewer_->Pictures().Reference(), R2::Display::straight);
  EXPECT_GT(difference.rmse, 0);
  EXPECT_NE(viewer_->Message().find("display RMSE"), std::string::npos);
  const FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.picture && shown.picture->image);
  EXPECT_NEAR(shown.picture->image->At(10, 10).r,
              std::abs(current->At(10, 10).r - viewer_->Pictures().Reference()->At(10, 10).r), 1e-6);
}

TEST_F(ViewerTest, TheRenderedPictureIsShownFlatUntilEscape) {
  Do("key I");
  EXPECT_FALSE(viewer_->Show().picture) << "nothing is rendered yet";
  Do("key S\nwait trace\nkey I");
  FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.picture && shown.picture->frame);
  EXPECT_EQ(shown.picture->frame, &viewer_->Pictures().Trace()->frame());
  EXPECT_EQ(shown.picture->place.width, width);
  EXPECT_EQ(shown.picture->place.height, height);
  EXPECT_EQ(shown.split, width) << "all of it";
  EXPECT_TRUE(shown.lines->empty());
  Do("key Control+Up");
  EXPECT_EQ(viewer_->Show().picture->exposure.factor, 2);
  Do("key Escape");
  EXPECT_FALSE(viewer_->Show().picture);
  EXPECT_EQ(viewer_->Show().split, -1);
}

TEST_F(ViewerTest, TheWheelZoomsTheFlatPictureAboutThePointerAndADragMovesIt) {
  Do("key S\nwait trace\nkey I\nmove 10.5 20.5");
  const Camera before = camera();
  const R2::Point pixel = viewer_->Pointer();
  Do("scroll 5 10.5 20.5");
  const PixelBox zoomed = viewer_->Show().picture->place;
  EXPECT_GT(zoomed.width, 2 * width);
  EXPECT_NEAR(viewer_->Pointer().x, pixel.x, 1e-9);
  EXPECT_NEAR(viewer_->Pointer().y, pixel.y, 1e-9);
  Do("down left 10.5 20.5\nmove 30.5 25.5\nup left 30.5 25.5");
  EXPECT_NEAR(viewer_->Pointer().x, pixel.x, 1e-9) << "what was taken hold of stays under the pointer";
  EXPECT_NEAR(viewer_->Pointer().y, pixel.y, 1e-9);
  Do("click right 30.5 25.5");
  EXPECT_EQ(StateLine("pixel"), "10 20");
  EXPECT_TRUE(IsCameraOf(before));
  Do("scroll 1000 30 20\nscroll -1000 30 20");
  EXPECT_NEAR(viewer_->Show().picture->place.width, 0.1 * width, 1e-9);
}

TEST_F(ViewerTest, TheSliderShowsThePreviewOrTheReferenceBesideTheFlatPicture) {
  Do("key S\nwait trace\nkey I\ndown left 64 20\nmove 50 20\nmove 16 20\nup left 16 20");
  EXPECT_EQ(viewer_->Show().split, 16);
  EXPECT_FALSE(viewer_->Show().beside);
  Do("down left 40 20 Shift\nmove 48 20\nup left 48 20");
  EXPECT_EQ(viewer_->Show().split, 48);
  Do("key R");
  ASSERT_TRUE(viewer_->Show().beside);
  EXPECT_EQ(viewer_->Show().beside->image, viewer_->Pictures().Reference());
  // The preview beside it is of the picture's camera, wherever the viewer's own is by then.
  Do("key Escape");
  const auto eye = viewer_->Show().seen_from.eye;
  Do("key Pad7");
  EXPECT_NE(viewer_->Show().seen_from.eye, eye);
  Do("key I");
  EXPECT_EQ(viewer_->Show().seen_from.eye, eye);
}

TEST_F(ViewerTest, IsNotBusyWhereNothingIsRendered) {
  EXPECT_FALSE(viewer_->IsBusy());
  Do("drag left 10 10 40 30\nresize 80 60");
  EXPECT_FALSE(viewer_->IsBusy()) << "an idle window would look for news all the time";
}

TEST_F(ViewerTest, ShiftRShowsTheReferenceWhileItIsHeld) {
  Do("key P\nwait trace\nkey R\nkey [\nwait trace\npress Shift+R");
  EXPECT_EQ(viewer_->Show().picture->image, viewer_->Pictures().Reference());
  Do("release Shift+R");
  EXPECT_FALSE(viewer_->Show().picture->image);
}

TEST_F(ViewerTest, RowsOfTheQuadAreThoseOfTheRender) {
  RenderSettings slow;
  slow.samples = 64;
  Open(project::Root() / "scenes/hello.scn", slow);
  Do("key S");
  const RenderJob& job = *viewer_->Pictures().Trace();
  const R2::Image whole = Rendered(job.Settings());
  while (!job.HasEnded()) {
    const FrameState shown = viewer_->Show();
    ASSERT_TRUE(shown.quad);
    for (int y = 0; y < shown.quad->rows; ++y)
      for (int x = 0; x < width; x += 7) {
        const R2::Color seen = shown.quad->frame->At(x, y), right = whole.At(x, y);
        ASSERT_EQ(seen, right) << x << " " << y;
      }
  }
}

TEST_F(ViewerTest, AClickOnTheTracedQuadDebugsItsPixel) {
  Do("key S\nwait trace\nclick right 40.5 10.5");
  // From the traced camera itself, the quad covers the picture pixel by pixel, unless something is before it.
  EXPECT_EQ(StateLine("pixel"), "40 10");
  EXPECT_FALSE(viewer_->Rays().PixelSettings().view);
}

TEST_F(ViewerTest, ResizingTracesTheNewSize) {
  Do("resize 33 71\nkey S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  EXPECT_EQ(host_.traced[0].Width(), 33);
  EXPECT_EQ(host_.traced[0].Height(), 71);
  EXPECT_EQ(host_.traced[0], Rendered(host_.traced_settings[0]));
}

TEST_F(ViewerTest, AnEmptySceneCanBeLookedAt) {
  Open(project::Root() / "scenes/empty.scn");
  Do("key F\nkey B\nkey G\nkey X\nkey L\nkey Shift+C\nclick left 5 5\nclick right 5 5\ndrag left 1 1 30 30\nkey S\n"
     "wait trace\nkey P\nwait trace");
  EXPECT_EQ(host_.traced.size(), 1u);
  viewer_->Show();
}

TEST_F(ViewerTest, BookmarksOutliveTheProgram) {
  const CopiedScenes folder;
  Open(folder / "hello.scn");
  Do("drag left 10 10 30 30\nkey Control+3");
  const Camera kept = camera();
  Open(folder / "hello.scn");
  EXPECT_FALSE(IsCameraOf(kept));
  Do("key 3");
  EXPECT_TRUE(IsCameraOf(kept));
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
