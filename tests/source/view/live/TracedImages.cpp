#include "source/view/live/TracedImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "R2/compare/Difference.h"
#include "R2/compare/Flip.h"
#include "source/text/NumberText.h"
#include "source/view/live/JobStatus.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

TEST_F(ViewerTest, KeySTracesTheImageThatRayproMakes) {
  Do("key S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  EXPECT_FALSE(host_.traced_settings[0].view) << "the scene's own view needs no mention";
  EXPECT_EQ(host_.traced[0], Rendered(host_.traced_settings[0]));
  EXPECT_EQ(viewer_->Message(), "saved");
  EXPECT_EQ(StateLine("quad"), "yes");
}

TEST_F(ViewerTest, AMovedViewTracesLikeItsPrintedCamera) {
  Do("drag left 10 10 25 17\nscroll 2 30 20\ndrag middle 5 5 9 9\nkey ]\nkey C\nkey S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  const std::string line = host_.printed.substr(0, host_.printed.find('\n'));
  EXPECT_EQ(host_.clipboard, line + "\n");
  // The printed line in the place of the scene's own.
  const CopiedScenes copy;
  std::string text = project::BytesOf(copy / "hello.scn");
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

TEST_F(ViewerTest, TheLiveImageEndsAsRayproMakesIt) {
  RenderSettings four;
  four.samples = 4;
  Open(project::Root() / "scenes/hello.scn", four);
  Do("key P\nwait trace");
  ASSERT_TRUE(viewer_->Traced().Live());
  ASSERT_TRUE(viewer_->Traced().Live()->IsComplete());
  EXPECT_EQ(viewer_->Traced().Live()->Result()->image, Rendered(viewer_->state().SettingsOfView()));
  const std::uint64_t number = viewer_->Traced().JobNumber();
  Do("key Control+Up");
  EXPECT_EQ(viewer_->Traced().JobNumber(), number) << "exposure does not begin the picture anew";
  Do("key [");
  EXPECT_EQ(viewer_->Traced().JobNumber(), number + 1) << "a move does, once";
  Do("wait trace");
  EXPECT_EQ(viewer_->Traced().Live()->Result()->image, Rendered(viewer_->state().SettingsOfView()));
}

TEST_F(ViewerTest, WithoutSamplesAskedForTheTracedImageHasThoseOfAViewAtRest) {
  Open(project::Root() / "scenes/cornell.scn", {}, true);
  Do("key P");
  EXPECT_EQ(viewer_->Message(), "traced, mode whitted");
  while (viewer_->Traced().Live()->Samples() < 1) std::this_thread::yield();
  viewer_->Update();
  EXPECT_NE(viewer_->Title().find(" of 64 samples "), std::string::npos) << viewer_->Title();
  Do("key Escape");
  WaitUntilIdle();
  EXPECT_NE(viewer_->Title().find(" stopped "), std::string::npos) << viewer_->Title();
  EXPECT_TRUE(viewer_->Traced().IsLive()) << "what there is stays";
  Do("key P");
  EXPECT_EQ(viewer_->Message(), "tracing continues");
  WaitUntilIdle();
  ASSERT_TRUE(viewer_->Traced().Live()->IsComplete());
  RenderSettings all = viewer_->state().SettingsOfView();
  all.samples = 64;
  EXPECT_EQ(viewer_->Traced().Live()->Result()->image, Rendered(all)) << "as if it had never been paused";
  Do("key [");
  EXPECT_TRUE(viewer_->IsBusy()) << "a move begins it anew";
  // Its samples would not be better by being more.
  for (const char* key : {"key F7", "key F10", "key F11", "key F12"}) {
    Do(key + std::string("\nwait trace"));
    EXPECT_TRUE(viewer_->Traced().Live()->IsComplete()) << key;
    EXPECT_EQ(viewer_->Traced().Live()->Samples(), 1) << key;
  }
}

TEST_F(ViewerTest, ALiveImageWithAnErrorEndsWithItsClaim) {
  RenderSettings settings;
  settings.budget.error = {4, ErrorUnit::display};
  Open(project::Root() / "scenes/hello.scn", settings, true);
  Do("key P\nwait trace");
  const RenderResult* result = viewer_->Traced().Live()->Result();
  ASSERT_TRUE(result && result->error);
  EXPECT_EQ(result->stop, Stop::error);
  EXPECT_EQ(result->image, Rendered(viewer_->state().SettingsOfView()));
  EXPECT_EQ(viewer_->Message(), ClaimOf(*result));
  EXPECT_EQ(viewer_->Title(), "hello.scn 64x48 " + ClaimOf(*result));
}

TEST_F(ViewerTest, TheTitleChangesOnlyWithPassesAndTime) {
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

TEST_F(ViewerTest, ComparingShowsTheDifferenceOfTheImages) {
  Do("key P\nwait trace\nkey R\nkey [\nwait trace\nkey D");
  const auto current = viewer_->Traced().Current();
  const R2::Difference difference = R2::Compare(*current, *viewer_->Traced().Reference(), R2::Display::straight);
  EXPECT_GT(difference.rmse, 0);
  EXPECT_NE(viewer_->Message().find("display RMSE"), std::string::npos);
  const FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.covering && shown.covering->image);
  EXPECT_NEAR(shown.covering->image->At(10, 10).r,
              std::abs(current->At(10, 10).r - viewer_->Traced().Reference()->At(10, 10).r), 1e-6);
}

// Most differences are too dark to be seen as they are.
TEST_F(ViewerTest, FalseColorsRunFromNoDifferenceToTheLargest) {
  Do("key P\nwait trace\nkey R\nkey [\nwait trace\nkey Shift+D");
  const auto current = viewer_->Traced().Current(), reference = viewer_->Traced().Reference();
  const R2::Plane numbers = R2::DisplayDifference(*current, *reference, R2::Display::straight);
  const float largest = *std::ranges::max_element(numbers.values);
  const auto shown = viewer_->Show().covering->image;
  double brightest = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double expected = static_cast<double>(numbers.Row(y)[x] / largest);
      EXPECT_NEAR(Luminance(shown->At(x, y)), expected, 2e-3) << x << ' ' << y;
      brightest = std::max(brightest, Luminance(shown->At(x, y)));
    }
  EXPECT_NEAR(brightest, 1, 2e-3);
  EXPECT_NE(viewer_->Traced().ScaleOfComparison().find(Rounded(255 * static_cast<double>(largest), 3)),
            std::string::npos);
  Do("key Control+Up");
  EXPECT_EQ(viewer_->Show().covering->exposure.factor, 1) << "it changes light, not what stands for a number";
  Do("key Shift+D");
  const double mean = R2::Mean(
      R2::Flip(R2::Displayed(*current, R2::Display::straight), R2::Displayed(*reference, R2::Display::straight)));
  EXPECT_NE(viewer_->Traced().ScaleOfComparison().find("mean " + Rounded(mean, 3)), std::string::npos);
  Do("key R");  // now the image is its own reference
  EXPECT_EQ(viewer_->Traced().ScaleOfComparison(), "the image equals the reference");
}

// An equal pair was an all-black image without a word.
TEST_F(ViewerTest, AnEqualReferenceIsNamedOnTheImage) {
  const auto seen = [&] {
    std::string all;
    for (const Label& label : viewer_->Show().labels) all += label.text + " ";
    return all;
  };
  Do("resize 640 480\nkey P\nwait trace\nkey R\nkey D\ntick 9");
  EXPECT_NE(seen().find("the image equals the reference"), std::string::npos) << seen();
  Do("key [\nwait trace\ntick 9");
  EXPECT_EQ(seen().find("equals"), std::string::npos) << seen();
}

TEST_F(ViewerTest, LightThatMaxDepthCutsOffIsNamedOnTheImage) {
  shows_bar_ = true;
  const auto seen = [&](const std::string& scene, int depth) {
    RenderSettings settings;
    settings.trace.max_depth = depth;
    Open(project::Root() / "scenes" / scene, settings);
    Do("resize 640 480\nkey P\nwait trace\ntick 9");
    std::string all;
    for (const Label& label : viewer_->Show().labels) all += label.text + " ";
    return all;
  };
  EXPECT_NE(seen("drink.scn", 3).find("% of the light ended at -max_depth 3"), std::string::npos);
  EXPECT_EQ(seen("cone.scn", 3).find("of the light ended"), std::string::npos);
}

// A student was told of an error that was not there: the file that raypro writes is clamped and rounded.
TEST_F(ViewerTest, AnImageDoesNotDifferFromItsOwnFile) {
  for (const bool srgb : {false, true}) {
    RenderSettings render;
    render.srgb = srgb;
    Open(project::Root() / "scenes/hello.scn", render);
    Do("key P\nwait trace");
    const auto light = viewer_->Traced().Current();
    R2::Image bytes(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const R2::Color c = srgb ? EncodeSrgb(Clamped(light->At(x, y))) : light->At(x, y);
        bytes.Set(x, y, {R2::ToByte(c.r) / 255.0, R2::ToByte(c.g) / 255.0, R2::ToByte(c.b) / 255.0});
      }
    EXPECT_GT(R2::Compare(*light, bytes, R2::Display::straight).rmse, 0) << "else nothing is shown by this";
    host_.picture = {std::make_shared<const R2::Image>(bytes), 255};
    Do("drop picture\nkey D");
    EXPECT_EQ(viewer_->Message(), "0 of 3072 pixels differ as 8 bits");
    const FrameState shown = viewer_->Show();
    ASSERT_TRUE(shown.covering && shown.covering->image);
    for (const float channel : shown.covering->image->Channels()) ASSERT_LT(channel, 1e-6F);
    const double before = bytes.At(3, 4).r;
    bytes.Set(3, 4, {before < 0.5 ? before + 0.2 : before - 0.2, bytes.At(3, 4).g, bytes.At(3, 4).b});
    host_.picture = {std::make_shared<const R2::Image>(bytes), 255};
    Do("key D\ndrop picture\nkey D");
    EXPECT_EQ(viewer_->Message().rfind("1 of 3072 pixels differ as 8 bits, RMSE ", 0), 0u) << viewer_->Message();
  }
}

// An hour of rendering was gone when the window was closed by mistake, and when it was stopped on purpose.
TEST_F(ViewerTest, ARenderThatWasStoppedGoesOnWhereItWas) {
  RenderSettings slow;
  slow.samples = 64;
  Open(project::Root() / "scenes/hello.scn", slow);
  const auto stop_after_some_rows = [&] {
    Do("key S");
    while (viewer_->Traced().Trace()->RowsDone() < 5) std::this_thread::yield();
    Do("key Escape\nwait trace");
  };
  stop_after_some_rows();
  ASSERT_EQ(StateLine("trace"), "stopped");
  EXPECT_NE(viewer_->Message().find("S continues it"), std::string::npos) << viewer_->Message();
  const int done = viewer_->Traced().Trace()->RowsDone();
  stop_after_some_rows();
  EXPECT_GE(viewer_->Traced().Trace()->RowsDone(), done);
  Do("key S\nwait trace");
  ASSERT_EQ(host_.traced.size(), 1u);
  const R2::Image whole = Rendered(host_.traced_settings[0]);
  EXPECT_EQ(R2::PixelsBeyond(host_.traced[0], whole, 0), 0);
  stop_after_some_rows();
  Do("key [\nkey S");
  EXPECT_EQ(viewer_->Message(), "rendering") << "another view is another image";
  Do("key Escape\nwait trace");
}

// The preview took its place at each move, and its shadows and mirrors came and went.
TEST_F(ViewerTest, ALiveImageStaysTracedInMotion) {
  Do("key P\nwait trace\ndown left 20 20");
  for (int x = 21; x < 60; ++x) {
    viewer_->Handle(MoveEvent{static_cast<double>(x), 20});
    viewer_->Update();
    const FrameState shown = viewer_->Show();
    ASSERT_TRUE(shown.covering && shown.covering->frame) << x;
  }
  Do("up left 60 20\nwait trace");
  EXPECT_EQ(StateLine("trace"), "none");
  const R2::Image whole = Rendered(viewer_->Traced().Live()->Settings());
  EXPECT_EQ(R2::PixelsBeyond(*viewer_->Traced().Current(), whole, 0), 0) << "in the end it is of the view at rest";
  Do("resize 80 60");
  EXPECT_FALSE(viewer_->Show().covering && viewer_->Traced().Live()->Places() == 0) << "no other size is shown";
}

TEST_F(ViewerTest, IsNotBusyWhereNothingIsRendered) {
  EXPECT_FALSE(viewer_->IsBusy());
  Do("drag left 10 10 40 30\nresize 80 60");
  EXPECT_FALSE(viewer_->IsBusy()) << "an idle window would look for news all the time";
}

TEST_F(ViewerTest, ShiftRShowsTheReferenceWhileItIsHeld) {
  Do("key P\nwait trace\nkey R\nkey [\nwait trace\npress Shift+R");
  EXPECT_EQ(viewer_->Show().covering->image, viewer_->Traced().Reference());
  Do("release Shift+R");
  EXPECT_FALSE(viewer_->Show().covering->image);
}

TEST_F(ViewerTest, RowsOfTheQuadAreThoseOfTheRender) {
  RenderSettings slow;
  slow.samples = 64;
  Open(project::Root() / "scenes/hello.scn", slow);
  Do("key S");
  const RenderJob& job = *viewer_->Traced().Trace();
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
  // From the traced camera itself, the quad covers the image pixel by pixel, unless something is before it.
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

}  // namespace
}  // namespace ray
