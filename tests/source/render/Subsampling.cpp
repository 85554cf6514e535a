// -samples 1/4 and similar: that fraction of the pixels is traced, and the rest is filled in.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "source/film/BlockOrder.h"
#include "source/render/PixelTrace.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

std::string Hello() { return (project::Root() / "scenes/hello.scn").string(); }

RenderSettings Settings(int apart, int width = 90, int height = 70) {
  RenderSettings settings = project::Sized(width, height);
  settings.places = BlockOrder::places / apart;
  return settings;
}

TEST(Subsampling, OnlyLatticePixelsAreTracedAndMatchTheWhole) {
  const project::Stage stage(Hello());
  const R2::Image whole = project::Render(stage, Settings(1)).image;
  for (const int apart : {2, 4, 8, 16}) {
    const RenderResult result = project::Render(stage, Settings(apart));
    EXPECT_EQ(result.stop, Stop::samples);
    std::int64_t traced = 0;
    double worst = 0;
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 90; ++x) {
        const bool is_traced = BlockOrder::PlaceOf(x, y) < BlockOrder::places / apart;
        traced += is_traced;
        const R2::Color d = result.image.At(x, y) - whole.At(x, y);
        if (is_traced) worst = std::max({worst, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
      }
    EXPECT_EQ(worst, 0) << apart;
    EXPECT_EQ(result.rays[RayKind::camera].rays, static_cast<std::uint64_t>(traced)) << apart;
    EXPECT_EQ(result.pixels_done, traced) << apart;
    EXPECT_DOUBLE_EQ(result.samples.mean, static_cast<double>(traced) / (90 * 70)) << apart;
  }
}

TEST(Subsampling, AQuarterIsEverySecondPixelOfEverySecondRow) {
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      EXPECT_EQ(BlockOrder::PlaceOf(x, y) < BlockOrder::places / 4, x % 2 == 0 && y % 2 == 0);
      EXPECT_EQ(BlockOrder::PlaceOf(x, y) < BlockOrder::places / 16, x % 4 == 0 && y % 4 == 0);
    }
}

TEST(Subsampling, ThreadsAndTilesMakeTheSameImage) {
  const project::Stage stage(Hello());
  RenderSettings settings = Settings(4);
  const R2::Image image = project::Render(stage, settings).image;
  settings.threads = 3, settings.tile_size = 8;
  EXPECT_TRUE(project::Render(stage, settings).image == image);
}

TEST(Subsampling, DoesNotApplyToSeveralSamples) {
  const project::Stage stage(Hello());
  RenderSettings settings = Settings(4), plain = Settings(1);
  settings.samples = plain.samples = 2;
  EXPECT_TRUE(project::Render(stage, settings).image == project::Render(stage, plain).image);
}

TEST(Subsampling, ThePixelsTreeSaysThatItIsSkipped) {
  const project::Stage stage(Hello());
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  const auto says = [&](int x, int y) {
    return Has(DebugPixel(stage.world, *accelerator, Settings(4), x, y), "skipped by -samples");
  };
  EXPECT_FALSE(says(10, 20));
  EXPECT_TRUE(says(11, 20));
}

TEST(Subsampling, TheProgramReportsTheTracedPixels) {
  NEEDS_THE_PROGRAM();
  const SceneFolder folder;
  const Finished ended =
      RunProgram({folder.Scene(), folder / "out.png", "-width", "64", "-height", "64", "-samples", "1/4"});
  EXPECT_EQ(ended.status, 0) << ended.error;
  EXPECT_TRUE(Has(ended.error + ended.output, "1 spp at 25.0% of the pixels, the others interpolated"))
      << ended.error << ended.output;
  EXPECT_TRUE(Has(Decode(folder / "out.png").settings.at("pixels"), "1024 of 4096 pixels traced"));
}

TEST(Subsampling, PartsAndResumedRendersAreTheSameBytes) {
  NEEDS_THE_PROGRAM();
  const SceneFolder folder;
  const std::vector<std::string> request{folder.Scene(), folder / "out.png", "-width", "70",    "-height",
                                         "50",           "-samples",         "1/4",    "-quiet"};
  ASSERT_EQ(RunProgram(request).status, 0);
  const R2::Image whole = Decode(folder / "out.png").image;
  for (const char* part : {"1/2", "2/2"}) ASSERT_EQ(RunProgram(With(request, {"-part", part})).status, 0) << part;
  const Finished ended = RunProgram(With(request, {"-parts", folder / "out.png.part-*"}));
  ASSERT_EQ(ended.status, 0) << ended.error;
  EXPECT_TRUE(Decode(folder / "out.png").image == whole);
}

TEST(Subsampling, LayersAreTracedInEveryPixel) {
  NEEDS_THE_PROGRAM();
  const SceneFolder folder;
  const std::vector<std::string> request{folder.Scene(), folder / "all.pfm", "-width",
                                         "40",           "-height",          "30",
                                         "-quiet",       "-layers",          "depth,normal,uv,albedo,id"};
  ASSERT_EQ(RunProgram(request).status, 0);
  auto some = With(request, {"-samples", "1/16"});
  some[1] = folder / "some.pfm";
  ASSERT_EQ(RunProgram(some).status, 0);
  for (const std::string layer : {"depth", "normal", "uv", "albedo", "id"})
    EXPECT_TRUE(Decode(folder / ("all." + layer + ".pfm")).image == Decode(folder / ("some." + layer + ".pfm")).image)
        << layer;
}

TEST(Subsampling, G9_PixelsBeyondFloatsAreStoredAsTheLargest) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const std::string scene = WriteFile(folder / "a.scn",
                                      "camera 0 0 5  0 0 -1  0 1 0  .3 .01 100\n"
                                      "material 0 0 0  0 0 0  0 0 0  0 0 0  1e300 1e39 1  1 1 0\nsphere 0  0 0 0  1\n");
  for (const char* samples : {"1", "1/2", "1/4", "1/8", "1/16"}) {
    ASSERT_EQ(RunProgram({scene, folder / "a.pfm", "-width", "16", "-height", "16", "-samples", samples}).status, 0);
    const R2::Image image = Decode(folder / "a.pfm").image;
    EXPECT_TRUE(std::ranges::all_of(image.Channels(), [](float x) { return std::isfinite(x); })) << samples;
    constexpr double largest = std::numeric_limits<float>::max();
    EXPECT_EQ(image.At(8, 8), (R2::Color{largest, largest, 1})) << samples;
  }
}

TEST(Subsampling, OptionsThatNeedEveryPixelAreRefused) {
  NEEDS_THE_PROGRAM();
  const SceneFolder folder;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"-error", "2"}, {"-denoise"}, {"-adaptive", "neighbors"}, {"-mode", "heat"}, {"-mode", "id"}}) {
    const Finished ended = RunProgram(With({folder.Scene(), folder / "out.png", "-samples", "1/4"}, words));
    EXPECT_NE(ended.status, 0) << words[0];
    EXPECT_TRUE(Has(ended.error, "cannot be combined with " + words[0])) << ended.error;
  }
  for (const char* bad : {"1/3", "1/32", "0", "2/4", ".25", "1/-4", "1/4 "}) {
    const Finished ended = RunProgram({folder.Scene(), folder / "out.png", "-samples", bad});
    EXPECT_NE(ended.status, 0) << bad;
    EXPECT_TRUE(Has(ended.error, "or 1/2, 1/4, 1/8 or 1/16")) << ended.error;
  }
}

}  // namespace
}  // namespace ray::testing
